#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Makes the film of caches that learn, of pictures of one view frame by frame.

    python3 tools/docs/learning_film.py FOLDER OUT.webp

FOLDER holds picture_00.png, picture_01.png ... tools/pictures makes them."""

import sys
from pathlib import Path

from PIL import Image

FIRST_MS, LATER_MS, LAST_MS = 900, 220, 2500


def main(folder, out):
    films = [Image.open(path).convert("RGB") for path in sorted(Path(folder).glob("picture_*.png"))]
    durations = [FIRST_MS] + [LATER_MS] * (len(films) - 2) + [LAST_MS]
    films[0].save(out, save_all=True, append_images=films[1:], duration=durations, loop=0, quality=70, method=6)
    print(f"{out}: {len(films)} frames, {Path(out).stat().st_size / 1e6:.2f} MB")


if __name__ == "__main__":
    main(*sys.argv[1:])
