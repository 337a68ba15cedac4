# SPDX-License-Identifier: GPL-2.0-or-later
"""The level `gallery`: a museum hall with a finely carved statue, after the paper's figure 8 (c).

Ten square lamps lie in a recess of the ceiling above the statue, behind a grille of slats: from
most places most of each lamp is hidden. They are the level's only lamps.
"""

import numpy as np

import farm
from brush import beam, box, circle, cylinder, frustum, prism
from carver import Carver, Skin
from map_file import Level
from material import vigil
from route import Route
from stair import railing

LENGTH, NAVE, AISLE = 1344, 272, 176
HEIGHT, AISLE_HEIGHT = 384, 288
STATUE = (672, 0, 56)
LAMP_VALUE = 140
MARBLE = vigil("marble")
DARK = vigil("marble_dark")
PLASTER = vigil("plaster")
RED = vigil("plaster_red")
WALNUT = vigil("walnut")
BRASS = vigil("brass")
PILLARS = [96, 288, 480, 672, 864, 1056, 1248]
# name, width, height, gallery side (+1 north, -1 south), x of its middle
PAINTINGS = [("dunes", 144, 96, 1, 192), ("rings", 96, 96, 1, 384), ("sea", 144, 96, 1, 576),
             ("field", 112, 112, 1, 768), ("squares", 132, 88, 1, 960), ("trees", 96, 96, 1, 1152),
             ("trees", 112, 112, -1, 192), ("squares", 144, 96, -1, 384),
             ("field", 96, 96, -1, 576), ("sea", 144, 96, -1, 768), ("rings", 112, 112, -1, 960),
             ("dunes", 144, 96, -1, 1152)]


def build():
    """The level and its camera route: through the door, around the statue, along the paintings."""
    level = Level("gallery", "The serpent hall")
    carver = Carver(16)
    nave = Skin(PLASTER, vigil("marble_floor"), PLASTER, [(16, PLASTER)])
    wing = Skin(RED, vigil("parquet"), PLASTER, [(24, RED)])
    carver.room((0, -NAVE, 0), (LENGTH, NAVE, HEIGHT), nave)
    for side in (-1, 1):
        near, far = sorted((side * NAVE, side * (NAVE + AISLE)))
        carver.room((0, near, 0), (LENGTH, far, AISLE_HEIGHT), wing)
    white = Skin(vigil("white"), vigil("white"), vigil("white"))
    carver.room((352, -192, HEIGHT), (992, 192, HEIGHT + 72), white)
    # Entrance hall and apse.
    carver.room((-16, -104, 0), (0, 104, 208), nave)
    carver.room((-400, -160, 0), (-16, 160, 224), nave)
    carver.room((LENGTH, -112, 0), (LENGTH + 16, 112, 240), nave)
    carver.room((LENGTH + 16, -144, 0), (LENGTH + 176, 144, 272), nave)
    level.add(*carver.brushes())
    colonnade(level)
    lamps(level)
    mouldings(level)
    plinth(level)
    pictures(level)
    furniture(level)
    entrance(level)
    level.entity("misc_model", model="models/statue.glb", origin=STATUE, angle=215)
    camera = route()
    level.start(camera.keys[0][0], 0)
    return level, camera


def colonnade(level):
    """Square pillars with base and capital between nave and wings, and the beam they carry."""
    for side in (-1, 1):
        y = side * NAVE
        for x in PILLARS:
            pillar(level, x, y)
        lo, hi = sorted((y - side * 16, y + side * 16))
        level.add_detail(box((0, lo, 256), (LENGTH, hi, 288), MARBLE),
                         box((0, lo - 4, 288), (LENGTH, hi + 4, 294), MARBLE),
                         box((0, lo - 8, 294), (LENGTH, hi + 8, 300), MARBLE))
        # Flat pilasters carry on above the beam.
        for x in PILLARS:
            a, b = sorted((y, y - side * 8))
            level.add_detail(box((x - 12, a, 300), (x + 12, b, HEIGHT - 20), MARBLE))
        # Panels between them, framed by a thin moulding.
        for x0, x1 in zip(PILLARS, PILLARS[1:]):
            a, b = sorted((y, y - side * 3))
            for lo2, hi2 in (((x0 + 26, 312), (x1 - 26, 316)), ((x0 + 26, 350), (x1 - 26, 354)),
                             ((x0 + 26, 316), (x0 + 30, 350)), ((x1 - 30, 316), (x1 - 26, 350))):
                level.add_detail(box((lo2[0], a, lo2[1]), (hi2[0], b, hi2[1]), BRASS))


def pillar(level, x, y):
    """A column of dark marble on a square base, under a capital that widens."""
    level.add_detail(
        box((x - 23, y - 23, 0), (x + 23, y + 23, 10), MARBLE),
        *turned_drums(x, y, [(10, 22), (14, 22), (19, 18.5)], MARBLE),
        *turned_drums(x, y, [(19, 17), (90, 16.6), (224, 14)], DARK),
        *turned_drums(x, y, [(224, 15.5), (228, 15.5)], BRASS),
        *turned_drums(x, y, [(228, 14), (236, 15.5), (246, 22)], MARBLE),
        box((x - 24, y - 24, 246), (x + 24, y + 24, 256), MARBLE))


def turned_drums(x, y, profile, material, sides=14):
    """Drums between the (height, radius) pairs of a turned profile."""
    return [frustum(np.column_stack([circle((x, y), r0, sides), np.full(sides, float(z0))]),
                    np.column_stack([circle((x, y), r1, sides), np.full(sides, float(z1))]),
                    material)
            for (z0, r0), (z1, r1) in zip(profile, profile[1:])]


def square(x, y, half):
    return [(x - half, y - half), (x + half, y - half), (x + half, y + half), (x - half, y + half)]


def lamps(level):
    """Ten lamps in two rows under the recess, and the slotted cover below them."""
    light = vigil("lamp_panel").emissive(LAMP_VALUE).fitted()
    steel = vigil("metal_dark")
    top = HEIGHT + 72
    for i in range(5):
        for y in (-96, 96):
            x = 416 + 128 * i
            level.add_detail(box((x - 32, y - 32, top - 14), (x + 32, y + 32, top - 8),
                                 {"all": steel, "bottom": light}),
                             box((x - 3, y - 3, top - 8), (x + 3, y + 3, top), steel))
    wood = WALNUT
    for x in range(364, 992, 24):
        level.add_detail(box((x - 3, -192, HEIGHT - 4), (x + 3, 192, HEIGHT + 20), wood.turned()))
    for y in (-64, 64):
        level.add_detail(box((352, y - 4, HEIGHT - 12), (992, y + 4, HEIGHT - 4), wood))
    for lo, hi in (((336, -208), (1008, -192)), ((336, 192), (1008, 208)),
                   ((336, -192), (352, 192)), ((992, -192), (1008, 192))):
        level.add_detail(box((*lo, HEIGHT - 16), (*hi, HEIGHT), WALNUT))


def mouldings(level):
    """Skirtings, dado rails, a cornice, and ceiling beams over the ends of the nave."""
    end = NAVE + AISLE
    for side in (-1, 1):
        wall = side * end
        for low, high, out in ((0, 14, 3), (44, 48, 3), (AISLE_HEIGHT - 12, AISLE_HEIGHT, 8)):
            a, b = sorted((wall, wall - side * out))
            level.add_detail(box((0, a, low), (LENGTH, b, high), WALNUT))
        a, b = sorted((side * NAVE, side * (NAVE - 14)))
        level.add_detail(box((0, a, HEIGHT - 20), (LENGTH, b, HEIGHT), MARBLE))
        for x in (0, LENGTH):
            a, b = sorted((x, x + (14 if x == 0 else -14)))
            level.add_detail(box((a, -NAVE + 14, HEIGHT - 20), (b, NAVE - 14, HEIGHT), MARBLE))
    for x in (96, 224, 1120, 1248):
        level.add_detail(box((x - 10, -NAVE + 14, HEIGHT - 18), (x + 10, NAVE - 14, HEIGHT),
                             WALNUT.turned()))
    # Beams under the wings' ceilings, from every column and between.
    for side in (-1, 1):
        a, b = sorted((side * (NAVE + 16), side * end))
        for x in range(0, LENGTH + 1, 96):
            level.add_detail(box((max(x - 6, 0), a, AISLE_HEIGHT - 14),
                                 (min(x + 6, LENGTH), b, AISLE_HEIGHT), WALNUT.turned()))
    # A dark border in the floor around the plinth.
    for half, width in ((208, 8), (176, 4)):
        x, y = STATUE[0], STATUE[1]
        for lo, hi in (((-half, -half), (half, -half + width)),
                       ((-half, half - width), (half, half)),
                       ((-half, -half + width), (-half + width, half - width)),
                       ((half - width, -half + width), (half, half - width))):
            level.add_detail(box((x + lo[0], y + lo[1], 0), (x + hi[0], y + hi[1], .5), DARK))


def plinth(level):
    """An octagonal plinth in three steps, with a brass plate, and a rope barrier around it."""
    x, y, top = STATUE
    level.add_detail(prism(circle((x, y), 140, 8), 0, 10, DARK),
                     prism(circle((x, y), 118, 8), 10, top - 8, MARBLE),
                     prism(circle((x, y), 126, 8), top - 8, top, DARK),
                     box((x - 115, y - 24, 22), (x - 108, y + 24, 38), BRASS))
    posts = circle((x, y), 176, 12)
    rope = vigil("plaster_red", scale=.25)
    for a, b in zip(posts, np.roll(posts, -1, axis=0)):
        line = [(*(a + (b - a) * t), 34 - 34 * t * (1 - t)) for t in (0, .25, .5, .75, 1)]
        level.add_detail(*[beam(p, q, 2.2, 2.2, rope) for p, q in zip(line, line[1:])])
    for px, py in posts:
        level.add_detail(box((px - 4, py - 4, 0), (px + 4, py + 4, 2), BRASS),
                         box((px - 1.5, py - 1.5, 2), (px + 1.5, py + 1.5, 36), BRASS),
                         box((px - 3, py - 3, 36), (px + 3, py + 3, 41), BRASS))


def pictures(level):
    """Paintings in walnut frames with a brass label each."""
    for name, width, height, side, x in PAINTINGS:
        wall = side * (NAVE + AISLE)
        middle = 126
        face = "-y" if side > 0 else "+y"
        canvas = vigil("painting_" + name, fit=True)

        def plate(half_w, low, high, near, far, materials):
            a, b = sorted((wall - side * near, wall - side * far))
            level.add_detail(box((x - half_w, a, low), (x + half_w, b, high), materials))

        w, h = width / 2, height / 2
        plate(w, middle - h, middle + h, 0, 3, {"all": WALNUT, face: canvas})
        plate(w + 7, middle + h, middle + h + 7, 0, 5, BRASS)
        plate(w + 7, middle - h - 7, middle - h, 0, 5, BRASS)
        plate(w + 11, middle + h + 7, middle + h + 11, 0, 3, WALNUT)
        plate(w + 11, middle - h - 11, middle - h - 7, 0, 3, WALNUT)
        for s in (-1, 1):
            lo, hi = sorted((x + s * (w + 7), x + s * (w + 11)))
            a, b = sorted((wall, wall - side * 3))
            level.add_detail(box((lo, a, middle - h - 7), (hi, b, middle + h + 7), WALNUT))
        for s in (-1, 1):
            a, b = sorted((wall, wall - side * 5))
            lo, hi = sorted((x + s * w, x + s * (w + 7)))
            level.add_detail(box((lo, a, middle - h), (hi, b, middle + h), BRASS))
        plate(9, middle - h - 26, middle - h - 19, 0, 1, BRASS)


def bench(level, x, y, length, along="x"):
    """An upholstered bench."""
    leather = vigil("metal_red")
    w, d = (length / 2, 17) if along == "x" else (17, length / 2)
    level.add_detail(box((x - w, y - d, 14), (x + w, y + d, 18), WALNUT),
                     box((x - w + 2, y - d + 2, 18), (x + w - 2, y + d - 2, 22), leather))
    for sx in (-1, 1):
        a, b = sorted((x + sx * (w - 4), x + sx * (w - 12 if along == "x" else w - 10)))
        level.add_detail(box((a, y - d + 3, 0), (b, y + d - 3, 14), WALNUT))


def furniture(level):
    """Benches, two vases on pedestals, and the apse with a third."""
    for x in (288, 1056):
        bench(level, x, -64, 112, "y")
        bench(level, x, 64, 112, "y")
    for x in (384, 960):
        for side in (-1, 1):
            bench(level, x, side * (NAVE + 92), 120)
    rng = np.random.default_rng(5)
    for x, y in ((192, -232), (1152, -232), (1152, 232)):
        farm.pot(level, x, y, 0, rng, 15)
    for x, y in ((56, -216), (56, 216), (1288, -216), (1288, 216), (1436, 0)):
        vase(level, x, y)
    for y in (-96, 96):
        level.add_detail(cylinder((1376, y), 15, 12, 200, DARK, 8),
                         box((1376 - 20, y - 20, 0), (1376 + 20, y + 20, 12), MARBLE),
                         box((1376 - 20, y - 20, 200), (1376 + 20, y + 20, 212), MARBLE))


def vase(level, x, y):
    """A vase turned in four drums on a pedestal."""
    clay = vigil("brick_pale", scale=.25)
    level.add_detail(box((x - 22, y - 22, 0), (x + 22, y + 22, 6), MARBLE),
                     box((x - 18, y - 18, 6), (x + 18, y + 18, 44), MARBLE),
                     box((x - 21, y - 21, 44), (x + 21, y + 21, 48), MARBLE))
    profile = [(48, 7), (58, 14), (72, 17), (84, 9), (92, 12)]
    for (z0, r0), (z1, r1) in zip(profile, profile[1:]):
        level.add_detail(frustum(np.column_stack([circle((x, y), r0, 8), np.full(8, float(z0))]),
                                 np.column_stack([circle((x, y), r1, 8), np.full(8, float(z1))]),
                                 clay if z0 != 72 else DARK))


def entrance(level):
    """The entrance hall: a counter, a closed double door, a rail, and the doorway's frame."""
    for y0, y1 in ((-112, -104), (104, 112)):
        level.add_detail(box((-20, y0, 0), (4, y1, 216), WALNUT.turned()))
    level.add_detail(box((-20, -112, 208), (4, 112, 222), WALNUT),
                     box((-300, 96, 0), (-180, 128, 40), WALNUT),
                     box((-304, 92, 40), (-176, 132, 44), DARK))
    door = vigil("planks", turn=True)
    for y0, y1 in ((-62, -2), (2, 62)):
        level.add_detail(box((-400, y0, 0), (-396, y1, 136), {"all": WALNUT, "+x": door}))
    level.add_detail(box((-400, -70, 0), (-392, -62, 144), WALNUT),
                     box((-400, 62, 0), (-392, 70, 144), WALNUT),
                     box((-400, -62, 136), (-392, 62, 144), WALNUT))
    for y in (-12, 8):
        level.add_detail(box((-396, y, 52), (-392, y + 4, 64), BRASS))
    railing(level, (-120, -150, 0), (-120, -90, 0), 40, 3, BRASS)
    railing(level, (-120, 90, 0), (-120, 150, 0), 40, 3, BRASS)


def route():
    camera = Route(16)
    x, y, z = STATUE
    head = (x, y, z + 84)
    for eye, look in [
        ((-110, 0, 56), (600, 0, 110)), ((20, 0, 56), (640, 0, 130)),
        ((160, -20, 60), head), ((330, -130, 66), head), ((500, -206, 80), head),
        ((672, -214, 96), head), ((860, -196, 110), (x, y, z + 100)),
        ((944, 0, 120), (x, y, z + 90)), ((860, 190, 100), head), ((672, 212, 80), head),
        ((584, 272, 74), (560, 448, 120)), ((500, 334, 70), (420, 448, 110)),
        ((420, 338, 66), (280, 448, 115)),
        ((260, 332, 64), (300, 60, 90)), ((192, 272, 64), (420, 0, 110)),
        ((180, 140, 64), (620, 0, 150)),
    ]:
        camera.key(eye, look)
    return camera
