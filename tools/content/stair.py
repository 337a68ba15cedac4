# SPDX-License-Identifier: GPL-2.0-or-later
"""Stairs with treads and a rail, as detail brushes."""

from brush import box, oblong
from material import vigil

import numpy as np

TREAD = vigil("tread")
RAIL = vigil("metal_orange")


def stairs(level, lo, hi, direction, steps, material=TREAD, rails=True):
    """Fills lo..hi with steps that climb towards a direction (+x, -x, +y, -y)."""
    (x0, y0, z0), (x1, y1, z1) = lo, hi
    rise = (z1 - z0) / steps
    for i in range(steps):
        top = z0 + (i + 1) * rise
        a, b = i / steps, 1.0
        if direction[0] == "-":
            a, b = 0.0, 1 - i / steps
        if direction[1] == "x":
            low, high = (x0 + a * (x1 - x0), y0, top - rise), (x0 + b * (x1 - x0), y1, top)
        else:
            low, high = (x0, y0 + a * (y1 - y0), top - rise), (x1, y0 + b * (y1 - y0), top)
        level.add_detail(box(low, high, material))
    if rails:
        for side in (0, 1):
            rail(level, (lo, hi), direction, side)


def rail(level, span, direction, side):
    """A sloping hand rail over one side of a flight."""
    (x0, y0, z0), (x1, y1, z1) = span
    up, forward = 36, direction[0] == "+"
    if direction[1] == "x":
        y = (y0 + 2, y1 - 2)[side]
        a, b = (x0, y, z0), (x1, y, z1)
        if not forward:
            a, b = (x1, y, z0), (x0, y, z1)
        right = np.array([0, 1.5, 0])
    else:
        x = (x0 + 2, x1 - 2)[side]
        a, b = (x, y0, z0), (x, y1, z1)
        if not forward:
            a, b = (x, y1, z0), (x, y0, z1)
        right = np.array([1.5, 0, 0])
    lift = np.array([0, 0, up])
    level.add_detail(oblong(np.array(a, float) + lift, np.array(b, float) + lift, right,
                            np.array([0, 0, 1.5]), RAIL))
    for t in (.02, .5, .98):
        p = np.array(a, float) + t * (np.array(b, float) - a)
        level.add_detail(box(p - [1.5, 1.5, 0], p + [1.5, 1.5, up], RAIL))


def railing(level, a, b, height=40, posts=4, material=RAIL):
    """A level railing from a to b (axis-aligned) with posts."""
    a, b = np.array(a, float), np.array(b, float)
    thick = np.array([1.5, 1.5, 0])
    for up in (height, height * .5):
        lo, hi = np.minimum(a, b) - thick, np.maximum(a, b) + thick
        lo[2] += up - 3
        hi[2] = lo[2] + 3
        level.add_detail(box(lo, hi, material))
    for i in range(posts):
        p = a + (b - a) * i / (posts - 1)
        level.add_detail(box(p - thick, p + thick + [0, 0, height - 3], material))
