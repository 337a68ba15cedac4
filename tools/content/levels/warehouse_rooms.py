# SPDX-License-Identifier: GPL-2.0-or-later
"""Furniture and lamps of the level `warehouse`, one function per kind of room; the large spaces are
in warehouse_halls.py.
"""

import numpy as np

import crate
import lamp
import warehouse_halls as halls
from brush import box, cylinder
from depot import BLUE, HAZARD, PIPE, STEEL, WHITE, WOOD, girders, grid, pipe_run
from material import WATER_SURFACE, vigil
from rack import shelf
from stair import railing, stairs


def furnish(level, rooms, aisles):
    """Adds everything that stands, hangs or shines in the rooms."""
    rng = np.random.default_rng(7)
    for i, (name, room) in enumerate(aisles.items()):
        halls.aisle(level, rng, room, i, name)
    for place in (halls.dock, halls.corridors, halls.north, boiler, pump, halls.workshop,
                  small_rooms, offices, cold, lockers, halls.packing, control, halls.battery,
                  halls.stair_hall):
        place(level, rng, rooms)


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
