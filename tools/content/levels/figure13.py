# SPDX-License-Identifier: GPL-2.0-or-later
"""The level `figure13`: the five artefacts of the paper's figure 13, a closed room each, along the y axis.

(a) Variance edges: one lamp on one side of a low screen, 64 on the other. Leaves beside each other hold few lights and many.
(b) Motion: two lamps turn behind a wall of slits; all light of the front room moves.
(c) Distance: terraces of stalls with a lamp each, at the far end of a long hall. A leaf covers several of them.
(d) Locality: the sun falls through a hole in the roof. A leaf at the edge of the spot has both light and shade.
(e) Specular: a polished floor under a wall that is lit from a trough.
"""

from brush import box
from carver import Carver, Skin
from map_file import Level
from material import ORIGIN, SKY, Material

WHITE, GREY, SAND, BLACK = (Material("test/" + name) for name in ("white50", "grey20", "sand", "black"))
POLISHED = Material("test/polished")
SPACING = 1024
EYE_HEIGHT = 22  # of a player over its origin

# Eye (x, y within the room, z), pitch downwards and yaw in degrees: bench takes them in this order.
VIEWS = [(-232, 0, 112, 22, 0), (-236, 0, 150, 18, 0), (-232, 0, 250, 3, 0), (-180, -60, 150, 34, 20), (-232, 0, 88, 14, 0)]


def lamp(texture, value, lo, hi, face):
    """A box of which one face shines."""
    return box(lo, hi, {"all": BLACK, face: Material("test/" + texture).emissive(value)})


def edge(carver, level, y):
    carver.room((-256, y - 256, 0), (256, y + 256, 192), Skin(WHITE, WHITE, GREY))
    level.add_detail(box((-4, y - 256, 56), (4, y + 256, 192), GREY))
    level.add_detail(lamp("lamp_warm", 60, (-160, y - 32, 188), (-96, y + 32, 192), "bottom"))
    for i in range(8):
        for j in range(8):
            x, across = 32 + 28 * i, y - 238 + 66 * j
            level.add_detail(lamp(("lamp_cool", "lamp_green", "lamp_warm")[(i + 2 * j) % 3], 40 + 60 * ((3 * i + j) % 5),
                                  (x - 3, across - 3, 186), (x + 3, across + 3, 192), "bottom"))


def motion(carver, level, y):
    carver.room((-256, y - 192, 0), (192, y + 192, 192), Skin(WHITE, SAND, GREY))
    for i in range(8):
        low = y - 192 + 48 * i
        level.add_detail(box((0, low + 20, 0), (8, low + 48, 192), GREY))
    bulb = Material("test/lamp_warm").emissive(300)
    arms = [box((82, y + side * 56 - 8, 94), (98, y + side * 56 + 8, 110), bulb) for side in (-1, 1)]
    axle = Material("test/black", contents=ORIGIN)
    level.entity("func_rotating", [*arms, box((86, y - 48, 98), (94, y + 48, 106), BLACK), box((86, y - 4, 96), (94, y + 4, 104), axle)],
                 spawnflags=1, speed=240)


def distance(carver, level, y):
    carver.room((-256, y - 192, 0), (3072, y + 192, 320), Skin(GREY, SAND, GREY))
    for step in range(12):
        x, top = 2200 + 72 * step, 16 * (step + 1)
        level.add_detail(box((x, y - 192, top - 16), (3072, y + 192, top), WHITE))
        for bay in range(8):
            low = y - 192 + 48 * bay
            level.add_detail(box((x + 8, low, top), (x + 72, low + 4, top + 14), GREY), box((x + 52, low + 4, top + 12), (x + 72, low + 48, top + 14), GREY))
            level.add_detail(lamp(("lamp_warm", "lamp_cool", "lamp_red", "lamp_green")[(bay + 3 * step) % 4], 2000,
                                  (x + 60, low + 22, top + 10), (x + 66, low + 28, top + 12), "bottom"))


def locality(carver, level, y):
    carver.room((-256, y - 256, 0), (256, y + 256, 256), Skin(WHITE, WHITE, GREY))
    carver.room((-64, y - 64, 256), (64, y + 64, 272), Skin(GREY, GREY, GREY))
    sky = Material("test/sky", flags=SKY)
    carver.room((-192, y - 192, 272), (192, y + 192, 336), Skin(sky, GREY, sky))


def specular(carver, level, y):
    carver.room((-256, y - 256, 0), (256, y + 256, 224), Skin(WHITE, POLISHED, WHITE))
    # The trough hides its lamp from the floor.
    level.add_detail(box((208, y - 200, 40), (214, y + 200, 72), GREY), box((214, y - 200, 40), (256, y + 200, 46), GREY),
                     box((20, y - 90, 0), (52, y - 58, 72), SAND), box((40, y + 60, 0), (88, y + 108, 40), GREY))
    level.add_detail(lamp("lamp", 400, (228, y - 180, 46), (240, y + 180, 50), "top"))


def build():
    level = Level("figure13", "Five artefacts", sky="court", _sun_light=200, _sun_color="1 0.9 0.75", _sun_mangle="40 -62 0")
    carver = Carver(16)
    for i, room in enumerate((edge, motion, distance, locality, specular)):
        room(carver, level, SPACING * i)
        x, y, z, pitch, yaw = VIEWS[i]
        level.entity("info_player_deathmatch" if i else "info_player_start", origin=(x, SPACING * i + y, z - EYE_HEIGHT), angles=(pitch, yaw, 0))
    level.add(*carver.brushes())
    return level
