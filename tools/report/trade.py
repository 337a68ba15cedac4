#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Draws the front of time against error, one picture per level, from the report of `run bench trade`: every value of every
variable is a point, over the default of `vlc`; the front is what nothing else beats in both. A level without ratios of errors has
no picture."""

from matplotlib import pyplot, ticker

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


def rows_for(heights, gap):
    """Heights in [0, 1], highest first, moved apart until `gap` lies between neighbours: each as low as the one above
    demands, then as high as the bottom demands."""
    placed = []
    for height in heights:
        placed.append(min(height, placed[-1] - gap) if placed else height)
    floor = 0
    for i in reversed(range(len(placed))):
        placed[i] = max(placed[i], floor)
        floor = placed[i] + gap
    return placed


def label(axes, named):
    """Names of points in a column to the right of the axes, from the largest error down, each with a line to its point."""
    named = sorted(named, key=lambda point: -point[2])
    to_axes = axes.transData + axes.transAxes.inverted()
    heights = [to_axes.transform((time, error))[1] for _, time, error in named]
    for (name, time, error), height in zip(named, rows_for(heights, 0.036)):
        axes.annotate(name, (time, error), xytext=(1.04, height), textcoords="axes fraction", fontsize=9, color=drawing.color_of(name) if "=" not in name else "0.15", va="center",
                      arrowprops={"arrowstyle": "-", "color": "0.75", "linewidth": 0.5, "shrinkA": 0, "shrinkB": 2,
                                  "relpos": (0, 0.5)})


def draw(report):
    for level, parts in parts_by_level(report).items():
        found = points(parts)
        if not found:
            continue # no error tells anything: docs/research/quality.md, Rare paths
        figure, axes = pyplot.subplots(figsize=(10, 7.5), layout="constrained")
        kept = front(found)
        rest = [point for point in found if point not in kept]
        named = [point for point in rest if "=" not in point[0]]
        axes.scatter([time for _, time, _ in rest], [error for _, _, error in rest], s=13, color="0.6", zorder=3)
        for name, time, error in named + [point for point in kept if "=" not in point[0]]:
            axes.scatter(time, error, s=28, color=drawing.color_of(name), marker=drawing.marker_of(name), zorder=4)
        axes.scatter([time for _, time, _ in kept], [error for _, _, error in kept], s=16, color="0.1", zorder=3)
        axes.step([time for _, time, _ in kept], [error for _, _, error in kept], where="post", color="0.1", linewidth=1)
        axes.set_xscale("log")
        axes.set_yscale("log")
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_locator(ticker.LogLocator(subs=(1, 2, 3, 5, 7)))
            axis.set_major_formatter("{x:g}")
            axis.set_minor_formatter(ticker.NullFormatter())
        axes.set_xlabel("frame time over that of vlc")
        axes.set_ylabel("trimmed MSE over that of vlc")
        axes.set_title(f"{level}: what each value costs and buys (black: the front; colours: techniques and presets)", fontsize=10)
        label(axes, kept + named)
        yield f"trade_{level}", figure


if __name__ == "__main__":
    drawing.main(__doc__, "trade", draw)
