# SPDX-License-Identifier: GPL-2.0-or-later
"""Doorways, windows and portal arches: openings in walls with the frames around them."""

from brush import box
from carver import Skin
from material import GLASS, vigil

FRAME = vigil("metal_dark")
LINING = Skin(vigil("concrete"), vigil("tread"), vigil("concrete"))


def doorway(level, carver, lo, hi, frame=FRAME, lining=LINING, sill=False):
    """Cuts a box through a wall and sets a frame 8 wide into it that stands 4 proud of the wall.

    The opening's short horizontal side is the wall's depth. A sill makes it a window frame.
    """
    carver.room(lo, hi, lining)
    (x0, y0, z0), (x1, y1, z1) = lo, hi
    low = z0 + 6 if sill else z0
    if x1 - x0 < y1 - y0:
        parts = [((x0 - 4, y0 - 4, z0), (x1 + 4, y0 + 8, z1)),
                 ((x0 - 4, y1 - 8, z0), (x1 + 4, y1 + 4, z1)),
                 ((x0 - 4, y0 - 4, z1 - 8), (x1 + 4, y1 + 4, z1 + 4))]
        if sill:
            parts.append(((x0 - 6, y0 - 4, z0 - 4), (x1 + 6, y1 + 4, low)))
    else:
        parts = [((x0 - 4, y0 - 4, z0), (x0 + 8, y1 + 4, z1)),
                 ((x1 - 8, y0 - 4, z0), (x1 + 4, y1 + 4, z1)),
                 ((x0 - 4, y0 - 4, z1 - 8), (x1 + 4, y1 + 4, z1 + 4))]
        if sill:
            parts.append(((x0 - 4, y0 - 6, z0 - 4), (x1 + 4, y1 + 6, low)))
    level.add_detail(*[box(a, b, frame) for a, b in parts])


def window(level, carver, lo, hi, frame=FRAME, mullions=0):
    """A glazed opening: frame, one pane in the middle of the wall, upright bars."""
    doorway(level, carver, lo, hi, frame, sill=True)
    (x0, y0, z0), (x1, y1, z1) = lo, hi
    if x1 - x0 < y1 - y0:
        x = (x0 + x1) / 2
        level.add_detail(box((x - 1, y0 + 8, z0 + 6), (x + 1, y1 - 8, z1 - 8), GLASS))
        for i in range(mullions):
            y = y0 + (y1 - y0) * (i + 1) / (mullions + 1)
            level.add_detail(box((x - 3, y - 2, z0 + 6), (x + 3, y + 2, z1 - 8), frame))
    else:
        y = (y0 + y1) / 2
        level.add_detail(box((x0 + 8, y - 1, z0 + 6), (x1 - 8, y + 1, z1 - 8), GLASS))
        for i in range(mullions):
            x = x0 + (x1 - x0) * (i + 1) / (mullions + 1)
            level.add_detail(box((x - 2, y - 3, z0 + 6), (x + 2, y + 3, z1 - 8), frame))


def arch(level, axis, at, lo, hi, clear, material=vigil("concrete"), depth=16):
    """A structural portal across a passage: it splits visibility.

    axis is the direction of the passage; lo and hi are (across, z) corners of the passage;
    clear is (across from, across to, top) of what stays open.
    """
    (a0, z0), (a1, z1) = lo, hi
    c0, c1, top = clear

    def put(b0, b1, low, high):
        if b1 > b0 and high > low:
            if axis == "x":
                level.add(box((at, b0, low), (at + depth, b1, high), material))
            else:
                level.add(box((b0, at, low), (b1, at + depth, high), material))

    put(a0, c0, z0, z1)
    put(c1, a1, z0, z1)
    put(c0, c1, top, z1)
