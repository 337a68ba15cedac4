# SPDX-License-Identifier: GPL-2.0-or-later
"""Parts that several halls and rooms of the level `warehouse` share: an even grid of places,
girders, pipes, floor markings, forklift trucks.
"""

import numpy as np

import lamp
from brush import beam, box, circle, cylinder, frustum, lying, prism
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


def pallet_truck(level, x, y, z, yaw=0.0):
    """A hand pallet truck, forks along +x before yaw; about 70 long."""
    paint, dark = vigil("metal_red"), vigil("black")
    parts = [box((x - 4, y - 13, z + 5), (x + 48, y - 5, z + 8), paint),
             box((x - 4, y + 5, z + 5), (x + 48, y + 13, z + 8), paint),
             box((x - 12, y - 13, z + 4), (x - 4, y + 13, z + 18), paint),
             box((x - 15, y - 5, z), (x - 8, y + 5, z + 6), dark),
             box((x + 40, y - 12, z), (x + 46, y - 6, z + 5), dark),
             box((x + 40, y + 6, z), (x + 46, y + 12, z + 5), dark),
             beam((x - 10, y, z + 18), (x - 22, y, z + 50), 3, 3, STEEL),
             box((x - 25, y - 9, z + 49), (x - 21, y + 9, z + 52), dark)]
    level.add_detail(*[p.turned(yaw, (x, y, z)) for p in parts])


def cone(level, x, y, z):
    """A traffic cone with a white band."""
    orange, white = vigil("metal_orange"), vigil("white")
    level.add_detail(box((x - 9, y - 9, z), (x + 9, y + 9, z + 2), orange))
    for low, high, r0, r1, paint in ((2, 10, 7, 5.4, orange), (10, 16, 5.4, 4.2, white),
                                     (16, 28, 4.2, 1.6, orange)):
        level.add_detail(frustum(
            np.column_stack([circle((x, y), r0, 8), np.full(8, float(z + low))]),
            np.column_stack([circle((x, y), r1, 8), np.full(8, float(z + high))]), paint))


def extinguisher(level, x, y, z, face):
    """A fire extinguisher on a wall at (x, y), its sign above; face is where it looks to."""
    dx, dy = {"+x": (6, 0), "-x": (-6, 0), "+y": (0, 6), "-y": (0, -6)}[face]
    red = vigil("metal_red")
    level.add_detail(cylinder((x + dx, y + dy), 5, z, z + 22, red, 8),
                     cylinder((x + dx, y + dy), 2, z + 22, z + 27, vigil("black"), 6))
    lo = (min(x, x + dx / 6) - abs(dy) * 1.3, min(y, y + dy / 6) - abs(dx) * 1.3, z + 40)
    hi = (max(x, x + dx / 6) + abs(dy) * 1.3, max(y, y + dy / 6) + abs(dx) * 1.3, z + 56)
    level.add_detail(box(lo, hi, red))


def cabinet(level, lo, hi, face, conduit):
    """A switch cabinet on a wall with a door and a conduit up to a height."""
    level.add_detail(box(lo, hi, {"all": vigil("metal_wall"), face: vigil("locker", fit=True)}))
    x, y = (lo[0] + hi[0]) / 2, (lo[1] + hi[1]) / 2
    level.add_detail(box((x - 1.5, y - 1.5, hi[2]), (x + 1.5, y + 1.5, conduit), STEEL))


def wrapped_pallet(level, x, y, z, height=60, yaw=0.0):
    """A pallet of cartons in even layers under straps."""
    carton = vigil("carton", fit=True)
    parts = []
    rows = max(1, round(height / 22))
    for row in range(rows):
        for i in (-1, 0, 1):
            for j in (-1, 1):
                if row == rows - 1 and (i + j) % 3 == 1:
                    continue
                parts.append(box((x + 18 * i - 8.8, y + 13.5 * j - 13.2, z + 9 + 22 * row),
                                 (x + 18 * i + 8.8, y + 13.5 * j + 13.2, z + 31 + 22 * row - .4),
                                 carton))
    top = z + 31 + 22 * (rows - 2) if rows > 1 else z + 31
    for d in (-17, 17):
        parts.append(box((x + d - 1, y - 27.3, z + 9), (x + d + 1, y + 27.3, top), STEEL))
    for dy in (-27, -4, 19):
        parts.append(box((x - 28, y + dy, z), (x + 28, y + dy + 8, z + 6), WOOD))
    parts.append(box((x - 28, y - 28, z + 6), (x + 28, y + 28, z + 9), WOOD))
    level.add_detail(*[p.turned(yaw, (x, y, z)) for p in parts])
