#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The levels' pictures as they were, from the history of this repository, beside those of today.

    /usr/bin/python3 tools/docs/before_after.py docs/images/before_after.webp
"""

import io
import subprocess
import sys
from pathlib import Path

import sheet
from PIL import Image

IMAGES = Path(__file__).resolve().parents[2] / "docs/images"
BEFORE = {"warehouse": "41011f5^", "mine": "41011f5^", "gallery": "41011f5^", "many_1000": "8c10f06", "yard": "2c64318^", "room": "4fa1b31^", "quay": None}
SIZE = (360, 202)


def picture(data):
    return Image.open(io.BytesIO(data)).convert("RGB")


def before(level, commit):
    shown = subprocess.run(["git", "show", f"{commit}:docs/images/{level}.png"], cwd=IMAGES, stdout=subprocess.PIPE, check=True)
    return picture(shown.stdout)


def main(target):
    rows = [[before(level, commit) if commit else None, picture((IMAGES / f"{level}.png").read_bytes())] for level, commit in BEFORE.items()]
    sheet.save(target, rows, SIZE)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
