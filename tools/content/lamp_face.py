# SPDX-License-Identifier: GPL-2.0-or-later
"""Painters of emissive faces. A lamp's radiance follows from the average linear colour of its
texture, so these stay bright and even."""

import numpy as np

from painter import bevel, canvas, coordinates, mix, rectangle, smooth, times


def tube(colour):
    """A fluorescent tube along u, 64 x 16."""
    size = (64, 16)
    x, y = coordinates(size)
    across = 1 - .22 * np.abs(y - 8) / 8
    ends = .55 + .45 * smooth(0, 5, np.minimum(x, 64 - x))
    return times(canvas(size, colour), across * ends)


def panel(colour):
    """A square ceiling panel with a prismatic diffuser, 64 x 64."""
    size = (64, 64)
    x, y = coordinates(size)
    prism = 1 - .05 * ((x // 4 + y // 4) % 2)
    image = times(canvas(size, colour), prism)
    return mix(image, (.55, .55, .55), 1 - bevel(size, 0, 0, 64, 64, 3))


def bulb(colour):
    """A round lamp behind glass, 32 x 32; the corners are the rim."""
    size = (32, 32)
    x, y = coordinates(size)
    r = np.hypot(x - 16, y - 16)
    core = times(canvas(size, colour), 1 - .25 * smooth(0, 16, r))
    return mix(core, np.array(colour) * .45, smooth(14.5, 16, r))


def screen(seed):
    """A monitor with text rows and a graph, 64 x 64."""
    size = (64, 64)
    rng = np.random.default_rng(seed)
    image = canvas(size, (.03, .16, .12))
    for row in range(7):
        at = 4
        while at < 30:
            length = int(rng.integers(2, 8))
            image = mix(image, (.25, .95, .60), rectangle(size, at, 5 + 8 * row, at + length,
                                                          8 + 8 * row))
            at += length + 2
    x, y = coordinates(size)
    curve = 30 + 10 * np.sin(x / 5) + 6 * np.sin(x / 2.3)
    plot = rectangle(size, 35, 6, 60, 58)
    image = mix(image, (.05, .22, .30), plot)
    return mix(image, (.9, .8, .3), plot * (np.abs(y - curve) < 1.5))


def lit_window(seed):
    """A window at night, 64 x 64: a warm room behind drawn curtains, bars before it."""
    size = (64, 64)
    x, y = coordinates(size)
    fold = .06 * np.sin(x / 1.7 + seed) + .05 * np.sin(x / 3.1)
    image = times(canvas(size, (1.0, .60, .24)), .62 + .38 * smooth(64, 8, y) + fold)
    curtain = smooth(22, 15, np.minimum(x, 64 - x) + 4 * np.sin(y / 14))
    image = mix(image, times(canvas(size, (.62, .22, .07)), .8 + 2.5 * fold), curtain * .85)
    bars = np.maximum(rectangle(size, 30, 0, 34, 64), rectangle(size, 0, 30, 64, 33))
    return mix(image, (.03, .02, .015), bars)
