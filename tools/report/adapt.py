#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Draws error over frames from empty caches, after figure 9 of the paper, from the report of `run bench adapt`: one picture
per level. Lines are typical runs, dots are means, of which the frame where a row settles is found."""

from matplotlib import pyplot

import drawing

LABELS = {"mse": "MSE", "trimmed_mse": "trimmed MSE"}
# Techniques that learn nothing from frame to frame are drawn as one level.
LEVEL_ROWS = ("sll", "lh", "ris", "uniform", "power")


def draw_row(axes, row, measure, color):
    curve = row[measure]
    if row["label"] in LEVEL_ROWS:
        axes.axhline(curve["settled"], color=color, label=row["label"])
        return
    frames = range(1, len(curve["frames"]) + 1)
    drawing.curve(axes, frames, curve["frames"], color, linestyle=drawing.line_of(row["label"]), label=row["label"])
    axes.axhline(curve["settled"] * curve["settled_factor"], color=color, linestyle=":", linewidth=1)
    if curve["settled_frame"] <= len(curve["frames"]):
        axes.axvline(curve["settled_frame"], color=color, linestyle=":", linewidth=1)


def draw(report):
    for part in report["parts"]:
        figure, grid = pyplot.subplots(1, len(LABELS), figsize=(11, 4), layout="constrained")
        for axes, (measure, label) in zip(grid, LABELS.items()):
            for row in part["rows"]:
                draw_row(axes, row, measure, drawing.color_of(row["label"]))
            axes.set_yscale("log")
            drawing.plain_axis(axes.yaxis)
            axes.set_xlabel("frame from an empty cache")
            axes.set_ylabel(label)
            axes.legend()
        figure.suptitle(f"{part['level']}: {len(part['views'])} views, {part['seeds']} seeds, "
                        f"{part['width']} x {part['height']}, 1 sample per pixel")
        yield f"adapt_{part['part']}", figure


if __name__ == "__main__":
    drawing.main(__doc__, "adapt", draw)
