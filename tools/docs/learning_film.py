#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Makes the film of caches that learn: pictures of one view frame by frame, under the borders of the octree's leaves.

    python3 tools/docs/learning_film.py FOLDER OUT.webp

FOLDER holds picture_00.png, picture_01.png ... and octree_00.png ... of the same frames (pt_view octree). tools/pictures makes them."""

import sys
from pathlib import Path

import numpy
from PIL import Image

FIRST_MS, LATER_MS, LAST_MS = 900, 220, 2500
BORDER = numpy.array([120.0, 200.0, 255.0])
SHARE = 0.3  # of a border's colour


def with_borders(picture, octree):
    """The picture, with a thin line where neighbouring pixels lie in different leaves."""
    edges = numpy.zeros(octree.shape[:2], bool)
    edges[:, 1:] |= (octree[:, 1:] != octree[:, :-1]).any(axis=2)
    edges[1:, :] |= (octree[1:, :] != octree[:-1, :]).any(axis=2)
    result = picture.astype(float)
    result[edges] = (1 - SHARE) * result[edges] + SHARE * BORDER
    return Image.fromarray(result.astype(numpy.uint8))


def load(path):
    return numpy.asarray(Image.open(path).convert("RGB"))


def main(folder, out):
    films = [with_borders(load(path), load(path.with_name(path.name.replace("picture", "octree"))))
             for path in sorted(Path(folder).glob("picture_*.png"))]
    durations = [FIRST_MS] + [LATER_MS] * (len(films) - 2) + [LAST_MS]
    films[0].save(out, save_all=True, append_images=films[1:], duration=durations, loop=0, quality=70, method=6)
    print(f"{out}: {len(films)} frames, {Path(out).stat().st_size / 1e6:.2f} MB")


if __name__ == "__main__":
    main(*sys.argv[1:])
