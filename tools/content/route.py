# SPDX-License-Identifier: GPL-2.0-or-later
"""A camera route: key views, smoothed into lines `time x y z pitch yaw roll` for Vigil.

Positions are eye positions in Quake units; pitch is positive downwards, yaw counter-clockwise from
+x, all in degrees. The path is a centripetal Catmull-Rom spline walked at constant speed.
"""

import numpy as np


class Route:
    """Key views of one level: eye position, and the point the camera looks at (or None to look
    ahead along the path)."""

    def __init__(self, seconds, interval=0.25):
        self.seconds = seconds
        self.interval = interval
        self.keys = []

    def key(self, eye, look=None):
        self.keys.append((np.array(eye, float), None if look is None else np.array(look, float)))
        return self

    def lines(self):
        """Rows of time, x, y, z, pitch, yaw, roll at equal times; yaw does not jump."""
        eyes = np.array([k[0] for k in self.keys])
        dense, knot = spline(eyes)
        step = np.linalg.norm(np.diff(dense, axis=0), axis=1)
        length = np.concatenate([[0], np.cumsum(step)])
        times = np.arange(0, self.seconds + 1e-6, self.interval)
        wanted = ease(times / self.seconds) * length[-1]
        place = np.column_stack([np.interp(wanted, length, dense[:, i]) for i in range(3)])
        at_key = np.interp(wanted, length, knot)
        angles = self._angles(eyes, dense, knot)
        pitch = blend(at_key, angles[:, 0])
        yaw = blend(at_key, np.degrees(np.unwrap(np.radians(angles[:, 1]))))
        return np.column_stack([times, place, pitch, yaw, np.zeros(len(times))])

    def _angles(self, eyes, dense, knot):
        """Pitch and yaw at each key."""
        out = []
        for i, (eye, look) in enumerate(self.keys):
            if look is None:
                j = np.searchsorted(knot, i)
                a, b = dense[max(j - 3, 0)], dense[min(j + 3, len(dense) - 1)]
                d = b - a
                d[2] = 0
            else:
                d = look - eye
            out.append([-np.degrees(np.arctan2(d[2], np.hypot(d[0], d[1]))),
                        np.degrees(np.arctan2(d[1], d[0]))])
        return np.array(out)

    def write(self, path, comment):
        rows = self.lines()
        with open(path, "w", encoding="ascii") as file:
            file.write("# %s\n# time x y z pitch yaw roll\n" % comment)
            for row in rows:
                file.write("%.2f %.2f %.2f %.2f %.2f %.2f %.2f\n" % tuple(row + 0.0))


def ease(t):
    """Starts and stops gently: speed ramps over the first and last tenth."""
    ramp = 0.1
    top = 1 / (1 - ramp)
    return np.where(t < ramp, top * t * t / (2 * ramp),
                    np.where(t > 1 - ramp, 1 - top * (1 - t) ** 2 / (2 * ramp),
                             top * (t - ramp / 2)))


def spline(points, per_span=40):
    """Centripetal Catmull-Rom through the points; returns samples and their key parameter."""
    padded = np.vstack([2 * points[0] - points[1], points, 2 * points[-1] - points[-2]])
    out, knot = [], []
    for i in range(len(points) - 1):
        p = padded[i:i + 4]
        t = np.concatenate([[0], np.cumsum(np.maximum(
            np.linalg.norm(np.diff(p, axis=0), axis=1), 1e-3) ** 0.5)])
        for u in np.arange(per_span) / per_span:
            s = t[1] + u * (t[2] - t[1])
            a = [lerp(p[k], p[k + 1], (s - t[k]) / (t[k + 1] - t[k])) for k in range(3)]
            b = [lerp(a[k], a[k + 1], (s - t[k]) / (t[k + 2] - t[k])) for k in range(2)]
            out.append(lerp(b[0], b[1], (s - t[1]) / (t[2] - t[1])))
            knot.append(i + u)
    return np.vstack([*out, points[-1]]), np.array([*knot, len(points) - 1.0])


def lerp(a, b, t):
    return a + (b - a) * t


def blend(at, values):
    """Monotone smooth interpolation of values at keys 0, 1, 2, ...: cubic with limited slopes."""
    steps = np.diff(values)
    slope = np.zeros(len(values))
    for i in range(1, len(values) - 1):
        if steps[i - 1] * steps[i] > 0:
            slope[i] = 2 * steps[i - 1] * steps[i] / (steps[i - 1] + steps[i])
    i = np.clip(at.astype(int), 0, len(values) - 2)
    t = at - i
    return (values[i] * (1 + 2 * t) * (1 - t) ** 2 + slope[i] * t * (1 - t) ** 2
            + values[i + 1] * t * t * (3 - 2 * t) + slope[i + 1] * t * t * (t - 1))
