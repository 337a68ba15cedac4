# SPDX-License-Identifier: GPL-2.0-or-later
"""The level `quay`: a harbour front at dusk, under a nearly dark sky, lit by many small lamps.

A row of houses looks over a paved quay to the water. Strings of bulbs hang from the houses to lamp
posts at the edge; stalls have lanterns, windows are lit, boats carry a light.
"""

import numpy as np

import crate
import farm
from brush import beam, box, circle, cylinder, frustum, prism
from carver import Carver, Skin
from house import SHUTTER, WOOD, chimney, gable
from lamp import lamp_post, lantern
from map_file import Level
from material import SKY_BOX, WATER_SURFACE, vigil
from plant import tree
from route import Route
from stair import stairs

LOW, HIGH = (-640, -768, -112), (1664, 768, 704)
SEA = -26
FRONT = 448
STONE = vigil("flagstones")
RUBBLE = vigil("rubble")
OAK = vigil("beam", scale=.35)
POST = vigil("beam", scale=.35, turn=True)
IRON = vigil("metal_dark")
RED, CREAM = vigil("plaster_red", scale=.25), vigil("linen", scale=.25)
# x0, x1, eaves, wall, storeys
HOUSES = [(-640, -404, 236, "stucco", 2), (-404, -148, 300, "stucco_rose", 3),
          (-148, 92, 220, "stucco_pale", 2), (92, 380, 316, "stucco", 3),
          (380, 596, 228, "plaster_blue", 2), (596, 868, 300, "stucco_pale", 3),
          (868, 1112, 232, "stucco_rose", 2), (1112, 1392, 312, "stucco", 3),
          (1392, 1664, 230, "stucco_pale", 2)]
POSTS = [-420, -140, 140, 420, 700, 980, 1260]
COLOURS = ("lamp_sodium", "lamp_warm", "lamp_red", "lamp_sodium", "lamp_green", "lamp_warm",
           "lamp_blue", "lamp_sodium")


def build():
    """The level and its camera route: along the stalls and back over the edge of the water."""
    level = Level("quay", "The quay at dusk", sky="afterglow")
    rng = np.random.default_rng(31)
    carver = Carver(16)
    carver.room(LOW, HIGH, Skin(SKY_BOX, vigil("soil"), SKY_BOX))
    level.add(*carver.brushes())
    ground(level)
    for house in HOUSES:
        front(level, rng, *house)
    lights(level, rng)
    for i, x in enumerate((-300, -20, 250, 560, 830, 1150)):
        stall(level, rng, x, 250 + 18 * (i % 2), i)
    for x, y, yaw, light in ((-210, -96, 4, True), (330, -150, -8, True), (880, -110, 12, True),
                             (640, -330, 40, True), (1230, -260, -20, False)):
        boat(level, x, y, yaw, light)
    things(level, rng)
    camera = route()
    level.start((-560, 150, 60), 0)
    return level, camera


def ground(level):
    """The paved quay with its edge, steps to the water, the water, a mole with a beacon."""
    x0, x1 = LOW[0], HIGH[0]
    level.add(box((x0, 24, LOW[2]), (x1, HIGH[1], 0), {"all": RUBBLE, "top": vigil("cobbles")}),
              box((x0, LOW[1], LOW[2]), (x1, 0, SEA - 22), vigil("concrete_dark")),
              box((x0, LOW[1], SEA - 22), (x1, 0, SEA), WATER_SURFACE))
    level.add_detail(box((x0, 0, LOW[2]), (x1, 24, 4), {"all": RUBBLE, "top": STONE}),
                     box((x0, -4, -8), (x1, 0, 4), STONE))
    stairs(level, (480, -72, -52), (560, 0, 4), "+y", 6, STONE, rails=False)
    level.add_detail(box((200, -660, LOW[2]), (x1, -610, -4), {"all": RUBBLE, "top": STONE}))
    low = np.column_stack([circle((260, -635), 26, 10), np.full(10, -4.0)])
    high = np.column_stack([circle((260, -635), 17, 10), np.full(10, 120.0)])
    light = vigil("lamp_green").emissive(900)
    level.add_detail(frustum(low, high, vigil("stucco_pale")),
                     cylinder((260, -635), 22, 120, 126, STONE, 10),
                     cylinder((260, -635), 10, 126, 148, {"all": IRON, "side": light}, 6),
                     frustum(np.column_stack([circle((260, -635), 16, 6), np.full(6, 148.0)]),
                             np.column_stack([circle((260, -635), 3, 6), np.full(6, 162.0)]), RED))


def front(level, rng, x0, x1, eaves, wall, storeys):
    """A house: wall, plinth, door, windows of which half are lit, shutters, roof, chimney."""
    paint = vigil(wall)
    level.add(box((x0, FRONT, 0), (x1, HIGH[1], eaves), paint))
    level.add_detail(box((x0, FRONT - 4, 0), (x1, FRONT, 18), RUBBLE),
                     box((x0, FRONT - 3, eaves - 8), (x1, FRONT, eaves), STONE),
                     box((x0, FRONT - 3, 104), (x1, FRONT, 109), STONE))
    middle = (x0 + x1) / 2
    level.add_detail(box((middle - 24, FRONT - 2, 0), (middle + 24, FRONT, 92),
                         vigil("planks_old", turn=True)))
    for a, b, z0, z1 in ((-30, -24, 0, 98), (24, 30, 0, 98), (-24, 24, 92, 98)):
        level.add_detail(box((middle + a, FRONT - 5, z0), (middle + b, FRONT, z1), STONE))
    level.add_detail(box((middle - 34, FRONT - 14, 0), (middle + 34, FRONT - 4, 6), STONE))
    columns = max(2, round((x1 - x0) / 84))
    for storey in range(storeys):
        for i in range(columns):
            x = x0 + (x1 - x0) * (i + .5) / columns
            if storey == 0 and abs(x - middle) < 64:
                continue
            window(level, round(x), 38 + 94 * storey, rng.random() < .5)
    for part in gable("x", (x0, x1), (FRONT, HIGH[1] - 40), eaves, .5, paint, 14):
        level.add_detail(part)
    level.add_detail(*chimney(round(x0 + .3 * (x1 - x0)), FRONT + 120, eaves + 40, eaves + 130, 12))


def window(level, x, z, lit):
    """A window 36 x 52 on the houses' front: pane, frame, sill, shutters [1 when lit]."""
    pane = vigil("window_lit").emissive(60).fitted() if lit else vigil("black")
    level.add_detail(box((x - 16, FRONT - 1, z), (x + 16, FRONT, z + 48),
                         {"all": WOOD, "-y": pane}),
                     box((x - 22, FRONT - 6, z - 5), (x + 22, FRONT, z), STONE))
    for a, b in ((-19, -16), (16, 19)):
        level.add_detail(box((x + a, FRONT - 3, z), (x + b, FRONT, z + 51), WOOD))
    level.add_detail(box((x - 16, FRONT - 3, z + 48), (x + 16, FRONT, z + 51), WOOD))
    for a, b in ((-36, -20), (20, 36)):
        level.add_detail(box((x + a, FRONT - 2, z), (x + b, FRONT, z + 50), SHUTTER))


def lights(level, rng):
    """Lamp posts at the edge [4 each]; strings of bulbs from them to the houses, and between."""
    for x in POSTS:
        lamp_post(level, x, 52, 16, 260, 104)
    count = 0
    for x in POSTS:
        for target in (x - 70, x + 80):
            count += string(level, (x, 52, 140), (target, FRONT, 196), 11, 46, count)
    for a, b in zip(POSTS, POSTS[1:]):
        count += string(level, (a, 52, 142), (b, 52, 142), 9, 34, count)


def string(level, a, b, bulbs, sag, first):
    """A sagging wire with bulbs [3 each]; returns how many."""
    a, b = np.array(a, float), np.array(b, float)

    def at(t):
        return a + (b - a) * t - [0, 0, sag * 4 * t * (1 - t)]

    knots = [at(t) for t in np.linspace(0, 1, 7)]
    for p, q in zip(knots, knots[1:]):
        level.add_detail(beam(p, q, .8, .8, IRON))
    for i in range(bulbs):
        x, y, z = np.round(at((i + .5) / bulbs), 1)
        light = vigil(COLOURS[(first + i) % len(COLOURS)]).emissive(900).fitted()
        level.add_detail(prism(circle((x, y), 2.6, 3), z - 7, z - 2, {"all": IRON, "side": light}))
    return bulbs


def stall(level, rng, x, y, kind):
    """A market stall: counter, striped awning on posts, goods, a lantern [4]."""
    for dx in (-52, 48):
        for dy, high in ((-30, 84), (28, 104)):
            level.add_detail(box((x + dx, y + dy, 0), (x + dx + 4, y + dy + 4, high), POST))
    level.add_detail(box((x - 54, y - 28, 28), (x + 54, y + 6, 32), vigil("planks", scale=.25)),
                     box((x - 50, y - 26, 0), (x + 50, y - 22, 28), vigil("planks_old", scale=.25)))
    cloth = (RED, vigil("plaster_green", scale=.25), vigil("plaster_blue", scale=.25))[kind % 3]
    for i in range(8):
        a, b = x - 60 + 15 * i, x - 45 + 15 * i
        level.add_detail(farm.prism_along("x", a, b, [(y - 42, 80), (y + 36, 106), (y + 36, 108),
                                                     (y - 42, 82)], cloth if i % 2 else CREAM),
                         box((a, y - 43, 70), (b, y - 42, 82), cloth if i % 2 else CREAM))
    crate.load(level, rng, (x - 50, y - 24, 32), (x + 40, y + 2), 16)
    for i, paint in enumerate(("metal_red", "metal_orange", "metal_green", "paint_yellow")):
        at = x - 42 + 26 * i
        level.add_detail(box((at - 11, y - 46, 8), (at + 11, y - 30, 18),
                             vigil("planks", scale=.2)),
                         box((at - 9, y - 44, 18), (at + 9, y - 32, 21), vigil(paint)))
    lantern(level, x, y - 14, 92, 520)


def boat(level, x, y, yaw, light):
    """A rowing boat or a cutter with a mast; its lantern burns [4] or there is none."""
    outline = np.array([(-62, -20), (20, -22), (52, -12), (74, 0), (52, 12), (20, 22), (-62, 20)],
                       float)
    wood = vigil("planks", scale=.25)

    def ring(scale, z):
        return np.column_stack([outline * scale, np.full(len(outline), float(z))])

    inner = outline * .9
    parts = [frustum(ring(.72, SEA - 14), ring(.9, SEA - 2), vigil("metal_blue"))]
    for a, b, c, d in zip(outline, np.roll(outline, -1, 0), inner, np.roll(inner, -1, 0)):
        parts.append(prism([a, b, d, c], SEA - 2, SEA + 14, wood))
    for at in (-40, -4, 28):
        parts.append(box((at - 5, -18, SEA + 6), (at + 5, 18, SEA + 9), OAK))
    if light:
        parts.append(box((6, -2, SEA - 2), (10, 2, SEA + 150), POST))
        parts.append(beam((8, 0, SEA + 30), (-56, 0, SEA + 34), 3, 3, OAK))
        parts.append(beam((-50, 0, SEA + 37), (4, 0, SEA + 33), 7, 6, CREAM))
        glow = vigil("lamp_sodium").emissive(420).fitted()
        parts.append(box((13, -3, SEA + 66), (19, 3, SEA + 76), {"all": IRON, "side": glow}))
        parts.append(box((10, -1, SEA + 76), (17, 1, SEA + 78), IRON))
    level.add_detail(*[p.turned(yaw).moved((x, y, 0)) for p in parts])


def things(level, rng):
    """Bollards with rings, barrels, crates, fish boxes, a bench under each of two trees, pots."""
    for x in range(-560, 1600, 140):
        level.add_detail(cylinder((x, 14), 6, 4, 20, IRON, 8),
                         cylinder((x, 14), 8, 20, 24, IRON, 8))
    for x, y, size, count in ((-520, 90, 34, 3), (60, 90, 30, 2), (690, 120, 36, 3),
                              (1400, 110, 40, 3)):
        crate.stack(level, rng, x, y, 0, size, count)
    for x, y in ((-470, 66), (10, 70), (34, 104), (760, 96), (1040, 80), (1350, 90)):
        crate.barrel(level, x, y, 0, "rust" if x % 4 else "crate_dark", 13, 36)
    for x in (110, 1010):
        tree(level, rng, x, 330, 6, 210, 9, (4, 2))
        level.add_detail(prism(circle((x, 330), 34, 8), 0, 12, STONE))
    for house in HOUSES[1:-1]:
        middle = (house[0] + house[1]) / 2
        farm.pot(level, middle - 46, FRONT - 16, 0, rng, 9)
    farm.washing(level, rng, (-380, 396, 0), (-190, 396, 0), 130)


def route():
    camera = Route(20)
    for eye, look in [
        ((-560, 150, 60), (200, 120, 70)), ((-430, 150, 60), (300, 140, 70)),
        ((-240, 140, 60), (200, 300, 80)), ((-40, 140, 60), (400, 330, 90)),
        ((180, 150, 62), (600, 300, 90)), ((380, 150, 62), (500, 440, 120)),
        ((560, 160, 64), (880, 300, 80)), ((760, 170, 66), (1100, 100, 70)),
        ((960, 150, 66), (1400, 40, 70)), ((1140, 130, 70), (1500, 300, 90)),
        ((1290, 110, 76), (1200, 440, 120)), ((1330, -20, 84), (800, 300, 90)),
        ((1150, -130, 90), (500, 200, 90)), ((900, -230, 96), (300, 200, 90)),
        ((560, -240, 90), (100, 250, 90)), ((200, -250, 84), (-150, 250, 90)),
    ]:
        camera.key(eye, look)
    return camera
