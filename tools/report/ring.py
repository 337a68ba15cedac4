#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Draws error over frames after a turn of the lamp, after figure 10 of the paper, from the report of `run bench ring`: a row
per turn, a column per size of quadtree."""

from matplotlib import pyplot

import drawing


def draw_curve(axes, row, color, label):
    values = [row["before"]] + row["frames"]
    drawing.curve(axes, range(len(values)), values, color, label=label)


def draw(report):
    turns = report["parts"]
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
    yield "ring", figure


if __name__ == "__main__":
    drawing.main(__doc__, "ring", draw)
