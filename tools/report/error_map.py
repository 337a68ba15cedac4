#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Where in the picture a row's squared error is: on the borders of what is bright, inside, and elsewhere. Bright is above 0.3 of the
reference's brightest pixel; on a border are pixels whose neighbourhood of 3 x 3 has a bright one and one below 0.6 of the brightest there. One path per pixel
sees a pixel on a border bright or dark: its error is that of the picture, whatever chose the light.

    ./run bench quality ... --pictures out/pictures
    python3 tools/report/error_map.py out/quality.json ROW [OUT.json]    # prints a table; OUT.json gets its numbers
"""

import json
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent


def neighbourhood(values, extreme):
    """Largest or smallest value of the 3 x 3 pixels around each."""
    height, width = values.shape
    padded = numpy.pad(values, 1, mode="edge")
    return extreme([padded[y : y + height, x : x + width] for y in range(3) for x in range(3)], axis=0)


def parts_of(reference):
    """Masks of the picture's parts by name."""
    brightness = reference.mean(axis=-1)
    most, least = neighbourhood(brightness, numpy.max), neighbourhood(brightness, numpy.min)
    limit = 0.3 * brightness.max()
    border = (most > limit) & (least < 0.6 * most)
    inside = (brightness > limit) & ~border
    return {"border": border, "inside": inside, "elsewhere": ~border & ~inside}


def main(arguments):
    if len(arguments) not in (2, 3):
        sys.exit(__doc__)
    report, row = tables.load(arguments[0], "quality"), arguments[1]
    parts = []
    for part in report["parts"]:
        rows = []
        for view in part["views"]:
            folder = Path(view.get("pictures", ""))
            runs = sorted(folder.glob(f"{row}_*.exr"))
            if not runs:
                sys.exit(f"{arguments[0]}: no pictures of row {row}: measure with --pictures")
            reference = load(folder / "reference.exr")
            error = numpy.mean([((load(run) - reference) ** 2).mean(axis=-1) for run in runs], axis=0)
            scale = error.size * float(reference.mean()) ** 2
            masks = parts_of(reference)
            rows.append({"label": view["name"]} | {name: {"pixels": int(mask.sum()), "value": float(error[mask].sum() / scale)} for name, mask in masks.items()})
        parts.append({"part": part["part"], "rows": rows})
    print("| view | " + " | ".join(f"{name}: pixels, MSE / mean²" for name in ("border", "inside", "elsewhere")) + " |")
    print("| --- | --- | --- | --- |")
    for part in parts:
        for line in part["rows"]:
            print(f"| {part['part']}, {line['label']} | " + " | ".join(f"{cell['pixels']}, {cell['value']:.3g}" for cell in list(line.values())[1:]) + " |")
    if len(arguments) == 3:
        Path(arguments[2]).write_text(json.dumps({key: report[key] for key in ("commit", "device", "width", "height")} | {"measured": "error map", "parts": parts}))


if __name__ == "__main__":
    try:
        import numpy
        import tables
        from pictures import load
    except ImportError:
        sys.path.insert(0, str(HERE.parent))
        from python_environment import run_with

        sys.exit(run_with(HERE / "requirements.txt", "report", "error maps", HERE / "error_map.py", sys.argv[1:]))
    main(sys.argv[1:])
