# SPDX-License-Identifier: GPL-2.0-or-later
"""The gallery's statue: a coiled dragon serpent, carved as one displaced tube with two horns.

The body is a spline with a parallel frame; its cross-section carries scales, belly plates, a crest,
brows, eyes and a mouth, so that the receiver is as intricate as a scanned model. It stands on z = 0
and is about 240 high. No part is taken from a scan.
"""

import numpy as np

from mesh_file import MeshMaterial, Primitive, smooth_normals, write_glb

ALONG, AROUND = 800, 72
MARBLE = MeshMaterial("marble", (.60, .565, .50), .45)
HORN = MeshMaterial("horn", (.30, .26, .21), .35)


def catmull(points, values):
    """Evaluates a uniform Catmull-Rom spline at parameters in 0..len(points) - 1."""
    p = np.asarray(points, float)
    padded = np.vstack([2 * p[0] - p[1], p, 2 * p[-1] - p[-2]])
    i = np.clip(values.astype(int), 0, len(p) - 2)
    t = (values - i)[:, None]
    a, b, c, d = (padded[i + k] for k in range(4))
    return .5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t
                 + (3 * b - a - 3 * c + d) * t ** 3)


def body_points():
    """The spine: tail tip on the ground, three coils, a rising neck, the head looking to +x.

    Returns points, radii, dorsal directions.
    """
    points, radii, dorsal = [], [], []
    for t in np.linspace(0, 1, 34):
        angle = np.radians(150 + 800 * t)
        ring = 86 - 38 * t ** 1.2
        thick = 2 + 17 * np.sin(np.pi / 2 * min(1, t * 1.6)) ** .8
        points.append([ring * np.cos(angle), ring * np.sin(angle), thick + 56 * t ** 1.2])
        radii.append(thick)
        dorsal.append([.35 * np.cos(angle), .35 * np.sin(angle), 1])
    z = points[-1][2]
    for t in np.linspace(0, 1, 13)[1:]:
        angle = np.radians(950 + 310 * t)
        ring = 48 - 18 * t
        points.append([ring * np.cos(angle), ring * np.sin(angle), z + 14 * t + 50 * t ** 2.2])
        radii.append(19 - 4 * t)
        dorsal.append([(.35 + .65 * t) * np.cos(angle), (.35 + .65 * t) * np.sin(angle), 1 - t])
    for point, radius, up in [
        ((-33, -5, 165), 14.5, (-1, 0, .1)), ((-22, -4, 190), 13.5, (-1, .1, .4)),
        ((2, -3, 208), 13, (-.5, 0, 1)), ((26, -3, 213), 15.5, (-.1, 0, 1)),
        ((46, -4, 209), 17, (.1, 0, 1)), ((66, -4, 202), 12.5, (.25, 0, 1)),
        ((84, -4, 196), 10.5, (.25, 0, 1)), ((96, -4, 191), 6.5, (.3, 0, 1)),
    ]:
        points.append(point)
        radii.append(radius)
        dorsal.append(up)
    return np.array(points), np.array(radii), np.array(dorsal)


def spine():
    """Samples of the spine at equal lengths: position, tangent, dorsal, side, radius, arc length,
    and how much of each sample is head (0..1)."""
    points, radii, dorsal = body_points()
    dense = np.linspace(0, len(points) - 1, 6000)
    path = catmull(points, dense)
    length = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))])
    at = np.interp(np.linspace(0, length[-1], ALONG), length, dense)
    position = catmull(points, at)
    tangent = np.gradient(position, axis=0)
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    up = catmull(dorsal, at)
    up -= tangent * np.sum(up * tangent, axis=1, keepdims=True)
    up /= np.linalg.norm(up, axis=1, keepdims=True)
    side = np.cross(tangent, up)
    radius = catmull(radii[:, None], at)[:, 0]
    head = np.clip((at - (len(points) - 5.6)) / .9, 0, 1)
    head = head * head * (3 - 2 * head)
    return position, up, side, radius, np.linspace(0, length[-1], ALONG), head


def bump(x, width):
    return np.exp(-(x / width) ** 2)


def surface():
    """Vertices of the tube as (ALONG, AROUND, 3). The angle runs from the dorsal line (0) over the
    sides to the belly (pi), denser near the dorsal line for the crest."""
    position, up, side, radius, arc, head = spine()
    u = np.linspace(-1, 1, AROUND, endpoint=False)
    theta = np.pi * (u + .28 * np.sin(np.pi * u) * -1)
    s, a = np.meshgrid(arc, theta, indexing="ij")
    r = radius[:, None]
    h = head[:, None]
    from_nose = arc[-1] - s

    # Scales: rows of overlapping lozenges whose size follows the body.
    count = 16
    row = s / 6.4
    lane = a / (2 * np.pi) * count
    parity = np.floor(row) % 2
    du = row - np.floor(row)
    dv = np.abs(lane + .5 * parity - np.round(lane + .5 * parity))
    scale = np.clip(1 - dv * 2, 0, 1) ** .5 * (1 - du) * (.35 + .65 * np.clip(1 - dv * 2, 0, 1))
    flank = 1 - bump(np.abs(a) - np.pi, .95)
    relief = .15 * scale * flank * (1 - .75 * h)
    # Belly plates.
    plates = .5 + .5 * np.cos(2 * np.pi * s / 12.8)
    relief += .07 * plates ** .5 * bump(np.abs(a) - np.pi, .7) * (1 - h)
    # The crest: a row of fins along the back that grow towards the neck and end at the tail.
    grow = np.clip((s - 90) / 350, 0, 1) * (1 - h)
    tooth = (1 - np.abs(2 * ((s / 19.2) % 1) - 1)) ** 1.3
    relief += (.22 + .50 * tooth) * grow * bump(a, .13)

    # The head: flat below, broad brows, eyes, nostrils and the line of the mouth.
    flat = 1 - h * (.26 * bump(np.abs(a) - np.pi, 1.0) + .10 * bump(a, .8))
    flat *= 1 + h * .16 * bump(np.abs(a) - 1.45, .5)
    relief += h * .30 * bump(np.abs(a) - .78, .20) * bump(from_nose - 50, 12)
    relief += h * .30 * bump(np.abs(a) - 1.20, .20) * bump(from_nose - 43, 4.6)
    relief += h * .28 * bump(np.abs(a) - .62, .25) * bump(from_nose - 8, 4.5)
    mouth = bump(np.abs(a) - (1.92 + .12 * np.sin(from_nose / 9)), .12)
    relief -= h * .32 * mouth * np.clip((64 - from_nose) / 8, 0, 1)
    relief += h * .05 * np.cos(from_nose * 1.3) * bump(np.abs(a) - 2.05, .14)
    relief += h * .30 * (1 - np.abs(2 * ((from_nose / 7) % 1) - 1)) * bump(np.abs(a) - 1.75, .3) \
        * bump(from_nose - 66, 9)

    ring = r * flat * (1 + relief)
    out = (position[:, None] + (ring * np.cos(a))[..., None] * up[:, None]
           + (ring * np.sin(a))[..., None] * side[:, None])
    return out, position


def tube(rings, first, last):
    """A closed tube from rings (n, m, 3) with an apex at either end."""
    n, m, _ = rings.shape
    points = np.concatenate([rings.reshape(-1, 3), [first, last]])
    i, j = np.meshgrid(np.arange(n - 1), np.arange(m), indexing="ij")
    a, b = i * m + j, i * m + (j + 1) % m
    c, d = a + m, b + m
    triangles = np.concatenate([np.stack([a, b, d], -1).reshape(-1, 3),
                                np.stack([a, d, c], -1).reshape(-1, 3)])
    ring = np.arange(m)
    after = (ring + 1) % m
    start = np.column_stack([np.full(m, n * m), after, ring])
    end = np.column_stack([np.full(m, n * m + 1), (n - 1) * m + ring, (n - 1) * m + after])
    return points, outward(points, np.concatenate([triangles, start, end]))


def outward(points, triangles):
    """Turns all triangles when the enclosed volume is negative."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    volume = np.sum(a * np.cross(b, c))
    return triangles if volume > 0 else triangles[:, ::-1]


def horn(side):
    """One horn, swept back from the brow, ringed."""
    spine_points = np.array([[36, 9 * side - 4, 219], [26, 15 * side - 4, 229],
                             [10, 20 * side - 4, 236], [-8, 21 * side - 4, 235],
                             [-22, 17 * side - 4, 228]], float)
    at = np.linspace(0, 4, 60)
    path = catmull(spine_points, at)
    tangent = np.gradient(path, axis=0)
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    up = np.cross(tangent, [0, 1, 0])
    up /= np.linalg.norm(up, axis=1, keepdims=True)
    across = np.cross(tangent, up)
    radius = 5.2 * (1 - at / 4.15) ** .8 * (1 + .09 * np.cos(at * 22))
    a = 2 * np.pi * np.arange(20) / 20
    rings = (path[:, None] + (radius[:, None] * np.cos(a))[..., None] * up[:, None]
             + (radius[:, None] * np.sin(a))[..., None] * across[:, None])
    return tube(rings, path[0], path[-1] + .5 * tangent[-1])


def primitives():
    rings, spine_path = surface()
    nose = spine_path[-1] + .45 * (rings[-1].mean(axis=0) - rings[-6].mean(axis=0))
    points, triangles = tube(rings, rings[0].mean(axis=0), nose)
    points[:, 2] -= points[:, 2].min()
    lift = -min(0.0, rings[..., 2].min())
    out = [Primitive(MARBLE, points, triangles, smooth_normals(points, triangles))]
    for side in (-1, 1):
        p, t = horn(side)
        p[:, 2] += lift
        out.append(Primitive(HORN, p, t, smooth_normals(p, t)))
    return out


def write(path):
    """Writes the statue; returns the number of its triangles."""
    parts = primitives()
    write_glb(path, parts, "statue")
    return sum(len(p.triangles) for p in parts)
