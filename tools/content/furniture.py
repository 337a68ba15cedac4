# SPDX-License-Identifier: GPL-2.0-or-later
"""Furniture as detail brushes: tables, chairs, beds, shelves of books, chests, easels, rugs."""

import numpy as np

from brush import Brush, Side, beam, box
from material import vigil

OAK = vigil("beam", scale=.35)
PLANK = vigil("planks", scale=.25)
WALNUT = vigil("walnut")
LINEN = vigil("linen", scale=.25)


def table(level, lo, hi, z, height=32, wood=OAK):
    """A table with four legs over a rectangle."""
    (x0, y0), (x1, y1) = lo, hi
    top = z + height
    level.add_detail(box((x0, y0, top - 3), (x1, y1, top), wood),
                     box((x0 + 5, y0 + 5, top - 8), (x1 - 5, y1 - 5, top - 3), wood))
    for x in (x0 + 3, x1 - 8):
        for y in (y0 + 3, y1 - 8):
            level.add_detail(box((x, y, z), (x + 5, y + 5, top - 3), wood.turned()))


def chair(level, x, y, z, yaw, wood=WALNUT):
    """A chair that looks along yaw."""
    parts = [box((x - 9, y - 9, z + 16), (x + 9, y + 9, z + 18), wood)]
    for dx in (-9, 7):
        for dy in (-9, 7):
            high = 38 if dx < 0 else 16
            parts.append(box((x + dx, y + dy, z), (x + dx + 2, y + dy + 2, z + high), wood))
    for low in (24, 31):
        parts.append(box((x - 8.5, y - 7, z + low), (x - 7.5, y + 7, z + low + 5), wood))
    level.add_detail(*[p.turned(yaw, (x, y, z)) for p in parts])


def stool(level, x, y, z):
    level.add_detail(box((x - 8, y - 8, z + 18), (x + 8, y + 8, z + 21), OAK))
    for dx in (-7, 4):
        for dy in (-7, 4):
            level.add_detail(box((x + dx, y + dy, z), (x + dx + 3, y + dy + 3, z + 18), OAK))


def bed(level, lo, hi, z):
    """A bed along y with its head at the high end."""
    (x0, y0), (x1, y1) = lo, hi
    level.add_detail(box((x0, y0, z + 8), (x1, y1, z + 14), WALNUT),
                     box((x0 + 2, y0 + 3, z + 14), (x1 - 2, y1 - 4, z + 22), LINEN),
                     box((x0 + 1, y0 + 2, z + 16), (x1 - 1, y0 + (y1 - y0) * .6, z + 24),
                         vigil("plaster_blue", scale=.25)),
                     box((x0 + 8, y1 - 24, z + 22), (x1 - 8, y1 - 5, z + 27), LINEN),
                     box((x0, y1 - 3, z), (x1, y1, z + 44), WALNUT),
                     box((x0, y0, z), (x1, y0 + 3, z + 26), WALNUT))


def bookcase(level, lo, hi, face):
    """A bookcase that fills a box; face ('+x', ...) shows the books, of four shelves."""
    (x0, y0, z0), (x1, y1, z1) = lo, hi
    level.add_detail(box((x0, y0, z0), (x1, y1, z0 + 6), WALNUT),
                     box((x0, y0, z1 - 4), (x1, y1, z1), WALNUT))
    thin = 3
    if face[1] == "x":
        inner = ((x0 + (0 if face[0] == "+" else 2), y0 + thin), (x1 - (2 if face[0] == "+" else 0),
                                                                 y1 - thin))
        ends = (((x0, y0), (x1, y0 + thin)), ((x0, y1 - thin), (x1, y1)))
    else:
        inner = ((x0 + thin, y0 + (0 if face[0] == "+" else 2)),
                 (x1 - thin, y1 - (2 if face[0] == "+" else 0)))
        ends = (((x0, y0), (x0 + thin, y1)), ((x1 - thin, y0), (x1, y1)))
    for a, b in ends:
        level.add_detail(box((*a, z0 + 6), (*b, z1 - 4), WALNUT))
    books = vigil("books", scale=(z1 - z0 - 10) / 256)
    level.add_detail(box((*inner[0], z0 + 6), (*inner[1], z1 - 4),
                         {"all": WALNUT, face: books.fitted()}))


def chest(level, x, y, z, yaw=0.0):
    """A chest with iron bands."""
    parts = [box((x - 26, y - 15, z), (x + 26, y + 15, z + 20), PLANK),
             box((x - 27, y - 16, z + 20), (x + 27, y + 16, z + 26), OAK)]
    parts += [box((x + d - 2, y - 16, z), (x + d + 2, y + 16, z + 20), vigil("rust"))
              for d in (-18, 18)]
    level.add_detail(*[p.turned(yaw, (x, y, z)) for p in parts])


def easel(level, x, y, z, yaw, painting, width, height):
    """A painting on a tripod; it looks along yaw and leans back."""
    back = np.array([-np.cos(np.radians(yaw)), -np.sin(np.radians(yaw)), 0])
    side = np.array([-back[1], back[0], 0])
    foot = np.array([x, y, z], float)
    lean = back * .22 + [0, 0, 1]

    def leg(a, b, size=3):
        level.add_detail(beam(a, b, size, size, OAK))

    for s in (-1, 1):
        leg(foot + s * 20 * side, foot + lean * 84 + s * 4 * side)
    leg(foot + back * 44, foot + lean * 80)
    leg(foot + lean * 26 - side * (width / 2 + 4) - back * 4,
        foot + lean * 26 + side * (width / 2 + 4) - back * 4, 5)
    middle = foot + lean * (28 + height / 2) - back * 3
    board = box((-1, -width / 2, -height / 2), (1, width / 2, height / 2),
                {"all": LINEN, "+x": vigil(painting, fit=True)})
    level.add_detail(tilted(board, np.degrees(np.arctan(.22)), yaw, middle))


def tilted(brush, pitch, yaw, centre):
    """A brush about the origin, its +x side raised by pitch degrees, turned to yaw, moved."""
    p = np.radians(pitch)
    r = np.array([[np.cos(p), 0, -np.sin(p)], [0, 1, 0], [np.sin(p), 0, np.cos(p)]])
    sides = [Side(s.polygon @ r.T, s.material) for s in brush.sides]
    return Brush(sides).turned(yaw).moved(centre)


def rug(level, lo, hi, z):
    level.add_detail(box((*lo, z), (*hi, z + .75), {"all": LINEN, "top": vigil("rug", fit=True)}))
