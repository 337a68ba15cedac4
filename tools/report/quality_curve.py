#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Draws error over frames, after figure 9 of the paper, from the report of `run bench quality --curve`: one PNG per level.
It computes nothing: means, intervals and settled values are those of the report."""

import argparse
import json
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot

LABELS = {"mse": "MSE", "trimmed_mse": "MSE without the largest 0.1% of the pixels"}


def draw_row(axes, row, measure, color, is_level):
    """A curve with its intervals; a technique that learns nothing (`is_level`) as its mean level."""
    curve = row[measure]
    if is_level:
        axes.axhline(curve["settled"], color=color, label=row["label"])
        return
    frames = range(1, len(curve["frames"]) + 1)
    values = [frame["value"] for frame in curve["frames"]]
    axes.plot(frames, values, color=color, marker=".", label=row["label"])
    # Intervals without an end (one seed) are not drawn; those below zero are cut by the logarithmic axis.
    ends = [(frame["low"], frame["high"]) for frame in curve["frames"]]
    if all(low is not None and high is not None for low, high in ends):
        smallest = min(value for value in values if value > 0) * 0.3
        axes.fill_between(frames, [max(low, smallest) for low, _ in ends], [high for _, high in ends],
                          color=color, alpha=0.2, linewidth=0)
    limit = curve["settled"] * curve["settled_factor"]
    axes.axhline(limit, color=color, linestyle=":", linewidth=1)
    if curve["settled_frame"] <= len(values):
        axes.axvline(curve["settled_frame"], color=color, linestyle=":", linewidth=1)


def draw_level(level, report, measure, level_rows, path):
    figure, axes = pyplot.subplots(figsize=(7, 4), layout="constrained")
    for number, row in enumerate(level["rows"]):
        technique = row["variables"].get("pt_nee", row["label"])
        draw_row(axes, row, measure, f"C{number}", technique in level_rows)
    axes.set_yscale("log")
    axes.set_xlabel("frame from an empty cache")
    axes.set_ylabel(LABELS[measure])
    axes.set_title(f"{level['level']}: {len(level['views'])} views, {report['seeds']} seeds, "
                   f"{report['width']} x {report['height']}, 1 sample per pixel")
    axes.legend()
    figure.savefig(path, dpi=120)
    pyplot.close(figure)
    print(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("report", type=Path, help="quality_curve.json")
    parser.add_argument("--measure", choices=LABELS, default="mse")
    parser.add_argument("--level-rows", nargs="*", default=["sll", "lh", "uniform", "power"],
                        help="techniques that learn nothing from frame to frame: drawn as one level")
    parser.add_argument("--out", type=Path, help="folder for the pictures; default: that of the report")
    arguments = parser.parse_args()
    report = json.loads(arguments.report.read_text())
    if report["measured"] != "curve":
        parser.error(f"{arguments.report} is no report of --curve")
    folder = arguments.out or arguments.report.parent
    folder.mkdir(parents=True, exist_ok=True)
    for level in report["levels"]:
        draw_level(level, report, arguments.measure, arguments.level_rows,
                   folder / f"quality_curve_{level['level']}_{arguments.measure}.png")


if __name__ == "__main__":
    main()
