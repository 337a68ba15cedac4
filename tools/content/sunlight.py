# SPDX-License-Identifier: GPL-2.0-or-later
"""Sun exposure: which points of a level see the sun, by segments against its brushes."""

import numpy as np


def sunlit(planes, starts, points, toward, reach):
    """Booleans per point: whether its segment towards the sun, reach (per point) long, meets no
    brush.

    planes and starts are those of Bsp.blocking_planes (sky brushes are solid: reach must end
    below them, so pass the height of the opening divided by the sun's elevation).
    """
    out = np.empty(len(points), bool)
    slope = planes[:, :3] @ toward
    parallel = np.abs(slope) < 1e-9
    safe = np.where(parallel, 1.0, slope)
    for i, point in enumerate(points):
        away = planes[:, 3] - planes[:, :3] @ point
        t = away / safe
        enter = np.where(slope < 0, t, -np.inf)
        leave = np.where(slope > 0, t, np.inf)
        outside = parallel & (away < 0)
        enter = np.where(parallel, np.where(outside, np.inf, -np.inf), enter)
        leave = np.where(parallel, np.inf, leave)
        first = np.maximum(np.maximum.reduceat(enter, starts), 0.5)
        last = np.minimum(np.minimum.reduceat(leave, starts), reach[i])
        out[i] = not np.any(first < last - 1e-3)
    return out
