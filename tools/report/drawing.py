# SPDX-License-Identifier: GPL-2.0-or-later
"""What the plots of `run bench` share: the command line of each, and how values with intervals are drawn. The plots compute
nothing: means, ratios and intervals are those of the reports."""

import argparse
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot, ticker

from tables import load
from colors import color_of, line_of, marker_of  # what plots ask for

PLAIN = ticker.FuncFormatter(lambda value, _: f"{value:,.10g}")


def plain_axis(axis):
    """A logarithmic axis with numbers as people write them."""
    axis.set_major_locator(ticker.LogLocator(subs=(1, 2, 5)))
    axis.set_major_formatter(PLAIN)
    axis.set_minor_formatter(ticker.NullFormatter())


def name_line(axes, x, y, label, color):
    """Writes a line's name behind its end, in its colour."""
    axes.annotate(label, (x, y), xytext=(4, 0), textcoords="offset points", color=color, fontsize=8, va="center", annotation_clip=False)


def typical(value):
    """A measure's median over its runs, which has an interval; older reports have the mean alone."""
    return value.get("median", value)


def spread(values):
    """Distances to the ends of intervals, as errorbar wants them; 0 where an interval has no end."""
    low = [0 if value.get("low") is None else max(0, value["value"] - value["low"]) for value in values]
    high = [0 if value.get("high") is None else max(0, value["high"] - value["value"]) for value in values]
    return [low, high]


def numbers(values):
    """Values of intervals; those that do not exist are left out of lines."""
    return [float("nan") if value["value"] is None else value["value"] for value in values]


def curve(axes, frames, values, color, **options):
    """The typical run and the band of its intervals, and dots for the means. Without an end (few views or seeds) no band is drawn,
    and a logarithmic axis cuts those below zero."""
    medians = [typical(value) for value in values]
    axes.plot(frames, numbers(medians), color=color, **options)
    axes.plot(frames, numbers(values), color=color, marker=".", linestyle="", markersize=4)
    if any(value.get("low") is None or value.get("high") is None for value in medians):
        return
    positive = [value["value"] for value in medians if value["value"] > 0]
    smallest = 0.3 * min(positive) if positive else 0
    axes.fill_between(frames, [max(value["low"], smallest) for value in medians], [value["high"] for value in medians],
                      color=color, alpha=0.2, linewidth=0)


def save(figures, folder):
    """Writes figures, as pairs of a name and a figure, and says where."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, figure in figures:
        path = folder / f"{name}.png"
        figure.savefig(path, dpi=110)
        pyplot.close(figure)
        print(path)


def main(description, measured, draw):
    """The program of one plot: `draw` makes figures of a report."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("report", type=Path, help=f"{measured}.json")
    parser.add_argument("--out", type=Path, help="folder for the pictures; default: that of the report")
    arguments = parser.parse_args()
    try:
        report = load(arguments.report, measured)
    except (OSError, ValueError) as fault:
        parser.error(str(fault))
    save(draw(report), arguments.out or arguments.report.parent)
