#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Draws cost and error against the number of lights, of pixels and of triangles, from the report of `run bench scale`."""

from matplotlib import pyplot, ticker

import drawing

# Axis, and what of a part stands on it.
AXES = {
    "lights": ("lights", lambda part: part["lights"]),
    "resolution": ("pixels", lambda part: part["width"] * part["height"]),
    "triangles": ("triangles", lambda part: part["triangles"]),
}


def axis_of(part):
    return next(name for name in AXES if name in part["part"].split()[0])


def draw(report):
    axes_here = [name for name in AXES if any(axis_of(part) == name for part in report["parts"])]
    figure, grid = pyplot.subplots(2, len(axes_here), figsize=(4.8 * len(axes_here), 7.5), squeeze=False, layout="constrained")
    for column, name in enumerate(axes_here):
        title, value_of = AXES[name]
        parts = sorted((part for part in report["parts"] if axis_of(part) == name), key=value_of)
        places = [value_of(part) for part in parts]
        for label in (row["label"] for row in parts[0]["rows"]):
            rows = [next(row for row in part["rows"] if row["label"] == label) for part in parts]
            for line, values in enumerate(([drawing.typical(row[measure]) for row in rows] for measure in ("frame_ms", "trimmed_mse"))):
                grid[line][column].errorbar(places, drawing.numbers(values), yerr=drawing.spread(values), marker="o",
                                            markersize=4, capsize=2, color=drawing.color_of(label), linestyle=drawing.line_of(label), label=label)
        for line in range(2):
            grid[line][column].set_xscale("log")
            grid[line][column].set_yscale("log")
            grid[line][column].set_xticks(places)
            grid[line][column].xaxis.set_major_formatter(drawing.PLAIN)
            grid[line][column].xaxis.set_minor_formatter(ticker.NullFormatter())
            drawing.plain_axis(grid[line][column].yaxis)
            grid[line][column].tick_params(labelsize=9)
            grid[line][column].set_xlabel(title)
    grid[0][0].set_ylabel("milliseconds of a frame")
    grid[1][0].set_ylabel("trimmed MSE")
    grid[0][0].legend(fontsize=10)
    yield "scale", figure


if __name__ == "__main__":
    drawing.main(__doc__, "scale", draw)
