#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Markdown tables of reports of `run bench`: what docs/results quotes. Ratios are over the baseline of their part, with 95%
intervals; bold is what is below 1 with its whole interval.

    python3 tools/report/tables.py out/quality.json [MORE.json ...]
"""

import json
import sys
from pathlib import Path

# Of techniques: title, then what to take from a row.
MEASURES = (
    ("MSE at equal samples", lambda row: row["mse"]["ratio"]),
    ("MSE at equal time", lambda row: row["mse"]["ratio_at_equal_time"]),
    ("Trimmed MSE at equal samples", lambda row: row["trimmed_mse"]["ratio"]),
    ("Trimmed MSE at equal time", lambda row: row["trimmed_mse"]["ratio_at_equal_time"]),
    ("Relative MSE at equal samples", lambda row: row["relative_mse"]["ratio"]),
    ("Milliseconds of a frame", lambda row: row["frame_ms"]["ratio"]),
)


def number(value):
    """Three digits at most; a question mark where there is none."""
    if value is None:
        return "?"
    return f"{value:.0f}" if abs(value) >= 100 else f"{value:.2g}" if abs(value) < 0.1 else f"{value:.3g}"


def cell(interval):
    value, low, high = (interval[key] for key in ("value", "low", "high"))
    if low == high and low is not None:
        return number(value)
    text = f"**{number(value)}**" if high is not None and high < 1 else number(value)
    return text if low is None or high is None else f"{text} [{number(low)}, {number(high)}]"


def plain(interval):
    """A cell that is no ratio."""
    return cell(interval).replace("**", "")


def first_labels(parts):
    return [row["label"] for row in parts[0]["rows"]]


def by_technique(title, parts, value_of, show=cell):
    """Parts down, techniques across."""
    labels = first_labels(parts)
    lines = []
    for part in parts:
        cells = {row["label"]: show(value_of(row)) for row in part["rows"]}
        lines.append([part["part"], *(cells.get(label, "") for label in labels)])
    return [title, *labels], lines


def quality(report):
    for title, value_of in MEASURES:
        yield by_technique(title, report["parts"], value_of)
    yield by_technique("Mean over the reference's", report["parts"], lambda row: row["mean_ratio"], plain)


def adapt(report):
    lines = []
    for part in report["parts"]:
        for row in part["rows"]:
            lines.append([part["part"], row["label"]])
            for measure in ("mse", "trimmed_mse"):
                curve = row[measure]
                frame = curve["settled_frame"]
                lines[-1] += [number(curve["frames"][0]["value"]), number(curve["settled"]),
                              str(frame) if frame <= len(curve["frames"]) else "never"]
    yield ["level", "", "MSE of frame 1", "settled", "from frame", "trimmed, frame 1", "settled", "from frame"], lines


def ring(report):
    lines = []
    for turn in report["parts"]:
        for row in turn["rows"]:
            back = row["readapted_frame"]
            lines.append([f"{turn['degrees']}°", row["label"], plain(row["before"]), plain(row["frames"][0]),
                          str(back) if back <= len(row["frames"]) else "never", number(row["settled"])])
    yield ["turn", "", "MSE before", "frame 1", "back from frame", "settled"], lines


def timing(report):
    yield by_technique("Path tracing", report["parts"], lambda row: row["path_ms"]["ratio"])
    yield by_technique("Preparation over path tracing", report["parts"], lambda row: row["prepare_ms"]["share_of_path"], plain)
    for part in report["parts"]:
        names = list(dict.fromkeys(entry["name"] for row in part["rows"] for entry in row["passes"]))
        lines = []
        for name in names:
            passes = [next((entry for entry in row["passes"] if entry["name"] == name), None) for row in part["rows"]]
            lines.append([name, *(f"{number(entry['median_ms'])} ({100 * entry['share']:.1f}%)" if entry else ""
                                  for entry in passes)])
        yield [f"{part['part']}: median ms (share)", *first_labels([part])], lines


def scale(report):
    yield by_technique("Milliseconds of a frame", report["parts"], lambda row: row["frame_ms"], plain)
    yield by_technique("Trimmed MSE over the baseline", report["parts"], lambda row: row["trimmed_mse"]["ratio"])
    yield by_technique("The same at equal time", report["parts"], lambda row: row["trimmed_mse"]["ratio_at_equal_time"])


def trade(report):
    """One table per level: every value against the default of its technique."""
    levels = dict.fromkeys(part["level"] for part in report["parts"])
    for level in levels:
        lines = []
        for part in report["parts"]:
            if part["level"] != level:
                continue
            for row in part["rows"]:
                if row["label"] != part["baseline"]:
                    lines.append([row["label"], part["baseline"], cell(row["frame_ms"]["ratio"]),
                                  cell(row["trimmed_mse"]["ratio"]), cell(row["trimmed_mse"]["ratio_at_equal_time"]),
                                  cell(row["mse"]["ratio"])])
        yield [f"{level}", "over", "frame time", "trimmed MSE", "trimmed, equal time", "MSE"], lines


KINDS = {function.__name__: function for function in (quality, adapt, ring, timing, scale, trade)}


def markdown_table(head, lines):
    rows = [head, ["---"] * len(head), *lines]
    return "\n".join("| " + " | ".join(cells) + " |" for cells in rows)


def markdown(report):
    """All tables of a report."""
    return "\n\n".join(markdown_table(head, lines) for head, lines in KINDS[report["measured"]](report))


def main(paths):
    if not paths:
        sys.exit(__doc__)
    for path in paths:
        try:
            report = json.loads(Path(path).read_text())
        except (OSError, ValueError) as fault:
            sys.exit(f"{path}: {fault}")
        if report.get("measured") not in KINDS or not report.get("parts"):
            sys.exit(f"{path}: no report of `run bench` that has tables")
        print(f"{report['device']}, commit {report['commit']}\n\n{markdown(report)}\n")


if __name__ == "__main__":
    main(sys.argv[1:])
