# SPDX-License-Identifier: GPL-2.0-or-later
"""The level `room`: a painter's studio under the roof, lit by the evening sun and the sky through
tall windows, and by nothing else.

Four windows in the south wall let the sun in, two in the east wall only the sky. A library in the
north gets what comes through its doorway. Roofs of a town lie outside.
"""

import numpy as np

import farm
import furniture
from brush import beam, box, circle, cylinder, frustum, prism
from carver import Carver, Skin
from house import Facade, chimney, gable, prism_along
from map_file import Level
from material import SKY_BOX, vigil
from plant import cypress
from route import Route
from sky import EVENING_SUN

# The studio, the library beyond its north wall, and the space outside the windows.
WIDTH, DEPTH, HEIGHT = 768, 416, 256
WALL = 32
LIBRARY = (64, 384, DEPTH + WALL, DEPTH + WALL + 256, 176)
OUT, STREET, TOP = 448, -256, 384
DOORWAY = (192, 256, 120)
SOUTH_WINDOWS = [(72, 152), (232, 312), (392, 472), (552, 632)]
EAST_WINDOWS = [(96, 168), (248, 320)]
SILL, HEAD = 36, 204
PALE, STUCCO, ROSE = vigil("stucco_pale"), vigil("stucco"), vigil("stucco_rose")
WHITE = vigil("plaster")
OAK = vigil("beam", scale=.35)
WALNUT = vigil("walnut")
FLOOR = vigil("planks")
STONE = vigil("flagstones")
LINEN = vigil("linen", scale=.25)


def build():
    """The level and its camera route: along the windows, round the table, into the library."""
    level = Level("room", "The studio", sky="evening", _sun_light=110, _sun_color="1 0.72 0.44",
                  _sun_mangle="%d %d 0" % EVENING_SUN)
    carver = Carver(WALL / 2)
    plaster = Skin(WHITE, FLOOR, WHITE)
    carver.room((0, 0, 0), (WIDTH, DEPTH, HEIGHT), plaster)
    x0, x1, y0, y1, high = LIBRARY
    carver.room((x0, y0, 0), (x1, y1, high), Skin(vigil("plaster_green"), vigil("parquet"), WHITE))
    carver.room((DOORWAY[0], DEPTH, 0), (DOORWAY[1], y0, DOORWAY[2]), Skin(WALNUT, FLOOR, WALNUT))
    reveal = Skin(WHITE, STONE, WHITE)
    for a0, a1 in SOUTH_WINDOWS:
        carver.room((a0, -WALL, SILL), (a1, 0, HEAD), reveal)
    for a0, a1 in EAST_WINDOWS:
        carver.room((WIDTH, a0, SILL), (WIDTH + WALL, a1, HEAD), reveal)
    outside(carver)
    level.add(*carver.brushes())
    windows(level)
    woodwork(level)
    studio(level)
    drapes(level)
    utensils(level)
    library(level)
    town(level)
    camera = route()
    level.start((96, 300, 64), 0)
    return level, camera


def outside(carver):
    """Air outside the south and the east wall: a slice with the facade, beyond it the sky."""
    facade = Skin(STUCCO, vigil("cobbles"), SKY_BOX)
    sky = Skin(SKY_BOX, vigil("cobbles"), SKY_BOX)
    end = WIDTH + WALL
    carver.room((-OUT, -OUT, STREET), (end + OUT, -WALL - 8, TOP), sky)
    carver.room((end + 8, -OUT, STREET), (end + OUT, DEPTH + OUT, TOP), sky)
    carver.room((-OUT, -WALL - 8, STREET), (end, -WALL, TOP), facade)
    carver.room((end, -WALL - 8, STREET), (end + 8, DEPTH + OUT, TOP), facade)


def windows(level):
    """Frames with narrow panes at the outer face, sills, and a rail before each window."""
    south = Facade("x", -WALL, -1, WALL, STUCCO, WHITE)
    east = Facade("y", WIDTH + WALL, 1, WALL, STUCCO, WHITE)
    for facade, spans in ((south, SOUTH_WINDOWS), (east, EAST_WINDOWS)):
        for a0, a1 in spans:
            level.add_detail(*facade.window((a0, a1, SILL, HEAD), 3, 5, shutters=False, back=6))
            # A wooden board inside, on the sill, and a lintel board over it.
            level.add_detail(facade.box((a0 - 6, a1 + 6), (-WALL - 5, -WALL), (SILL - 4, SILL),
                                        WALNUT),
                             facade.box((a0 - 6, a1 + 6), (-WALL - 4, -WALL), (HEAD, HEAD + 8),
                                        WALNUT))
            for side in ((a0 - 6, a0), (a1, a1 + 6)):
                level.add_detail(facade.box(side, (-WALL - 3, -WALL), (SILL, HEAD),
                                            WALNUT.turned()))


def woodwork(level):
    """Skirting, ceiling beams with braces, the frame of the doorway."""
    for lo, hi in (((0, 0), (WIDTH, 3)), ((0, 3), (3, DEPTH)), ((WIDTH - 3, 3), (WIDTH, DEPTH)),
                   ((3, DEPTH - 3), (DOORWAY[0] - 10, DEPTH)),
                   ((DOORWAY[1] + 10, DEPTH - 3), (WIDTH - 3, DEPTH))):
        level.add_detail(box((*lo, 0), (*hi, 12), WALNUT))
    for x in (32, 192, 352, 512, 672):
        level.add_detail(box((x - 9, 0, HEIGHT - 22), (x + 9, DEPTH, HEIGHT), OAK.turned()))
        for y, s in ((0, 1), (DEPTH, -1)):
            level.add_detail(box((x - 7, min(y, y + 12 * s), 150), (x + 7, max(y, y + 12 * s),
                                                                    HEIGHT - 22), OAK.turned()),
                             beam([x, y + 6 * s, 172], [x, y + 62 * s, HEIGHT - 24], 10, 10, OAK))
    for y in (104, 208, 312):
        level.add_detail(box((0, y - 6, HEIGHT - 12), (WIDTH, y + 6, HEIGHT), OAK))
    d0, d1, top = DOORWAY
    for y in (DEPTH - 4, DEPTH + WALL):
        level.add_detail(box((d0 - 9, y, 0), (d0, y + 4, top + 9), WALNUT.turned()),
                         box((d1, y, 0), (d1 + 9, y + 4, top + 9), WALNUT.turned()),
                         box((d0, y, top), (d1, y + 4, top + 9), WALNUT))


def studio(level):
    """Easels, a long table, shelves, a model's dais, paintings on and against the walls."""
    furniture.easel(level, 330, 96, 0, 140, "painting_dunes", 72, 48)
    furniture.easel(level, 520, 110, 0, 160, "painting_trees", 48, 48)
    furniture.stool(level, 282, 132, 0)
    furniture.stool(level, 462, 140, 0)
    furniture.table(level, (580, 300), (716, 360), 0)
    for x, y, yaw in ((612, 286, 88), (664, 284, 96), (704, 376, -110)):
        furniture.chair(level, x, y, 0, yaw)
    for x, y, size in ((596, 334, 5), (608, 346, 4), (690, 318, 6)):
        level.add_detail(box((x - size / 2, y - size / 2, 32), (x + size / 2, y + size / 2,
                                                                32 + 1.8 * size), vigil("brass")))
    level.add_detail(box((634, 318, 32), (672, 344, 33), vigil("white")),
                     box((640, 322, 33), (658, 336, 36), vigil("plaster_red", scale=.25)))
    furniture.rug(level, (356, 96), (548, 192), 0)
    furniture.chest(level, 720, 212, 0, 90)
    # The dais with a draped seat.
    level.add_detail(box((40, 300, 0), (152, 400, 14), OAK),
                     box((66, 344, 14), (126, 392, 38), LINEN),
                     box((62, 388, 14), (130, 398, 92), vigil("plaster_red", scale=.25)),
                     box((64, 342, 36), (128, 390, 40), vigil("plaster_red", scale=.25)))
    # Canvases that lean on the wall, and pictures that hang.
    for i, (x, w, h, name) in enumerate(((420, 64, 52, "sea"), (452, 52, 64, "rings"),
                                         (500, 72, 48, "squares"))):
        board = box((-1.5, -w / 2, -h / 2), (1.5, w / 2, h / 2),
                    {"all": LINEN, "+x": vigil("painting_" + name, fit=True)})
        lean = 14 + 3 * i
        level.add_detail(furniture.tilted(board, lean, -90, [
            x, DEPTH - 6 - h / 2 * np.sin(np.radians(lean)) - 3 * i,
            h / 2 * np.cos(np.radians(lean)) + 1]))
    for x, z, w, h, name in ((350, 140, 96, 64, "field"), (464, 148, 64, 80, "dunes"),
                             (590, 144, 112, 74, "sea")):
        level.add_detail(box((x - w / 2 - 4, DEPTH - 4, z - h / 2 - 4),
                             (x + w / 2 + 4, DEPTH, z + h / 2 + 4), WALNUT),
                         box((x - w / 2, DEPTH - 6, z - h / 2), (x + w / 2, DEPTH - 4, z + h / 2),
                             {"all": WALNUT, "-y": vigil("painting_" + name, fit=True)}))
    # A cast-iron stove in the west with its pipe, and a cupboard.
    iron = vigil("metal_dark")
    level.add_detail(box((14, 150, 8), (50, 190, 56), iron),
                     box((10, 146, 56), (54, 194, 60), iron),
                     box((26, 164, 60), (38, 176, HEIGHT), iron),
                     box((0, 120, 0), (72, 220, 3), STONE),
                     box((3, 20, 0), (27, 108, 116), WALNUT),
                     box((3, 16, 116), (31, 112, 122), OAK))
    for dx in (16, 44):
        for dy in (152, 184):
            level.add_detail(box((dx - 2, dy - 2, 3), (dx + 2, dy + 2, 8), iron))


def drapes(level):
    """Linen curtains, drawn aside, on rods before the south windows; plants on two sills."""
    rng = np.random.default_rng(4)
    for a0, a1 in SOUTH_WINDOWS:
        level.add_detail(box((a0 - 26, 8, HEAD + 14), (a1 + 26, 11, HEAD + 17), vigil("brass")))
        for side, edge in ((-1, a0 - 4), (1, a1 + 4)):
            for i in range(4):
                lo, hi = sorted((edge + side * (5 * i - 4), edge + side * (5 * i + 1)))
                out = 5 + 3 * (i % 2)
                level.add_detail(box((lo, out, 16), (hi, out + 3, HEAD + 14), LINEN))
    for x, kind in ((250, 9), (292, 8), (576, 8), (612, 10)):
        farm.pot(level, x, -12, SILL, rng, kind)


def utensils(level):
    """What a painter has about: a palette, jars of brushes, tubes of colour, plaster casts."""
    clay, cast = vigil("stucco_rose", scale=.25), vigil("white")
    for x, y, z in ((486, 84, 0), (604, 318, 32), (700, 342, 32)):
        if z == 0:
            level.add_detail(box((x - 14, y - 12, 0), (x + 14, y + 12, 26), OAK))
            z = 26
        level.add_detail(cylinder((x, y), 4, z, z + 8, clay, 8))
        for dx, dy, high in ((-2, -1, 21), (0, 2, 24), (2, -1, 19), (1, 0, 22)):
            level.add_detail(beam((x + .4 * dx, y + .4 * dy, z + 6), (x + 1.6 * dx, y + 1.6 * dy,
                                                                       z + high), .9, .9, OAK))
    level.add_detail(prism(circle((668, 352), 9, 9), 32, 32.8, WALNUT))
    for dx, dy, paint in ((-4, 2, "metal_red"), (0, 5, "metal_blue"), (4, 2, "paint_yellow"),
                          (4, -3, "metal_green")):
        level.add_detail(box((667 + dx, 351 + dy, 32.8), (669 + dx, 353 + dy, 33.4), vigil(paint)))
    # A turned column with a cast of a head, and a vase on the cupboard.
    for x, y, z, scale in ((716, 60, 0, 1.0), (15, 60, 122, .5)):
        if z == 0:
            level.add_detail(box((x - 13, y - 13, 0), (x + 13, y + 13, 5), STONE),
                             cylinder((x, y), 9, 5, 52, WHITE, 10),
                             box((x - 12, y - 12, 52), (x + 12, y + 12, 56), STONE))
            z = 56
        profile = [(0, 8), (5, 5), (9, 4), (13, 7.5), (20, 8.5), (26, 7), (30, 3)]
        for (z0, r0), (z1, r1) in zip(profile, profile[1:]):
            low = np.column_stack([circle((x, y), r0 * scale, 9), np.full(9, z + z0 * scale)])
            high = np.column_stack([circle((x, y), r1 * scale, 9), np.full(9, z + z1 * scale)])
            level.add_detail(frustum(low, high, cast))


def library(level):
    """Walls of books, a desk, a chair; no window."""
    x0, x1, y0, y1, high = LIBRARY
    for a in range(x0 + 8, x1 - 60, 76):
        furniture.bookcase(level, (a, y1 - 24, 0), (a + 72, y1, 128), "-y")
    for a in (y0 + 40, y0 + 116):
        furniture.bookcase(level, (x0, a, 0), (x0 + 24, a + 72, 128), "+x")
    furniture.table(level, (250, 560), (340, 610), 0, 30, WALNUT)
    furniture.chair(level, 296, 630, 0, -92)
    furniture.rug(level, (150, 520), (342, 616), 0)
    level.add_detail(box((272, 574, 30), (298, 592, 33), vigil("plaster_red", scale=.25)),
                     box((276, 577, 33), (300, 593, 35), vigil("plaster_blue", scale=.25)),
                     box((x1 - 4, y0 + 70, 60), (x1, y0 + 166, 124),
                         {"all": WALNUT, "-x": vigil("painting_rings", fit=True)}))
    furniture.chest(level, 352, 480, 0, 90)
    for a in range(x0 + 40, x1, 80):
        level.add_detail(box((a - 6, y0, high - 12), (a + 6, y1, high), OAK.turned()))


def town(level):
    """Roofs and chimneys below the windows, a row of cypresses; they send light up to the
    ceiling."""
    for lo, hi, eave, wall in (((-330, -400), (40, -170), -110, ROSE),
                               ((120, -420), (420, -180), -150, PALE),
                               ((500, -400), (900, -190), -90, STUCCO)):
        level.add_detail(box((*lo, STREET - 8), (*hi, eave), wall))
        for part in gable("x", (lo[0], hi[0]), (lo[1], hi[1]), eave, .625, wall, 16):
            level.add_detail(part)
    for lo, hi, eave, wall in (((980, 40), (1190, 300), -70, PALE),
                               ((1000, 380), (1200, 640), -120, ROSE)):
        level.add_detail(box((*lo, STREET - 8), (*hi, eave), wall))
        for part in gable("y", (lo[1], hi[1]), (lo[0], hi[0]), eave, .625, wall, 16):
            level.add_detail(part)
    level.add_detail(*chimney(-60, -320, -140, 14), *chimney(330, -330, -150, -22),
                     *chimney(820, -250, -90, 26), *chimney(1120, 220, -70, 36))
    for x, y, height in ((450, -360, 330), (80, -250, 290), (1080, 342, 320), (940, -60, 250)):
        cypress(level, x, y, STREET, height, height * .1)
    # A flag pole and a wire's mast on the roofs.
    level.add_detail(box((638, -297, -30), (642, -293, 190), vigil("metal_dark")),
                     prism_along("x", 600, 680, [(-296, 150), (-294, 150), (-294, 152),
                                                 (-296, 152)], vigil("metal_dark")))


def route():
    camera = Route(18)
    for eye, look in [
        ((64, 290, 72), (500, 170, 90)), ((130, 270, 74), (620, 150, 90)),
        ((260, 244, 76), (640, 240, 70)), ((420, 240, 78), (620, 110, 90)),
        ((560, 232, 80), (720, 110, 90)), ((680, 170, 80), (300, 210, 90)),
        ((694, 110, 82), (120, 250, 80)), ((640, 190, 80), (100, 130, 100)),
        ((540, 236, 84), (200, 90, 90)), ((400, 300, 80), (224, 440, 60)),
        ((224, 350, 72), (224, 520, 64)), ((224, 430, 70), (224, 600, 64)),
        ((226, 500, 72), (200, 660, 66)), ((190, 560, 74), (330, 590, 40)),
        ((200, 640, 78), (250, 440, 60)),
    ]:
        camera.key(eye, look)
    return camera
