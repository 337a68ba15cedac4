#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Pictures of one size side by side, as one file.

    python3 tools/docs/sheet.py TARGET COLUMNS PICTURE ...    # row by row
"""

import sys

from PIL import Image

GAP = 4


def save(target, rows, size):
    """Rows of pictures, None where one is missing, each brought to `size` (width, height)."""
    width, height = size
    columns = max(map(len, rows))
    sheet = Image.new("RGB", (columns * (width + GAP) - GAP, len(rows) * (height + GAP) - GAP), (24, 24, 24))
    for y, row in enumerate(rows):
        for x, picture in enumerate(row):
            if picture:
                if picture.size != size:
                    picture = picture.resize(size, Image.LANCZOS)
                sheet.paste(picture.convert("RGB"), (x * (width + GAP), y * (height + GAP)))
    sheet.save(target, quality=90, method=6)


def main(target, columns, *names):
    pictures = [Image.open(name).convert("RGB") for name in names]
    count = int(columns)
    save(target, [pictures[i:i + count] for i in range(0, len(pictures), count)], pictures[0].size)


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
