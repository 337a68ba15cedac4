#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Draws error over frames after a turn of the lamp, after figure 10 of the paper, from the report of `run bench ring`: a row
per turn, a column per size of quadtree. It computes nothing: means and intervals are those of the report."""

import argparse
import json
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot


def draw_curve(axes, row, color, label):
    values = [row["before"]] + row["frames"]
    frames = range(len(values))
    axes.plot(frames, [value["value"] for value in values], color=color, label=label)
    # Intervals without an end (one seed) are not drawn.
    if all(value["low"] is not None and value["high"] is not None for value in values):
        axes.fill_between(frames, [value["low"] for value in values], [value["high"] for value in values],
                          color=color, alpha=0.2, linewidth=0)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("report", type=Path, help="ring.json")
    parser.add_argument("--out", type=Path, help="picture; default: beside the report")
    arguments = parser.parse_args()
    report = json.loads(arguments.report.read_text())
    if report["measured"] != "ring":
        parser.error(f"{arguments.report} is no report of `run bench ring`")
    turns = report["turns"]
    sizes = [row for row in turns[0]["rows"] if row["label"] != "brdf"]
    figure, grid = pyplot.subplots(len(turns), len(sizes), figsize=(2.6 * len(sizes), 2.3 * len(turns)), sharex=True,
                                   sharey=True, squeeze=False, layout="constrained")
    for turn, line in zip(turns, grid):
        rows = {row["label"]: row for row in turn["rows"]}
        for size, axes in zip(sizes, line):
            row = rows[size["label"]]
            draw_curve(axes, row, "C0", "CDQ")
            draw_curve(axes, rows["brdf"], "C1", "BRDF")
            axes.axvline(row["settled_frame"], color="C0", linestyle=":", linewidth=1)
            axes.set_yscale("log")
            axes.set_title(f"{row['variables']['pt_cdq_bits']} bits, {turn['degrees']}°", fontsize=9)
        line[0].set_ylabel("MSE")
    for axes in grid[-1]:
        axes.set_xlabel("frames after the turn")
    grid[0][0].legend(fontsize=8)
    path = arguments.out or arguments.report.with_suffix(".png")
    figure.savefig(path, dpi=120)
    print(path)


if __name__ == "__main__":
    main()
