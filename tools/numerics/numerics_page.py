#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Puts what tests recorded of extremes (tests/numerics/record.h) into the tables of docs/internals/numerics.md.

usage: numerics_page.py [--check] PAGE PROGRAM...

PROGRAMs are those of the tests. Each has left a report, GoogleTest's XML, in a folder of build/results, as
`./run test` makes them do it; a report older than its program is passed over.
PAGE keeps its text; what stands between the two marks is made anew. With --check nothing is written: the exit status
is 1 if the page lacks a row that a test recorded or demands something else in it, or has one that none did. What was
seen may differ, as machines do.
"""

import re
import sys
import xml.etree.ElementTree as tree
from pathlib import Path

BEGIN = "<!-- tables: made by tools/numerics/numerics_page.py -->"
END = "<!-- end of the tables -->"
SKIPPED = 77  # of the test in ctest
HEADER = "| extreme | what tests demand | seen |"


def read_rows(files):
    """{area: {extreme: (demanded, seen)}} in the order of the tests; a test that failed is an error."""
    areas = {}
    for file in files:
        for case in tree.parse(file).iter("testcase"):
            if case.find("failure") is not None:
                sys.exit(f"{file}: {case.get('classname')}.{case.get('name')} failed")
            for entry in case.iter("property"):
                key = entry.get("name").split("/", 2)
                if key[0] != "numerics":
                    continue
                demanded, seen = entry.get("value").split(" | ", 1)
                areas.setdefault(key[1], {})[key[2]] = (demanded, seen)
    return areas


def cell(text):
    return text.replace("|", "\\|")


def make_tables(areas):
    lines = []
    for area in sorted(areas):
        lines += ["", f"### {area[0].upper()}{area[1:]}", "", HEADER, "|---|---|---|"]
        lines += [f"| {cell(extreme)} | {cell(demanded)} | {cell(seen)} |"
                  for extreme, (demanded, seen) in areas[area].items()]
    return "\n".join(lines) + "\n\n"


def without_seen(tables):
    """Rows but for their last cell."""
    return {line.rsplit(" | ", 1)[0] for line in tables.splitlines() if line.startswith(("|", "#"))}


def find_reports(programs):
    """The newest report of each program that is not older than the program. GoogleTest numbers reports: NAME_1.xml."""
    folder = Path(__file__).resolve().parents[2] / "build" / "results"
    found = []
    for program in map(Path, programs):
        reports = [path for path in folder.glob("*/" + program.name + "*.xml")
                   if re.fullmatch(program.name + r"(_\d+)?\.xml", path.name)]
        newest = max(reports, key=lambda path: path.stat().st_mtime, default=None)
        if newest and program.exists() and newest.stat().st_mtime >= program.stat().st_mtime:
            found.append(newest)
    return found


def main(arguments):
    check = "--check" in arguments
    names = [name for name in arguments if name != "--check"]
    if len(names) < 2:
        sys.exit(__doc__)
    page, programs = Path(names[0]), names[1:]
    reports = find_reports(programs)
    if not reports or (not check and len(reports) < len(programs)):
        print(f"{len(reports)} of {len(programs)} reports are there: `./run test` makes them")
        sys.exit(SKIPPED if check else 1)
    text = page.read_text(encoding="utf-8")
    try:
        before, rest = text.split(BEGIN)
        old, after = rest.split(END)
    except ValueError:
        sys.exit(f"{page}: the marks of the tables are missing")
    tables = make_tables(read_rows(reports))
    if not check:
        page.write_text(before + BEGIN + tables + END + after, encoding="utf-8")
        return
    wanted, found = without_seen(tables), without_seen(old)
    missing = sorted(wanted - found)
    extra = sorted(found - wanted) if len(reports) == len(programs) else []
    for row in missing:
        print(f"missing: {row}")
    for row in extra:
        print(f"no test recorded: {row}")
    if missing or extra:
        sys.exit(f"{page} is not what the tests say: run numerics_page.py without --check")


if __name__ == "__main__":
    main(sys.argv[1:])
