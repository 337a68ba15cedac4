# SPDX-License-Identifier: GPL-2.0-or-later
"""A carver: rooms are boxes of air, the solid around them follows.

Air boxes are laid on the grid of all their own coordinates; every solid cell that touches air
(also over an edge or corner) becomes wall, and cells grow together into boxes as long as each of
their six sides shows one material. The shell closes by construction, so a level cannot leak.
"""

from dataclasses import dataclass, field

import numpy as np

from brush import FACES, box
from material import CAULK


@dataclass
class Skin:
    """Materials of a room's inner surfaces. bands: list of (z, material) that replace the wall
    material from z upwards, lowest first."""

    wall: object
    floor: object
    ceiling: object
    bands: list = field(default_factory=list)


class Carver:
    """Collects air boxes; later boxes win where they overlap."""

    def __init__(self, thickness=16):
        self.thickness = thickness
        self.rooms = []

    def room(self, lo, hi, skin):
        self.rooms.append((np.array(lo, float), np.array(hi, float), skin))

    def brushes(self):
        """The solid around all rooms as boxes."""
        grid = [self._lines(axis) for axis in range(3)]
        shape = tuple(len(g) - 1 for g in grid)
        air = np.full(shape, -1, int)
        for index, (lo, hi, _) in enumerate(self.rooms):
            where = tuple(slice(np.searchsorted(grid[a], lo[a]), np.searchsorted(grid[a], hi[a]))
                          for a in range(3))
            air[where] = index
        wall = touches(air >= 0) & (air < 0)
        shown = {tuple(c): self._faces(tuple(c), air, grid) for c in np.argwhere(wall)}
        return [self._box(lo, hi, faces, grid) for lo, hi, faces in merge(wall, shown)]

    def _lines(self, axis):
        cuts = set()
        for lo, hi, skin in self.rooms:
            cuts |= {lo[axis], hi[axis], lo[axis] - self.thickness, hi[axis] + self.thickness}
            if axis == 2:
                cuts |= {z for z, _ in skin.bands if lo[2] < z < hi[2]}
        return np.array(sorted(cuts))

    def _faces(self, cell, air, grid):
        """The material that each of the cell's six sides shows, None where it shows none."""
        faces = []
        for axis in range(3):
            for step in (-1, 1):
                near = list(cell)
                near[axis] += step
                room = -1
                if 0 <= near[axis] < air.shape[axis]:
                    room = air[tuple(near)]
                faces.append(self._show(room, axis, step, grid[2][cell[2]]))
        return faces

    def _show(self, room, axis, step, z):
        if room < 0:
            return None
        skin = self.rooms[room][2]
        if axis == 2:
            return skin.floor if step > 0 else skin.ceiling
        material = skin.wall
        for start, other in skin.bands:
            if z >= start:
                material = other
        return material

    def _box(self, lo, hi, faces, grid):
        low = [grid[a][lo[a]] for a in range(3)]
        high = [grid[a][hi[a]] for a in range(3)]
        return box(low, high, {f: m or CAULK for f, m in zip(FACES, faces)})


def touches(air):
    """Cells with air among their 26 neighbours or themselves."""
    padded = np.pad(air, 1)
    out = np.zeros_like(air)
    for i in range(3):
        for j in range(3):
            for k in range(3):
                out |= padded[i:i + air.shape[0], j:j + air.shape[1], k:k + air.shape[2]]
    return out


def merge(wall, shown):
    """Greedy boxes over wall cells whose sides agree; yields (lo, hi, six materials)."""
    left = wall.copy()
    for start in np.argwhere(wall):
        if not left[tuple(start)]:
            continue
        lo, hi = list(start), [int(c) + 1 for c in start]
        faces = list(shown[tuple(start)])
        for axis in (0, 1, 2):
            while grow(axis, lo, hi, faces, left, shown):
                pass
        left[tuple(slice(a, b) for a, b in zip(lo, hi))] = False
        yield lo, hi, faces


def grow(axis, lo, hi, faces, left, shown):
    """Adds one layer of cells along axis when all are free and agree; tells whether it did."""
    if hi[axis] >= left.shape[axis]:
        return False
    ranges = [range(a, b) for a, b in zip(lo, hi)]
    ranges[axis] = range(hi[axis], hi[axis] + 1)
    layer = [(i, j, k) for i in ranges[0] for j in ranges[1] for k in ranges[2]]
    merged = list(faces)
    # The side that the layer hides must show nothing, and so must the layer's own near side.
    if merged[2 * axis + 1] is not None:
        return False
    merged[2 * axis + 1] = None
    for cell in layer:
        if not left[cell] or shown[cell][2 * axis] is not None:
            return False
        for side, material in enumerate(shown[cell]):
            if side == 2 * axis or material is None:
                continue
            if merged[side] is None:
                merged[side] = material
            elif merged[side] != material:
                return False
    faces[:] = merged
    hi[axis] += 1
    return True
