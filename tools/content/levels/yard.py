# SPDX-License-Identifier: GPL-2.0-or-later
"""The level `yard`: a farmyard in the evening. A low sun behind the gate throws long shadows; the
sky fills them.

A farmhouse with two rooms stands on a terrace in the north, a barn with an open door in the east, a
gate in the west wall; hills lie around. The rooms are lit by windows and doors, one has a lamp.
"""

import numpy as np

import check
import crate
import farm
import furniture
from brush import box, circle, frustum, prism
from carver import Carver, Skin
from house import Facade, chimney, gable
from lamp import bulkhead, lamp_post, lantern
from map_file import Level
from material import CAULK, SKY_BOX, vigil
from plant import bush, cypress, tree
from rock import Rock, value_noise
from route import Route
from sky import EVENING_SUN
from stair import stairs

LOW, HIGH = (-576, -480), (2016, 1728)
BOTTOM, TOP = -96, 704
YARD = (0, 0, 1536, 1216)
WALL_HEIGHT = 104
GATE = (576, 688)
# The terrace: x0, y0, x1, y1 and its height.
TERRACE = (112, 816, 880, 1216)
DECK = 32
STUCCO, PALE, ROSE = vigil("stucco"), vigil("stucco_pale"), vigil("stucco_rose")
RUBBLE = vigil("rubble")
STONE = vigil("flagstones")
BOARDS = vigil("planks_old", turn=True)
OAK = vigil("beam", scale=.35)
POST = vigil("beam", scale=.35, turn=True)
PLANKS = vigil("planks")
SUN_LIGHT = 100


def outside(x, y):
    """Distance from the yard, 0 in it."""
    x0, y0, x1, y1 = YARD
    return np.hypot(np.maximum(np.maximum(x0 - x, x - x1), 0),
                    np.maximum(np.maximum(y0 - y, y - y1), 0))


def floor(x, y):
    """Height of the ground: level in the yard but for wear, hills outside, low ones to the sun."""
    away = outside(x, y)
    wear = 5 * value_noise(x, y, 210, 1) + 3 * value_noise(x, y, 90, 2)
    slope = 14 * np.clip((y - 150) / 700, 0, 1)
    dip = -6 * np.exp(-((y - 632) / 60) ** 2) * np.clip((500 - x) / 300, 0, 1)
    far = np.clip((away - 60) / 380, 0, 1)
    from_sun = np.clip((x + y) / 2200 + .1, 0, 1)
    hills = far ** 1.4 * (34 + 190 * from_sun) * (1 + .35 * value_noise(x, y, 300, 3))
    return slope + dip + wear + hills + np.where(away > 0, 10 * value_noise(x, y, 160, 4), 0)


class Ground(Rock):
    """The terrain; what it is painted with depends on the place."""

    def _paint(self, outline, heights, flat, steep):
        x, y = outline.mean(axis=0)
        lane = x < 0 and abs(y - 632 - 30 * value_noise(x, 0, 200, 9)) < 60
        if outside(x, y) > 0 and not lane:
            return flat
        trodden = vigil("soil", cast=True)
        if lane or value_noise(x, y, 150, 12) > .42 or x > 1060 and y < 300:
            return trodden
        return vigil("cobbles", cast=True)


def terrain():
    return Ground(LOW, HIGH, 128, 26, BOTTOM, TOP, floor, lambda x, y: np.full(np.shape(x), TOP),
                  seed=7)


def build():
    """The level and its camera route: in at the gate, round the yard, through barn and house."""
    level = Level("yard", "The evening yard", sky="evening", _sun_light=SUN_LIGHT,
                  _sun_color="1 0.70 0.40", _sun_mangle="%d %d 0" % EVENING_SUN)
    ground = terrain()
    carver = Carver(16)
    carver.room((*LOW, BOTTOM), (*HIGH, TOP), Skin(SKY_BOX, vigil("soil"), SKY_BOX))
    level.add(*carver.brushes())
    grass = vigil("grass", cast=True)
    level.add_detail(*ground.brushes(grass, grass, grass, [(LOW, HIGH)]))
    rng = np.random.default_rng(11)
    yard_walls(level)
    gate(level)
    terrace(level, rng)
    farmhouse(level)
    inside(level)
    barn(level, rng)
    shed(level, rng)
    trees(level, rng, ground)
    things(level, rng, ground)
    camera = route()
    level.start((700, 300, 72), 100)
    return level, camera


def verify(bsp):
    """Raises ValueError where the compiler took air for ground or the reverse."""
    check.solidity(bsp, (*LOW, BOTTOM), (*HIGH, TOP))


def ground_at(ground, x, y):
    return float(ground.floor_at(np.array([float(x)]), np.array([float(y)]))[0])


def yard_walls(level):
    """Rubble walls with tiled copings; the north and the east one run behind the houses."""
    x0, y0, x1, y1 = YARD
    tiles = vigil("roof_tiles", scale=.4)
    for lo, hi in (((x0 - 24, y0 - 24), (x1 + 24, y0)), ((x0 - 24, y1), (x1 + 24, y1 + 24)),
                   ((x1, y0), (x1 + 24, y1)), ((x0 - 24, y0), (x0, GATE[0] - 40)),
                   ((x0 - 24, GATE[1] + 40), (x0, y1))):
        level.add_detail(box((*lo, -32), (*hi, WALL_HEIGHT), RUBBLE))
        middle = (np.array(lo) + hi) / 2
        half = (np.array(hi) - lo) / 2 + 7
        low = [middle + half * s for s in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        thin = np.where(half == half.min(), 2, half - 8)
        high = [middle + thin * s for s in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        level.add_detail(frustum([(*p, WALL_HEIGHT) for p in low],
                                 [(*p, WALL_HEIGHT + 16) for p in high], tiles))


def gate(level):
    """An arched gateway in the west wall under a small roof, its leaves open."""
    g0, g1 = GATE
    middle, radius = (g0 + g1) / 2, (g1 - g0) / 2
    spring, top = 92, 172
    for a, b in ((g0 - 40, g0), (g1, g1 + 40)):
        level.add_detail(box((-36, a, -32), (12, b, top), STUCCO),
                         box((-40, a - 4, -32), (16, b + 4, 20), STONE),
                         box((-38, a - 2, spring - 8), (14, b + 2, spring), STONE))
    angle = np.linspace(np.pi, 0, 11)
    arc = [(middle + radius * np.cos(t), spring + radius * np.sin(t)) for t in angle]
    for (a, za), (b, zb) in zip(arc, arc[1:]):
        level.add_detail(farm.prism_along("x", -36, 12, [(a, za), (b, zb), (b, top), (a, top)],
                                          STUCCO))
    for part in gable("y", (g0 - 40, g1 + 40), (-36, 12), top, .625, STUCCO, 10):
        level.add_detail(part)
    for hinge, yaw in ((g0, -78), (g1, 78)):
        leaf = 54 if hinge == g0 else -54
        a, b = sorted((hinge, hinge + leaf))
        parts = [box((-34, a + 1, 4), (-30, b - 1, 88), BOARDS)]
        parts += [box((-30, a + 2, z), (-28, b - 2, z + 6), vigil("rust")) for z in (18, 68)]
        level.add_detail(*[p.turned(yaw, (-32, hinge, 0)) for p in parts])


def terrace(level, rng):
    """The paved terrace in front of the house, a low wall at its edge, steps, pots."""
    x0, y0, x1, y1 = TERRACE
    level.add_detail(box((x0, y0, -32), (x1, y1, DECK), {"all": RUBBLE, "top": STONE}),
                     box((x0 - 3, y0 - 3, DECK - 5), (x1 + 3, y0, DECK), STONE))
    stairs(level, (292, y0 - 72, 0), (388, y0, DECK), "+y", 5, STONE, rails=False)
    for a, b in ((x0, 284), (396, x1)):
        level.add_detail(box((a, y0, DECK), (b, y0 + 12, DECK + 22), PALE),
                         box((a - 2, y0 - 2, DECK + 22), (b + 2, y0 + 14, DECK + 27), STONE))
    for x in (276, 404, 640, 868):
        farm.pot(level, x, y0 + 6, DECK + 27, rng, 9)
    farm.pergola(level, 528, 800, 912, 846, DECK, leaves=rng)


DOOR = (300, 364, DECK, DECK + 100)
ROOM_WINDOWS = [(188, 244, 68, 128), (424, 480, 68, 128)]
WING_WINDOWS = [(560, 616, 68, 124), (688, 744, 68, 124)]
UPPER = 292
WEST_WINDOW = (1016, 1080, 66, 130)
EAST_WINDOW = (1024, 1080, 68, 124)


def farmhouse(level):
    """Two storeys of ochre plaster, the ground floor of which is a room, and a lower wing."""
    ceiling = 160
    white = PALE
    south = Facade("x", 912, -1, 20, STUCCO, white)
    wing = Facade("x", 912, -1, 20, ROSE, white)
    west = Facade("y", 144, -1, 20, STUCCO, white)
    north = Facade("x", 1200, 1, 20, STUCCO, white)
    east = Facade("y", 784, 1, 20, ROSE, white)
    level.add(*south.wall((144, 516), (-16, ceiling), [DOOR, *ROOM_WINDOWS], white),
              *wing.wall((516, 784), (-16, ceiling), WING_WINDOWS, white),
              *west.wall((932, 1180), (-16, ceiling), [WEST_WINDOW], white),
              *north.wall((144, 784), (-16, ceiling), [], white),
              *east.wall((932, 1180), (-16, ceiling), [EAST_WINDOW], white))
    # The wall between the rooms, with a doorway.
    between = Facade("y", 516, 1, 12, white, white)
    level.add(*between.wall((932, 1180), (-16, ceiling), [(1040, 1096, DECK, DECK + 96)], white))
    level.add(box((164, 932, -16), (764, 1180, DECK - 4), CAULK),
              box((144, 912, ceiling), (516, 1200, ceiling + 16),
                  {"all": STUCCO, "bottom": PLANKS}),
              box((516, 912, ceiling), (784, 1200, ceiling + 16), {"all": ROSE, "bottom": PLANKS}))
    level.add_detail(box((164, 932, DECK - 4), (764, 1180, DECK), PLANKS.turned()),
                     box((300, 912, DECK - 4), (364, 932, DECK), STONE),
                     box((144, 912, ceiling + 16), (516, 1200, UPPER), STUCCO))
    for opening in ROOM_WINDOWS:
        level.add_detail(*south.window(opening))
    for opening in WING_WINDOWS:
        level.add_detail(*wing.window(opening, glass=True))
    level.add_detail(*west.window(WEST_WINDOW), *east.window(EAST_WINDOW, glass=True),
                     *south.lintel(DOOR))
    for a0 in (188, 304, 424):
        level.add_detail(*south.closed_window((a0, a0 + 56, 204, 268)))
    for a0 in (960, 1092):
        level.add_detail(*west.closed_window((a0, a0 + 52, 204, 268)))
    # A string course, a plinth, and the door leaf, open against the inner wall.
    level.add_detail(south.box((144, 516), (0, 3), (172, 178), STONE),
                     west.box((912, 1200), (0, 3), (172, 178), STONE))
    for facade, spans in ((south, ((144, 292), (372, 516))), (wing, ((516, 784),)),
                          (west, ((912, 1200),))):
        level.add_detail(*[facade.box(s, (0, 4), (-16, DECK + 16), RUBBLE) for s in spans])
    leaf = box((364, 932, DECK), (368, 992, DECK + 98), {"all": vigil("louvre_green", scale=.5),
                                                        "side": BOARDS})
    level.add_detail(leaf.turned(-72, (364, 932, 0)))
    for part in gable("x", (144, 516), (912, 1200), UPPER, .625, STUCCO):
        level.add_detail(part)
    for part in gable("x", (516, 784), (912, 1200), ceiling + 16, .625, ROSE):
        level.add_detail(part)
    level.add_detail(*chimney(236, 1100, UPPER + 20, UPPER + 112),
                     *chimney(690, 1120, 200, 286))
    bulkhead(level, (388, 912, 148), "-y", "lamp_warm", 90, (12, 12))


def inside(level):
    """The room with a table, a hearth and a bench; the room beyond with a bed and a lamp."""
    for x in range(200, 500, 60):
        level.add_detail(box((x, 932, 150), (x + 10, 1180, 160), OAK.turned()))
    for x in range(560, 760, 60):
        level.add_detail(box((x, 932, 150), (x + 10, 1180, 160), OAK.turned()))
    # The hearth on the north wall.
    level.add_detail(box((196, 1148, DECK), (216, 1180, 92), RUBBLE),
                     box((276, 1148, DECK), (296, 1180, 92), RUBBLE),
                     box((188, 1142, 92), (304, 1180, 104), OAK),
                     box((206, 1152, 104), (286, 1180, 160), PALE),
                     box((196, 1140, DECK), (296, 1148, DECK + 5), STONE),
                     box((216, 1176, DECK), (276, 1180, 92), vigil("concrete_dark")))
    furniture.table(level, (246, 1028), (346, 1084), DECK)
    for x, y, yaw in ((280, 1016, 84), (318, 1014, 96), (276, 1098, -88)):
        furniture.chair(level, x, y, DECK, yaw)
    farm.pot(level, 318, 1052, DECK + 32, None, 6)
    level.add_detail(box((278, 1048, DECK + 32), (292, 1062, DECK + 33), vigil("white")),
                     box((402, 1158, DECK), (500, 1180, DECK + 84), vigil("walnut")),
                     box((398, 1154, DECK + 40), (500, 1158, DECK + 44), OAK))
    furniture.chest(level, 192, 968, DECK, 90)
    furniture.rug(level, (400, 980), (496, 1028), DECK)
    furniture.bed(level, (684, 1060), (752, 1170), DECK)
    furniture.bookcase(level, (540, 1160, DECK), (624, 1180, DECK + 104), "-y")
    furniture.table(level, (534, 944), (580, 1000), DECK, 30)
    furniture.stool(level, 600, 976, DECK)
    lantern(level, 640, 1060, 150, 250)


BARN = (1160, 288, 1504, 848)


def barn(level, rng):
    """A barn of boards on a rubble base, open to the west; the evening sun reaches its back."""
    x0, y0, x1, y1 = BARN
    base, eave, floor_z = 52, 216, 20
    door = (488, 632, floor_z, 176)
    slits = [(y, y + 6, 76, 176) for y in (336, 372, 408, 712, 748, 784)]
    facades = [(Facade("y", x0, -1, 16, BOARDS, BOARDS), (y0, y1), [door, *slits]),
               (Facade("y", x1, 1, 16, BOARDS, BOARDS), (y0, y1), []),
               (Facade("x", y0, -1, 16, BOARDS, BOARDS), (x0 + 16, x1 - 16),
                [(x, x + 6, 76, 176) for x in (1230, 1270)] + [(1330, 1400, 92, 148)]),
               (Facade("x", y1, 1, 16, BOARDS, BOARDS), (x0 + 16, x1 - 16), [])]
    for facade, span, openings in facades:
        low = [(a, b, z0, base) for a, b, z0, z1 in openings if z0 < base]
        rubble = Facade(facade.axis, facade.at, facade.out, facade.thick, RUBBLE, RUBBLE)
        level.add(*rubble.wall(span, (-24, base), low, RUBBLE),
                  *facade.wall(span, (base, eave),
                               [(a, b, max(z0, base), z1) for a, b, z0, z1 in openings], BOARDS))
    level.add_detail(box((x0 + 16, y0 + 16, -24), (x1 - 16, y1 - 16, floor_z), vigil("soil")),
                     box((x0 - 6, door[0] - 8, -24), (x0 + 16, door[1] + 8, floor_z), STONE))
    for part in gable("y", (y0, y1), (x0, x1), eave, .625, BOARDS, 24, solid=False):
        level.add_detail(part)
    # Door posts, a lintel, the leaves folded back, and the frame inside.
    west = facades[0][0]
    level.add_detail(west.box((door[0] - 10, door[0]), (-16, 4), (floor_z, 186), POST),
                     west.box((door[1], door[1] + 10), (-16, 4), (floor_z, 186), POST),
                     west.box((door[0], door[1]), (-16, 4), (176, 186), OAK))
    for a, b in ((door[0] - 82, door[0] - 10), (door[1] + 10, door[1] + 82)):
        level.add_detail(west.box((a, b), (4, 8), (floor_z - 2, 174), BOARDS))
        for z in (40, 144):
            level.add_detail(west.box((a, b), (8, 10), (z, z + 8), OAK))
    middle = (x0 + x1) / 2
    for y in (y0 + 144, y0 + 392):
        level.add_detail(box((x0 + 16, y, eave - 12), (x1 - 16, y + 10, eave), OAK),
                         box((middle - 5, y, eave), (middle + 5, y + 10, eave + 100), POST))
        for x in (x0 + 16, x1 - 26):
            level.add_detail(box((x, y, floor_z), (x + 10, y + 10, eave - 12), POST))
    # The loft over the north bay, a ladder to it, straw.
    level.add_detail(box((x0 + 16, y1 - 150, 128), (x1 - 16, y1 - 16, 136), PLANKS),
                     box((x0 + 16, y1 - 156, 122), (x1 - 16, y1 - 146, 136), OAK))
    farm.ladder(level, (1290, y1 - 190, floor_z), (1290, y1 - 150, 150))
    for x, y, z, yaw in ((1460, 340, 0, 90), (1424, 340, 0, 88), (1388, 342, 0, 90),
                         (1444, 340, 28, 92), (1408, 344, 28, 90), (1424, 342, 56, 84),
                         (1400, 760, 116, 8), (1460, 770, 116, 0), (1430, 764, 144, 4),
                         (1220, 350, 0, 20)):
        farm.bale(level, x, y, floor_z + z, yaw)
    level.add_detail(farm.heap(rng, 1440, 620, floor_z, 64), farm.heap(rng, 1430, 540, floor_z, 44))
    crate.barrel(level, 1200, 800, floor_z, "rust")
    crate.stack(level, rng, 1230, 420, floor_z, 40, 3)


def shed(level, rng):
    """An open wood shed under a lean-to roof against the south wall."""
    x0, x1, y = 816, 1040, 112
    for x in (x0, (x0 + x1) / 2, x1):
        level.add_detail(box((x - 4, y - 4, -16), (x + 4, y + 4, 92), POST))
    level.add_detail(box((x0 - 6, y - 5, 92), (x1 + 6, y + 5, 100), OAK))
    for low, material in ((0, vigil("planks_old")), (3, vigil("roof_tiles"))):
        level.add_detail(farm.prism_along("x", x0 - 16, x1 + 16, [
            (y + 16, 92 + low), (0, 146 + low), (0, 150 + low), (y + 16, 96 + low)][::-1],
            material))
    level.add_detail(box((x0 - 4, 0, -16), (x0 + 2, y, 88), BOARDS),
                     box((x0 - 6, 0, WALL_HEIGHT), (x1 + 6, 6, 146), BOARDS))
    farm.wood_pile(level, rng, 850, 14, 4, 9, 4)


def trees(level, rng, ground):
    """The walnut tree of the yard, cypresses that stand between it and the sun, and others."""
    tree(level, rng, 372, 300, ground_at(ground, 372, 300), 330, 17)
    tree(level, rng, -330, 1010, ground_at(ground, -330, 1010), 230, 13, (4, 2))
    for x, y, height in ((-150, 330, 250), (-170, 430, 280), (-90, 860, 240), (560, -130, 270),
                         (650, -150, 300), (1120, -140, 250), (1330, 1330, 300),
                         (1420, 1380, 270), (1640, 900, 280), (60, 1340, 260), (-40, 1380, 290),
                         (1730, 1180, 300), (-380, 200, 300)):
        cypress(level, x, y, ground_at(ground, x, y), height, height * .11)


def things(level, rng, ground):
    """Well, cart, washing, lamp posts, crates, barrels, a bench, a trough."""
    def at(x, y):
        return round(ground_at(ground, x, y))

    farm.well(level, 700, 470, at(700, 470))
    farm.cart(level, rng, 985, 800, at(985, 800) - 2, 204)
    lamp_post(level, 92, 484, at(92, 484), 200)
    lamp_post(level, 1090, 400, at(1080, 470), 200)
    farm.washing(level, rng, (930, 960, at(930, 960)), (1130, 1080, at(1130, 1080)))
    for x, y, size, count in ((70, 770, 44, 3), (1090, 720, 40, 2), (60, 130, 48, 3)):
        crate.stack(level, rng, x, y, at(x, y) - 1, size, count)
    for x, y in ((1128, 690), (1098, 672), (150, 90), (48, 430), (1010, 240)):
        crate.barrel(level, x, y, at(x, y) - 1, "crate_dark", 15, 40)
    # A bench under the tree, a trough by the wall.
    x, y, z = 470, 250, at(470, 250)
    level.add_detail(box((x - 40, y - 9, z + 16), (x + 40, y + 9, z + 20), OAK),
                     box((x - 34, y - 7, z - 6), (x - 26, y + 7, z + 16), STONE),
                     box((x + 26, y - 7, z - 6), (x + 34, y + 7, z + 16), STONE))
    for x, y in ((250, 890), (420, 890), (824, 890)):
        farm.pot(level, x, y, DECK, rng, 13)
    climbers(level, rng)
    level.add_detail(prism(circle((1300, 190), 26, 10), 0, at(1300, 190) + 26, RUBBLE))
    farm.ladder(level, (1100, 330, at(1100, 330)), (1150, 330, 200))


def climbers(level, rng):
    """Roses up the front of the house, flower beds along the terrace, pots about the well."""
    for x, top in ((158, 250), (284, 150), (380, 150), (508, 230)):
        for z in range(DECK + 14, top, 26):
            bush(level, rng, np.array([x + rng.uniform(-7, 7), 906, z]), rng.uniform(9, 15))
    for x in range(420, 860, 44):
        bush(level, rng, np.array([x, 804.0, 20.0]), rng.uniform(12, 17))
    for x, y in ((648, 440), (752, 506), (640, 500)):
        farm.pot(level, x, y, 3, rng, 10)


def route():
    camera = Route(24)
    for eye, look in [
        ((-250, 632, 70), (300, 640, 60)), ((-110, 632, 66), (400, 640, 70)),
        ((60, 632, 64), (700, 560, 70)), ((200, 560, 66), (900, 640, 60)),
        ((560, 340, 70), (380, 1000, 110)), ((720, 330, 72), (330, 1000, 120)),
        ((980, 300, 80), (350, 900, 90)), ((1010, 420, 72), (1300, 600, 80)),
        ((1060, 560, 68), (1450, 560, 70)), ((1230, 560, 72), (1440, 420, 60)),
        ((1300, 600, 76), (1180, 360, 70)), ((1120, 560, 72), (300, 560, 70)),
        ((820, 700, 72), (200, 640, 70)), ((600, 740, 76), (560, 1000, 90)),
        ((340, 740, 70), (340, 1000, 80)), ((332, 860, 86), (340, 1060, 70)),
        ((340, 962, 84), (250, 1080, 70)), ((410, 1064, 84), (220, 1000, 60)),
        ((470, 1066, 84), (640, 1080, 70)), ((600, 1070, 84), (560, 960, 70)),
    ]:
        camera.key(eye, look)
    return camera
