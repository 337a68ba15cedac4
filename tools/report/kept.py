#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Keeps what pages quote of reports in docs/results/pages: the values of rows, their intervals and the medians of views,
but without single runs.

    python3 tools/report/kept.py NAME REPORT.json [MORE.json ...]    # puts the parts of these reports into NAME.json

A part takes the place of one of the same name. tools/docs/quoted_numbers.py quotes them as pages.NAME:PART/ROW/PATH.
A report is one of `./run bench` or `./run crosscheck --json`, or of these:

- What a test program writes with --gtest_output=json:REPORT.json. Each test is a part: its properties measured/ROW/FIELD are what it measured.
- timedemo_json. The name of the file is the part, the demo its row, with the share of each pass in the frame.
- What `./run test` printed, NAME.log. The part is its commit, NAME its row, with the seconds of each stage."""

import json
import re
import sys
from pathlib import Path

import tables

FOLDER = Path(__file__).resolve().parents[2] / "docs/results/pages"
OF_REPORT = ("measured", "commit", "device", "width", "height")
SINGLE = ("by_view_and_seed", "by_seed", "pass_ms", "passes", "pass_frames_ms", "pictures", "views", "planned")


def with_views(value):
    """Adds by_view, the median of each view, to what has single runs."""
    if isinstance(value, dict):
        found = {key: with_views(inner) for key, inner in value.items()}
        runs = value.get("by_view_and_seed")
        return found | {"by_view": [tables.median(view) for view in runs]} if runs and all(runs) else found
    return [with_views(inner) for inner in value] if isinstance(value, list) else value


def traced(levels):
    """Parts of `bench trace`."""
    return [{"part": level["name"], "triangles": level["triangles"], "build_ms": level["build_ms"],
             "rows": [row | {"label": row["rays"]} for row in level["rows"]]} for level in levels]


def recorded(suites):
    """Parts of a test program's report."""
    parts = []
    for test in (test for suite in suites for test in suite["testsuite"]):
        rows = {}
        for name, value in test.items():
            if name.startswith("measured/"):
                row, _, field = name.removeprefix("measured/").rpartition("/")
                rows.setdefault(row, {"label": row})[field] = float(value)
        if rows:
            parts.append({"part": test["name"], "rows": list(rows.values())})
    return parts


def flown(report, name):
    """A part of one row."""
    shares = {one["name"]: one["share"] for one in report["passes"]}
    shares["filter"] = sum(share for name, share in shares.items() if name.startswith("filter_"))
    row = {"label": report["demo"], "fps": report["fps"], "runs": len(report["repetitions"]), "share": shares}
    return {"part": name, "rows": [row]}


def tested(text, name):
    """A report of the seconds that the stages of `./run test` took."""
    commit = re.search(r"^== Done .* commit (\w+)", text, re.M)
    laps = re.search(r"^ +(packages and program \d+ s, .*)$", text, re.M)
    if commit is None or laps is None:
        raise ValueError("not all that `./run test` prints")
    seconds = {stage: int(took) for stage, took in re.findall(r"([^,]+?) (\d+) s(?:, |$)", laps[1])}
    return {"parts": [{"part": commit[1], "rows": [{"label": name, "seconds": seconds | {"all": sum(seconds.values())}}]}]}


def read(path):
    return tested(path.read_text(), path.stem) if path.suffix == ".log" else json.loads(path.read_text())


def parts_of(report, name):
    if "levels" in report:
        return traced(report["levels"])
    if "testsuites" in report:
        return recorded(report["testsuites"])
    return [flown(report, name)] if "repetitions" in report else report["parts"]


def join(joined, report, name=""):
    """Puts the parts of a finished report into one that join() made, or into None. Each part says what the report did of all."""
    if not report.get("finished", True):
        raise ValueError("a report is not finished")
    parts = {part["part"]: part for part in joined["parts"]} if joined else {}
    for part in parts_of(report, name):
        kept = {key: report[key] for key in OF_REPORT if key in report} | tables.rounded(with_views(part), SINGLE)
        views = part.get("views")
        if views is not None:
            kept["views"] = len(views) if isinstance(views, list) else views
        parts[part["part"]] = kept
    return {"parts": list(parts.values())}


def main(name, paths):
    path = FOLDER / f"{name}.json"
    joined = json.loads(path.read_text()) if path.exists() else None
    for source in paths:
        try:
            joined = join(joined, read(Path(source)), Path(source).stem)
        except (OSError, ValueError, KeyError) as fault:
            sys.exit(f"{source}: {fault}")
    FOLDER.mkdir(exist_ok=True)
    path.write_text(json.dumps(joined, separators=(",", ":")) + "\n")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2:])
