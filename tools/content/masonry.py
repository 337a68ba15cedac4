# SPDX-License-Identifier: GPL-2.0-or-later
"""Painters of old masonry: weathered stucco, rubble walls, cobbles, flagstones, roof tiles."""

import numpy as np

from painter import (canvas, cloud, coordinates, emboss, mix, nearest, seam, smooth, streaks,
                     times)
from stone import grain

SIZE = (256, 256)


def rows_of_points(rows, columns, jitter, seed):
    """Points of a staggered grid on the canvas, each moved by up to jitter of its cell."""
    rng = np.random.default_rng(seed)
    j, i = np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij")
    x = (i + .5 * (j % 2) + rng.uniform(-jitter, jitter, i.shape)) * SIZE[0] / columns
    y = (j + .5 + rng.uniform(-jitter, jitter, i.shape)) * SIZE[1] / rows
    return np.column_stack([x.ravel() % SIZE[0], y.ravel() % SIZE[1]])


def stones(rows, columns, jitter, colour, joint, gap, seed, vary=.13):
    """Rounded stones in staggered rows, with joints gap pixels wide between them."""
    first, second, index = nearest(SIZE, rows_of_points(rows, columns, jitter, seed))
    rng = np.random.default_rng(seed + 1)
    edge = second - first + .8 * cloud(SIZE, seed + 2, 1.0, 6)
    body = smooth(gap, gap + 2.5, edge)
    tone = rng.normal(1, vary, rows * columns)[index]
    warm = rng.normal(0, .05, rows * columns)[index]
    image = times(canvas(SIZE, colour), tone * grain(SIZE, seed + 3, .06, .05))
    image[..., 0] *= 1 + warm
    image[..., 2] *= 1 - warm
    filling = times(canvas(SIZE, joint), grain(SIZE, seed + 4, .09, .06))
    dome = 2.2 * smooth(gap, gap + 9, edge) + .22 * cloud(SIZE, seed + 5, .8, 8)
    return times(mix(filling, image, body), emboss(dome, .30))


def stucco(colour, seed):
    """Lime plaster that has seen weather: clouds of tone, runs below, hairline cracks."""
    stain = smooth(.1, 2.2, cloud(SIZE, seed, 1.5, 2))
    run = smooth(.3, 2.4, streaks(SIZE, seed + 1, "y", .25, 1.1))
    bump = cloud(SIZE, seed + 2, .8, 8)
    image = times(canvas(SIZE, colour), grain(SIZE, seed + 3, .015, .04) * emboss(bump, .035))
    image = mix(image, np.array(colour) * (.80, .74, .66), .55 * stain)
    return mix(image, np.array(colour) * (.72, .70, .68), .35 * run)


def roof_tiles(seed):
    """Clay pantiles: eight columns of round tiles, eight rows that overlap downwards."""
    x, y = coordinates(SIZE)
    column, row = (x // 32).astype(int), (y // 32).astype(int)
    rng = np.random.default_rng(seed)
    shift = rng.uniform(-2.5, 2.5, 8)[column]
    row = ((y + shift) // 32).astype(int) % 8
    across = (x % 32 - 16) / 16
    down = ((y + shift) % 32) / 32
    tone = rng.normal(1, .17, (8, 8))[row, column]
    pale = np.clip(rng.normal(.12, .16, (8, 8)), 0, .6)[row, column]
    image = times(canvas(SIZE, (.46, .19, .105)), tone * grain(SIZE, seed, .06, .06))
    image = mix(image, (.50, .36, .25), pale)
    # The tile is a half pipe; its lower end shades the one below.
    round_off = .45 + .62 * np.sqrt(np.clip(1 - across ** 2, 0, 1)) - .16 * across
    lip = 1 - .55 * (1 - smooth(0, .2, down)) + .10 * smooth(.8, .98, down)
    image = times(image, round_off * lip)
    moss = smooth(1.3, 2.4, cloud(SIZE, seed + 3, 1.2, 3))
    return mix(image, (.16, .17, .07), .5 * moss)


def flagstones(seed):
    """Worn square slabs, 64 pixels, of slightly different stone."""
    x, y = coordinates(SIZE)
    row = (y // 64).astype(int)
    along = (x + 32 * (row % 2)) % 256
    column = (along // 64).astype(int)
    rng = np.random.default_rng(seed)
    tone = rng.normal(1, .10, (4, 4))[row, column]
    image = times(canvas(SIZE, (.37, .31, .235)), tone * grain(SIZE, seed, .05, .07))
    wobble = 1.1 * cloud(SIZE, seed + 1, 1.1, 5)
    line = np.maximum(seam(along + wobble, 64, 3), seam(y + wobble, 64, 3))
    image = mix(image, (.13, .11, .08), .85 * line)
    return times(image, emboss(-1.2 * line + .3 * cloud(SIZE, seed + 2, 1.1, 4), .25))
