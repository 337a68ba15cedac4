#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Draws what frames cost while the camera moves, after figures 11 (preparation by pass) and 12 (path tracing by technique) of
the paper, from the report of `run bench timing`: one picture per level."""

from matplotlib import pyplot

import drawing


def draw_preparation(axes, row):
    passes = row["pass_frames_ms"]
    frames = range(1, 1 + max((len(times) for times in passes.values()), default=0))
    axes.stackplot(frames, list(passes.values()), labels=list(passes))
    axes.set_title(f"preparation for {row['label']}: milliseconds of a frame", fontsize=10)
    axes.set_ylabel("ms")
    axes.legend(fontsize=7, loc="lower right", framealpha=0.9)


def draw_paths(axes, rows):
    for row in rows:
        times = row["path_ms"]["frames"]
        axes.plot(range(1, len(times) + 1), times, color=drawing.color_of(row["label"]), linestyle=drawing.line_of(row["label"]), label=row["label"])
        drawing.name_line(axes, len(times), times[-1], row["label"], drawing.color_of(row["label"]))
    axes.set_ylim(bottom=0)
    axes.set_title("path tracing: milliseconds of a frame", fontsize=10)


def draw(report):
    for part in report["parts"]:
        prepared = [row for row in part["rows"] if row["pass_frames_ms"]]
        figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4), layout="constrained")
        if prepared:
            draw_preparation(left, prepared[-1])
        draw_paths(right, part["rows"])
        for axes in (left, right):
            axes.set_xlabel("frame")
        figure.suptitle(f"{part['level']}: {part['width']} x {part['height']}, medians of {part['seeds']} flights")
        yield f"timing_{part['part']}", figure


if __name__ == "__main__":
    drawing.main(__doc__, "timing", draw)
