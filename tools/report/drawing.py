# SPDX-License-Identifier: GPL-2.0-or-later
"""What the plots of `run bench` share: the command line of each, and how values with intervals are drawn. The plots compute
nothing: means, ratios and intervals are those of the reports."""

import argparse
import json
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot


def load(path, measured):
    """The report at a path, which must be one of `measured` with a part in it. Raises ValueError."""
    report = json.loads(Path(path).read_text())
    if report.get("measured") != measured:
        raise ValueError(f"{path}: not a report of `run bench {measured}`")
    if not report.get("parts"):
        raise ValueError(f"{path}: nothing has been measured yet")
    return report


def spread(values):
    """Distances to the ends of intervals, as errorbar wants them; 0 where an interval has no end."""
    low = [0 if value["low"] is None else max(0, value["value"] - value["low"]) for value in values]
    high = [0 if value["high"] is None else max(0, value["high"] - value["value"]) for value in values]
    return [low, high]


def numbers(values):
    """Values of intervals; those that do not exist are left out of lines."""
    return [float("nan") if value["value"] is None else value["value"] for value in values]


def fill(axes, frames, values, color):
    """The band of the intervals; without an end (one seed) none is drawn, and a logarithmic axis cuts those below zero."""
    if any(value["low"] is None or value["high"] is None for value in values):
        return
    positive = [value["value"] for value in values if value["value"] > 0]
    smallest = 0.3 * min(positive) if positive else 0
    axes.fill_between(frames, [max(value["low"], smallest) for value in values], [value["high"] for value in values],
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
