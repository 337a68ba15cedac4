# SPDX-License-Identifier: GPL-2.0-or-later
"""Parts of houses: facades with openings, window frames, shutters, gable roofs.

A facade is a wall that looks to one side; its parts are boxes in (along, out, up), out counted from
its outer face, so that one description serves all four directions.
"""

from brush import box, lying
from material import GLASS, vigil

STONE = vigil("flagstones")
WOOD = vigil("window_wood")
SHUTTER = vigil("louvre_green", fit=True)
TILES = vigil("roof_tiles")
PLANKS = vigil("planks_old")


class Facade:
    """A wall along axis 'x' or 'y'; its outer face is at a coordinate and looks to out (+1, -1)."""

    def __init__(self, axis, at, out, thick, outer, inner):
        self.axis, self.at, self.out, self.thick = axis, at, out, thick
        self.outer, self.inner = outer, inner
        across = "y" if axis == "x" else "x"
        signs = "+-" if out > 0 else "-+"
        self.front, self.back = signs[0] + across, signs[1] + across

    def box(self, along, out, up, materials):
        """A box; materials may also name the faces 'front' and 'back'."""
        d = sorted(self.at + self.out * o for o in out)
        if isinstance(materials, dict):
            names = {"front": self.front, "back": self.back}
            materials = {names.get(k, k): m for k, m in materials.items()}
        if self.axis == "x":
            return box((along[0], d[0], up[0]), (along[1], d[1], up[1]), materials)
        return box((d[0], along[0], up[0]), (d[1], along[1], up[1]), materials)

    def wall(self, along, up, openings, reveal):
        """The wall as boxes around openings (from, to, low, high), which must not overlap along."""
        skin = {"all": reveal, "front": self.outer, "back": self.inner}
        out = (-self.thick, 0)
        parts, at = [], along[0]
        for a0, a1, z0, z1 in sorted(openings):
            if a0 > at:
                parts.append(self.box((at, a0), out, up, skin))
            if z0 > up[0]:
                parts.append(self.box((a0, a1), out, (up[0], z0), skin))
            if z1 < up[1]:
                parts.append(self.box((a0, a1), out, (z1, up[1]), skin))
            at = a1
        if along[1] > at:
            parts.append(self.box((at, along[1]), out, up, skin))
        return parts

    def window(self, opening, columns=2, rows=3, glass=False, shutters=True, back=10):
        """Frame, bars, sill and shutters of an opening; the frame stands back from the face."""
        a0, a1, z0, z1 = opening
        deep = (-back - 4, -back)
        parts = [self.box((a0, a0 + 4), deep, (z0, z1), WOOD),
                 self.box((a1 - 4, a1), deep, (z0, z1), WOOD),
                 self.box((a0 + 4, a1 - 4), deep, (z0, z0 + 4), WOOD),
                 self.box((a0 + 4, a1 - 4), deep, (z1 - 4, z1), WOOD),
                 self.box((a0 - 4, a1 + 4), (0, 4), (z0 - 6, z0), STONE)]
        for i in range(1, columns):
            a = a0 + (a1 - a0) * i / columns
            parts.append(self.box((a - 1.5, a + 1.5), (deep[0] + .5, deep[1] - .5),
                                  (z0 + 4, z1 - 4), WOOD))
        for i in range(1, rows):
            z = z0 + (z1 - z0) * i / rows
            parts.append(self.box((a0 + 4, a1 - 4), (deep[0] + 1, deep[1] - 1), (z - 1, z + 1),
                                  WOOD))
        if glass:
            parts.append(self.box((a0 + 4, a1 - 4), (-back - 2.5, -back - 1.5), (z0 + 4, z1 - 4),
                                  GLASS))
        if shutters:
            half = (a1 - a0) / 2
            for side in ((a0 - half - 2, a0 - 2), (a1 + 2, a1 + half + 2)):
                parts.append(self.box(side, (0, 2), (z0, z1), SHUTTER))
        return parts

    def closed_window(self, opening):
        """A window whose shutters are closed, on a wall without an opening."""
        a0, a1, z0, z1 = opening
        middle = (a0 + a1) / 2
        return [self.box((a0, middle - .5), (0, 2), (z0, z1), SHUTTER),
                self.box((middle + .5, a1), (0, 2), (z0, z1), SHUTTER),
                self.box((a0 - 4, a1 + 4), (0, 4), (z0 - 6, z0), STONE)]

    def lintel(self, opening, material=STONE):
        """A stone frame around a doorway, 8 wide, standing 3 proud."""
        a0, a1, z0, z1 = opening
        return [self.box((a0 - 8, a0), (0, 3), (z0, z1 + 8), material),
                self.box((a1, a1 + 8), (0, 3), (z0, z1 + 8), material),
                self.box((a0, a1), (0, 3), (z1, z1 + 8), material)]


def prism_along(axis, lo, hi, outline, materials):
    """lying(), with the outline in world coordinates across the axis for both axes."""
    if axis == "y":
        outline = [(-a, z) for a, z in outline]
    return lying(axis, lo, hi, outline, materials)


def gable(axis, along, across, z, slope, gables, over=20, solid=True):
    """A gable roof over a rectangle: attic, boards, tiles, ridge; slope is rise over run. Without
    the solid attic the gables are walls 12 thick and the roof is open below."""
    a0, a1 = across
    middle, rise = (a0 + a1) / 2, slope * (a1 - a0) / 2
    triangle = [(a0, z), (a1, z), (middle, z + rise)]
    spans = [along] if solid else [(along[0], along[0] + 12), (along[1] - 12, along[1])]
    parts = [prism_along(axis, *span, triangle, gables) for span in spans]
    lo, hi = along[0] - over * .6, along[1] + over * .6
    for edge, sign in ((a0, -1), (a1, 1)):
        foot = edge + sign * over
        for low, high, material in ((0, 3, PLANKS), (3, 10, TILES)):
            parts.append(prism_along(axis, lo, hi, [
                (foot, z - over * slope + low), (middle, z + rise + low),
                (middle, z + rise + high), (foot, z - over * slope + high)], material))
    top = z + rise + 10
    parts.append(prism_along(axis, lo - 2, hi + 2, [(middle - 9, top - 9 * slope),
                                                    (middle + 9, top - 9 * slope),
                                                    (middle + 4, top + 3), (middle - 4, top + 3)],
                             TILES))
    return parts


def chimney(x, y, z0, z1, half=14):
    return [box((x - half, y - half, z0), (x + half, y + half, z1), vigil("rubble")),
            box((x - half - 4, y - half - 4, z1), (x + half + 4, y + half + 4, z1 + 6), STONE),
            box((x - half + 3, y - half + 3, z1 + 6), (x + half - 3, y + half - 3, z1 + 16),
                vigil("rust"))]
