#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""tidy_test.py SOURCES BUILD: clang-tidy finds nothing in src, by the checks of .clang-tidy. Versions differ in what they find, so one
of them decides: without clang-tidy 14 the test is skipped (77). Units are those of the build folder, several files each. One that was
found clean is not asked again until its preprocessed text or the checks change."""
import concurrent.futures
import hashlib
import json
import os
import pathlib
import shlex
import shutil
import subprocess
import sys

SKIPPED = 77


def find_clang_tidy():
    for name in ("clang-tidy-14", "clang-tidy"):
        path = shutil.which(name)
        if path and "version 14." in subprocess.run([path, "--version"], capture_output=True, text=True).stdout:
            return path
    return None


def text_of(unit):
    """The unit as the compiler sees it."""
    command = shlex.split(unit["command"])
    output = command.index("-o")
    del command[output:output + 2]
    command[command.index("-c")] = "-E"
    return subprocess.run(command, cwd=unit["directory"], stdout=subprocess.PIPE, check=True).stdout


def main(sources, build):
    clang_tidy = find_clang_tidy()
    if not clang_tidy:
        print("clang-tidy 14 is not here")
        return SKIPPED
    checks = (sources / ".clang-tidy").read_bytes()
    clean = build / "tidy"
    clean.mkdir(exist_ok=True)

    def ask(unit):
        """What clang-tidy says of a unit; nothing if it is clean."""
        seen = clean / hashlib.sha256(checks + text_of(unit)).hexdigest()
        if seen.exists():
            return ""
        run = subprocess.run([clang_tidy, "-p", build, "--quiet", f"--config-file={sources / '.clang-tidy'}", unit["file"]],
                             capture_output=True, text=True)
        if run.returncode == 0:
            seen.touch()
            return ""
        return run.stdout + run.stderr

    # Those of src's own targets: a file, or one that includes several; not what a build writes (commit.cpp, embedded shaders).
    folders = (f"{sources}/src/", f"{build}/src/")
    units = [unit for unit in json.loads((build / "compile_commands.json").read_text())
             if " -o src/" in unit["command"] and unit["file"].startswith(folders) and not unit["file"].endswith("/commit.cpp")]
    assert units, "no unit of src in compile_commands.json"
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        said = [text for text in pool.map(ask, units) if text]
    print("\n".join(said))
    return 1 if said else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
