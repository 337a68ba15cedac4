# SPDX-License-Identifier: GPL-2.0-or-later
"""Furniture and lamps of the level `warehouse`, one function per kind of room."""

import numpy as np

import crate
import lamp
from brush import beam, box, cylinder, lying
from material import WATER_SURFACE, vigil
from rack import rack, shelf
from stair import railing, stairs

GIRDER = vigil("metal_red")
PIPE = vigil("rust")
STEEL = vigil("metal_dark")
BLUE = vigil("metal_blue")
WOOD = vigil("planks", scale=.25)
WHITE = vigil("white")
HAZARD = vigil("hazard", scale=.25)


def furnish(level, rooms, aisles):
    """Adds everything that stands, hangs or shines in the rooms."""
    rng = np.random.default_rng(7)
    for i, (name, room) in enumerate(aisles.items()):
        aisle(level, rng, room, i, name)
    for place in (dock, corridors, north, boiler, pump, workshop, small_rooms, offices, cold,
                  lockers, packing, control, battery, stair_hall):
        place(level, rng, rooms)


def grid(room, columns, rows):
    """Evenly spread places over a room's plan."""
    x0, y0, x1, y1 = room[:4]
    return [(x0 + (x1 - x0) * (i + .5) / columns, y0 + (y1 - y0) * (j + .5) / rows)
            for i in range(columns) for j in range(rows)]


def girders(level, room, spacing, depth=20, width=10, along="y", material=GIRDER):
    """T-beams under a ceiling: web and lower flange."""
    x0, y0, x1, y1, _, z1, _ = room
    lo, hi = (x0, x1) if along == "y" else (y0, y1)
    count = int((hi - lo) // spacing)
    for i in range(count):
        at = lo + (hi - lo) * (i + .5) / count
        for half, low, high in ((2, z1 - depth + 3, z1), (width / 2, z1 - depth,
                                z1 - depth + 3)):
            if along == "y":
                level.add_detail(box((at - half, y0, low), (at + half, y1, high), material))
            else:
                level.add_detail(box((x0, at - half, low), (x1, at + half, high), material))


def skirting(level, room, height=8, material=vigil("concrete_dark")):
    """A kerb along the two long walls."""
    x0, y0, x1, _, z0, _, _ = room
    level.add_detail(box((x0, y0, z0), (x1, y0 + 2, z0 + height), material))


def pipe_run(level, axis, lo, hi, across, z, radius=5, material=PIPE):
    """A round pipe along an axis."""
    outline = [(across + radius * np.cos(a), z + radius * np.sin(a))
               for a in 2 * np.pi * (np.arange(6) + .5) / 6]
    if axis == "y":
        outline = [(-u, v) for u, v in outline]
    level.add_detail(lying(axis, lo, hi, outline, material))


def aisle(level, rng, room, index, name):
    """Racks on both sides between portals, tubes above, signal lamps on the posts."""
    x0, y0, x1, y1, _, z1, _ = room
    for a, b in ((652, 836), (860, 1036), (1060, 1236), (1260, 1444)):
        for left in (True, False):
            wall, front = (x0, x0 + 48) if left else (x1, x1 - 48)
            rack(level, rng, wall, front, a, b, 0, (10, 84, 156), 236, 2)
            face = "+x" if left else "-x"
            texture = ("lamp_green", "lamp_red", "lamp_blue", "lamp_warm")[int(rng.integers(0, 4))]
            lamp.spot(level, (front, (a + b) / 2, 118 + 24 * (index % 2)), face, texture, 300)
        middle = (x0 + x1) / 2
        for y in (a + 46, b - 46):
            lamp.tube(level, middle, y, z1, "y", ("lamp_cool", "lamp_warm")[index % 2], 500, 72,
                      48, True)
        level.add_detail(box((x0, (a + b) / 2 - 5, z1 - 18), (x1, (a + b) / 2 + 5, z1), GIRDER))
    sign = vigil("sign_" + name[-1], fit=True)
    for y, face in ((632, "-y"), (1464, "+y")):
        lo, hi = (y - 12, y - 8) if face == "-y" else (y + 8, y + 12)
        base = 142 if face == "-y" else 190
        level.add_detail(box((middle - 16, lo, base), (middle + 16, hi, base + 32),
                             {"all": STEEL, face: sign}))


def lanes(level, room, margin, along):
    """Two painted lines on the floor beside the way through a hall."""
    x0, y0, x1, y1, z0 = room[:5]
    paint = vigil("paint_yellow")
    if along == "x":
        for y in (y0 + margin, y1 - margin):
            level.add_detail(box((x0 + 8, y - 3, z0), (x1 - 8, y + 3, z0 + .25), paint))
    else:
        for x in (x0 + margin, x1 - margin):
            level.add_detail(box((x - 3, y0 + 8, z0), (x + 3, y1 - 8, z0 + .25), paint))


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
    for x, y in grid(room, 6, 3):
        lamp.high_bay(level, x, y, 288, 34, "lamp_sodium", 420)
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
        crate.stack(level, rng, x - 8, y, 9, 44, 3)
    for x in (80, 116, 152):
        crate.barrel(level, 30, x, 0, ("metal_blue", "metal_red", "metal_green")[x % 3])
    forklift(level, 640, 300, 0)
    for x in (0, 480, 952):
        level.add_detail(box((x, 0, 0), (x + 8, 12, 288), GIRDER),
                         box((x, 468, 0), (x + 8, 480, 288), GIRDER))
    railing(level, (700, 30, 0), (700, 90, 0), 40, 3)


def forklift(level, x, y, z):
    """A forklift truck facing +x, about 100 long; its two headlamps shine."""
    dark, paint = vigil("black"), vigil("metal_orange")
    level.add_detail(box((x, y, z + 10), (x + 64, y + 40, z + 36), paint),
                     box((x, y + 4, z + 36), (x + 18, y + 36, z + 56), paint),
                     box((x + 22, y + 8, z + 36), (x + 40, y + 32, z + 42), dark),
                     box((x + 4, y + 2, z + 88), (x + 60, y + 38, z + 92), dark))
    for dx, dy in ((4, 2), (4, 35), (57, 2), (57, 35)):
        level.add_detail(box((x + dx, y + dy, z + 36), (x + dx + 3, y + dy + 3, z + 88), dark))
    for dy in (-4, 36):
        for dx in (6, 44):
            level.add_detail(lying("y", y + dy, y + dy + 8, [
                (-(x + dx + 8) + 9 * np.cos(a), z + 9 + 9 * np.sin(a))
                for a in 2 * np.pi * np.arange(10) / 10], dark))
    for dy in (8, 28):
        level.add_detail(box((x + 64, y + dy, z + 2), (x + 68, y + dy + 4, z + 100), dark),
                         box((x + 68, y + dy, z + 4), (x + 106, y + dy + 4, z + 7), dark))
        lamp.spot(level, (x + 64, y + dy - 5, z + 60), "+x", "lamp_warm", 500, 5)


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
    for x in (80, 236, 396, 552, 712, 868, 1028, 1184):
        lamp.high_bay(level, x, 1544, 304, 40, "lamp_sodium", 420)
        lamp.bulkhead(level, (x + 40, 1616, 150), "-y", "lamp_warm", 300)
    for x in (60, 420, 980):
        crate.stack(level, rng, x, 1592, 0, 40, 2)
    pipe_run(level, "x", 0, 1264, 1606, 200)


def boiler(level, rng, rooms):
    room = rooms["boiler"]
    girders(level, room, 128, along="x")
    # Landing along two walls at z 0, stairs down to the floor at -64.
    grate = vigil("grate", scale=.5)
    level.add_detail(box((1872, 400, -6), (2384, 480, 0), grate),
                     box((1872, 160, -6), (1952, 400, 0), grate))
    for x, y in ((1944, 168), (1944, 280), (1944, 404), (2060, 404), (2170, 404), (2376, 404)):
        level.add_detail(box((x - 4, y - 4, -64), (x + 4, y + 4, -6), STEEL))
    stairs(level, (2288, 272, -64), (2376, 400, 0), "+y", 8)
    railing(level, (1952, 402, 0), (2288, 402, 0), 40, 6)
    railing(level, (1952, 162, 0), (1952, 402, 0), 40, 5)
    level.add_detail(box((2000, 96, -112), (2208, 256, -76), WATER_SURFACE))
    for lo, hi in (((1992, 88), (2216, 96)), ((1992, 256), (2216, 264)),
                   ((1992, 96), (2000, 256)), ((2208, 96), (2216, 256))):
        level.add_detail(box((*lo, -64), (*hi, -54), HAZARD))
    # Under water: two lamps in the basin's wall.
    for y in (130, 222):
        lamp.strip(level, (2000, y - 10, -96), (2004, y + 10, -88), "+x", "lamp_blue", 600)
    # Three boilers with glowing grates.
    for i in range(3):
        y = 60 + 0 * i
        x = 2030 + 90 * i
        level.add_detail(cylinder((x, y - 20), 36, -64, 70, vigil("metal_plate"), 14),
                         cylinder((x, y - 20), 12, 70, 240, PIPE, 8),
                         box((x - 16, y + 12, -50), (x + 16, y + 18, -26), STEEL))
        lamp.strip(level, (x - 12, y + 18, -46), (x + 12, y + 20, -30), "+y", "lamp_red", 300)
    for y in (40, 120, 330, 440):
        lamp.bulkhead(level, (2384, y, 90), "-x", "lamp_red", 500, (16, 16))
    for x, y in ((1940, 240), (2080, 320), (2240, 320), (2130, 176)):
        lamp.high_bay(level, x, y, 240, 30, "lamp_warm", 260)
    for z in (120, 150, 180):
        pipe_run(level, "x", 1872, 2384, 470, z, 6)
    pipe_run(level, "y", 0, 480, 1882, 190, 9)


def pump(level, rng, rooms):
    for x in (2480, 2580, 2680):
        level.add_detail(cylinder((x, 180), 26, -64, -10, vigil("metal_green"), 12),
                         cylinder((x, 180), 10, -10, 128, PIPE, 8),
                         box((x - 34, 140, -64), (x + 34, 220, -56), HAZARD))
        lamp.spot(level, (x, 240, 40), "-y", "lamp_green", 500, 10)
    for x, y in grid(rooms["pump"], 4, 2):
        lamp.tube(level, x, y, 128, "x", "lamp_cool", 300, 48)
    pipe_run(level, "x", 2400, 2784, 228, 90, 8)
    for x, y in grid(rooms["parts"], 3, 2):
        lamp.tube(level, x, y, 144, "x", "lamp_cool", 300, 56, 0, True)
    for y in (270, 400):
        shelf(level, rng, (2420, y, 0), (2520, y + 28, 112), 4)
        shelf(level, rng, (2660, y, 0), (2770, y + 28, 112), 4)


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


def small_rooms(level, rng, rooms):
    for name, columns, rows, texture in (("tool_store", 2, 2, "lamp_cool"),
                                         ("janitor", 2, 1, "lamp_warm"),
                                         ("wash", 2, 2, "lamp_cool"),
                                         ("cage", 3, 3, "lamp_warm"),
                                         ("plant", 4, 1, "lamp_cool")):
        room = rooms[name]
        for x, y in grid(room, columns, rows):
            lamp.tube(level, x, y, room[5], "x", texture, 360, 56)
    for x in (990, 1120):
        shelf(level, rng, (x, 250, 0), (x + 90, 278, 112), 4)
    shelf(level, rng, (1230, 300, 0), (1258, 440, 112), 4)
    shelf(level, rng, (1640, 500, 0), (1740, 524, 112), 4)
    crate.barrel(level, 1830, 520, 0, "metal_red")
    crate.barrel(level, 1800, 514, 0, "metal_blue")
    # Wash room: partitions and basins.
    for x in (1470, 1530):
        level.add_detail(box((x, 590, 8), (x + 3, 656, 100), vigil("metal_green")))
    for x in (1570,):
        for y in (510, 550, 590):
            level.add_detail(box((x + 26, y, 34), (x + 46, y + 24, 40), WHITE))
            lamp.bulkhead(level, (1616, y + 12, 88), "-x", "lamp_panel", 260, (16, 6))
    # Cage store: mesh partitions and crates.
    for y in (1740, 1870):
        for x in range(1072, 1250, 22):
            level.add_detail(box((x, y - 1, 4), (x + 2, y + 1, 128), STEEL))
        level.add_detail(box((1056, y - 2, 128), (1250, y + 3, 134), STEEL),
                         box((1056, y - 2, 0), (1250, y + 3, 4), STEEL))
        crate.stack(level, rng, 1100, y + 50, 0, 48, 3)
        crate.stack(level, rng, 1190, y + 54, 0, 40, 2)
    # Plant room: ventilation boxes.
    for x in (2300, 2420, 2660):
        level.add_detail(box((x, 1160, 0), (x + 90, 1214, 96), vigil("metal_wall", fit=True)),
                         box((x + 30, 1170, 96), (x + 60, 1200, 160), vigil("metal_plate")))
        lamp.spot(level, (x + 45, 1160, 70), "-y", "lamp_red", 300, 6)
    # Vestibule.
    for x, y in grid(rooms["vestibule"], 3, 1):
        lamp.tube(level, x, y, 176, "x", "lamp_warm", 360, 72, 0, True)
    crate.stack(level, rng, 1920, 600, 0, 44, 3)
    for x in (2280, 2320, 2350):
        crate.barrel(level, x, 520, 0, "metal_green")


def desk(level, x, y, z, screen="-x", size=(40, 88)):
    """A desk with a lit screen on it."""
    w, d = size
    level.add_detail(box((x, y, z + 28), (x + w, y + d, z + 31), WOOD),
                     box((x + 2, y + 2, z), (x + w - 2, y + 8, z + 28), STEEL),
                     box((x + 2, y + d - 22, z), (x + w - 2, y + d - 2, z + 28), STEEL))
    light = vigil("screen").emissive(60).fitted()
    middle = y + d * .4
    level.add_detail(box((x + 16, middle - 12, z + 36), (x + 20, middle + 12, z + 54),
                         {"all": STEEL, screen: light}),
                     box((x + 17, middle - 3, z + 31), (x + 19, middle + 3, z + 36), STEEL))
    seat = x - 26 if screen == "-x" else x + w + 6
    level.add_detail(box((seat, middle - 10, z + 16), (seat + 20, middle + 10, z + 19), BLUE),
                     cylinder((seat + 10, middle), 3, z, z + 16, STEEL, 6))


def offices(level, rng, rooms):
    for name, columns, rows in (("dock_office", 3, 2), ("records", 4, 2), ("archive", 3, 3),
                                ("office_a", 3, 3), ("office_b", 2, 3)):
        room = rooms[name]
        for x, y in grid(room, columns, rows):
            lamp.panel(level, x, y, room[5], 40, "lamp_panel", 140)
    for x, y, z in ((1040, 30, 0), (1150, 30, 0), (60, 1700, 176), (60, 1820, 176),
                    (230, 1700, 176), (230, 1860, 176), (500, 1700, 176), (500, 1840, 176)):
        desk(level, x, y, z)
    for x in (20, 110, 200, 290):
        for y in (1740, 1850):
            shelf(level, rng, (x, y, 0), (x + 76, y + 24, 112), 4)
    for x in (2420, 2500, 2680):
        level.add_detail(box((x, 632, 0), (x + 70, 654, 84), {"all": STEEL, "-y":
                             vigil("locker", fit=True)}))
        shelf(level, rng, (x, 500, 0), (x + 20, 580, 100), 4)


def cold(level, rng, rooms):
    for name in ("cold_a", "cold_b"):
        room = rooms[name]
        for x, y in grid(room, 3, 3):
            lamp.tube(level, x, y, 208, "x", "lamp_cool", 420, 72, 0, True)
        x0, y0, x1, y1 = room[:4]
        for y in (y0 + 60, y1 - 110):
            shelf(level, rng, (x0 + 60, y, 0), (x0 + 160, y + 44, 130), 3, vigil("metal_plate"))
            shelf(level, rng, (x1 - 160, y, 0), (x1 - 60, y + 44, 130), 3, vigil("metal_plate"))
        for x in (x0 + 100, x1 - 170):
            level.add_detail(box((x, y1 - 24, 150), (x + 70, y1, 190),
                                 {"all": vigil("metal_plate"), "-y": vigil("grate", scale=.25)}))
        lamp.spot(level, (x0 + 200, y0, 150), "+y", "lamp_blue", 600, 14)
        lamp.spot(level, (x0 + 200, y1, 150), "-y", "lamp_blue", 600, 14)


def lockers(level, rng, rooms):
    room = rooms["lockers"]
    for x, y in grid(room, 5, 2):
        lamp.tube(level, x, y, 160, "x", "lamp_warm", 360, 60)
    front = vigil("locker", fit=True)
    for x in range(2260, 2430, 56):
        level.add_detail(box((x, 1020, 0), (x + 56, 1056, 100), {"all": STEEL, "-y": front}))
    for x in range(2560, 2780, 56):
        level.add_detail(box((x, 816, 0), (x + 56, 850, 100), {"all": STEEL, "+y": front}))
    for x in (2300, 2560):
        level.add_detail(box((x, 920, 18), (x + 140, 944, 22), WOOD),
                         box((x + 10, 926, 0), (x + 16, 938, 18), STEEL),
                         box((x + 124, 926, 0), (x + 130, 938, 18), STEEL))


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


def control(level, rng, rooms):
    room = rooms["control"]
    for x, y in grid(room, 4, 2):
        lamp.panel(level, x, y, 176, 36, "lamp_green", 50)
    face = vigil("console", fit=True)
    light = vigil("screen").emissive(80).fitted()
    for i in range(6):
        x = 2270 + 84 * i
        level.add_detail(box((x, 1452, 0), (x + 80, 1486, 36), {"all": STEEL, "-y": face}),
                         box((x, 1470, 36), (x + 80, 1486, 120), {"all": STEEL}),
                         box((x + 8, 1466, 62), (x + 72, 1470, 110), {"all": STEEL,
                                                                        "-y": light}))
    for i in range(4):
        x = 2560 + 56 * i
        level.add_detail(box((x, 1232, 0), (x + 50, 1262, 120), {"all": STEEL, "+y":
                             vigil("metal_wall", fit=True)}))
        for k in range(3):
            lamp.spot(level, (x + 12 + 12 * k, 1262, 90), "+y",
                      ("lamp_green", "lamp_red", "lamp_blue")[(i + k) % 3], 300, 4)
    desk(level, 2360, 1330, 0)
    desk(level, 2500, 1330, 0)
    # Electrical room: switch cabinets.
    for i in range(4):
        x = 430 + 60 * i
        level.add_detail(box((x, 1960, 0), (x + 56, 2000, 112), {"all": STEEL, "-y": face}))
        lamp.spot(level, (x + 28, 1960, 104), "-y", ("lamp_green", "lamp_red")[i % 2], 300, 5)
    for x, y in grid(rooms["electrical"], 2, 3):
        lamp.tube(level, x, y, 144, "x", "lamp_cool", 300, 48)


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
