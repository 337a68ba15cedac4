# SPDX-License-Identifier: GPL-2.0-or-later
"""Lamps: fixtures whose emissive sides face the room, as detail brushes.

Each function hangs one fixture; `value` is the surface value of the emissive sides (radiance is the
texture's average linear colour * value * 0.1). Numbers in brackets say how many emissive faces a
fixture has.
"""

from brush import box, circle, frustum
from material import vigil

import numpy as np

STEEL = vigil("metal_dark")
IRON = vigil("rust")
CREAM = vigil("white")


def tube(level, x, y, ceiling, axis="x", texture="lamp_cool", value=500, length=64, drop=0,
         pair=False):
    """A fluorescent fixture under a ceiling, hanging drop units below it [1, pair: 2]."""
    z = ceiling - drop
    light = vigil(texture).emissive(value).fitted()
    half = length / 2
    if axis == "y":
        light = light.turned()

    def across(low, high, lo, hi, materials):
        if axis == "x":
            return box((x - half, y + low, lo), (x + half, y + high, hi), materials)
        return box((x + low, y - half, lo), (x + high, y + half, hi), materials)

    if pair:
        level.add_detail(across(-3, 3, z - 5, z, CREAM))
    for row in (-9, 9) if pair else (0,):
        level.add_detail(across(row - 6, row + 6, z - 8, z, {"all": CREAM, "bottom": light}))
    if drop:
        for at in (-half * .7, half * .7):
            dx, dy = (at, 0) if axis == "x" else (0, at)
            level.add_detail(box((x + dx - 1, y + dy - 1, z), (x + dx + 1, y + dy + 1, ceiling),
                                 STEEL))


def panel(level, x, y, ceiling, size=48, texture="lamp_panel", value=150):
    """A square panel set into a suspended ceiling, framed [1]."""
    h = size / 2
    light = vigil(texture).emissive(value).fitted()
    level.add_detail(box((x - h, y - h, ceiling - 2), (x + h, y + h, ceiling),
                         {"all": CREAM, "bottom": light}))
    for a, b in (((-h - 3, -h - 3), (h + 3, -h)), ((-h - 3, h), (h + 3, h + 3)),
                 ((-h - 3, -h), (-h, h)), ((h, -h), (h + 3, h))):
        level.add_detail(box((x + a[0], y + a[1], ceiling - 4), (x + b[0], y + b[1], ceiling),
                             CREAM))


def high_bay(level, x, y, ceiling, drop=40, texture="lamp_sodium", value=400):
    """A hall lamp: a square reflector, 31 wide, on a rod; shines downwards [1]."""
    z = ceiling - drop
    low = np.column_stack([circle((x, y), 22, 4), np.full(4, z - 16.0)])
    high = np.column_stack([circle((x, y), 8, 4), np.full(4, float(z))])
    light = vigil(texture).emissive(value).fitted()
    level.add_detail(frustum(low, high, {"all": vigil("metal_green"), "bottom": light}),
                     box((x - 2, y - 2, z), (x + 2, y + 2, ceiling), STEEL))


def bulkhead(level, point, face, texture="lamp_warm", value=300, size=(20, 12),
             hood=True):
    """A wall lamp under a hood at a point of a wall; face names the direction it looks to [1]."""
    light = vigil(texture).emissive(value).fitted()
    w, h = size[0] / 2, size[1] / 2
    x, y, z = point
    reach = {"+x": (1, 0), "-x": (-1, 0), "+y": (0, 1), "-y": (0, -1)}[face]

    def plate(half_w, half_h, near, far, materials):
        dx, dy = reach
        a = (x + dx * near - abs(dy) * half_w, y + dy * near - abs(dx) * half_w)
        b = (x + dx * far + abs(dy) * half_w, y + dy * far + abs(dx) * half_w)
        lo = (min(a[0], b[0]), min(a[1], b[1]), z - half_h)
        hi = (max(a[0], b[0]), max(a[1], b[1]), z + half_h)
        return box(lo, hi, materials)

    level.add_detail(plate(w, h, 0, 6, {"all": CREAM, face: light}))
    if hood:
        lo, hi = plate(w + 2, h, 0, 9, STEEL).bounds()
        level.add_detail(box((lo[0], lo[1], hi[2]), (hi[0], hi[1], hi[2] + 2), STEEL))


def spot(level, point, face, texture, value=400, size=6):
    """A small signal lamp [1]."""
    bulkhead(level, point, face, texture, value, (size, size), False)


def strip(level, lo, hi, face, texture="lamp_warm", value=200):
    """A bare light strip: a box one side of which shines [1]."""
    level.add_detail(box(lo, hi, {"all": CREAM, face: vigil(texture).emissive(value).fitted()}))


def lantern(level, x, y, z, value=300):
    """An oil lamp on a hook: four panes between a foot and a cap [4]."""
    light = vigil("lamp_sodium").emissive(value).fitted()
    level.add_detail(box((x - 1, y - 1, z - 12), (x + 1, y + 1, z), IRON),
                     box((x - 5, y - 5, z - 15), (x + 5, y + 5, z - 12), IRON),
                     box((x - 4, y - 4, z - 26), (x + 4, y + 4, z - 15),
                         {"all": IRON, "side": light}),
                     box((x - 5, y - 5, z - 28), (x + 5, y + 5, z - 26), IRON))


def lamp_post(level, x, y, z, value=400, height=112):
    """A street lamp: stone foot, iron post, a lantern of four panes under a pointed cap [4]."""
    light = vigil("lamp_warm").emissive(value).fitted()
    top = z + height
    level.add_detail(box((x - 8, y - 8, z - 16), (x + 8, y + 8, z + 8), vigil("rubble")),
                     box((x - 3, y - 3, z + 8), (x + 3, y + 3, top - 4), STEEL),
                     box((x - 8, y - 8, top - 4), (x + 8, y + 8, top), STEEL),
                     box((x - 6, y - 6, top), (x + 6, y + 6, top + 18),
                         {"all": STEEL, "side": light}))
    for dx in (-1, 1):
        for dy in (-1, 1):
            level.add_detail(box((x + 7 * dx - 1, y + 7 * dy - 1, top),
                                 (x + 7 * dx + 1, y + 7 * dy + 1, top + 18), STEEL))
    low = np.column_stack([circle((x, y), 14, 4), np.full(4, top + 18.0)])
    high = np.column_stack([circle((x, y), 3, 4), np.full(4, top + 30.0)])
    level.add_detail(frustum(low, high, STEEL))
