# SPDX-License-Identifier: GPL-2.0-or-later
"""Furniture and lamps of the large spaces of the level `warehouse`: dock, aisles, corridors, north
hall, workshop, packing hall, charging hall, stairs.
"""

import numpy as np

import crate
import lamp
from brush import beam, box, lying
from depot import (GIRDER, HAZARD, STEEL, WOOD, cabinet, cone, extinguisher, forklift, girders,
                   grid, lanes, pallet_truck, pipe_run, wrapped_pallet)
from material import vigil
from rack import rack, shelf
from stair import railing, stairs


def aisle(level, rng, room, index, name):
    """Racks on both sides between portals, tubes above, signal lamps on the posts. At night only
    every second section burns: pools of light with dark between them."""
    x0, y0, x1, y1, _, z1, _ = room
    for section, (a, b) in enumerate(((652, 836), (860, 1036), (1060, 1236), (1260, 1444))):
        on = (section + index) % 2 == 1
        for left in (True, False):
            wall, front = (x0, x0 + 48) if left else (x1, x1 - 48)
            rack(level, rng, wall, front, a, b, 0, (10, 84, 156), 236, 2)
            face = "+x" if left else "-x"
            texture = ("lamp_green", "lamp_red", "lamp_blue", "lamp_warm")[int(rng.integers(0, 4))]
            lamp.spot(level, (front, (a + b) / 2, 118 + 24 * (index % 2)), face, texture, 300)
        middle = (x0 + x1) / 2
        for y in (a + 46, b - 46):
            lamp.tube(level, middle, y, z1, "y", "lamp_warm" if on else "lamp_cool",
                      620 if on else 9, 72, 48, True)
        level.add_detail(box((x0, (a + b) / 2 - 5, z1 - 18), (x1, (a + b) / 2 + 5, z1), GIRDER))
    # Things left standing: a pallet truck, a lone carton, a cone.
    if index % 2 == 0:
        pallet_truck(level, middle + 36, 930, 0, 90)
    else:
        crate.carton(level, (middle + 24, 770, 0), (middle + 48, 794, 18))
        cone(level, middle + 34, 1170, 0)
    for s in (-1, 1):
        level.add_detail(box((middle + s * 47 - 2, 648, 0), (middle + s * 47 + 2, 1448, .25),
                             vigil("paint_yellow")))
    sign = vigil("sign_" + name[-1], fit=True)
    for y, face in ((632, "-y"), (1464, "+y")):
        lo, hi = (y - 12, y - 8) if face == "-y" else (y + 8, y + 12)
        base = 142 if face == "-y" else 190
        level.add_detail(box((middle - 16, lo, base), (middle + 16, hi, base + 32),
                             {"all": STEEL, face: sign}))


def guards(level):
    """Striped corner guards at the portals of corridor and north hall."""
    for x in (424, 636, 1052):
        for y in (505, 612):
            level.add_detail(box((x - 3, y, 0), (x + 19, y + 3, 44), HAZARD))
    for x in (404, 628, 1044):
        for y in (1481, 1604):
            level.add_detail(box((x - 3, y, 0), (x + 19, y + 3, 44), HAZARD))


def dock(level, rng, rooms):
    room = rooms["dock"]
    lanes(level, room, 232, "x")
    girders(level, room, 160)
    # The night shift: four lamps burn, low over the floor; the others glimmer under the roof.
    for i, (x, y) in enumerate(grid(room, 6, 3)):
        on = i in (2, 4, 11, 15)
        lamp.high_bay(level, x, y, 288, 104 if on else 34, "lamp_sodium", 520 if on else 4)
    # Two roller doors with bumpers, and a trailer at one of them.
    for x in (160, 520):
        level.add_detail(box((x, 0, 0), (x + 200, 4, 176), {"all": STEEL, "+y":
                             vigil("shutter")}),
                         box((x - 12, 0, 0), (x, 10, 188), HAZARD),
                         box((x + 200, 0, 0), (x + 212, 10, 188), HAZARD),
                         box((x - 12, 0, 176), (x + 212, 14, 196), STEEL))
        lamp.bulkhead(level, (x + 100, 0, 212), "+y", "lamp_warm", 300, (40, 10))
        for dx in (-6, 206):
            lamp.spot(level, (x + dx, 10, 120), "+y", ("lamp_red", "lamp_green")[x > 300], 300, 8)
    for x, y in ((60, 380), (520, 200), (760, 120), (820, 330), (560, 400)):
        crate.pallet(level, x, y, 0, 64)
        if x < 700:
            crate.framed(level, x - 8, y, 9, 44, 0, float(rng.uniform(-6, 6)))
            crate.framed(level, x - 6, y + 2, 53, 34, 1, float(rng.uniform(-14, 14)))
            crate.framed(level, x + 44, y + 6, 0, 36, 1, float(rng.uniform(-12, 12)))
        else:
            crate.stack(level, rng, x - 8, y, 9, 44, 3)
    for x, y, height, yaw in ((150, 240, 44, 0), (404, 320, 66, 0), (880, 220, 66, 90)):
        wrapped_pallet(level, x, y, 0, height, yaw)
    pallet_truck(level, 330, 200, 0, 208)
    for x, y in ((452, 206), (596, 250), (500, 280)):
        cone(level, x, y, 0)
    for x in (120, 470, 700):
        extinguisher(level, x, 480, 36, "-y")
    for x in (560, 592, 636):
        cabinet(level, (x, 470, 30), (x + 28, 480, 78), "-y", 288)
    pipe_run(level, "x", 0, 960, 470, 236, 7)
    pipe_run(level, "x", 0, 960, 472, 222, 4, STEEL)
    # Striped bays before the roller doors.
    for x in (160, 520):
        for dx in (0, 50, 100, 150, 200):
            level.add_detail(box((x + dx - 2, 20, 0), (x + dx + 2, 110, .25),
                                 vigil("paint_yellow")))
    for x in (80, 116, 152):
        crate.barrel(level, 30, x, 0, ("metal_blue", "metal_red", "metal_green")[x % 3])
    forklift(level, 640, 300, 0)
    for x in (0, 480, 952):
        level.add_detail(box((x, 0, 0), (x + 8, 12, 288), GIRDER),
                         box((x, 468, 0), (x + 8, 480, 288), GIRDER))
    railing(level, (700, 30, 0), (700, 90, 0), 40, 3)


def corridors(level, rng, rooms):
    for x in (80, 236, 396, 552, 712, 868, 1028, 1184):
        lamp.tube(level, x, 560, 176, "x", "lamp_cool", 420, 64)
    for y in (540, 620, 730, 800, 900, 1020, 1140, 1260, 1360, 1500, 1580):
        lamp.bulkhead(level, (1280, y, 112), "+x", "lamp_warm", 450, (24, 10))
        lamp.tube(level, 1340, y + 12, 176, "y", "lamp_warm", 300, 48)
    for x in (1480, 1590, 1750, 1840, 1980, 2080, 2180, 2340, 2480, 2640, 2730):
        lamp.tube(level, x, 736, 176, "x", "lamp_cool", 420, 64)
    pipe_run(level, "x", 0, 1264, 618, 164)
    pipe_run(level, "x", 0, 1264, 606, 168, 3, STEEL)
    pipe_run(level, "x", 1408, 2784, 680, 164)
    pipe_run(level, "y", 496, 1616, 1386, 166, 4)
    for point, face in (((640, 496, 140), "+y"), ((1264, 620, 140), "-x"),
                        ((1392, 860, 140), "-x"), ((2784, 736, 140), "-x")):
        lamp.spot(level, point, face, "lamp_green", 160, 12)
    for x in (40, 700, 960):
        shelf(level, rng, (x, 496, 0), (x + 60, 512, 84), 3)


def north(level, rng, rooms):
    room = rooms["north"]
    lanes(level, room, 24, "x")
    guards(level)
    girders(level, room, 158)
    for i, x in enumerate((80, 236, 396, 552, 712, 868, 1028, 1184)):
        on = i not in (1, 4, 6)
        lamp.high_bay(level, x, 1544, 304, 110 if on else 40, "lamp_sodium", 420 if on else 8)
        lamp.bulkhead(level, (x + 40, 1616, 150), "-y", "lamp_warm", 300)
    for x in (60, 420, 980):
        crate.stack(level, rng, x, 1592, 0, 40, 2)
    pipe_run(level, "x", 0, 1264, 1606, 200)


def workshop(level, rng, rooms):
    room = rooms["workshop"]
    girders(level, room, 144)
    for x, y in grid(room, 4, 3):
        lamp.tube(level, x, y, 208, "x", "lamp_cool", 420, 72, 36, True)
    for x in (1310, 1450, 1590):
        level.add_detail(box((x, 8, 36), (x + 110, 48, 42), WOOD))
        for dx, dy in ((2, 10), (102, 10), (2, 40), (102, 40)):
            level.add_detail(box((x + dx, dy, 0), (x + dx + 6, dy + 6, 36), STEEL))
        level.add_detail(box((x, 0, 56), (x + 110, 4, 112), vigil("metal_wall", fit=True)))
        lamp.strip(level, (x + 20, 4, 116), (x + 90, 12, 120), "bottom", "lamp_warm", 300)
        crate.load(level, rng, (x + 6, 14, 42), (x + 100, 40), 22)
    # A lathe and a lifting platform in the middle.
    level.add_detail(box((1500, 210, 0), (1640, 250, 30), vigil("metal_green")),
                     box((1500, 214, 30), (1530, 246, 58), vigil("metal_green")),
                     box((1612, 218, 30), (1636, 242, 50), STEEL),
                     box((1400, 330, 0), (1520, 430, 6), HAZARD))
    level.add_detail(lying("x", 1530, 1612, [(230 + 6 * np.cos(a), 44 + 6 * np.sin(a))
                                            for a in 2 * np.pi * np.arange(8) / 8],
                           vigil("metal_plate")))
    crate.stack(level, rng, 1450, 380, 6, 48, 3)
    shelf(level, rng, (1650, 448, 0), (1840, 476, 120), 4)
    door(level)


def door(level):
    """The sliding door between workshop and boiler room carries a lamp on either side."""
    leaf = vigil("door_metal", fit=True)
    light = vigil("lamp_sodium").emissive(300).fitted()
    level.entity("func_door", [
        box((1861, 184, 0), (1867, 296, 120), {"all": STEEL, "-x": leaf, "+x": leaf}),
        box((1858, 228, 88), (1861, 252, 98), {"all": STEEL, "-x": light}),
        box((1867, 228, 88), (1870, 252, 98), {"all": STEEL, "+x": light}),
    ], angle=-1, speed=80, wait=3, lip=8, targetname="boiler_door")


def packing(level, rng, rooms):
    room = rooms["packing"]
    lanes(level, (1408, 1322, 2224, 1402, 0), 0, "x")
    girders(level, room, 136)
    for x, y in grid(room, 6, 3):
        lamp.high_bay(level, x, y, 272, 34, "lamp_sodium" if y > 1600 else "lamp_cool", 420)
    # A conveyor along the hall, turning the corner, with cartons on it.
    belt, frame = vigil("black"), vigil("metal_green")
    for lo, hi in (((1560, 1470), (2060, 1510)), ((2020, 1510), (2060, 1700))):
        level.add_detail(box((*lo, 30), (*hi, 34), {"all": frame, "top": belt}),
                         box((lo[0], lo[1], 24), (hi[0], lo[1] + 3, 38), frame),
                         box((lo[0], hi[1] - 3, 24), (hi[0] - 40 * (lo[0] < 2000), hi[1], 38),
                             frame))
    for x in range(1570, 2060, 80):
        level.add_detail(box((x, 1474, 0), (x + 5, 1478, 30), STEEL),
                         box((x, 1502, 0), (x + 5, 1506, 30), STEEL))
    for i, x in enumerate((1590, 1680, 1750, 1850, 1960)):
        size = (26, 24, 20) if i % 2 else (32, 28, 26)
        crate.carton(level, (x, 1478, 34), (x + size[0], 1478 + size[1], 34 + size[2]))
    # Packing tables with task lights.
    for x in (1560, 1700, 1840):
        level.add_detail(box((x, 1560, 32), (x + 90, 1604, 36), WOOD),
                         box((x + 2, 1562, 0), (x + 8, 1602, 32), STEEL),
                         box((x + 82, 1562, 0), (x + 88, 1602, 32), STEEL),
                         box((x, 1600, 36), (x + 3, 1603, 92), STEEL),
                         box((x + 87, 1600, 36), (x + 90, 1603, 92), STEEL),
                         box((x, 1580, 92), (x + 90, 1604, 95), STEEL))
        lamp.strip(level, (x + 10, 1584, 89), (x + 80, 1592, 92), "bottom", "lamp_panel", 260)
        crate.load(level, rng, (x + 4, 1564, 36), (x + 84, 1596), 26)
    for x, y in ((1450, 1290), (1800, 1290), (1960, 1280), (2140, 1290), (2150, 1450),
                 (1470, 1690), (1660, 1690), (1900, 1680), (2150, 1600)):
        if rng.random() < .5:
            z = crate.pallet(level, x, y, 0, 60)
            crate.stack(level, rng, x - 6, y, z, 40, 3)
        else:
            crate.stack(level, rng, x, y, 0, 52, 3)
    for x in (1408, 2216):
        for y in (1236, 1480, 1736):
            level.add_detail(box((x, y - 4, 0), (x + 8, y + 8, 272), GIRDER))
    for y in (1280, 1500, 1600):
        lamp.bulkhead(level, (2224, y - 30, 150), "-x", "lamp_warm", 300)


def battery(level, rng, rooms):
    room = rooms["battery"]
    girders(level, room, 136)
    for x, y in grid(room, 4, 2):
        lamp.tube(level, x, y, 208, "x", "lamp_cool", 360, 72, 20, True)
    for i in range(5):
        x = 2300 + 90 * i
        level.add_detail(box((x, 1716, 0), (x + 56, 1744, 84), {"all": STEEL, "-y":
                             vigil("metal_wall", fit=True)}))
        lamp.spot(level, (x + 28, 1716, 70), "-y", ("lamp_green", "lamp_red")[i % 2], 400, 8)
    forklift(level, 2420, 1580, 0)
    forklift(level, 2600, 1590, 0)


def stair_hall(level, rng, rooms):
    for x, y in grid(rooms["stair_hall"], 2, 3):
        lamp.high_bay(level, x, y, 320, 20, "lamp_warm", 420)
    # One flight up along the east wall to a landing, then west to the upper offices.
    stairs(level, (952, 1696, 0), (1036, 1872, 88), "+y", 11)
    level.add_detail(box((952, 1872, 80), (1040, 2000, 88), vigil("tread")))
    stairs(level, (792, 1880, 88), (952, 1976, 176), "-x", 11)
    level.add_detail(box((704, 1860, 168), (792, 2000, 176), vigil("tread")))
    for x, y in ((956, 1876), (1032, 1996)):
        level.add_detail(box((x - 3, y - 3, 0), (x + 3, y + 3, 80), STEEL))
    railing(level, (706, 1862, 176), (790, 1862, 176), 40, 3)
    level.add_detail(beam((704, 1864, 160), (792, 1864, 160), 6, 10, STEEL))
    for y in (1700, 1900):
        lamp.bulkhead(level, (704, y, 110), "+x", "lamp_warm", 400)
    crate.stack(level, rng, 740, 1940, 0, 40, 3)
