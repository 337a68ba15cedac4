# SPDX-License-Identifier: GPL-2.0-or-later
"""A brush: a convex solid as a list of textured sides, and the primitives that build one.

Sides are written in the Valve 220 form of the .map format, which states the texture axes in full.
Quake II's sides carry contents, flags and value at the end of the line. Nothing here clips brushes
against each other: that is the compiler's task.
"""

from dataclasses import dataclass, replace

import numpy as np

from texture_size import texture_size

FACES = ("-x", "+x", "-y", "+y", "bottom", "top")


@dataclass
class Side:
    """A polygon (counter-clockwise seen from outside, n x 3) and the material painted on it."""

    polygon: np.ndarray
    material: object

    def normal(self):
        p = self.polygon
        n = np.zeros(3)
        for a, b in zip(p, np.roll(p, -1, axis=0)):
            n += np.cross(a - p[0], b - p[0])
        return n / np.linalg.norm(n)

    def axes(self):
        """Unit u (to the right) and v (down) in the side's plane, as a viewer outside sees it."""
        n = self.normal()
        if self.material.cast:
            nearest = np.argmax(np.abs(n))
            n = np.eye(3)[nearest] * np.sign(n[nearest])
        if abs(n[2]) > 0.8:
            u = np.array([1.0, 0.0, 0.0]) - n * n[0]
        else:
            u = np.cross([0.0, 0.0, 1.0], n)
        u /= np.linalg.norm(u)
        v = -np.cross(n, u)
        return (v, -u) if self.material.turn else (u, v)

    def line(self):
        """The .map text of the side."""
        m = self.material
        u, v = self.axes()
        scale = [m.scale, m.scale]
        shift = [0.0, 0.0]
        if m.fit:
            for i, axis in enumerate((u, v)):
                d = self.polygon @ axis
                scale[i] = (d.max() - d.min()) / texture_size(m.texture)[i]
                shift[i] = -d.min() / scale[i]
        points = plane_points(self.polygon)
        text = " ".join("( " + " ".join(number(c) for c in p) + " )" for p in points)
        uv = " ".join("[ %s %s ]" % (" ".join(number(c) for c in axis), number(s))
                      for axis, s in zip((u, v), shift))
        return "%s %s %s 0 %s %s %d %d %d" % (text, m.texture, uv, number(scale[0]),
                                              number(scale[1]), m.contents, m.flags, m.value)


def plane_points(polygon):
    """Three points of the polygon, clockwise from outside, that span the largest triangle."""
    best, area = (0, 1, 2), -1.0
    count = len(polygon)
    for i in range(count):
        for j in range(i + 1, count):
            for k in range(j + 1, count):
                a = np.linalg.norm(np.cross(polygon[j] - polygon[i], polygon[k] - polygon[i]))
                if a > area * 1.0001:
                    best, area = (i, j, k), a
    i, j, k = best
    return polygon[i], polygon[k], polygon[j]


def number(x):
    """Shortest decimal text of x with at most six digits after the point."""
    text = "%.6f" % x
    text = text.rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


class Brush:
    """A convex solid."""

    def __init__(self, sides):
        self.sides = sides

    def planes(self):
        """Outward planes as an (n, 4) array: normal and distance."""
        return np.array([[*s.normal(), s.normal() @ s.polygon[0]] for s in self.sides])

    def bounds(self):
        points = np.concatenate([s.polygon for s in self.sides])
        return points.min(axis=0), points.max(axis=0)

    def moved(self, offset):
        return Brush([Side(s.polygon + np.asarray(offset, float), s.material) for s in self.sides])

    def turned(self, yaw, centre=(0, 0, 0)):
        """Rotated about the vertical through centre by yaw degrees, counter-clockwise."""
        a = np.radians(yaw)
        r = np.array([[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]])
        c = np.asarray(centre, float)
        return Brush([Side((s.polygon - c) @ r.T + c, s.material) for s in self.sides])

    def detail(self):
        return Brush([Side(s.polygon, s.material.detail()) for s in self.sides])

    def text(self):
        # Sides of one brush must agree on contents: the first side's are taken.
        contents = self.sides[0].material.contents
        lines = [Side(s.polygon, replace(s.material, contents=contents)).line()
                 for s in self.sides]
        return "{\n" + "\n".join(lines) + "\n}\n"


def pick(materials, face):
    """The material of a named face: materials is a Material or a dict with 'all', 'side', ..."""
    if not isinstance(materials, dict):
        return materials
    if face in materials:
        return materials[face]
    if face not in ("top", "bottom") and "side" in materials:
        return materials["side"]
    return materials["all"]


def box(lo, hi, materials):
    """An axis-aligned box; materials may name faces -x +x -y +y bottom top, side, all."""
    (x0, y0, z0), (x1, y1, z1) = lo, hi
    if not (x0 < x1 and y0 < y1 and z0 < z1):
        raise ValueError("box %s %s has no volume" % (lo, hi))
    corner = {(i, j, k): np.array([(x0, x1)[i], (y0, y1)[j], (z0, z1)[k]], float)
              for i in (0, 1) for j in (0, 1) for k in (0, 1)}
    loops = {
        "-x": [(0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0)],
        "+x": [(1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1)],
        "-y": [(0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)],
        "+y": [(0, 1, 0), (0, 1, 1), (1, 1, 1), (1, 1, 0)],
        "bottom": [(0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0)],
        "top": [(0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)],
    }
    return Brush([Side(np.array([corner[c] for c in loops[f]]), pick(materials, f))
                  for f in FACES])


def prism(outline, z0, z1, materials):
    """A convex outline (counter-clockwise from above, n x 2) extruded from z0 to z1."""
    outline = np.asarray(outline, float)
    low = np.column_stack([outline, np.full(len(outline), float(z0))])
    high = np.column_stack([outline, np.full(len(outline), float(z1))])
    sides = [Side(high, pick(materials, "top")), Side(low[::-1], pick(materials, "bottom"))]
    for i in range(len(outline)):
        j = (i + 1) % len(outline)
        sides.append(Side(np.array([low[i], low[j], high[j], high[i]]), pick(materials, "side")))
    return Brush(sides)


def frustum(low, high, materials):
    """A solid between two outlines with equally many corners (n x 3 each, counter-clockwise
    from above). The side quads must be planar."""
    low, high = np.asarray(low, float), np.asarray(high, float)
    sides = [Side(high, pick(materials, "top")), Side(low[::-1], pick(materials, "bottom"))]
    for i in range(len(low)):
        j = (i + 1) % len(low)
        sides.append(Side(np.array([low[i], low[j], high[j], high[i]]), pick(materials, "side")))
    return Brush(sides)


def circle(centre, radius, count, phase=0.5):
    """Corners of a regular polygon, counter-clockwise; radius reaches the corners."""
    a = 2 * np.pi * (np.arange(count) + phase) / count
    return np.column_stack([centre[0] + radius * np.cos(a), centre[1] + radius * np.sin(a)])


def cylinder(centre, radius, z0, z1, materials, count=12):
    return prism(circle(centre, radius, count), z0, z1, materials)


def lying(axis, lo, hi, outline, materials):
    """A prism that lies along axis 'x' or 'y' from lo to hi; outline gives (across, height)."""
    outline = np.asarray(outline, float)

    def place(along):
        if axis == "x":
            return np.column_stack([np.full(len(outline), along), outline])
        return np.column_stack([-outline[:, 0], np.full(len(outline), along), outline[:, 1]])

    near, far = place(float(lo)), place(float(hi))
    sides = [Side(far, pick(materials, "end")), Side(near[::-1], pick(materials, "end"))]
    for i in range(len(outline)):
        j = (i + 1) % len(outline)
        sides.append(Side(np.array([near[i], near[j], far[j], far[i]]), pick(materials, "side")))
    return Brush(orient(sides))


def hull(points, material):
    """The convex hull of a few points in general position: a triangle per side."""
    points = np.asarray(points, float)
    sides = []
    count = len(points)
    for i in range(count):
        for j in range(i + 1, count):
            for k in range(j + 1, count):
                n = np.cross(points[j] - points[i], points[k] - points[i])
                away = (points - points[i]) @ n
                away[[i, j, k]] = 0
                if np.all(away <= 0):
                    sides.append(Side(points[[i, j, k]], material))
                elif np.all(away >= 0):
                    sides.append(Side(points[[i, k, j]], material))
    return Brush(sides)


def orient(sides):
    """Turns every side whose normal points at the solid's centre."""
    centre = np.concatenate([s.polygon for s in sides]).mean(axis=0)
    return [s if s.normal() @ (s.polygon.mean(axis=0) - centre) > 0
            else Side(s.polygon[::-1], s.material) for s in sides]


def beam(a, b, width, height, materials):
    """A square-cut beam from a to b (any direction that is not vertical)."""
    a, b = np.asarray(a, float), np.asarray(b, float)
    forward = (b - a) / np.linalg.norm(b - a)
    right = np.cross(forward, [0, 0, 1])
    right /= np.linalg.norm(right)
    up = np.cross(right, forward)
    return oblong(a, b, right * width / 2, up * height / 2, materials)


def oblong(a, b, right, up, materials):
    """A box around the segment a-b; right and up are half-extents across it."""
    corners = [-right - up, right - up, right + up, -right + up]
    near = np.array([a + c for c in corners])
    far = np.array([b + c for c in corners])
    sides = [Side(near, pick(materials, "end")), Side(far, pick(materials, "end"))]
    for i in range(4):
        j = (i + 1) % 4
        sides.append(Side(np.array([near[i], near[j], far[j], far[i]]), pick(materials, "side")))
    return Brush(orient(sides))
