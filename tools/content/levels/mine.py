# SPDX-License-Identifier: GPL-2.0-or-later
"""The level `mine`: a cave with a hole in its roof, after the paper's figure 8 (b).

The sun falls through the hole onto a small patch of ground; all else is lit by what that patch
and the bit of sky send on, and by a few oil lamps deep in the gallery.
"""

import numpy as np

import crate
import farm
from brush import beam, box, circle, cylinder, frustum, hull, lying, prism
from carver import Carver, Skin
from lamp import lantern
from map_file import Level
from material import SKY_BOX, vigil
from plant import LEAVES, bush, tree
from rock import Rock, value_noise
from route import Route
from sky import sun_direction
from sunlight import sunlit

SUN_YAW, SUN_PITCH = 215, -63
BOTTOM, TOP = -160, 672
# Where the hole is, its mean radius, and the plan of the cave: circles (x, y, radius).
HOLE = (1120, 800, 165)
CIRCLES = [(1020, 720, 500), (1340, 900, 330), (640, 480, 260), (1500, 460, 240),
           (1120, 1180, 230), (800, 980, 300)]
# Galleries: segments with a half width.
GALLERIES = [((640, 480), (-560, 300), 120), ((-560, 300), (-1000, 560), 115),
             ((1500, 460), (2040, 300), 105)]
# Boxes that hold the cave, with what closes them above: the rock fills them.
HULL = [((352, -96, BOTTOM), (1888, 1568, TOP), SKY_BOX),
        ((-640, 64, BOTTOM), (352, 704, 416), vigil("rock_dark")),
        ((-1248, 64, BOTTOM), (-640, 832, 416), vigil("rock_dark")),
        ((1888, 64, BOTTOM), (2208, 640, 416), vigil("rock_dark"))]
TRACK = [(-1000, 560), (-560, 300), (640, 480), (960, 640)]
# Spacing of the points that verify() looks at, in map units.
SAMPLE = 24
POST = vigil("beam", turn=True)
BEAM = vigil("beam")
IRON = vigil("rust")


def openness(x, y):
    """Distance into the cave in map units: positive inside its plan, negative in the rock."""
    best = np.full(np.shape(x), -1e9)
    for cx, cy, radius in CIRCLES:
        best = np.maximum(best, radius - np.hypot(x - cx, y - cy))
    for (ax, ay), (bx, by), half in GALLERIES:
        dx, dy = bx - ax, by - ay
        t = np.clip(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy), 0, 1)
        best = np.maximum(best, half - np.hypot(x - ax - t * dx, y - ay - t * dy))
    return best + 34 * value_noise(x, y, 130, 5) + 14 * value_noise(x, y, 60, 6)


def near_track(x, y):
    """Distance to the track."""
    best = np.full(np.shape(x), 1e9)
    for (ax, ay), (bx, by) in zip(TRACK, TRACK[1:]):
        dx, dy = bx - ax, by - ay
        t = np.clip(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy), 0, 1)
        best = np.minimum(best, np.hypot(x - ax - t * dx, y - ay - t * dy))
    return best


def floor(x, y):
    o = openness(x, y)
    wall = np.clip((72 - o) / 72, 0, 2.2)
    rough = 16 * value_noise(x, y, 170, 1) + 7 * value_noise(x, y, 64, 2)
    rough = rough * np.clip((near_track(x, y) - 70) / 90, 0, 1)
    heap = 52 * np.exp(-((x - 1300) ** 2 + (y - 640) ** 2) / 150 ** 2)
    return rough + heap + 150 * wall ** 1.6


def ceiling(x, y):
    o = openness(x, y)
    wide = np.clip(o / 330, 0, 1)
    roof = 156 + 216 * wide ** .8 + 26 * value_noise(x, y, 120, 3) + 12 * value_noise(x, y, 64, 4)
    wall = np.clip((60 - o) / 60, 0, 2.2)
    roof = roof - 130 * wall ** 1.5
    hx, hy, radius = HOLE
    away = np.hypot(x - hx, y - hy) + 26 * value_noise(x, y, 90, 8)
    return np.where(away < radius, TOP, roof + 60 * np.exp(-((away - radius) / 90) ** 2))


def cave():
    return Rock((-1248, -96), (2208, 1568), 64, 17, BOTTOM, TOP, floor, ceiling, seed=4)


def build():
    """The level and its camera route: out of the gallery, around the patch of sun."""
    level = Level("mine", "The open cut", sky="dusk", _sun_light=1500, _sun_color="1 0.88 0.70",
                  _sun_mangle="%d %d 0" % (SUN_YAW, SUN_PITCH))
    rock = cave()
    carver = Carver(16)
    stone = vigil("rock_dark")
    for lo, hi, roof in HULL:
        carver.room(lo, hi, Skin(stone, stone, roof))
    level.add(*carver.brushes())
    # Only the ground is painted along an axis: on steep rock that would stretch the texture.
    level.add_detail(*rock.brushes(vigil("soil", cast=True, scale=.3), vigil("rock", scale=.3),
                                   vigil("rock_dark", scale=.3),
                                   [(lo, hi) for lo, hi, _ in HULL]))
    supports(level, rock)
    track(level, rock)
    furniture(level, rock)
    hoist(level, rock)
    green(level, rock)
    camera = route(rock)
    level.start(camera.keys[0][0], 0)
    return level, camera


def verify(bsp):
    """Says where the sun meets the ground; raises ValueError when that is not a small patch."""
    x, y = np.meshgrid(np.arange(500, 1800, SAMPLE), np.arange(100, 1500, SAMPLE))
    points = np.column_stack([x.ravel(), y.ravel()])
    points = np.column_stack([points, cave().floor_at(*points.T) + 1])
    points = points[points[:, 2] < 200]
    sun = toward_sun()
    lit = points[sunlit(*bsp.blocking_planes(), points, sun, (TOP - 4 - points[:, 2]) / sun[2])]
    area = len(lit) * SAMPLE ** 2
    if not 10000 < area < 100000:
        raise ValueError("mine: the sun meets %d square units of ground" % area)
    print("mine          sun on %d square units of ground around %s" % (
        area, lit.mean(axis=0).round()))


def ground(rock, x, y):
    return float(rock.floor_at(np.array([float(x)]), np.array([float(y)]))[0])


def toward_sun():
    return sun_direction(SUN_YAW, SUN_PITCH)


def supports(level, rock):
    """Timber sets along the galleries: two posts, a cap, struts; every other one has a lamp."""
    count = 0
    for (ax, ay), (bx, by), half in GALLERIES:
        length = np.hypot(bx - ax, by - ay)
        forward = np.array([bx - ax, by - ay]) / length
        right = np.array([forward[1], -forward[0]])
        first = 250 if (ax, ay) in ((640, 480), (1500, 460)) else 80
        for at in np.arange(first, length - 30, 170):
            middle = np.array([ax, ay]) + forward * at
            timber_set(level, rock, middle, right, half - 46, lit=count % 2 == 0)
            count += 1


def timber_set(level, rock, middle, right, reach, lit):
    z = ground(rock, *middle)
    feet = [middle + s * reach * right for s in (-1, 1)]
    top = z + 132
    for foot in feet:
        x, y = np.round(foot)
        level.add_detail(box((x - 6, y - 6, z - 24), (x + 6, y + 6, top), POST))
    a, b = [np.array([*(f + s * 16 * right), top + 6]) for f, s in zip(feet, (-1, 1))]
    level.add_detail(beam(a, b, 14, 12, BEAM))
    for foot, s in zip(feet, (-1, 1)):
        level.add_detail(beam([*foot, top - 34], [*(foot - s * 34 * right), top + 2], 7, 7, BEAM))
    if lit:
        x, y = np.round(middle + .5 * reach * right)
        lantern(level, x, y, top)


def track(level, rock):
    """Two rails on sleepers along TRACK."""
    for (ax, ay), (bx, by) in zip(TRACK, TRACK[1:]):
        length = np.hypot(bx - ax, by - ay)
        forward = np.array([bx - ax, by - ay]) / length
        right = np.array([forward[1], -forward[0]])
        a, b = np.array([ax, ay]), np.array([bx, by])
        for s in (-1, 1):
            level.add_detail(beam([*(a + s * 22 * right), 6], [*(b + s * 22 * right), 6], 4, 5,
                                  IRON))
        for at in np.arange(14, length, 34):
            p = a + forward * at
            level.add_detail(beam([*(p - 34 * right), 1.5], [*(p + 34 * right), 1.5], 10, 5, BEAM))


def cart(level, x, y, yaw):
    """A tub on four wheels, heaped with stone."""
    parts = [box((x - 38, y - 24, 14), (x + 38, y + 24, 18), IRON)]
    plate = vigil("metal_dark")
    for lo, hi in (((-38, -26), (38, -23)), ((-38, 23), (38, 26)), ((-40, -26), (-37, 26)),
                   ((37, -26), (40, 26))):
        parts.append(box((x + lo[0], y + lo[1], 16), (x + hi[0], y + hi[1], 50), plate))
    parts.append(box((x - 37, y - 23, 18), (x + 37, y + 23, 40), vigil("soil")))
    for dx in (-22, 22):
        for dy in (-25, 20):
            parts.append(box((x + dx - 7, y + dy, 4), (x + dx + 7, y + dy + 5, 16), plate))
    level.add_detail(*[p.turned(yaw, (x, y, 0)) for p in parts])


def furniture(level, rock):
    """Carts, crates, boulders, tall props, and lamps where the galleries begin."""
    rng = np.random.default_rng(3)
    cart(level, 800, 560, 26.6)
    cart(level, 1240, 1180, 70)
    for x, y, size in ((560, 640, 48), (1480, 420, 44), (1040, 1230, 44), (1930, 345, 36)):
        z = ground(rock, x, y)
        crate.stack(level, rng, x, y, round(z) - 4, size, 3)
    for x, y in ((500, 600), (470, 590), (1560, 560), (1100, 1270)):
        crate.barrel(level, x, y, round(ground(rock, x, y)) - 4, "rust")
    for x, y, size in ((1180, 620, 52), (1420, 760, 64), (960, 900, 46), (1240, 1010, 58),
                       (760, 760, 40), (1340, 520, 44)):
        boulder(level, rng, x, y, ground(rock, x, y), size)
    # Props in the great chamber: tall tree trunks under the roof.
    for x, y in ((760, 1080), (900, 420), (1560, 760)):
        z = ground(rock, x, y)
        level.add_detail(cylinder((x, y), 13, round(z) - 30, 430, POST, 8))
    for x, y, value in ((1640, 410, 200), (452, 362, 200)):
        z = round(ground(rock, x, y))
        level.add_detail(box((x - 3, y - 3, z - 8), (x + 3, y + 3, z + 100), POST),
                         box((x - 3, y - 3, z + 94), (x + 17, y + 3, z + 100), BEAM))
        lantern(level, x + 12, y, z + 94, value)


def hoist(level, rock):
    """Two timbers across the hole with a drum; rope and bucket hang in the sunbeam. A ladder."""
    x, y, z = 1034, 742, 478
    for dy in (-16, 16):
        level.add_detail(beam((x - 190, y + dy, z), (x + 250, y + dy, z), 12, 14, BEAM))
    level.add_detail(lying("x", x - 14, x + 14, [(y + 9 * np.cos(a), z + 17 + 9 * np.sin(a))
                                                for a in 2 * np.pi * np.arange(8) / 8], BEAM))
    level.add_detail(box((x - 1, y - 1, 214), (x + 1, y + 1, z + 10), vigil("straw", scale=.2)),
                     frustum(np.column_stack([circle((x, y), 12, 8), np.full(8, 180.0)]),
                             np.column_stack([circle((x, y), 16, 8), np.full(8, 206.0)]),
                             vigil("planks_old", scale=.2)),
                     box((x - 15, y - 1, 205), (x + 15, y + 1, 208), IRON),
                     box((x - 1.5, y - 1.5, 206), (x + 1.5, y + 1.5, 216), IRON))
    foot = (1190, 900, ground(rock, 1190, 900) - 6)
    farm.ladder(level, foot, (1236, 944, 470), 24, 26)


def green(level, rock):
    """What grows where the sun comes: a young tree, ferns around the patch, creepers at the rim."""
    rng = np.random.default_rng(8)
    tree(level, rng, 948, 716, ground(rock, 948, 716), 128, 5, (3, 2))
    for _ in range(18):
        a, away = rng.uniform(0, 6.28), rng.uniform(20, 130)
        x, y = 930 + away * np.cos(a), 690 + .8 * away * np.sin(a)
        if near_track(np.array(x), np.array(y)) > 48:
            size = rng.uniform(5, 12)
            bush(level, rng, np.array([x, y, ground(rock, x, y) + size * .4]), size)
    hx, hy, radius = HOLE
    for a in np.linspace(0, 2 * np.pi, 17, endpoint=False):
        r = radius + rng.uniform(-6, 14)
        x, y = round(hx + r * np.cos(a)), round(hy + r * np.sin(a))
        length = rng.uniform(50, 150)
        level.add_detail(prism(circle((x, y), rng.uniform(2, 3.5), 3, rng.uniform()), 470 - length,
                               470, LEAVES))
        for k in range(2):
            at = np.array([x, y, 470 - length * (k + rng.uniform(.4, .9)) / 2])
            bush(level, rng, at, rng.uniform(5, 9))


def boulder(level, rng, x, y, z, size):
    """A squat, irregular block: the hull of points on a flattened ball, sunk into the ground."""
    d = rng.standard_normal((11, 3))
    d /= np.linalg.norm(d, axis=1, keepdims=True)
    points = np.round(d * [size * .75, size * .7, size * .6] + [x, y, z + .2 * size])
    level.add_detail(hull(points, vigil("rock", scale=.3)))


def route(rock):
    camera = Route(18)
    for x, y, up, look in [
        (-860, 477, 52, (-560, 300, 50)), (-700, 383, 52, (-300, 340, 60)),
        (-480, 315, 52, (200, 414, 60)), (-180, 357, 52, (500, 459, 60)),
        (120, 402, 54, (700, 520, 70)), (420, 447, 56, (1000, 700, 90)),
        (640, 470, 60, (1150, 800, 60)), (800, 460, 66, (1250, 900, 60)),
        (1000, 500, 72, (1050, 900, 30)), (1200, 480, 90, (1050, 900, 60)),
        (1440, 620, 84, (1000, 800, 100)), (1500, 900, 80, (1000, 760, 60)),
        (1340, 1080, 76, (1000, 760, 20)), (1100, 1100, 76, (1040, 700, 10)),
        (880, 1020, 76, (1100, 760, 60)),
    ]:
        camera.key((x, y, ground(rock, x, y) + up), look)
    return camera
