# SPDX-License-Identifier: GPL-2.0-or-later
"""Rock for caves: a floor and a ceiling height field on one jittered grid, as triangular prisms.

Where the floor rises above the ceiling the cave ends, so walls need no brushes of their own.
Corners are whole numbers, so neighbouring prisms share their planes exactly.
"""

import numpy as np

from brush import prism, Side, Brush


# Heights are multiples of this (map units); neighbours differ from a plane by CREASE or not at all.
STEP = 4
CREASE = 2.5
CREASE_PASSES = 60


def value_noise(x, y, scale, seed):
    """Smooth noise in -1..1 at any position; scale is the feature size in map units."""
    rng = np.random.default_rng(seed)
    table = rng.uniform(-1, 1, (64, 64))
    u, v = np.asarray(x, float) / scale, np.asarray(y, float) / scale
    i, j = np.floor(u).astype(int), np.floor(v).astype(int)
    a, b = u - i, v - j
    a, b = a * a * (3 - 2 * a), b * b * (3 - 2 * b)
    low = table[i % 64, j % 64] * (1 - a) + table[(i + 1) % 64, j % 64] * a
    high = table[i % 64, (j + 1) % 64] * (1 - a) + table[(i + 1) % 64, (j + 1) % 64] * a
    return low * (1 - b) + high * b


class Rock:
    """Grid points over lo..hi with a cell size; floor and ceiling are set from functions.

    floor(x, y) and ceiling(x, y) map arrays to heights. bottom and top bound the prisms; where the
    ceiling reaches top there is a hole.
    """

    def __init__(self, lo, hi, cell, jitter, bottom, top, floor, ceiling, seed=1):
        rng = np.random.default_rng(seed)
        nx, ny = round((hi[0] - lo[0]) / cell), round((hi[1] - lo[1]) / cell)
        x, y = np.meshgrid(np.linspace(lo[0], hi[0], nx + 1), np.linspace(lo[1], hi[1], ny + 1),
                           indexing="ij")
        # Border points stay on the border so that the hull closes against them.
        inner_x, inner_y = np.ones_like(x), np.ones_like(y)
        inner_x[[0, -1]] = 0
        inner_y[:, [0, -1]] = 0
        self.x = np.round(x + inner_x * rng.uniform(-jitter, jitter, x.shape))
        self.y = np.round(y + inner_y * rng.uniform(-jitter, jitter, y.shape))
        self.bottom, self.top = bottom, top
        self.floor = np.clip(STEP * np.round(floor(self.x, self.y) / STEP), bottom + 8, top)
        self.ceiling = np.clip(STEP * np.round(ceiling(self.x, self.y) / STEP), bottom, top)
        self._triangles = self._cut()
        self._crease(self.floor)
        self._crease(self.ceiling)

    def triangles(self):
        """Grid index triples, counter-clockwise from above."""
        return self._triangles

    def _cut(self):
        """Cuts each cell along the diagonal that bends the heights less."""
        nx, ny = self.x.shape
        out = []
        for i in range(nx - 1):
            for j in range(ny - 1):
                a, b, c, d = (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)
                if self._bend(a, c) <= self._bend(b, d):
                    out += [(a, b, c), (a, c, d)]
                else:
                    out += [(a, b, d), (b, c, d)]
        return out

    def _bend(self, p, q):
        return abs(self.floor[p] - self.floor[q]) + abs(self.ceiling[p] - self.ceiling[q])

    def _crease(self, heights):
        """Moves corners until neighbouring triangles lie in one plane or in clearly different
        ones: the compiler loses slivers of faces between planes that almost agree."""
        pairs = []
        beside = {}
        for corners in self._triangles:
            for k in range(3):
                edge = frozenset((corners[k], corners[(k + 1) % 3]))
                apex = corners[(k + 2) % 3]
                if edge in beside:
                    pairs.append((*edge, apex, beside[edge]))
                beside[edge] = apex
        for _ in range(CREASE_PASSES):
            moved = 0
            for a, b, c, d in pairs:
                rise = self._rise(heights, a, b, c, d)
                if 0 < abs(rise) < CREASE:
                    heights[d] += STEP if rise > 0 else -STEP
                    moved += 1
            if not moved:
                return

    def _rise(self, heights, a, b, c, d):
        """How far corner d lies above the plane through a, b, c."""
        px, py = self.x[a], self.y[a]
        ux, uy, uz = self.x[b] - px, self.y[b] - py, heights[b] - heights[a]
        vx, vy, vz = self.x[c] - px, self.y[c] - py, heights[c] - heights[a]
        nx, ny, nz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
        return heights[d] - heights[a] + (nx * (self.x[d] - px) + ny * (self.y[d] - py)) / nz

    def brushes(self, floor_material, wall_material, ceiling_material, hull):
        """Prisms below the floor and above the ceiling, and solid columns outside the cave, where
        they reach into one of the hull's boxes (lo, hi)."""
        out = []
        for corners in self.triangles():
            outline = np.array([(self.x[c], self.y[c]) for c in corners])
            if not any(np.all(outline.max(axis=0) > lo[:2]) and np.all(outline.min(axis=0) < hi[:2])
                       for lo, hi in hull):
                continue
            low = np.array([self.floor[c] for c in corners])
            high = np.array([self.ceiling[c] for c in corners])
            if np.all(low >= high):
                out.append(prism(outline, self.bottom, self.top, wall_material))
                continue
            out.append(column(outline, np.full(3, self.bottom), low,
                              self._paint(outline, low, floor_material, wall_material)))
            if np.any(high < self.top):
                out.append(column(outline, high, np.full(3, self.top),
                                  self._paint(outline, high, ceiling_material, wall_material)))
        return out

    def _paint(self, outline, heights, flat, steep):
        """The material by the slope of a triangle: steep ones are wall."""
        p = np.column_stack([outline, heights])
        n = np.cross(p[1] - p[0], p[2] - p[0])
        return flat if abs(n[2]) > .72 * np.linalg.norm(n) else steep

    def floor_at(self, x, y):
        """Floor heights under points, from the triangles."""
        out = np.full(len(x), np.nan)
        for corners in self.triangles():
            (x0, y0), (x1, y1), (x2, y2) = [(self.x[c], self.y[c]) for c in corners]
            area = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)
            u = ((x - x0) * (y2 - y0) - (x2 - x0) * (y - y0)) / area
            v = ((x1 - x0) * (y - y0) - (x - x0) * (y1 - y0)) / area
            inside = (u >= -1e-9) & (v >= -1e-9) & (u + v <= 1 + 1e-9)
            z = [self.floor[c] for c in corners]
            out[inside] = (z[0] + u * (z[1] - z[0]) + v * (z[2] - z[0]))[inside]
        return out


def column(outline, low, high, material):
    """A triangular prism between two sloping ends; an end that meets the other is left out."""
    bottom = np.column_stack([outline, low])
    top = np.column_stack([outline, high])
    sides = [Side(top, material), Side(bottom[::-1], material)]
    for i in range(3):
        j = (i + 1) % 3
        ring = [bottom[i], bottom[j], top[j], top[i]]
        ring = [p for k, p in enumerate(ring) if not np.array_equal(p, ring[k - 1])]
        if len(ring) >= 3:
            sides.append(Side(np.array(ring), material))
    return Brush(sides)
