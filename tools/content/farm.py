# SPDX-License-Identifier: GPL-2.0-or-later
"""Things of a farmyard as detail brushes: well, cart, wood pile, hay, pergola, washing, ladder."""

import numpy as np

from brush import beam, box, circle, cylinder, frustum, hull, prism
from house import prism_along
from material import WATER_SURFACE, vigil
from plant import bush, clump

OAK = vigil("beam", scale=.35)
POST = vigil("beam", scale=.35, turn=True)
PLANK = vigil("planks_old", scale=.25)
IRON = vigil("rust")
RUBBLE = vigil("rubble", scale=.35)
STONE = vigil("flagstones")
STRAW = vigil("straw", scale=.35)
LINEN = vigil("linen", scale=.25)
TILES = vigil("roof_tiles", scale=.4)


def well(level, x, y, z):
    """A round well with water, a windlass between two posts, and a small tiled roof."""
    sides = 10
    outer, inner = circle((x, y), 40, sides), circle((x, y), 28, sides)
    for i in range(sides):
        j = (i + 1) % sides
        level.add_detail(prism([inner[i], outer[i], outer[j], inner[j]], z - 12, z + 30, RUBBLE))
        rim = [p + (p - (x, y)) * f for p, f in
               ((inner[i], -.08), (outer[i], .06), (outer[j], .06), (inner[j], -.08))]
        level.add_detail(prism(rim, z + 30, z + 35, STONE))
    level.add(cylinder((x, y), 27, z - 4, z + 14, WATER_SURFACE, sides))
    for d in (-34, 34):
        level.add_detail(box((x + d - 3, y - 3, z + 35), (x + d + 3, y + 3, z + 100), POST))
    level.add_detail(prism_along("x", x - 31, x + 31, circle((y, z + 62), 5, 8), OAK),
                     prism_along("x", x - 7, x + 7, circle((y, z + 62), 6.5, 8), LINEN),
                     box((x - .75, y + 5.5, z + 34), (x + .75, y + 7, z + 62), LINEN),
                     cylinder((x, y + 6), 7, z + 22, z + 34, PLANK, 8))
    for s in (-1, 1):
        level.add_detail(prism_along("x", x - 46, x + 46, [
            (y + s * 38, z + 88), (y, z + 118), (y, z + 123), (y + s * 38, z + 93)], TILES))


def wheel(x, y, z, radius, width=5):
    """A disc wheel whose axle lies along y, with an iron tyre and a hub."""
    return [prism_along("y", y - width / 2, y + width / 2, circle((x, z), radius, 12), IRON),
            prism_along("y", y - width / 2 - .5, y + width / 2 + .5,
                        circle((x, z), radius - 3, 12), PLANK),
            prism_along("y", y - width / 2 - 4, y + width / 2 + 4, circle((x, z), 4.5, 8), OAK)]


def cart(level, rng, x, y, z, yaw):
    """A two-wheeled cart loaded with hay, its shafts on the ground."""
    parts = wheel(x, y - 32, z + 24, 24) + wheel(x, y + 32, z + 24, 24)
    parts += [box((x - 50, y - 26, z + 28), (x + 50, y + 26, z + 32), PLANK),
              box((x - 4, y - 36, z + 22), (x + 4, y + 36, z + 28), OAK)]
    for s in (-1, 1):
        a, b = sorted((y + s * 26, y + s * 24))
        for low in (34, 43):
            parts.append(box((x - 50, a, z + low), (x + 50, b, z + low + 7), PLANK))
        for dx in (-44, 0, 40):
            a2, b2 = sorted((y + s * 26, y + s * 29))
            parts.append(box((x + dx, a2, z + 26), (x + dx + 4, b2, z + 54), OAK))
        parts.append(beam([x + 50, y + s * 18, z + 30], [x + 128, y + s * 18, z + 3], 5, 5, OAK))
    parts.append(box((x - 50, y - 24, z + 34), (x - 48, y + 24, z + 50), PLANK))
    for dx, size in ((-24, 30), (8, 34), (30, 24)):
        parts.append(heap(rng, x + dx, y, z + 38, size))
    level.add_detail(*[p.turned(yaw, (x, y, 0)) for p in parts])


def heap(rng, x, y, z, size, material=STRAW):
    """A loose heap: the hull of points on half a flattened ball."""
    a = 6.28 * (np.arange(9) + rng.uniform(-.25, .25, 9)) / 9
    low = np.column_stack([np.cos(a), np.sin(a), rng.uniform(-.05, .05, 9)])
    a = 6.28 * (np.arange(5) + rng.uniform(-.3, .3, 5)) / 5
    high = np.column_stack([.6 * np.cos(a), .6 * np.sin(a), rng.uniform(.55, .7, 5)])
    points = np.concatenate([low, high, [[.05, .03, .9]]])
    return hull(np.round(points * [size, size * .72, size * .8] + [x, y, z], 1), material)


def bale(level, x, y, z, yaw=0.0):
    """A bale of straw, 56 x 32 x 28."""
    straw = box((x - 28, y - 16, z), (x + 28, y + 16, z + 28), STRAW)
    level.add_detail(straw.turned(yaw, (x, y, z)))


def wood_pile(level, rng, x, y, z, count=6, rows=4, length=52):
    """Logs along y, stacked in staggered rows along x."""
    bark = vigil("bark", scale=.35)
    cut = vigil("beam", scale=.25)
    for row in range(rows):
        for i in range(count - row % 2):
            r = rng.uniform(6.2, 7.4)
            at = x + 15 * (i + .5 * (row % 2)) + rng.uniform(-.6, .6)
            push = rng.uniform(-4, 4)
            level.add_detail(prism_along("y", y + push, y + push + length,
                                         circle((at, z + 7 + 12.5 * row), r, 6, rng.uniform()),
                                         {"all": bark, "end": cut, "side": bark}))
    for at in (x - 11, x + 15 * count - 5):
        level.add_detail(box((at, y + 8, z - 8), (at + 4, y + 12, z + 60), POST),
                         box((at, y + length - 12, z - 8), (at + 4, y + length - 8, z + 60), POST))


def pergola(level, x0, x1, wall, front, z, height=112, leaves=None):
    """Posts at y = front and rafters from there to the wall; leaves (an rng) lets vines grow on
    it."""
    for x in np.linspace(x0 + 8, x1 - 8, 4):
        level.add_detail(box((x - 4, front - 4, z), (x + 4, front + 4, z + height), POST),
                         box((x - 6, front - 6, z), (x + 6, front + 6, z + 8), STONE))
    level.add_detail(box((x0, front - 4, z + height), (x1, front + 4, z + height + 8), OAK))
    for x in np.arange(x0 + 4, x1, 24):
        a, b = sorted((front, wall))
        level.add_detail(box((x, a - 14, z + height + 8), (x + 5, b, z + height + 15),
                             OAK.turned()))
    if leaves is not None:
        for x in np.arange(x0 + 16, x1 - 110, 36):
            at = [x, front + leaves.uniform(-6, 40), z + height + 16]
            bush(level, leaves, np.array(at), leaves.uniform(14, 22))


def washing(level, rng, a, b, height=84):
    """A line between two posts with sheets on it; a and b are feet along x or y."""
    a, b = np.array(a, float), np.array(b, float)
    along = (b - a)[:2] / np.linalg.norm((b - a)[:2])
    for foot in (a, b):
        x, y, z = foot
        level.add_detail(box((x - 3, y - 3, z - 12), (x + 3, y + 3, z + height + 4), POST))
    level.add_detail(beam(a + [0, 0, height], b + [0, 0, height], .8, .8, LINEN))
    length = np.linalg.norm((b - a)[:2])
    at = 22.0
    while at + 50 < length:
        width, drop = rng.uniform(36, 52), rng.uniform(40, 56)
        colour = LINEN if rng.random() < .75 else vigil("plaster_blue", scale=.25)
        p = a + [*(along * at), height]
        # Several strips at small angles make the cloth hang in folds.
        folds = 3
        points = [p + [*(along * width * i / folds), 0] for i in range(folds + 1)]
        across = np.array([-along[1], along[0], 0])
        points = [q + across * (1.6 * (-1) ** i) for i, q in enumerate(points)]
        for q, r in zip(points, points[1:]):
            thick = across * .4
            level.add_detail(prism(ccw([q[:2] - thick[:2], r[:2] - thick[:2], r[:2] + thick[:2],
                                        q[:2] + thick[:2]]), p[2] - drop, p[2] + .6, colour))
        at += width + rng.uniform(6, 14)


def ccw(outline):
    """The outline, counter-clockwise."""
    p = np.asarray(outline, float)
    area = np.sum(p[:, 0] * np.roll(p[:, 1], -1) - np.roll(p[:, 0], -1) * p[:, 1])
    return p if area > 0 else p[::-1]


def ladder(level, foot, head, width=22, rungs=9):
    """A ladder that leans from foot to head."""
    foot, head = np.array(foot, float), np.array(head, float)
    forward = head - foot
    side = np.cross(forward, [0, 0, 1])
    side *= width / 2 / np.linalg.norm(side)
    for s in (-1, 1):
        level.add_detail(beam(foot + s * side, head + s * side, 3, 3, OAK))
    for i in range(rungs):
        p = foot + forward * (i + .7) / rungs
        level.add_detail(beam(p - side, p + side, 2, 2, OAK))


def pot(level, x, y, z, rng=None, radius=10):
    """A clay pot, with a bush in it when rng (of its shape) is given."""
    clay = vigil("plaster_red", scale=.25) if rng is None else vigil("stucco_rose", scale=.25)
    low = np.column_stack([circle((x, y), radius * .7, 8), np.full(8, float(z))])
    high = np.column_stack([circle((x, y), radius, 8), np.full(8, z + radius * 1.5)])
    level.add_detail(frustum(low, high, clay))
    if rng is not None:
        clump(level, rng, np.array([x, y, z + radius * 2.2]), radius * 1.25)
