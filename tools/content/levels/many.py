# SPDX-License-Identifier: GPL-2.0-or-later
"""The levels `many_N`: one great hall, lit by N lamps, for N from 10 to 100,000.

Brush lamps (N up to 1,000) hang as lanterns; beyond that every lamp is a triangle of
models/lamps_N.glb: swags of small glass drops between the columns and chandeliers of drops. The
hall itself never changes.
"""

import numpy as np

import hall_lamps
from brush import box, circle, cylinder, frustum, lying, prism
from carver import Carver, Skin
from doorway import doorway
from house import prism_along
from map_file import Level
from material import vigil
from route import Route

LENGTH, NAVE, AISLE = 2048, 320, 224
HEIGHT, AISLE_HEIGHT = 512, 272
COLUMNS = [128 + 256 * i for i in range(8)]
CHANDELIERS = [(256 + 512 * i, 0) for i in range(4)]
BRUSH_LIMIT = 1000
STONE = vigil("concrete_panel")
PALE = vigil("marble")
DARK = vigil("marble_dark")
WOOD = vigil("beam")


def build(count):
    """The level and its camera route for count lamps."""
    level = Level("many_%d" % count, "Hall of %d lamps" % count)
    carver = Carver(16)
    hall = Skin(vigil("brick_pale"), vigil("marble_floor"), vigil("planks_old"),
                [(96, STONE)])
    side = Skin(STONE, vigil("parquet"), vigil("plaster"), [(56, vigil("plaster_green"))])
    carver.room((0, -NAVE, 0), (LENGTH, NAVE, HEIGHT), hall)
    for s in (-1, 1):
        lo, hi = sorted((s * NAVE, s * (NAVE + AISLE)))
        carver.room((0, lo, 0), (LENGTH, hi, AISLE_HEIGHT), side)
    vestry = Skin(vigil("brick"), vigil("planks"), vigil("plaster"))
    carver.room((LENGTH + 16, -256, 0), (LENGTH + 400, 256, 208), vestry)
    doorway(level, carver, (LENGTH, -80, 0), (LENGTH + 16, 80, 176), frame=WOOD)
    level.add(*carver.brushes())
    arcade(level)
    brackets(level)
    feast(level)
    organ(level)
    roof(level)
    chandeliers(level)
    furniture(level)
    rng = np.random.default_rng(count)
    if count <= BRUSH_LIMIT:
        lanterns(level, count, rng)
    else:
        level.entity("misc_model", model="models/lamps_%d.glb" % count, origin=(0, 0, 0), angle=0)
    camera = route()
    level.start(camera.keys[0][0], 0)
    return level, camera


def arcade(level):
    """Columns between nave and aisles, the wall above them, galleries' rails."""
    for s in (-1, 1):
        y = s * NAVE
        for x in COLUMNS:
            level.add_detail(box((x - 30, y - 30, 0), (x + 30, y + 30, 16), DARK),
                             cylinder((x, y), 22, 16, 208, PALE, 8),
                             frustum(np.column_stack([circle((x, y), 22, 4), np.full(4, 208.0)]),
                                     np.column_stack([circle((x, y), 44, 4), np.full(4, 232.0)]),
                                     PALE),
                             box((x - 32, y - 32, 232), (x + 32, y + 32, 244), DARK))
        lo, hi = sorted((y + s * 20, y - s * 20))
        level.add_detail(box((0, lo, 244), (LENGTH, hi, 288), STONE),
                         box((0, lo - 6, 288), (LENGTH, hi + 6, 298), PALE))
        for x in COLUMNS:
            a, b = sorted((y, y - s * 14))
            level.add_detail(box((x - 14, a, 298), (x + 14, b, 440), PALE))
        banners(level, s)
        wall = s * (NAVE + AISLE)
        for x in [c + 128 for c in COLUMNS[:-1]]:
            a, b = sorted((wall, wall - s * 10))
            level.add_detail(box((x - 52, a, 60), (x - 44, b, 200), WOOD.turned()),
                             box((x + 44, a, 60), (x + 52, b, 200), WOOD.turned()),
                             box((x - 52, a, 200), (x + 52, b, 210), WOOD),
                             box((x - 56, a, 52), (x + 56, b, 60), WOOD))
            a, b = sorted((wall, wall - s * 2))
            level.add_detail(box((x - 44, a, 60), (x + 44, b, 200), vigil("metal_blue")))
            a, b = sorted((wall - s * 2, wall - s * 6))
            level.add_detail(box((x - 3, a, 60), (x + 3, b, 200), WOOD.turned()),
                             *[box((x - 44, a, z), (x + 44, b, z + 4), WOOD)
                               for z in (104, 150)])
        a, b = sorted((wall, wall - s * 4))
        level.add_detail(box((0, a, 0), (LENGTH, b, 12), DARK))


def brackets(level):
    """Brackets from the columns to the wall of the nave."""
    for s in (-1, 1):
        y = s * NAVE
        for x0, x1 in zip(COLUMNS, COLUMNS[1:]):
            a, b = x0 + 32, x1 - 32
            for near, far, foot in ((a, a + 40, 196), (b, b - 40, 196)):
                outline = [(near, foot), (far, 244), (near, 244)]
                level.add_detail(prism_along("y", y - 12, y + 12, outline, PALE))


def feast(level):
    """A carpet down the nave and laid tables: bowls of fruit, jugs, loaves on linen."""
    rng = np.random.default_rng(21)
    carpet, edge = vigil("plaster_red", scale=.25), vigil("brass")
    level.add_detail(box((60, -56, 0), (1800, 56, .75), carpet))
    for y in (-50, 46):
        level.add_detail(box((60, y, .75), (1800, y + 4, 1), edge))
    clay = vigil("stucco_rose", scale=.25)
    bread, fruit = vigil("straw", scale=.35), (vigil("metal_red"), vigil("metal_orange"),
                                               vigil("metal_green"))
    for x in (420, 932, 1444):
        for y in (-150, 150):
            level.add_detail(box((x - 150, y - 11, 38), (x + 150, y + 11, 38.5),
                                 vigil("linen", scale=.25)))
            for i in range(4):
                at = x - 120 + 72 * i
                kind = (i + (y > 0)) % 3
                if kind == 0:
                    level.add_detail(*drums((at + 24, y), [(38.5, 4), (45, 6.5), (54, 3.5)], clay))
                elif kind == 1:
                    level.add_detail(*drums((at + 24, y), [(38.5, 4), (43, 11)], edge))
                    for k in range(3):
                        px, py = at + 24 + rng.uniform(-5, 5), y + rng.uniform(-5, 5)
                        level.add_detail(box((round(px) - 3, round(py) - 3, 43),
                                             (round(px) + 3, round(py) + 3, 48), fruit[k]))
                else:
                    level.add_detail(box((at + 14, y - 6, 38.5), (at + 34, y + 6, 45), bread))


def drums(centre, profile, material, sides=6):
    """Drums between the (height, radius) pairs of a turned profile."""
    return [frustum(np.column_stack([circle(centre, r0, sides), np.full(sides, float(z0))]),
                    np.column_stack([circle(centre, r1, sides), np.full(sides, float(z1))]),
                    material)
            for (z0, r0), (z1, r1) in zip(profile, profile[1:])]


def organ(level):
    """Organ pipes of brass over the doorway in the far wall, in three towers on a gallery."""
    level.add_detail(box((LENGTH - 60, -220, 204), (LENGTH, 220, 216), WOOD),
                     box((LENGTH - 64, -224, 216), (LENGTH - 58, 224, 222), WOOD))
    for y in np.arange(-216, 220, 48):
        level.add_detail(box((LENGTH - 62, y - 1.5, 222), (LENGTH - 59, y + 1.5, 244), WOOD))
    level.add_detail(box((LENGTH - 64, -224, 244), (LENGTH - 57, 224, 248), WOOD),
                     box((LENGTH - 40, -196, 216), (LENGTH, 196, 258), WOOD))
    for i in range(-8, 9):
        top = 430 - 13 * min(abs(i), abs(abs(i) - 8) + 2)
        level.add_detail(cylinder((LENGTH - 11, 23 * i), 8, 258, top, vigil("brass"), 6))


def banners(level, side):
    """Cloths on rods, high between the columns."""
    for i, x in enumerate(c + 128 for c in COLUMNS[:-1]):
        cloth = vigil(("plaster_red", "plaster_blue", "plaster_green")[(i + (side > 0)) % 3])
        a, b = sorted((side * (NAVE - 6), side * (NAVE - 4)))
        level.add_detail(box((x - 30, a, 312), (x + 30, b, 420), cloth),
                         box((x - 36, a - 1, 420), (x + 36, b + 1, 424), vigil("brass")))


def roof(level):
    """Open trusses: tie beam, struts and purlins under the ceiling."""
    for x in COLUMNS:
        level.add_detail(box((x - 9, -NAVE, 440), (x + 9, NAVE, 460), WOOD.turned()),
                         box((x - 7, -8, 460), (x + 7, 8, HEIGHT), WOOD.turned()))
        for s in (-1, 1):
            level.add_detail(lying("x", x - 6, x + 6, [(s * 300, 460), (s * 276, 460),
                                                      (s * 120, HEIGHT), (s * 144, HEIGHT)],
                                   WOOD))
    for y in (-200, 0, 200):
        level.add_detail(box((0, y - 6, HEIGHT - 12), (LENGTH, y + 6, HEIGHT), WOOD))


def chandeliers(level):
    """Iron hoops on chains; the lamps of the mesh levels hang below them."""
    iron = vigil("metal_dark")
    for x, y in CHANDELIERS:
        level.add_detail(box((x - 2, y - 2, 300), (x + 2, y + 2, HEIGHT - 12), iron))
        for radius, z in ((96, 296), (56, 320)):
            for a, b in zip(circle((x, y), radius, 8), np.roll(circle((x, y), radius, 8), -1, 0)):
                inner = .94
                level.add_detail(prism_ring((x, y), a, b, inner, z, iron))
        for a in (0, 90):
            level.add_detail(box((x - 92, y - 2, 297), (x + 92, y + 2, 300), iron)
                             .turned(a, (x, y, 0)))


def prism_ring(centre, a, b, inner, z, material):
    """One block of a hoop between corners a and b."""
    c = np.array(centre)
    return prism([c + inner * (a - c), a, b, c + inner * (b - c)], z, z + 5, material)


def furniture(level):
    """Long tables with benches, an altar block at the far end, barrels in the side room."""
    for x in (420, 932, 1444):
        for y in (-150, 150):
            level.add_detail(box((x - 150, y - 30, 34), (x + 150, y + 30, 38), vigil("planks")))
            for dx in (-130, 122):
                level.add_detail(box((x + dx, y - 24, 0), (x + dx + 8, y + 24, 34), WOOD.turned()))
            for dy in (-58, 44):
                level.add_detail(box((x - 150, y + dy, 18), (x + 150, y + dy + 14, 22),
                                     vigil("planks")),
                                 box((x - 130, y + dy + 2, 0), (x - 122, y + dy + 12, 18), WOOD),
                                 box((x + 122, y + dy + 2, 0), (x + 130, y + dy + 12, 18), WOOD))
    level.add_detail(box((1820, -200, 0), (2048, -96, 12), DARK),
                     box((1820, 96, 0), (2048, 200, 12), DARK),
                     box((1880, -176, 12), (1944, -120, 60), PALE),
                     box((1880, 120, 12), (1944, 176, 60), PALE))
    for x in (2120, 2200, 2300):
        level.add_detail(cylinder((x, 210), 26, 0, 64, WOOD, 8),
                         box((x - 24, -240, 0), (x + 24, -192, 48), vigil("crate", fit=True)))
    for s in (-1, 1):
        for x in (256, 768, 1280, 1792):
            level.add_detail(box((x - 60, s * 500 - 14, 0), (x + 60, s * 500 + 14, 20), WOOD))


def lanterns(level, count, rng):
    """count brush lamps at places spread over the hall: three-cornered, shining downwards, so that
    each is one triangle like the lamps of the mesh levels."""
    places = brush_places(count)
    colour, strength = hall_lamps.draw(count, places, rng)
    half = 18 if count <= 10 else 10 if count <= 100 else 5
    corners = np.round(half * np.array([(1, 0), (-.5, .9), (-.5, -.9)]))
    area = abs(np.cross(corners[1] - corners[0], corners[2] - corners[0])) / 2
    iron, brass = vigil("metal_dark"), vigil("brass")
    for (x, y, z, top), c, s in zip(places, colour, strength):
        radiance = hall_lamps.TOTAL_POWER / count * s / area
        name, rgb, _ = hall_lamps.COLOURS[c]
        value = max(1, round(radiance / (.1 * np.mean(rgb))))
        light = vigil(name).emissive(value).fitted()
        # A shade of brass; the largest lamps have a hood and hang in a hoop.
        low = np.column_stack([corners + [x, y], np.full(3, float(z))])
        high = np.column_stack([corners * .3 + [x, y], np.full(3, float(z + half))])
        level.add_detail(frustum(low, high, {"all": brass, "bottom": light}))
        if count <= 10:
            low = np.column_stack([corners * 1.5 + [x, y], np.full(3, z + half)])
            high = np.column_stack([corners * .3 + [x, y], np.full(3, z + 1.8 * half)])
            level.add_detail(frustum(low, high, brass))
            ring = circle((x, y), 2.2 * half, 8)
            for a, b in zip(ring, np.roll(ring, -1, 0)):
                level.add_detail(prism_ring((x, y), a, b, .9, z + half, iron))
            level.add_detail(box((x - 2.1 * half, y - 1, z + half), (x + 2.1 * half, y + 1,
                                                                     z + half + 2), iron))
        if count <= 100:
            level.add_detail(box((x - 1, y - 1, z + half), (x + 1, y + 1, top), iron))
    if count > 100:
        for x, z, lo, hi in sorted({(p[0], p[2], *strung(p[1])) for p in places}):
            level.add_detail(box((x - 1, lo, z + half), (x + 1, hi, z + half + 1), iron))


def strung(y):
    """Where the rope that carries a lamp at y begins and ends: nave or one of the aisles."""
    if abs(y) < NAVE:
        return (-NAVE, NAVE)
    lo, hi = sorted((np.sign(y) * NAVE, np.sign(y) * (NAVE + AISLE)))
    return (int(lo), int(hi))


def brush_places(count):
    """Places (x, y, z, height of the hook) of brush lamps: nave first, then aisles, then strings
    of lanterns across the nave."""
    if count <= 10:
        nave = [(x + 128, y, 300, HEIGHT) for x in (256, 640, 1024, 1408, 1792)
                for y in (-150, 150)]
        return nave[:count]
    out = []
    rows = [(-432, 190, AISLE_HEIGHT), (432, 190, AISLE_HEIGHT), (-180, 330, HEIGHT),
            (44, 290, HEIGHT), (180, 330, HEIGHT)]
    if count <= 100:
        per = int(np.ceil(count / len(rows)))
        for y, z, top in rows:
            for i in range(per):
                x = (i + .5) * LENGTH / per
                out.append((round(x), y, z + 6 * (i % 3), top))
        return out[:count]
    lines = int(np.ceil(count / 25))
    for i in range(lines):
        x = round((i + .5) * LENGTH / lines)
        for j in range(25):
            t = (j + .5) / 25
            y = (t - .5) * 2 * (NAVE + AISLE - 24)
            z = 330 + 24 * (i % 2)
            if abs(y) >= NAVE - 24:
                z = 186 + 12 * (i % 2)
                y = np.sign(y) * max(abs(y), NAVE + 44)
            out.append((x, round(y), round(z), 0))
    return out[:count]


def mesh_places(triangles):
    """Centres of the glass drops of a mesh of lamps: four triangles each."""
    count = triangles // 4
    rng = np.random.default_rng(triangles)
    hung = count // 3
    # A third hangs in the chandeliers: strands on cones between two hoops.
    which = np.arange(hung) % len(CHANDELIERS)
    angle = rng.uniform(0, 2 * np.pi, hung)
    t = np.sqrt(rng.uniform(0, 1, hung))
    radius = 6 + 86 * t
    z = 232 + 60 * t ** 2 + rng.uniform(-3, 3, hung)
    centres = np.array(CHANDELIERS)[which]
    drops = np.column_stack([centres[:, 0] + radius * np.cos(angle),
                             centres[:, 1] + radius * np.sin(angle), z])
    # The rest are swags: across the nave and along the aisles.
    rest = count - hung
    lines = 64
    i = np.arange(rest) % lines
    u = (np.arange(rest) // lines + .5) / np.ceil(rest / lines)
    across = i < 40
    x = np.where(across, 24 + (LENGTH - 48) * (i + .5) / 40, 24 + (LENGTH - 48) * u)
    y = np.where(across, (u - .5) * 2 * (NAVE - 34), 0)
    lane = (i - 40) // 2
    aisle_y = np.where(i % 2 == 0, 1, -1) * (NAVE + 34 + (AISLE - 60) * (lane + .5) / 12)
    y = np.where(across, y, aisle_y)
    sag = np.where(across, 400 - 70 * (1 - (2 * u - 1) ** 2), 0)
    bays = 7
    v = (u * bays) % 1
    z = np.where(across, sag, 236 - 26 * 4 * v * (1 - v))
    jitter = rng.uniform(-2.5, 2.5, (rest, 3))
    swags = np.column_stack([x, y, z]) + jitter
    return np.concatenate([drops, swags])


def write_lamps(path, triangles):
    """Writes models/lamps_N.glb; returns the number of its triangles."""
    return hall_lamps.write_mesh(path, mesh_places(triangles), np.random.default_rng(triangles))


def route():
    camera = Route(16)
    for eye, look in [
        ((80, 0, 60), (1000, 0, 150)), ((300, -30, 60), (1100, 100, 170)),
        ((560, 0, 62), (1200, -300, 180)), ((690, -225, 62), (1100, -440, 150)),
        ((768, -330, 60), (1200, -440, 130)), ((850, -412, 60), (1500, -420, 100)),
        ((1060, -420, 60), (1700, -200, 150)),
        ((1225, -392, 60), (1400, -100, 170)), ((1262, -310, 60), (1300, 200, 200)),
        ((1216, -215, 62), (1200, 300, 220)), ((1192, -80, 66), (1000, 300, 220)),
        ((1180, 30, 90), (500, 100, 230)), ((1180, 90, 150), (300, 0, 220)),
        ((1300, 20, 200), (1900, 0, 200)), ((1600, 0, 180), (2100, 0, 150)),
        ((1860, 0, 90), (2300, 20, 80)), ((2000, 0, 60), (2400, 60, 60)),
        ((2140, 10, 58), (2400, 100, 50)),
    ]:
        camera.key(eye, look)
    return camera
