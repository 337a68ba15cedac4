# SPDX-License-Identifier: GPL-2.0-or-later
"""Checks of compiled levels: counts, lamps per PVS, and the clearance of camera routes."""

import numpy as np

from bsp import Bsp, clearance
from material import SOLID, WINDOW

# Points that solidity() looks at, and how far they lie from the surfaces it cannot judge.
SAMPLES = 40000
DOUBT = 1.0

# A route keeps this distance from every wall, in map units.
ROUTE_CLEARANCE = 24.0


def summary(path):
    """One line of counts for a compiled level."""
    level = Bsp(path)
    lamps = level.lights_by_cluster()
    inner = lamps if len(lamps) else np.zeros(1, int)
    return ("%-13s %5d faces %5d planes %4d clusters %4d lamps, in a PVS max %d median %d, "
            "%d models, %d kB" % (path.stem, len(level.faces), len(level.planes),
                                  level.clusters(), len(level.emissive()), inner.max(),
                                  int(np.median(inner)), len(level.models), level.size // 1024))


def route(path, camera):
    """Raises ValueError where a route comes too close to a wall."""
    planes, starts = Bsp(path).blocking_planes()
    rows = camera.lines()
    near = clearance(planes, starts, rows[:, 1:4])
    worst = int(np.argmin(near))
    if near[worst] < ROUTE_CLEARANCE:
        raise ValueError("%s: the route is %.1f units from a wall at %.2f s (%s)" % (
            path.stem, near[worst], rows[worst, 0], rows[worst, 1:4].round(1)))
    print("%-13s route %.0f s, %d views, at least %.1f units from walls" % (
        path.stem, rows[-1, 0], len(rows), near[worst]))


def solidity(level, lo, hi):
    """Raises ValueError where a leaf of a Bsp is solid outside all brushes or empty in one, at
    random points of a box that holds no void. The compiler errs so where slivers of brushes
    vanish: the air there would be a wall that nobody sees, or the sky a hole."""
    points = np.random.default_rng(1).uniform(np.array(lo) + 2, np.array(hi) - 2, (SAMPLES, 3))
    solid = level.leafs["contents"][level.leafs_at(points)] & (SOLID | WINDOW) != 0
    away = clearance(*level.blocking_planes(), points)
    wrong = np.flatnonzero((solid & (away > DOUBT)) | (~solid & (away < -DOUBT)))
    if len(wrong):
        raise ValueError("%d of %d points are solid outside brushes or empty in one: %s" % (
            len(wrong), SAMPLES, points[wrong[:3]].round().tolist()))
