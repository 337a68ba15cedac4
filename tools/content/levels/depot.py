# SPDX-License-Identifier: GPL-2.0-or-later
"""Parts that several halls and rooms of the level `warehouse` share: an even grid of places,
girders, pipes, floor markings, forklift trucks.
"""

import numpy as np

import lamp
from brush import box, lying
from material import vigil

GIRDER = vigil("metal_red")
PIPE = vigil("rust")
STEEL = vigil("metal_dark")
BLUE = vigil("metal_blue")
WOOD = vigil("planks", scale=.25)
WHITE = vigil("white")
HAZARD = vigil("hazard", scale=.25)


def grid(room, columns, rows):
    """Evenly spread places over a room's plan."""
    x0, y0, x1, y1 = room[:4]
    return [(x0 + (x1 - x0) * (i + .5) / columns, y0 + (y1 - y0) * (j + .5) / rows)
            for i in range(columns) for j in range(rows)]


def girders(level, room, spacing, depth=20, width=10, along="y", material=GIRDER):
    """T-beams under a ceiling: web and lower flange."""
    x0, y0, x1, y1, _, z1, _ = room
    lo, hi = (x0, x1) if along == "y" else (y0, y1)
    count = int((hi - lo) // spacing)
    for i in range(count):
        at = lo + (hi - lo) * (i + .5) / count
        for half, low, high in ((2, z1 - depth + 3, z1), (width / 2, z1 - depth,
                                z1 - depth + 3)):
            if along == "y":
                level.add_detail(box((at - half, y0, low), (at + half, y1, high), material))
            else:
                level.add_detail(box((x0, at - half, low), (x1, at + half, high), material))


def pipe_run(level, axis, lo, hi, across, z, radius=5, material=PIPE):
    """A round pipe along an axis."""
    outline = [(across + radius * np.cos(a), z + radius * np.sin(a))
               for a in 2 * np.pi * (np.arange(6) + .5) / 6]
    if axis == "y":
        outline = [(-u, v) for u, v in outline]
    level.add_detail(lying(axis, lo, hi, outline, material))


def lanes(level, room, margin, along):
    """Two painted lines on the floor beside the way through a hall."""
    x0, y0, x1, y1, z0 = room[:5]
    paint = vigil("paint_yellow")
    if along == "x":
        for y in (y0 + margin, y1 - margin):
            level.add_detail(box((x0 + 8, y - 3, z0), (x1 - 8, y + 3, z0 + .25), paint))
    else:
        for x in (x0 + margin, x1 - margin):
            level.add_detail(box((x - 3, y0 + 8, z0), (x + 3, y1 - 8, z0 + .25), paint))


def forklift(level, x, y, z):
    """A forklift truck facing +x, about 100 long; its two headlamps shine."""
    dark, paint = vigil("black"), vigil("metal_orange")
    level.add_detail(box((x, y, z + 10), (x + 64, y + 40, z + 36), paint),
                     box((x, y + 4, z + 36), (x + 18, y + 36, z + 56), paint),
                     box((x + 22, y + 8, z + 36), (x + 40, y + 32, z + 42), dark),
                     box((x + 4, y + 2, z + 88), (x + 60, y + 38, z + 92), dark))
    for dx, dy in ((4, 2), (4, 35), (57, 2), (57, 35)):
        level.add_detail(box((x + dx, y + dy, z + 36), (x + dx + 3, y + dy + 3, z + 88), dark))
    for dy in (-4, 36):
        for dx in (6, 44):
            level.add_detail(lying("y", y + dy, y + dy + 8, [
                (-(x + dx + 8) + 9 * np.cos(a), z + 9 + 9 * np.sin(a))
                for a in 2 * np.pi * np.arange(10) / 10], dark))
    for dy in (8, 28):
        level.add_detail(box((x + 64, y + dy, z + 2), (x + 68, y + dy + 4, z + 100), dark),
                         box((x + 68, y + dy, z + 4), (x + 106, y + dy + 4, z + 7), dark))
        lamp.spot(level, (x + 64, y + dy - 5, z + 60), "+x", "lamp_warm", 500, 5)
