#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Draws error against time for every technique, after figure 8 of the paper, from the report of `run bench quality`: one
picture per level that has ratios of errors. What is further down and to the left is better; the dotted line joins what is as good at equal time."""

import numpy
from matplotlib import pyplot

import drawing


def draw(report):
    for part in report["parts"]:
        rows = [row for row in part["rows"] if None not in (row["frame_ms"]["ratio"]["value"], row["trimmed_mse"]["ratio"]["value"])]
        if not rows:
            continue # no error tells anything: docs/research/quality.md, Rare paths
        figure, axes = pyplot.subplots(figsize=(7.5, 4.2), layout="constrained")
        for row in rows:
            time, error = row["frame_ms"]["ratio"], row["trimmed_mse"].get("typical", row["trimmed_mse"]["ratio"])
            axes.errorbar(time["value"], error["value"], xerr=drawing.spread([time]), yerr=drawing.spread([error]), linestyle="",
                          color=drawing.color_of(row["label"]), marker=drawing.marker_of(row["label"]), capsize=2, label=row["label"])
        low, high = axes.get_xlim()
        times = numpy.linspace(max(low, 1e-3), high, 100)
        axes.plot(times, 1 / times, color="gray", linestyle=":", linewidth=1)
        axes.set_yscale("log")
        axes.set_xlabel(f"frame time over that of {part['baseline']}")
        axes.set_ylabel(f"trimmed MSE over that of {part['baseline']}")
        drawing.plain_axis(axes.yaxis)
        axes.set_title(f"{part['level']}: {len(part['views'])} views, {part['seeds']} seeds, {part['width']} x {part['height']}",
                       fontsize=10)
        axes.legend(fontsize=9, loc="center left", bbox_to_anchor=(1.01, 0.5))
        yield f"quality_{part['part']}", figure


if __name__ == "__main__":
    drawing.main(__doc__, "quality", draw)
