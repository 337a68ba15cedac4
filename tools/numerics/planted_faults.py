#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Plants faults (fault_table.py), one at a time, in a copy of the project, and demands that the tests named beside
each notice.

usage: planted_faults.py [--quick] [--list | --check] [FOLDER [WORD]]

  FOLDER    receives the copy and its build (build-faults)
  WORD      only faults whose name or file holds it
  --quick   only those that are built and tested in seconds, without a GPU
  --list    their names
  --check   only whether each fault's line is, once, in its file

Run it in the project's folder. What becomes of a fault is one of three:

  noticed     its tests pass without it, and with it the program ends with failed tests
  UNNOTICED   its tests pass with it too
  ERROR       nothing is known: its line has changed, it does not build, its tests fail without it, no test ran, or the
              program was ended by a signal or by its time limit

The last line counts them. The exit status is 1 unless all were noticed.
"""

import argparse
import fnmatch
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

from fault_table import FAULTS

TIME_LIMIT = 3600  # seconds for one run of a test program, of which all end within minutes on a machine that is free


class Problem(Exception):
    """Why nothing is known about a fault."""


def run(command, **options):
    return subprocess.run(command, capture_output=True, text=True, **options)


def matches(name, tests):
    """Whether a GoogleTest filter without exceptions takes a test."""
    return any(fnmatch.fnmatchcase(name, pattern) for pattern in tests.split(":"))


class Copy:
    """The project, but for what git ignores, in a folder of its own, and its build below that."""

    def __init__(self, folder):
        self.folder = folder
        self.build_folder = folder / "build"
        # Compiled files come from the project's own build where ccache is asked the same.
        self.environment = {**os.environ, "CCACHE_BASEDIR": str(folder), "CCACHE_NOHASHDIR": "1"}

    def update(self):
        """Files that have not changed keep their time, so that a second run builds little; files that are gone go."""
        cache = self.build_folder / "CMakeCache.txt"
        home = f"CMAKE_HOME_DIRECTORY:INTERNAL={self.folder}\n"
        if cache.is_file() and home not in cache.read_text(encoding="utf-8"):
            shutil.rmtree(self.build_folder)  # of another folder, which was moved here
        listed = run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"])
        if listed.returncode != 0:
            print("not a checkout of git, which tells what to copy")
            sys.exit(77)  # ctest takes it for skipped
        names = {name for name in listed.stdout.split("\0") if Path(name).is_file()}
        for name in names:
            source, copy = Path(name), self.folder / name
            if not copy.is_file() or copy.read_bytes() != source.read_bytes():
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(source, copy)
        for top in {Path(name).parts[0] for name in names if len(Path(name).parts) > 1}:
            for copy in list((self.folder / top).rglob("*")):
                if copy.is_file() and str(copy.relative_to(self.folder)) not in names:
                    copy.unlink()

    def configure(self):
        launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
        self.build_folder.mkdir(parents=True, exist_ok=True)
        programs, injected = self.build_folder / "fault_programs.cmake", self.build_folder / "inject.cmake"
        programs.write_text(self.programs(), encoding="utf-8")
        injected.write_text(f"cmake_language(DEFER CALL include {programs})\n", encoding="utf-8")
        done = run(["cmake", "-G", "Ninja", "-S", str(self.folder), "-B", str(self.build_folder), *launcher,
                    f"-DCMAKE_PROJECT_vigil_INCLUDE={injected}"], env=self.environment)
        if done.returncode != 0:
            sys.exit(f"cmake failed\n{done.stderr[-3000:]}")

    def programs(self):
        """CMake code: the test programs that are made for faults alone."""
        lines = []
        for program in dict.fromkeys(fault.program for fault in FAULTS):
            if program.sources:
                sources = " ".join(str(self.folder / source) for source in program.sources)
                computes = "COMPUTES" if program.computes else ""
                lines.append(f"vigil_test({program.target} {computes} SOURCES {sources} "
                             f"LIBS {' '.join(program.libraries)})")
        return "\n".join(lines) + "\n"

    def build(self, target):
        done = run(["ninja", "-C", str(self.build_folder), target], env=self.environment)
        if done.returncode != 0:
            raise Problem(f"it does not build\n{done.stdout[-3000:]}")

    def test(self, program, tests, fail_fast):
        """Runs tests; gives the names of those that passed and of those that failed."""
        report = self.build_folder / "fault_report.json"
        report.unlink(missing_ok=True)
        command = [str(self.build_folder / program.path), "--gtest_filter=" + tests, f"--gtest_output=json:{report}"]
        if fail_fast:
            command.append("--gtest_fail_fast")
        try:
            done = run(command, cwd=self.build_folder, timeout=TIME_LIMIT,
                       env={**os.environ, **dict(program.environment)})
        except subprocess.TimeoutExpired:
            raise Problem(f"the tests had not ended after {TIME_LIMIT} s") from None
        if done.returncode < 0:
            raise Problem(f"the tests were ended by {signal.Signals(-done.returncode).name}")
        if not report.is_file():
            raise Problem(f"the tests ended with status {done.returncode} and without a report\n{done.stdout[-3000:]}")
        passed, failed = [], []
        for suite in json.loads(report.read_text(encoding="utf-8"))["testsuites"]:
            for case in suite["testsuite"]:
                if case.get("failures"):
                    failed.append(f"{suite['name']}.{case['name']}")
                elif case.get("result") == "COMPLETED":
                    passed.append(f"{suite['name']}.{case['name']}")
        if (done.returncode != 0) != bool(failed):
            raise Problem(f"{len(failed)} tests failed, but the program ended with status {done.returncode}")
        return passed, failed


def stale(fault, folder):
    path = folder / fault.file
    count = path.read_text(encoding="utf-8").count(fault.before) if path.is_file() else 0
    return "" if count == 1 else f"out of date: its line is {count} times in {fault.file}"


def judge(copy, fault, sound):
    """The test that noticed the fault, or nothing. `sound`: tests that pass without it."""
    if problem := stale(fault, copy.folder):
        raise Problem(problem)
    if not any(matches(name, fault.tests) for name in sound):
        raise Problem(f"no test of {fault.program.target} named {fault.tests} runs here")
    path = copy.folder / fault.file
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace(fault.before, fault.after), encoding="utf-8")
    try:
        copy.build(fault.program.target)
        _, failed = copy.test(fault.program, fault.tests, fail_fast=True)
        return failed[0] if failed else None
    finally:
        path.write_text(text, encoding="utf-8")


def plant_all(copy, faults, tell):
    """All faults of one program, which is built and run without any first."""
    program = faults[0].program
    try:
        copy.build(program.target)
        passed, failed = copy.test(program, ":".join(dict.fromkeys(fault.tests for fault in faults)), fail_fast=False)
    except Problem as problem:
        for fault in faults:
            tell(fault, "ERROR", f"without a fault: {problem}")
        return
    for fault in faults:
        broken = [name for name in failed if matches(name, fault.tests)]
        if broken:
            tell(fault, "ERROR", f"{broken[0]} fails without a fault")
            continue
        try:
            noticed = judge(copy, fault, passed)
        except Problem as problem:
            tell(fault, "ERROR", str(problem))
            continue
        tell(fault, "noticed" if noticed else "UNNOTICED", noticed or f"{fault.program.target} {fault.tests}")


class Results:
    def __init__(self):
        self.counts = {"noticed": 0, "UNNOTICED": 0, "ERROR": 0}
        self.last = time.monotonic()

    def tell(self, fault, result, text):
        self.counts[result] += 1
        now = time.monotonic()
        print(f"{result:<9}  {fault.name}  ({text}; {now - self.last:.0f} s)", flush=True)
        self.last = now

    def close(self):
        noticed, unnoticed, errors = self.counts.values()
        print(f"{noticed} noticed, {unnoticed} unnoticed, {errors} errors")
        return 1 if unnoticed or errors else 0


def main():
    about, usage, rest = re.fullmatch(r"(.*?)usage: (.*?)\n(.*)", __doc__, re.DOTALL).groups()
    parser = argparse.ArgumentParser(usage=usage, description=about + rest.lstrip("\n"),
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    for option in ("--quick", "--list", "--check"):
        parser.add_argument(option, action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("folder", nargs="?", default="build-faults", help=argparse.SUPPRESS)
    parser.add_argument("word", nargs="?", default="", help=argparse.SUPPRESS)
    options = parser.parse_args()
    faults = [fault for fault in FAULTS
              if (options.word in fault.name or options.word in fault.file) and (fault.quick or not options.quick)]
    if not faults:
        sys.exit(f"no fault's name or file holds '{options.word}'; --list tells them")
    if options.list:
        print("\n".join(f"{fault.name}  ({fault.file})" for fault in faults))
        return 0
    if options.check:
        problems = [f"{fault.name}: {stale(fault, Path())}" for fault in faults if stale(fault, Path())]
        print("\n".join([*problems, f"{len(faults)} faults, {len(problems)} out of date"]))
        return 1 if problems else 0

    copy = Copy(Path(options.folder).resolve())
    copy.update()
    copy.configure()
    groups = {}
    for fault in faults:
        groups.setdefault(fault.program, []).append(fault)
    results = Results()
    for group in groups.values():
        plant_all(copy, group, results.tell)
    return results.close()


if __name__ == "__main__":
    sys.exit(main())
