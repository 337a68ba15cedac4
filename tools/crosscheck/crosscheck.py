#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""A second opinion on Vigil's pictures: renders exported levels with Mitsuba 3 and compares (docs/crosscheck.md). This
file needs nothing but Python: it makes Mitsuba's virtual environment and hands over to compare.py inside it."""

import os
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
CACHE = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "vigil"


def environment():
    """The Python of an environment that holds requirements.txt; None, with a message, where it cannot be had."""
    wanted = (HERE / "requirements.txt").read_text()
    home = CACHE / "crosscheck"
    python, stamp = home / "bin" / "python", home / "requirements.txt"
    if stamp.is_file() and stamp.read_text() == wanted and python.is_file():
        return python
    print(f"crosscheck: installing Mitsuba 3 into {home}", flush=True)
    for step in ([sys.executable, "-m", "venv", "--clear", str(home)],
                 [str(python), "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "-r",
                  str(HERE / "requirements.txt")]):
        try:
            done = subprocess.run(step, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        except OSError as error:
            print(f"crosscheck: skipped: {step[0]}: {error.strerror}")
            return None
        if done.returncode != 0:
            said = (done.stdout.strip().splitlines() or ["no output"])[-1]
            print(f"crosscheck: skipped, Mitsuba 3 cannot be had here: {said}")
            return None
    stamp.write_text(wanted)
    return python


def main():
    python = environment()
    if python is None:
        return 0
    return subprocess.run([str(python), str(HERE / "compare.py"), *sys.argv[1:]], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
