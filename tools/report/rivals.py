#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""A row of reports of `run bench quality` over the best of its rivals at equal time, level by level, as a Markdown table.

    python3 tools/report/rivals.py ROW[=RIVAL,RIVAL] REPORT.json [MORE.json ...]

Rivals are all other rows, unless they are named; one alone has no column of its own. A ratio is the typical run's: the median, with its 95% interval, of error times time of a frame
over the rival's in the run of the same view and seed. The best rival is the one over which that is largest: 1 or less is as good as all of them.
"""

import json
import math
import sys

from tables import cell, geometric_mean, load, markdown_table, number, typical_run

# Columns: what is compared is the product of these values of a run.
AT_EQUAL_TIME = (("Trimmed MSE", ("trimmed_mse", "frame_ms")), ("MSE", ("mse", "frame_ms")))


def over(row, rival, names):
    """The typical run of a row over that of a rival, as tables.typical_run gives it; None where a row misses light, or a run has no error left
    after the reference's is taken off."""
    if row.get("misses_light") or rival.get("misses_light"):
        return None
    views = []
    for columns in zip(*(r[name]["by_view_and_seed"] for r in (row, rival) for name in names)):
        runs = list(zip(*columns))
        if any(value is None or value <= 0 for run in runs for value in run):
            return None
        views.append([math.prod(run[:len(names)]) / math.prod(run[len(names):]) for run in runs])
    return typical_run(views)


def best_rival(part, label, rivals, names):
    """The (label, ratio) of the rival over which a row is worst; None where it has none. Raises ValueError without the row."""
    rows = {row["label"]: row for row in part["rows"]}
    missing = [name for name in (label, *rivals) if name not in rows]
    if missing:
        raise ValueError(f"{part['part']}: no row {', '.join(missing)}")
    ratios = [(name, over(rows[label], rows[name], names)) for name in rivals or rows if name != label]
    return max((pair for pair in ratios if pair[1] is not None), key=lambda pair: pair[1]["value"], default=None)


def table(parts, label, rivals, measures=AT_EQUAL_TIME):
    """Head and lines, a part each, and the geometric means."""
    lines, columns, several = [], [[] for _ in measures], len(rivals) != 1
    for part in parts:
        lines.append([f"`{part['part']}`"])
        for column, (_, names) in zip(columns, measures):
            best = best_rival(part, label, rivals, names)
            column.append(best and best[1]["value"])
            lines[-1] += ([f"`{best[0]}`" if best else ""] if several else []) + [cell((None, best[1])) if best else "?"]
    name = [""] if several else []
    means = [text for column in columns for text in (*name, number(geometric_mean(column)))]
    head = [text for title, _ in measures for text in (*(["best other"] if several else []), title)]
    return ["level", *head], [*lines, ["geometric mean", *means]]


def main(arguments):
    if len(arguments) < 2:
        sys.exit(__doc__)
    label, _, rivals = arguments[0].partition("=")
    reports = []
    for path in arguments[1:]:
        try:
            reports.append(load(path, "quality"))
        except (OSError, ValueError, json.JSONDecodeError) as fault:
            sys.exit(f"{path}: {fault}")
    if len({(report["device"], report["commit"]) for report in reports}) > 1:
        sys.exit("these reports are of several devices or commits")
    try:
        head, lines = table([part for report in reports for part in report["parts"]], label, rivals.split(",") if rivals else [])
    except ValueError as fault:
        sys.exit(str(fault))
    print(f"{reports[0]['device']}, commit {reports[0]['commit']}\n\n{markdown_table(head, lines)}")


if __name__ == "__main__":
    main(sys.argv[1:])
