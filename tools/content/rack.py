# SPDX-License-Identifier: GPL-2.0-or-later
"""Pallet racks along y: steel uprights, orange beams, decks and goods, as detail brushes."""

from brush import box
from crate import load
from material import vigil

POST = vigil("metal_blue")
RAIL = vigil("metal_orange")
GUARD = vigil("hazard", scale=.2)
DECK = vigil("planks", scale=.25, turn=True)


def rack(level, rng, wall, front, y0, y1, floor, decks, top, bays):
    """A rack that stands against a wall (x = wall) and opens at x = front, with bays along y;
    decks are heights above the floor."""
    x0, x1 = min(wall, front), max(wall, front)
    edge = 4 if front > wall else -4
    post = (min(front, front - edge), max(front, front - edge))
    pitch = (y1 - y0) / bays
    for i in range(bays + 1):
        y = round(min(max(y0 + i * pitch, y0 + 2), y1 - 2))
        level.add_detail(box((post[0], y - 2, floor), (post[1], y + 2, floor + top), POST),
                         foot(post, y, front > wall, floor))
    heights = [*decks, top]
    for deck, above in zip(decks, heights[1:]):
        z = floor + deck
        level.add_detail(box((x0, y0, z - 6), (x1, y1, z),
                             {"all": RAIL, "top": DECK, "bottom": DECK}))
        for i in range(bays):
            load(level, rng, (x0 + 2, round(y0 + i * pitch) + 4, z),
                 (x1 - 2, round(y0 + (i + 1) * pitch) - 4), above - deck - 12)


def foot(post, y, right, floor):
    """The striped guard before the foot of an upright."""
    near, far = (post[1], post[1] + 4) if right else (post[0] - 4, post[0])
    return box((near, y - 4, floor), (far, y + 4, floor + 20), GUARD)


def shelf(level, rng, lo, hi, boards, material=vigil("metal_dark")):
    """A free-standing shelf unit: two end panels, boards evenly up to the top, small goods."""
    (x0, y0, z0), (x1, y1, z1) = lo, hi
    if x1 - x0 > y1 - y0:
        ends = (((x0, y0), (x0 + 3, y1)), ((x1 - 3, y0), (x1, y1)))
    else:
        ends = (((x0, y0), (x1, y0 + 3)), ((x0, y1 - 3), (x1, y1)))
    for a, b in ends:
        level.add_detail(box((*a, z0), (*b, z1), material))
    step = (z1 - z0 - 6) // boards
    for i in range(boards + 1):
        z = z0 + 4 + i * step
        level.add_detail(box((x0, y0, z), (x1, y1, z + 2), material))
        if i < boards:
            load(level, rng, (x0 + 3, y0 + 3, z + 2), (x1 - 3, y1 - 3), step - 4)
