# SPDX-License-Identifier: GPL-2.0-or-later
"""The level `ring`: the paper's figure 10. A floor, a circular wall around it, a lamp below.

The lamp (func_rotating, targetname "lamp") turns under the floor and shines out of one side of its
shade, through the gap around the floor's rim, onto a part of the wall, which lights the floor. Yaw
0 shines towards +x.
"""

import numpy as np

from brush import box, circle, oblong, prism
from map_file import Level
from material import ORIGIN, Material, vigil
from route import Route

SIDES = 48
FLOOR_RADIUS, WALL_RADIUS, WALL_TOP = 256, 448, 320
PIT = -272
# The lamp looks up at this angle, so that its light passes the rim and meets the wall above it.
LAMP_HEIGHT, LAMP_TILT = -196, 30
LAMP_VALUE = 3000


def sector(inner, outer, index, z0, z1, materials):
    """One of SIDES blocks of a ring between two radii (corner radii)."""
    a = 2 * np.pi * np.array([index, index + 1]) / SIDES
    outline = [(inner * np.cos(a[0]), inner * np.sin(a[0])),
               (outer * np.cos(a[0]), outer * np.sin(a[0])),
               (outer * np.cos(a[1]), outer * np.sin(a[1])),
               (inner * np.cos(a[1]), inner * np.sin(a[1]))]
    return prism(np.round(outline, 3), z0, z1, materials)


def build():
    """The level and its camera route: slowly around, looking down at the floor."""
    level = Level("ring", "The turning lamp")
    wall, dark = vigil("white"), vigil("black")
    floor = vigil("concrete_panel")
    for i in range(SIDES):
        level.add(sector(WALL_RADIUS, WALL_RADIUS + 24, i, PIT - 16, WALL_TOP + 16, wall))
    level.add(prism(np.round(circle((0, 0), WALL_RADIUS + 24, SIDES, 0), 3), PIT - 16, PIT, dark),
              prism(np.round(circle((0, 0), WALL_RADIUS + 24, SIDES, 0), 3), WALL_TOP,
                    WALL_TOP + 16, dark))
    # The floor: a disc with a raised rim, dark below, on four props.
    level.add_detail(prism(np.round(circle((0, 0), FLOOR_RADIUS, SIDES, 0), 3), -8, 0,
                           {"top": floor, "side": vigil("metal_dark"), "bottom": dark}))
    for i in range(SIDES):
        level.add_detail(sector(FLOOR_RADIUS - 6, FLOOR_RADIUS, i, 0, 6, vigil("hazard",
                                                                              scale=.25)))
    for x, y in circle((0, 0), 150, 4):
        level.add_detail(box((x - 8, y - 8, PIT), (x + 8, y + 8, -8), vigil("metal_dark")))
    # Uprights against the wall show the curve; kept above the lamp's beam.
    for i in range(0, SIDES, 4):
        level.add_detail(sector(WALL_RADIUS - 5, WALL_RADIUS + 1, i, 250, WALL_TOP,
                                vigil("metal_dark")))
    level.add_detail(*[sector(WALL_RADIUS - 8, WALL_RADIUS + 1, i, 238, 250, vigil("metal_dark"))
                       for i in range(SIDES)])
    figures(level)
    lamp(level)
    camera = Route(12)
    for angle in np.linspace(-150, 30, 13):
        a = np.radians(angle)
        camera.key((56 * np.cos(a), 56 * np.sin(a), 196), (8 * np.cos(a), 8 * np.sin(a), 0))
    level.start(camera.keys[0][0], 30)
    return level, camera


def figures(level):
    """A few plain bodies on the floor, so that the changing light can be read."""
    white = vigil("white")
    level.add_detail(box((-24, -24, 0), (24, 24, 8), vigil("grey")),
                     prism(circle((0, 0), 16, 8), 8, 56, white),
                     box((96, -60, 0), (128, -28, 32), vigil("metal_orange")).turned(20, (112, -44,
                                                                                         0)),
                     prism(circle((-90, 70), 22, 3), 0, 40, vigil("metal_blue")),
                     box((-120, -96, 0), (-80, -84, 48), vigil("plaster_green")))


def lamp(level):
    """The turning lamp: a tilted shade of four plates around a bright face deep inside."""
    steel = vigil("metal_dark")
    light = vigil("lamp_panel").emissive(LAMP_VALUE).fitted()
    a = np.radians(LAMP_TILT)
    forward = np.array([np.cos(a), 0, np.sin(a)])
    up = np.array([-np.sin(a), 0, np.cos(a)])
    right = np.array([0, -1.0, 0])
    back = np.array([0, 0, LAMP_HEIGHT]) - 40 * forward
    front = back + 88 * forward
    plate = oblong(back - 4 * forward, back, right * 26, up * 22, steel)
    plate.sides[1].material = light
    brushes = [plate, box((-5, -5, PIT + 2), (5, 5, LAMP_HEIGHT - 30), steel)]
    for side in (-1, 1):
        brushes += [
            oblong(back + side * 24 * right, front + side * 24 * right, right * 2, up * 22, steel),
            oblong(back + side * 20 * up, front + side * 20 * up, right * 22, up * 2, steel)]
    z = LAMP_HEIGHT
    brushes.append(box((-4, -4, z - 4), (4, 4, z + 4), Material("vigil/black", contents=ORIGIN)))
    level.entity("func_rotating", brushes, targetname="lamp", speed=0)
