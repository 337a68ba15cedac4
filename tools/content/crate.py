# SPDX-License-Identifier: GPL-2.0-or-later
"""Goods: crates, cartons, barrels, pallets and stacks of them, as detail brushes."""

from brush import box, cylinder
from material import vigil

CRATES = [vigil("crate", fit=True), vigil("crate_dark", fit=True)]
CARTON = vigil("carton", fit=True)
CRATE_METAL = vigil("metal_wall", scale=.25, fit=True)
PLANK = vigil("planks", scale=.25)


def crate(level, x, y, z, size, kind=0, yaw=0.0):
    """A wooden crate, size is its edge; yaw turns it a little about its centre."""
    h = size / 2
    material = CRATES[kind % 2] if kind < 2 else CRATE_METAL
    brush = box((x - h, y - h, z), (x + h, y + h, z + size), material)
    level.add_detail(brush.turned(yaw, (x, y, z)) if yaw else brush)


def framed(level, x, y, z, size, kind=0, yaw=0.0):
    """A crate for the foreground, whose posts and rails stand proud of its boards."""
    h, w = size / 2, max(2.5, size * .09)
    board = [vigil("planks", scale=.2), vigil("planks_old", scale=.2)][kind % 2]
    wood = vigil("beam", scale=.2)
    g = h - 1.5
    parts = [box((x - g, y - g, z + 1), (x + g, y + g, z + size - 1), board)]
    for sx in (-1, 1):
        for sy in (-1, 1):
            a, b = sorted((x + sx * h, x + sx * (h - w)))
            c, d = sorted((y + sy * h, y + sy * (h - w)))
            parts.append(box((a, c, z), (b, d, z + size), wood.turned()))
    for low in (z, z + size - w):
        for s in (-1, 1):
            a, b = sorted((y + s * h, y + s * (h - w)))
            parts.append(box((x - h + w, a, low), (x + h - w, b, low + w), wood))
            a, b = sorted((x + s * h, x + s * (h - w)))
            parts.append(box((a, y - h + w, low), (b, y + h - w, low + w), wood))
    level.add_detail(*[p.turned(yaw, (x, y, z)) for p in parts])


def carton(level, lo, hi):
    level.add_detail(box(lo, hi, CARTON))


def barrel(level, x, y, z, paint="metal_blue", radius=14, height=42):
    """A drum."""
    level.add_detail(cylinder((x, y), radius, z, z + height, vigil(paint), 8))


def pallet(level, x, y, z, size=56):
    """Three bearers and a deck; returns the height of the deck."""
    h = size / 2
    for dy in (-h, -4, h - 8):
        level.add_detail(box((x - h, y + dy, z), (x + h, y + dy + 8, z + 6), PLANK))
    level.add_detail(box((x - h, y - h, z + 6), (x + h, y + h, z + 9), PLANK))
    return z + 9


def stack(level, rng, x, y, z, size=48, count=3):
    """Crates heaped about a point: one or two below, the rest on top, slightly turned."""
    crate(level, x, y, z, size, int(rng.integers(0, 3)), float(rng.uniform(-6, 6)))
    if count > 1:
        crate(level, x + size * 1.12, y + rng.uniform(-6, 6), z, size * .85,
              int(rng.integers(0, 2)), float(rng.uniform(-10, 10)))
    if count > 2:
        crate(level, x + rng.uniform(-4, 4), y + rng.uniform(-4, 4), z + size, size * .75,
              int(rng.integers(0, 2)), float(rng.uniform(-14, 14)))


def load(level, rng, lo, hi, height):
    """Fills a shelf area with a random row of cartons and crates below a height.

    Sizes come from few steps: boxes that share planes keep the compiled tree small.
    """
    x0, y0, z = lo
    x1, y1 = hi
    along_y = y1 - y0 > x1 - x0
    at, end = (y0, y1) if along_y else (x0, x1)
    across = (x0, x1) if along_y else (y0, y1)
    inset = round((across[1] - across[0]) * .12)
    while at < end - 14:
        width = min(float(rng.choice([24, 32, 44])), end - at)
        if rng.random() < .75:
            top = z + round(float(rng.choice([.5, .7, .9])) * height)
            near, far = across[0] + inset, across[1] - inset
            material = CARTON if rng.random() < .6 else CRATES[int(rng.integers(0, 2))]
            a, b = (near, round(at)), (far, round(at + width))
            if not along_y:
                a, b = a[::-1], b[::-1]
            level.add_detail(box((*a, z), (*b, top), material))
        at += width + 4
