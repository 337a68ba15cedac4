# SPDX-License-Identifier: GPL-2.0-or-later
"""The level `warehouse`: a goods depot of 34 rooms, aisles and corridors with about 530 lamps.

Walls, door frames and portal arches hide most lamps from any place, as in the paper's figure 8 (a).
This file holds the plan; warehouse_rooms.py furnishes it.
"""

from carver import Carver, Skin
from doorway import arch, doorway, window
from map_file import Level
from material import vigil
from route import Route
import warehouse_rooms

CONCRETE = vigil("concrete")
PANEL = vigil("concrete_panel")
PAINTED = vigil("floor_painted")
RIBBED = vigil("metal_ribbed")
DARK = vigil("concrete_dark")
BRICK = vigil("brick", scale=.25)
PALE = vigil("brick_pale", scale=.25)
TILE = vigil("tile_white", scale=.25)
CHECK = vigil("tile_floor")
PLASTER = vigil("plaster")
CEILING = vigil("ceiling_tile")
HAZARD = vigil("hazard", scale=.25)
PLATE = vigil("metal_plate")
TREAD = vigil("tread", scale=.25)
PLANKS = vigil("planks", scale=.25)

HALL = Skin(PANEL, PAINTED, DARK, [(56, HAZARD), (64, PANEL), (160, RIBBED)])
AISLE = Skin(RIBBED, PAINTED, DARK)
CORRIDOR = Skin(vigil("plaster_green"), CONCRETE, CONCRETE, [(60, vigil("metal_green")),
                                                             (64, PLASTER)])
OFFICE = Skin(PLASTER, vigil("plaster_blue"), CEILING, [])
OFFICE_UP = Skin(PLASTER, PLANKS, CEILING)
SHOP = Skin(PALE, CONCRETE, DARK)
BOILER = Skin(BRICK, TREAD, DARK)
WET = Skin(TILE, CHECK, PLASTER)
COLD = Skin(TILE, CONCRETE, PLATE, [(112, PLATE)])
STORE = Skin(PALE, CONCRETE, CONCRETE)
CONTROL = Skin(vigil("metal_wall"), CHECK, CEILING)
PIT = Skin(TILE, TILE, TILE)

# name: (x0, y0, x1, y1, floor, ceiling, skin)
ROOMS = {
    "dock": (0, 0, 960, 480, 0, 288, HALL),
    "dock_office": (976, 0, 1264, 224, 0, 144, OFFICE),
    "tool_store": (976, 240, 1264, 480, 0, 144, STORE),
    "workshop": (1280, 0, 1856, 480, 0, 208, SHOP),
    "boiler": (1872, 0, 2384, 480, -64, 240, BOILER),
    "pump": (2400, 0, 2784, 240, -64, 128, BOILER),
    "parts": (2400, 256, 2784, 480, 0, 144, STORE),
    "corridor_a": (0, 496, 1264, 624, 0, 176, CORRIDOR),
    "corridor_b": (1280, 496, 1392, 1616, 0, 176, CORRIDOR),
    "corridor_c": (1408, 672, 2784, 800, 0, 176, CORRIDOR),
    "wash": (1408, 496, 1616, 656, 0, 144, WET),
    "janitor": (1632, 496, 1856, 656, 0, 144, STORE),
    "vestibule": (1872, 496, 2384, 656, 0, 176, SHOP),
    "records": (2400, 496, 2784, 656, 0, 144, OFFICE),
    "north": (0, 1472, 1264, 1616, 0, 304, HALL),
    "archive": (0, 1632, 400, 2000, 0, 144, OFFICE),
    "electrical": (416, 1632, 688, 2000, 0, 144, CONTROL),
    "stair_hall": (704, 1632, 1040, 2000, 0, 320, SHOP),
    "cage": (1056, 1632, 1392, 2000, 0, 208, STORE),
    "office_a": (0, 1632, 400, 2000, 176, 320, OFFICE_UP),
    "office_b": (416, 1632, 688, 2000, 176, 320, OFFICE_UP),
    "cold_a": (1408, 816, 1808, 1216, 0, 208, COLD),
    "cold_b": (1824, 816, 2224, 1216, 0, 208, COLD),
    "lockers": (2240, 816, 2784, 1056, 0, 160, WET),
    "plant": (2240, 1072, 2784, 1216, 0, 160, BOILER),
    "packing": (1408, 1232, 2224, 1744, 0, 272, HALL),
    "control": (2240, 1232, 2784, 1488, 0, 176, CONTROL),
    "battery": (2240, 1504, 2784, 1744, 0, 208, SHOP),
}
AISLES = {"aisle_" + letter: (212 * i, 640, 212 * i + 196, 1456, 0, 304, AISLE)
          for i, letter in enumerate("abcdef")}
ROOMS.update(AISLES)

# Openings through walls: (low corner, high corner).
DOORS = [
    ((224, 480, 0), (416, 496, 160)), ((960, 16, 0), (976, 112, 120)),
    ((960, 320, 0), (976, 432, 120)), ((1072, 480, 0), (1184, 496, 120)),
    ((1288, 480, 0), (1384, 496, 120)), ((1456, 480, 0), (1552, 496, 120)),
    ((1856, 176, 0), (1872, 304, 128)), ((2064, 480, 0), (2192, 496, 120)),
    ((2384, 64, -64), (2400, 160, 56)), ((2544, 480, 0), (2640, 496, 120)),
    ((2544, 656, 0), (2640, 672, 120)), ((2064, 656, 0), (2192, 672, 120)),
    ((1392, 528, 0), (1408, 624, 120)), ((1696, 656, 0), (1792, 672, 120)),
    ((1264, 512, 0), (1280, 608, 120)), ((1392, 688, 0), (1408, 784, 120)),
    ((144, 1616, 0), (240, 1632, 120)), ((512, 1616, 0), (608, 1632, 120)),
    ((800, 1616, 0), (928, 1632, 152)), ((1104, 1616, 0), (1200, 1632, 120)),
    ((1288, 1616, 0), (1384, 1632, 120)), ((1264, 1480, 0), (1280, 1600, 128)),
    ((688, 1880, 176), (704, 1976, 288)), ((400, 1760, 176), (416, 1856, 288)),
    ((1392, 960, 0), (1408, 1056, 120)), ((1808, 968, 0), (1824, 1064, 120)),
    ((1984, 800, 0), (2080, 816, 120)), ((2448, 800, 0), (2544, 816, 120)),
    ((2592, 1056, 0), (2688, 1072, 120)), ((2432, 1216, 0), (2528, 1232, 120)),
    ((1392, 1296, 0), (1408, 1408, 128)), ((2224, 1304, 0), (2240, 1400, 120)),
    ((2224, 1568, 0), (2240, 1712, 152)), ((1392, 1640, 0), (1408, 1736, 120)),
]
WINDOWS = [
    ((960, 128, 48), (976, 208, 116), 1), ((80, 1616, 216), (320, 1632, 284), 3),
    ((464, 1616, 216), (640, 1632, 284), 2), ((2224, 1416, 48), (2240, 1480, 112), 0),
]


def build():
    """The level and its camera route: dock, corridor, aisle C, north hall, packing hall."""
    level = Level("warehouse", "The depot")
    carver = Carver(16)
    for x0, y0, x1, y1, z0, z1, skin in ROOMS.values():
        carver.room((x0, y0, z0), (x1, y1, z1), skin)
    for lo, hi in DOORS:
        doorway(level, carver, lo, hi)
    for lo, hi, bars in WINDOWS:
        window(level, carver, lo, hi, mullions=bars)
    for x0, _, x1, _, _, _, _ in AISLES.values():
        doorway(level, carver, (x0 + 38, 624, 0), (x1 - 38, 640, 136))
        doorway(level, carver, (x0 + 34, 1456, 0), (x1 - 34, 1472, 184))
    carver.room((2000, 96, -112), (2208, 256, -64), PIT)
    level.add(*carver.brushes())
    portals(level)
    warehouse_rooms.furnish(level, ROOMS, AISLES)
    camera = route()
    level.start(camera.keys[0][0], 60)
    return level, camera


def portals(level):
    """Structural arches that cut long spaces into pieces the PVS can tell apart."""
    for x0, _, x1, _, _, _, _ in AISLES.values():
        for y in (840, 1040, 1240):
            arch(level, "y", y, (x0, 0), (x1, 304), (x0 + 50, x1 - 50, 176), vigil("metal_wall"))
    for x in (424, 636, 1052):
        arch(level, "x", x, (496, 0), (624, 176), (508, 612, 136), PALE)
    for x in (404, 628, 1044):
        arch(level, "x", x, (1472, 0), (1616, 304), (1484, 1604, 176), BRICK)
    for y in (656, 840, 1088, 1200, 1440):
        arch(level, "y", y, (1280, 0), (1392, 176), (1286, 1386, 128), PALE)
    for x in (1680, 1900, 2260, 2560):
        arch(level, "x", x, (672, 0), (800, 176), (684, 788, 136), PALE)


def route():
    camera = Route(20)
    for eye, look in [
        ((150, 130, 52), (420, 420, 60)), ((240, 250, 50), (360, 560, 60)),
        ((312, 400, 48), (340, 700, 60)), ((324, 500, 48), (520, 640, 60)),
        ((420, 560, 48), (540, 640, 70)), ((505, 590, 48), (522, 800, 80)),
        ((522, 690, 48), (530, 1000, 60)), ((522, 900, 48), (470, 1100, 60)),
        ((522, 1150, 48), (560, 1400, 70)), ((522, 1440, 48), (560, 1600, 90)),
        ((550, 1522, 48), (300, 1640, 180)), ((660, 1544, 48), (900, 1620, 120)),
        ((860, 1544, 48), (1200, 1560, 60)), ((1100, 1543, 48), (1400, 1520, 60)),
        ((1275, 1538, 48), (1340, 1420, 60)), ((1332, 1480, 48), (1340, 1300, 60)),
        ((1338, 1400, 48), (1500, 1330, 60)), ((1390, 1350, 48), (1700, 1400, 60)),
        ((1500, 1362, 48), (1900, 1500, 50)), ((1640, 1400, 56), (2100, 1600, 40)),
    ]:
        camera.key(eye, look)
    return camera
