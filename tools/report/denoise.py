#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Open Image Denoise on the raw pictures of a report of `./run bench picture --pictures FOLDER`: it sees one frame, with the albedo
and the normals of what camera rays met. Prints its errors beside those of the report's own rows, as Markdown, and writes
oidn_SEED.exr ("oidn TECHNIQUE_SEED.exr") into the folders.

    python3 tools/report/judge.py [--write] out/picture.json [MORE.json ...]    # --write: puts them into the reports, too

MSE and relative MSE are those of the bench (docs/research/quality.md); FLIP is that for high dynamic range, as on the page of reports.
Lamps that are seen are part of what is denoised here, while the filter adds them exactly: plain MSE is mostly about them."""

import json
import sys
import time
from pathlib import Path

import flip_evaluator
import numpy
import OpenEXR
import pyoidn

import pictures
import tables

RAW, JUDGE = "raw", "oidn"  # labels of rows begin so
MEASURES = {"MSE": "mse", "rel. MSE": "relative_mse", "FLIP": "flip"}  # and their names in reports


def denoised(folder, name):
    """What becomes of a raw picture, and how many milliseconds that takes."""
    color, albedo, normal = (pictures.load(folder / f"{part}.exr") for part in (name, "albedo", "normal"))
    started = time.perf_counter()
    picture = pyoidn.denoise(color, numpy.clip(albedo, 0.0, 1.0), normal, hdr=True, clean_aux=True)
    return picture, 1e3 * (time.perf_counter() - started)


def save(path, picture):
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    with OpenEXR.File(header, {"RGB": picture}) as file:
        file.write(str(path))


def errors(view, reference, picture):
    """Those of MEASURES."""
    known = view["reference"]
    squares = (picture.astype(numpy.float64) - reference) ** 2
    divisor = reference.astype(numpy.float64) ** 2 + (0.1 * known["mean"]) ** 2
    return (float(numpy.mean(squares)) - known["variance"], float(numpy.mean(squares / divisor)) - known["relative_variance"],
            flip_evaluator.evaluate(reference, picture, "HDR")[1])


def judge(part):
    """Runs by row, the judge's after those of the raw pictures: lists of (errors, the judge's milliseconds)."""
    runs = {}
    for view in part["views"]:
        folder = Path(view["pictures"])
        reference = pictures.load(folder / "reference.exr")
        for row in part["rows"]:
            label = row["label"]
            if label.startswith(JUDGE):
                continue
            for seed in range(1, part["seeds"] + 1):
                name = f"{label.replace('/', '_')}_{seed}"
                runs.setdefault(label, []).append((errors(view, reference, pictures.load(folder / f"{name}.exr")), None))
                if label.split()[0] != RAW:
                    continue
                picture, took_ms = denoised(folder, name)
                save(folder / f"{JUDGE}{name.removeprefix(RAW)}.exr", picture)
                runs.setdefault(JUDGE + label.removeprefix(RAW), []).append((errors(view, reference, picture), took_ms))
    return runs


def typical_ratio(own, baseline, measure):
    """To the baseline's run of the same view and seed."""
    return tables.median([run[0][measure] / other[0][measure] for run, other in zip(own, baseline)])


def write_rows(part, runs):
    """Puts these errors into the rows of a part of a report, as "judge": the mean, the typical run, and the typical ratio to the baseline. The
    judge has rows of its own."""
    rows = {row["label"]: row for row in part["rows"]}
    for label, own in runs.items():
        rows.setdefault(label, {"label": label})["judge"] = {
            key: {"value": sum(run[0][measure] for run in own) / len(own), "median": {"value": tables.median([run[0][measure] for run in own])},
                  "ratio": {"value": typical_ratio(own, runs[part["baseline"]], measure)}}
            for measure, key in enumerate(MEASURES.values())}
    part["rows"] = list(rows.values())


def table(part, runs):
    """Typical runs, and their ratios to the baseline."""
    lines = []
    for label, own in runs.items():
        cells = [label]
        for measure in range(len(MEASURES)):
            ratio = typical_ratio(own, runs[part["baseline"]], measure)
            cells.append(f"{tables.number(tables.median([run[0][measure] for run in own]))} ({tables.number(ratio)})")
        times = [took_ms for _, took_ms in own if took_ms is not None]
        lines.append([*cells, tables.number(tables.median(times)) if times else ""])
    return [part["part"], *(f"{name} (/ {part['baseline']})" for name in MEASURES), "ms of the judge"], lines


def main(arguments):
    paths = [argument for argument in arguments if argument != "--write"]
    if not paths:
        sys.exit(__doc__)
    for path in paths:
        try:
            report = tables.load(path, "picture")
            parts = [part for part in report["parts"] if part["views"] and all("pictures" in view for view in part["views"])]
            if not parts:
                sys.exit(f"{path}: no pictures; run the bench with --pictures FOLDER")
            print(f"{report['device']}, commit {report['commit']}\n")
            for part in parts:
                runs = judge(part)
                print(tables.markdown_table(*table(part, runs)), "\n")
                write_rows(part, runs)
            if "--write" in arguments:
                Path(path).write_text(json.dumps(report))
        except (OSError, ValueError) as fault:
            sys.exit(f"{path}: {fault}")


if __name__ == "__main__":
    main(sys.argv[1:])
