# SPDX-License-Identifier: GPL-2.0-or-later
"""Trees: branching ones with leaves in clumps, and cypresses."""

import numpy as np

from brush import circle, frustum, hull
from material import vigil

BARK = vigil("bark", scale=.35)
LEAVES = vigil("foliage", scale=.3)
NEEDLES = vigil("cypress", scale=.4)


def ring(centre, axis, radius, sides):
    """Corners of a regular polygon around an axis, counter-clockwise against it."""
    axis = axis / np.linalg.norm(axis)
    right = np.cross(axis, [0, 1, 0] if abs(axis[1]) < .8 else [1, 0, 0])
    right /= np.linalg.norm(right)
    up = np.cross(axis, right)
    a = 2 * np.pi * np.arange(sides) / sides
    return centre + radius * (np.outer(np.cos(a), right) + np.outer(np.sin(a), up))


def limb(level, a, b, start, end, sides=6):
    """A tapering branch from a to b with these radii."""
    a, b = np.asarray(a, float), np.asarray(b, float)
    level.add_detail(frustum(ring(a, b - a, start, sides), ring(b, b - a, end, sides), BARK))


def clump(level, rng, centre, radius):
    """A clump of leaves: an irregular, flattened ball of twenty triangles."""
    g = (1 + 5 ** .5) / 2
    d = np.array([(s, t * g, 0) for s in (-1, 1) for t in (-1, 1)])
    d = np.concatenate([np.roll(d, k, axis=1) for k in range(3)]) / np.hypot(1, g)
    leaves(level, rng, centre, radius * d * rng.uniform(.82, 1.18, (12, 1)) * [1, 1, .7])


def bush(level, rng, centre, radius):
    """A small clump of eight triangles."""
    d = np.concatenate([np.eye(3), -np.eye(3)]) + rng.uniform(-.25, .25, (6, 3))
    leaves(level, rng, centre, radius * d)


def leaves(level, rng, centre, points):
    a = rng.uniform(0, 6.28)
    turn = np.array([[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]])
    level.add_detail(hull(np.round(centre + points @ turn, 1), LEAVES))


def tree(level, rng, x, y, z, height, radius, forks=(4, 3, 2)):
    """A broad tree with its lowest fork at a third of its height; forks says how many branches
    leave each generation."""
    root = np.array([x, y, z - 12.0])
    fork = root + [rng.uniform(-8, 8), rng.uniform(-8, 8), height * .38]
    limb(level, root, root + (fork - root) * .2, radius * 1.5, radius, 7)
    limb(level, root + (fork - root) * .2, fork, radius, radius * .8, 7)
    grow(level, rng, fork, np.array([0, 0, 1.0]), height * .30, radius * .62, forks)


def grow(level, rng, start, along, length, radius, forks):
    """Branches from a point; the last ones carry clumps of leaves."""
    first = rng.uniform(0, 6.28)
    for i in range(forks[0]):
        a = first + 6.28 * i / forks[0] + rng.uniform(-.3, .3)
        out = np.array([np.cos(a), np.sin(a), 0])
        d = along + out * rng.uniform(.8, 1.25) + [0, 0, .15]
        d /= np.linalg.norm(d)
        end = start + d * length * rng.uniform(.8, 1.15)
        limb(level, start, end, radius, radius * .6, 3 + len(forks) // 2)
        if len(forks) > 1:
            grow(level, rng, end, d, length * .68, radius * .58, forks[1:])
        else:
            clump(level, rng, end + d * 10, length * rng.uniform(.62, .85))


def cypress(level, x, y, z, height, radius):
    """A slender cypress in six tapering drums."""
    level.add_detail(frustum(np.column_stack([circle((x, y), 6, 6), np.full(6, z - 12.0)]),
                             np.column_stack([circle((x, y), 5, 6), np.full(6, z + 14.0)]), BARK))
    profile = [(.04, .45), (.12, .85), (.30, 1.0), (.55, .84), (.78, .52), (.92, .24), (1.0, .03)]
    for (h0, r0), (h1, r1) in zip(profile, profile[1:]):
        level.add_detail(frustum(
            np.column_stack([circle((x, y), radius * r0, 7), np.full(7, z + height * h0)]),
            np.column_stack([circle((x, y), radius * r1, 7), np.full(7, z + height * h1)]),
            NEEDLES))
