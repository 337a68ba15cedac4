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
    figure, grid = pyplot.subplots(len(turns), len(sizes), figsize=(2.9 * len(sizes), 2.5 * len(turns)), sharex=True,
                                   sharey=True, squeeze=False, layout="constrained")
    for turn, line in zip(turns, grid):
        rows = {row["label"]: row for row in turn["rows"]}
        for size, axes in zip(sizes, line):
            row = rows[size["label"]]
            for shown, name in ((row, "quadtree"), (rows["brdf"], "BRDF")):
                color = drawing.color_of(shown["label"])
                draw_curve(axes, shown, color, name)
                drawing.name_line(axes, len(shown["frames"]), drawing.typical(shown["frames"][-1])["value"], name, color)
            axes.axvline(row["settled_frame"], color=drawing.color_of(row["label"]), linestyle=":", linewidth=1)
            axes.set_yscale("log")
            axes.set_title(f"{row['variables']['pt_cdq_bits']} bits, {turn['degrees']}°", fontsize=9)
        line[0].set_ylabel("MSE")
    for axes in grid[-1]:
        axes.set_xlabel("frames after the turn")
    figure.suptitle("error after a turn of the lamp; dotted: settled", fontsize=10)
    yield "ring", figure


if __name__ == "__main__":
    drawing.main(__doc__, "ring", draw)
