#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Markdown tables of `vigil_bench quality` reports: every level a row, every technique a column, errors over the baseline's
at equal samples and at equal time.

    python3 tools/report/quality_table.py out/quality.json [MORE.json ...]
"""

import json
import sys
from pathlib import Path

# Title, then what to take from a row of a level.
TABLES = (
    ("MSE at equal samples", lambda row: row["mse"]["ratio"]),
    ("MSE at equal time", lambda row: row["mse"]["ratio_at_equal_time"]),
    ("Trimmed MSE at equal samples", lambda row: row["trimmed_mse"]["ratio"]),
    ("Trimmed MSE at equal time", lambda row: row["trimmed_mse"]["ratio_at_equal_time"]),
    ("Milliseconds of a frame", lambda row: row["frame_ms"]["ratio"]),
)


def number(value):
    """Three digits at most; a question mark where there is none."""
    if value is None:
        return "?"
    return f"{value:.0f}" if abs(value) >= 100 else f"{value:.2g}" if abs(value) < 0.1 else f"{value:.3g}"


def cell(interval):
    value, low, high = (interval[key] for key in ("value", "low", "high"))
    if low == high:
        return number(value)
    better = high is not None and high < 1
    text = f"**{number(value)}**" if better else number(value)
    return f"{text} [{number(low)}, {number(high)}]"


def table(title, levels, value_of):
    labels = [row["label"] for row in levels[0]["rows"]]
    lines = [f"| {title} | " + " | ".join(labels) + " |", "|---" * (len(labels) + 1) + "|"]
    for level in levels:
        cells = {row["label"]: cell(value_of(row)) for row in level["rows"]}
        lines.append(f"| {level['level']} | " + " | ".join(cells.get(label, "") for label in labels) + " |")
    return "\n".join(lines)


def main(paths):
    if not paths:
        sys.exit(__doc__)
    reports = []
    for path in paths:
        try:
            reports.append(json.loads(Path(path).read_text()))
        except (OSError, ValueError) as fault:
            sys.exit(f"{path}: {fault}")
        if reports[-1].get("measured") != "quality":
            sys.exit(f"{path}: not a report of `bench quality`")
    levels = [level for report in reports for level in report["levels"]]
    print(f"Over `{reports[0]['baseline']}`, {reports[0]['device']}\n")
    print("\n\n".join(table(title, levels, value_of) for title, value_of in TABLES))


if __name__ == "__main__":
    main(sys.argv[1:])
