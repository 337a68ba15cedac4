#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The levels' pictures as they were, from the history of this repository, beside those of today.

    python3 tools/docs/before_after.py docs/images/before_after.webp
"""

import io
import subprocess
import sys
from pathlib import Path

from PIL import Image

IMAGES = Path(__file__).resolve().parents[2] / "docs/images"
BEFORE = {"warehouse": "41011f5^", "mine": "41011f5^", "gallery": "41011f5^", "many_1000": "8c10f06", "yard": "2c64318^", "room": "4fa1b31^", "quay": None}
WIDTH, HEIGHT, GAP = 360, 202, 4


def main(target):
    sheet = Image.new("RGB", (2 * WIDTH + GAP, len(BEFORE) * (HEIGHT + GAP) - GAP), (24, 24, 24))
    for row, (level, commit) in enumerate(BEFORE.items()):
        pictures = [None, (IMAGES / f"{level}.png").read_bytes()]
        if commit:
            pictures[0] = subprocess.run(["git", "show", f"{commit}:docs/images/{level}.png"], cwd=IMAGES, stdout=subprocess.PIPE, check=True).stdout
        for column, data in enumerate(pictures):
            if data:
                picture = Image.open(io.BytesIO(data)).convert("RGB").resize((WIDTH, HEIGHT), Image.LANCZOS)
                sheet.paste(picture, (column * (WIDTH + GAP), row * (HEIGHT + GAP)))
    sheet.save(target, quality=88, method=6)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
