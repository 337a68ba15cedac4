# SPDX-License-Identifier: GPL-2.0-or-later
"""Painters of mineral surfaces: concrete, plaster, brick, tiles, marble, rock, soil; masonry is in
masonry.py."""

import numpy as np

from painter import (canvas, cells, cloud, coordinates, emboss, mix, rivets, seam, smooth,
                     streaks, times)

SIZE = (256, 256)


def flat(colour):
    return canvas((16, 16), colour)


def grain(size, seed, fine, coarse):
    """A factor around 1: coarse stains and fine grain with the given deviations."""
    return 1 + coarse * cloud(size, seed, 1.6, 2) + fine * cloud(size, seed + 1000, .3, 8)


def concrete(colour, seed):
    image = times(canvas(SIZE, colour), grain(SIZE, seed, .035, .07))
    # Small air holes and a few hairline cracks.
    rng = np.random.default_rng(seed)
    holes = rivets(SIZE, rng.random((26, 2)) * 256, 1.6)
    image = times(image, 1 - .35 * holes)
    first, second, _ = cells(SIZE, 5, seed)
    edge = second - first + 5 * cloud(SIZE, seed + 2, 1.2, 3)
    crack = (1 - smooth(0.3, 1.2, np.abs(edge))) * (cloud(SIZE, seed + 3, 1.5, 1) > .9)
    return times(image, 1 - .3 * crack)


def concrete_panel(colour, seed):
    """Cast panels 128 pixels wide with seams and the four anchor holes of the shuttering."""
    image = concrete(colour, seed)
    x, y = coordinates(SIZE)
    tone = 1 + .05 * np.where((x // 128 + y // 128) % 2, 1, -1)
    image = times(image, tone)
    line = np.maximum(seam(x, 128, 2.5), seam(y, 128, 2.5))
    image = times(image, 1 - .55 * line)
    image = times(image, 1 + .18 * np.maximum(seam(x - 2, 128, 1.5), seam(y - 2, 128, 1.5)))
    spots = [(a + i, b + j) for a in (0, 128) for b in (0, 128) for i in (26, 102)
             for j in (26, 102)]
    return times(image, 1 - .5 * rivets(SIZE, spots, 3.2))


def floor_painted(seed):
    """A worn, painted hall floor in two greys with expansion joints."""
    image = concrete((.26, .27, .275), seed)
    wear = smooth(.2, 1.6, cloud(SIZE, seed + 5, 1.4, 2))
    image = mix(image, (.36, .35, .33), .6 * wear)
    x, y = coordinates(SIZE)
    joint = np.maximum(seam(x, 256, 3), seam(y, 256, 3))
    return times(image, 1 - .5 * joint)


def plaster(colour, seed):
    bump = cloud(SIZE, seed, .9, 6)
    return times(canvas(SIZE, colour), grain(SIZE, seed, .012, .025) * emboss(bump, .025))


def ceiling_tile(seed):
    """Mineral fibre tiles, 64 pixels, in a pale metal grid."""
    image = times(canvas(SIZE, (.62, .61, .57)), grain(SIZE, seed, .01, .015))
    rng = np.random.default_rng(seed)
    image = times(image, 1 - .28 * rivets(SIZE, rng.random((500, 2)) * 256, 1.3))
    x, y = coordinates(SIZE)
    line = np.maximum(seam(x, 128, 5), seam(y, 128, 5))
    image = mix(image, (.50, .50, .49), line)
    shadow = np.maximum(seam(x - 3.5, 128, 1.5), seam(y - 3.5, 128, 1.5))
    return times(image, 1 - .35 * shadow)


def brick(colour, mortar, seed):
    """Running bond, 8 courses of 32 pixels, bricks 64 wide."""
    x, y = coordinates(SIZE)
    row = (y // 32).astype(int)
    shifted = (x + 32 * (row % 2)) % 256
    column = (shifted // 64).astype(int)
    wobble = 1.2 * cloud(SIZE, seed, 1.0, 6)
    dx = np.minimum(shifted % 64, 64 - shifted % 64)
    dy = np.minimum(y % 32, 32 - y % 32)
    height = smooth(1.4, 4.2, np.minimum(dx, dy) + .5 * wobble)
    rng = np.random.default_rng(seed)
    tone = rng.normal(1, .13, (8, 4))[row, column]
    warm = rng.normal(0, .04, (8, 4))[row, column]
    body = times(canvas(SIZE, colour), tone * grain(SIZE, seed + 1, .07, .06))
    body[..., 0] *= 1 + warm
    joint = times(canvas(SIZE, mortar), grain(SIZE, seed + 2, .06, .04))
    return times(mix(joint, body, height), emboss(height, .35))


def tile(colour, grout, cells, seed):
    """Square glazed tiles, cells by cells on the canvas."""
    x, y = coordinates(SIZE)
    pitch = 256 / cells
    dx = np.minimum(x % pitch, pitch - x % pitch)
    dy = np.minimum(y % pitch, pitch - y % pitch)
    height = smooth(1.2, 3.5, np.minimum(dx, dy))
    rng = np.random.default_rng(seed)
    tone = rng.normal(1, .03, (cells, cells))[(y // pitch).astype(int), (x // pitch).astype(int)]
    body = times(canvas(SIZE, colour), tone * grain(SIZE, seed, .006, .015))
    return times(mix(canvas(SIZE, grout), body, height), emboss(height, .22))


def checker(a, b, cells, seed):
    """A two-coloured tile floor."""
    image = tile(a, (.10, .10, .10), cells, seed)
    x, y = coordinates(SIZE)
    pitch = 256 / cells
    dark = ((x // pitch + y // pitch) % 2) > 0
    other = tile(b, (.10, .10, .10), cells, seed + 1)
    return np.where(dark[..., None], other, image) * grain(SIZE, seed, .01, .04)[..., None]


def veins(size, seed):
    """0..1 lines along the zero crossings of turbulent noise."""
    n = cloud(size, seed, 2.0, 1) + .22 * cloud(size, seed + 1, 1.4, 4)
    m = cloud(size, seed + 2, 2.0, 1)
    main = 1 - smooth(.01, .16, np.abs(n))
    thin = 1 - smooth(0, .05, np.abs(m + .3 * n))
    return np.clip(.8 * main * smooth(-.8, .8, m) + .45 * thin, 0, 1)


def marble(base, vein, seed):
    image = times(canvas(SIZE, base), grain(SIZE, seed + 5, .008, .05))
    return mix(image, vein, .9 * veins(SIZE, seed))


def marble_floor(seed):
    """Pale slabs of 128 pixels with small dark inlays at the crossings."""
    light = marble((.60, .57, .52), (.34, .31, .28), seed)
    warm = marble((.52, .45, .36), (.28, .23, .18), seed + 9)
    x, y = coordinates(SIZE)
    image = np.where((((x // 128 + y // 128) % 2) > 0)[..., None], warm, light)
    image = times(image, 1 - .5 * np.maximum(seam(x, 128, 1.6), seam(y, 128, 1.6)))
    dx = np.abs((x + 64) % 128 - 64)
    dy = np.abs((y + 64) % 128 - 64)
    inlay = 1 - smooth(17.5, 18.5, dx + dy)
    return mix(image, marble((.07, .075, .08), (.3, .3, .28), seed + 20), inlay)


def rock(colour, seed):
    """Layered, fractured rock."""
    first, second, index = cells(SIZE, 60, seed)
    warp = cloud(SIZE, seed + 1, 1.4, 2)
    height = 1.1 * warp + .5 * cloud(SIZE, seed + 2, 1.0, 6) + .5 * streaks(SIZE, seed + 3,
                                                                           "x", .3, 1.1)
    crack = 1 - smooth(.5, 3.2, second - first + 1.6 * cloud(SIZE, seed + 4, .9, 8))
    rng = np.random.default_rng(seed)
    tone = rng.normal(1, .09, 60)[index]
    image = times(canvas(SIZE, colour), tone * (1 + .10 * warp))
    image[..., 0] *= 1 + .05 * cloud(SIZE, seed + 6, 1.5, 1)
    image = times(image, emboss(height, .33))
    return times(image, 1 - .5 * crack)


def gravel(colour, seed):
    """Trodden earth with stones."""
    first, second, index = cells(SIZE, 260, seed)
    rng = np.random.default_rng(seed)
    size = rng.uniform(.15, 1, 260)[index]
    stone = smooth(1, 4, second - first) * (size > .72)
    tone = rng.normal(1.15, .22, 260)[index]
    soil = times(canvas(SIZE, colour), grain(SIZE, seed, .10, .10))
    image = mix(soil, times(canvas(SIZE, np.array(colour) * 1.25), tone), stone)
    height = stone * np.clip(9 - first, 0, 9) / 9 + .25 * cloud(SIZE, seed + 1, .8, 6)
    return times(image, emboss(height, .4))
