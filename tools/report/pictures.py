# SPDX-License-Identifier: GPL-2.0-or-later
"""Pictures of `run bench quality --pictures`, and where they differ from the reference as a person would see it: FLIP for high
dynamic range (Andersson et al. 2021)."""

import os
import sys
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

import flip_evaluator
import numpy
import OpenEXR
from PIL import Image, ImageDraw

import tables


@dataclass
class Run:
    """One frame of a row: linear radiance, the map of FLIP in colours, and its mean."""

    radiance: numpy.ndarray
    flip_map: numpy.ndarray
    flip: float


@dataclass
class View:
    """What one place looks like: the reference, and the runs of each row, by seed."""

    name: str
    paths: int
    reference: numpy.ndarray
    runs: dict = field(default_factory=dict)

    def displayed(self, radiance):
        """Linear radiance as it is shown: x / (1 + x) at the exposure of the reference, in sRGB."""
        value = radiance * (0.5 / max(float(numpy.median(self.reference.mean(axis=-1))), 1e-6))
        value = value / (1.0 + value)
        return numpy.where(value <= 0.0031308, 12.92 * value, 1.055 * value ** (1 / 2.4) - 0.055)


def load(path):
    """Linear radiance. Raises OSError that names the file."""
    try:
        file = OpenEXR.File(str(path))
    except RuntimeError as fault:
        raise OSError(f"{path}: no EXR picture that can be read") from fault
    with file:
        channels = file.channels()
        if "RGB" in channels:
            return numpy.ascontiguousarray(channels["RGB"].pixels, dtype=numpy.float32)
        return numpy.stack([channels[name].pixels for name in "RGB"], axis=-1).astype(numpy.float32)


def compare(reference, picture):
    """The run whose picture is at a path, against the reference at another."""
    radiance = load(picture)
    flip_map, flip, _ = flip_evaluator.evaluate(load(reference), radiance, "HDR")
    return Run(radiance, flip_map, flip)


def view_of(part, view, pool):
    """Whose runs are still being compared."""
    folder = Path(view["pictures"])
    found = View(view["name"], view["reference"]["paths"], load(folder / "reference.exr"))
    for row in part["rows"]:
        name = row["label"].replace("/", "_")
        found.runs[row["label"]] = [pool.submit(compare, folder / "reference.exr", folder / f"{name}_{seed}.exr")
                                    for seed in range(1, part["seeds"] + 1)]
    return found


def of_report(report):
    """Views by part, of the parts that have pictures; FLIP takes a second for each. Raises OSError where the files are gone."""
    if report["measured"] != "quality":
        return {}
    with ProcessPoolExecutor(os.cpu_count()) as pool:
        seen = {part["part"]: [view_of(part, view, pool) for view in part["views"]]
                for part in report["parts"] if all("pictures" in view for view in part["views"])}
        jobs = [(runs, seed) for views in seen.values() for view in views for runs in view.runs.values() for seed in range(len(runs))]
        for done, (runs, seed) in enumerate(jobs):
            print(f"\rFLIP, {done + 1} of {len(jobs)}", end="", file=sys.stderr)
            runs[seed] = runs[seed].result()
    if jobs:
        print(file=sys.stderr)
    return seen


def flip_table(seen):
    """Mean FLIP over the pixels of the typical frame: parts down, rows across."""
    labels = list(next(iter(seen.values()))[0].runs)
    lines = []
    for part, views in seen.items():
        flips = {label: [[run.flip for run in view.runs[label]] for view in views] for label in views[0].runs}
        lines.append([part, *(tables.cell((None, tables.typical_run(flips[label]))) if label in flips else "" for label in labels)])
    return ["Mean FLIP", *labels], lines


def middle(pixels):
    height, width = pixels.shape[:2]
    return pixels[height // 4 : height - height // 4, width // 4 : width - width // 4]


def save_sheet(view, path):
    """The middle of the reference and of the first run of each row, their maps of FLIP below, with names; 256 colours."""
    columns, line, gap = 5, 14, 4
    tiles = [("reference", view.reference, numpy.ones_like(view.reference))]
    tiles += [(label, runs[0].radiance, runs[0].flip_map) for label, runs in view.runs.items()]
    height, width = middle(view.reference).shape[:2]
    step = line + 2 * height + gap
    sheet = Image.new("RGB", (columns * (width + gap), -(-len(tiles) // columns) * step), "white")
    for i, (label, radiance, flip_map) in enumerate(tiles):
        x, y = i % columns * (width + gap), i // columns * step
        ImageDraw.Draw(sheet).text((x + 2, y + 1), label, "black")
        for row, pixels in enumerate((view.displayed(radiance), flip_map)):
            tile = numpy.clip(middle(pixels), 0.0, 1.0) * 255.0 + 0.5
            sheet.paste(Image.fromarray(tile.astype(numpy.uint8)), (x, y + line + row * height))
    sheet.quantize(256).save(path, optimize=True)
    print(path)
