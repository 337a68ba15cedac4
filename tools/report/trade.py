#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Draws the front of time against error, one picture per level, from the report of `run bench trade`: every value of every
variable is a point, over the default of `vlc`; the front is what nothing else beats in both. A level without ratios of errors has
no picture."""

from matplotlib import pyplot

import drawing


def parts_by_level(report):
    levels = {}
    for part in report["parts"]:
        levels.setdefault(part["level"], []).append(part)
    return levels


def points(parts):
    """Label, time and error of every row of a level. Sweeps of a technique that is not the baseline of them all are brought
    there by what the part `techniques` says of it."""
    bases = {}
    for part in parts:
        if part["part"].endswith(" techniques"):
            for row in part["rows"]:
                bases[row["label"]] = (row["frame_ms"]["ratio"]["value"], row["trimmed_mse"]["ratio"]["value"])
    found = {}
    for part in parts:
        time_base, error_base = bases.get(part["baseline"], (1, 1))
        for row in part["rows"]:
            time, error = row["frame_ms"]["ratio"]["value"], row["trimmed_mse"]["ratio"]["value"]
            if None not in (time, error, time_base, error_base):
                found.setdefault(row["label"], (row["label"], time * time_base, error * error_base))
    return list(found.values())


def front(found):
    """The points that no other one beats in time and error, by time."""
    best, kept = float("inf"), []
    for point in sorted(found, key=lambda point: (point[1], point[2])):
        if point[2] < best:
            best = point[2]
            kept.append(point)
    return kept


def draw(report):
    for level, parts in parts_by_level(report).items():
        found = points(parts)
        if not found:
            continue # no error tells anything: docs/quality.md, Rare paths
        figure, axes = pyplot.subplots(figsize=(8.5, 5.5), layout="constrained")
        axes.scatter([time for _, time, _ in found], [error for _, _, error in found], s=12, color="0.6")
        kept = front(found)
        axes.step([time for _, time, _ in kept], [error for _, _, error in kept], where="post", color="C0", linewidth=1)
        named = {label for label, _, _ in kept} | {label for label, _, _ in found if "=" not in label}
        for label, time, error in found:
            if label in named:
                axes.scatter([time], [error], s=14, color="C0" if label in {name for name, _, _ in kept} else "C1")
                axes.annotate(label, (time, error), fontsize=7, xytext=(3, 3), textcoords="offset points")
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_xlabel("frame time over that of vlc")
        axes.set_ylabel("MSE without the largest 0.1%, likewise")
        axes.set_title(f"{level}: what each value costs and buys", fontsize=10)
        yield f"trade_{level}", figure


if __name__ == "__main__":
    drawing.main(__doc__, "trade", draw)
