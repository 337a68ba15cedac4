# SPDX-License-Identifier: GPL-2.0-or-later
"""Virtual environments for tools that need more than Python brings: one per requirements.txt, in the user's cache folder, made
when it is first needed and again when that file changes."""

import os
import subprocess
import sys
from pathlib import Path

CACHE = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "vigil"
UNAVAILABLE = 3  # exit status: nothing was done


def python_with(requirements, name, contents):
    """The Python of the environment `name` that holds requirements.txt (`contents` says what that is, for messages); None,
    with a message, where it cannot be had."""
    wanted = requirements.read_text()
    home = CACHE / name
    python, stamp = home / "bin" / "python", home / "requirements.txt"
    if stamp.is_file() and stamp.read_text() == wanted and python.is_file():
        return python
    print(f"{name}: installing {contents} into {home}", flush=True)
    for step in ([sys.executable, "-m", "venv", "--clear", str(home)],
                 [str(python), "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "-r", str(requirements)]):
        try:
            done = subprocess.run(step, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        except OSError as error:
            print(f"{name}: skipped: {step[0]}: {error.strerror}")
            return None
        if done.returncode != 0:
            said = (done.stdout.strip().splitlines() or ["no output"])[-1]
            print(f"{name}: skipped, {contents} cannot be had here: {said}")
            return None
    stamp.write_text(wanted)
    return python


def run_with(requirements, name, contents, script, arguments):
    """Runs a script of that environment; returns its exit status, UNAVAILABLE where the environment cannot be had."""
    python = python_with(requirements, name, contents)
    if python is None:
        return UNAVAILABLE
    return subprocess.run([str(python), str(script), *arguments], check=False).returncode


if __name__ == "__main__":
    # REQUIREMENTS NAME CONTENTS: prints the Python of that environment on the last line.
    print(python_with(Path(sys.argv[1]), *sys.argv[2:]) or "")
