# SPDX-License-Identifier: GPL-2.0-or-later
"""The small levels of the unit tests: a white furnace, a square lamp, three rooms, a courtyard.

Their textures are flat colours, so that expected values follow by hand. Numbers that tests rely on
are stated beside each level.
"""

from brush import box, cylinder
from carver import Carver, Skin
from map_file import Level
from material import Material, SKY, SOLID, TRANS33, WINDOW

BLACK = Material("test/black")
WHITE50 = Material("test/white50")
GREY = Material("test/grey20")


def furnace():
    """A closed box, 256 a side, all six inner walls emit white at value 100 with albedo 1."""
    level = Level("furnace", "Furnace")
    white = Material("test/white").emissive(100)
    carver = Carver(16)
    carver.room((-128, -128, 0), (128, 128, 256), Skin(white, white, white))
    level.add(*carver.brushes())
    level.start((0, 0, 128), 0)
    return level


def lamp():
    """A black room, 512 x 512 x 256, with a floor of albedo 0.5 and one square lamp: 64 x 64,
    facing down, 128 above the floor's centre, value 100, white."""
    level = Level("lamp", "Square lamp over a floor")
    carver = Carver(16)
    carver.room((-256, -256, 0), (256, 256, 256), Skin(BLACK, WHITE50, BLACK))
    level.add(*carver.brushes())
    level.add(box((-32, -32, 128), (32, 32, 132),
                  {"all": BLACK, "bottom": Material("test/lamp").emissive(100)}))
    level.start((-192, 0, 64), 0)
    return level


def opensky():
    """A courtyard with a column under sky and sun; no lamps."""
    level = Level("opensky", "Courtyard", sky="court", _sun_light=200, _sun_color="1 0.9 0.75",
                  _sun_mangle="40 -55 0")
    sky = Material("test/sky", flags=SKY)
    carver = Carver(16)
    carver.room((-256, -256, 0), (256, 256, 192), Skin(Material("test/sand"), WHITE50, sky))
    level.add(*carver.brushes())
    level.add(box((-24, -24, 0), (24, 24, 128), GREY))
    level.add(box((96, -160, 0), (160, -96, 64), Material("test/red")))
    level.start((-192, -64, 56), 20)
    return level


def rooms():
    """Three rooms in a row: twelve lamps of different size, colour and strength, a translucent
    window, a door with a lamp on it, and varied albedos."""
    level = Level("rooms", "Three rooms")
    skins = [Skin(Material("test/sand"), WHITE50, GREY), Skin(WHITE50, GREY, WHITE50),
             Skin(Material("test/blue"), WHITE50, Material("test/sand"))]
    carver = Carver(16)
    for i, skin in enumerate(skins):
        x = 272 * i
        carver.room((x, 0, 0), (x + 256, 256, 160 + 32 * (i == 1)), skin)
    carver.room((256, 96, 0), (272, 160, 112), skins[1])
    carver.room((528, 32, 0), (544, 96, 112), skins[1])
    carver.room((528, 144, 48), (544, 224, 112), skins[1])
    level.add(*carver.brushes())

    glass = Material("test/glass", contents=WINDOW, flags=TRANS33)
    level.add(box((534, 144, 48), (538, 224, 112), glass))
    level.add(box((40, 180, 0), (88, 228, 48), Material("test/red")),
              cylinder((400, 128), 16, 0, 192, Material("test/green"), 8),
              box((700, 40, 0), (760, 100, 64), GREY))
    for lo, hi, face, texture, value in LAMPS:
        light = Material("test/" + texture).emissive(value)
        level.add(box(lo, hi, {"all": GREY, face: light}))

    # The door stands in the first doorway and carries a lamp on the side of the first room.
    door = Material("test/green", contents=SOLID)
    light = Material("test/lamp_red").emissive(60)
    level.entity("func_door", [box((258, 96, 0), (270, 160, 112), door),
                               box((256, 120, 72), (258, 136, 80), {"all": door, "-x": light})],
                 angle=-1, speed=60, lip=8, targetname="door")
    level.start((64, 64, 56), 30)
    return level


# (low corner, high corner, emitting face, texture, value): six in each outer reach of strength.
LAMPS = [
    ((96, 96, 152), (160, 160, 160), "bottom", "lamp_warm", 40),
    ((20, 20, 152), (36, 36, 160), "bottom", "lamp", 400),
    ((0, 100, 64), (8, 164, 72), "+x", "lamp_cool", 120),
    ((200, 248, 40), (248, 256, 120), "-y", "lamp_green", 10),
    ((296, 32, 184), (328, 224, 192), "bottom", "lamp_cool", 60),
    ((472, 32, 184), (504, 224, 192), "bottom", "lamp", 20),
    ((384, 248, 100), (416, 256, 104), "-y", "lamp_warm", 900),
    ((380, 0, 24), (420, 8, 32), "+y", "lamp_red", 300),
    ((600, 100, 152), (616, 116, 160), "bottom", "lamp_warm", 600),
    ((660, 200, 152), (724, 208, 160), "bottom", "lamp_cool", 300),
    ((792, 60, 80), (800, 68, 88), "-x", "lamp_red", 2000),
    ((720, 60, 64), (736, 76, 68), "top", "lamp_green", 200),
]

LEVELS = [furnace, lamp, rooms, opensky]
