# SPDX-License-Identifier: GPL-2.0-or-later
"""Painters of what grows: grass, foliage, bark, straw."""

import numpy as np

from painter import canvas, cloud, coordinates, emboss, mix, nearest, smooth, streaks, times

SIZE = (256, 256)
SMALL = (128, 128)


def grass(colour, dry, seed):
    """Short grass with dry patches: noise drawn out along two slanted directions."""
    blades = np.maximum(streaks(SIZE, seed, "y", .22, .35), streaks(SIZE, seed + 1, "y", .4, .3))
    patch = .15 + .6 * smooth(-1.4, 2.2, cloud(SIZE, seed + 2, 1.1, 3))
    image = mix(canvas(SIZE, colour), dry, patch)
    image = times(image, np.clip(1 + .30 * blades, .35, 1.8))
    return times(image, 1 + .12 * cloud(SIZE, seed + 3, .6, 6))


def foliage(colour, seed, count=420):
    """Leaves over each other: cells, each lit by its own tilt, dark in the gaps."""
    rng = np.random.default_rng(seed)
    first, second, index = nearest(SIZE, rng.random((count, 2)) * SIZE)
    tilt = rng.normal(1, .28, count)[index]
    hue = rng.normal(0, .10, count)[index]
    image = times(canvas(SIZE, colour), np.clip(tilt, .3, 1.8))
    image[..., 0] *= 1 + 1.5 * hue
    image[..., 2] *= 1 - hue
    gap = 1 - smooth(.4, 2.6, second - first)
    deep = smooth(.5, 2, cloud(SIZE, seed + 1, 1.2, 3))
    image = times(image, (1 - .6 * gap) * (1 - .5 * deep))
    return times(image, emboss(np.clip(7 - first, 0, 7) / 4, .4))


def bark(colour, seed):
    """Furrowed bark along v."""
    ridge = streaks(SMALL, seed, "y", .16, .8) + .5 * streaks(SMALL, seed + 1, "y", .35, .6)
    image = times(canvas(SMALL, colour), 1 + .10 * cloud(SMALL, seed + 2, 1.2, 2))
    image = times(image, 1 - .55 * smooth(.5, 1.8, ridge))
    return times(image, emboss(-.8 * ridge, .22))


def straw(seed):
    """Pressed straw, mostly lying along u."""
    stalk = streaks(SMALL, seed, "x", .10, .35)
    cross = streaks(SMALL, seed + 1, "x", .3, .4)
    image = times(canvas(SMALL, (.50, .36, .13)), np.clip(1 + .22 * stalk + .14 * cross, .3, 1.7))
    dark = smooth(1.0, 2.2, cloud(SMALL, seed + 2, .9, 4))
    return mix(image, (.17, .11, .04), .55 * dark)


def weave(colour, seed):
    """Coarse linen."""
    x, y = coordinates(SMALL)
    thread = .5 * np.sin(np.pi * x / 1.5) * np.sin(np.pi * y / 1.5)
    fold = streaks(SMALL, seed, "y", .1, 1.4)
    return times(canvas(SMALL, colour), 1 + .03 * thread + .03 * fold)
