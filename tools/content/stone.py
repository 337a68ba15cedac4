# SPDX-License-Identifier: GPL-2.0-or-later
"""Painters of mineral surfaces: concrete, plaster, brick, tiles, marble, rock, soil; masonry is in
masonry.py."""

import numpy as np

from painter import (canvas, cells, cloud, coordinates, emboss, mix, rivets, seam, smooth,
                     streaks, times)

SIZE = (256, 256)
FINE = (512, 512)


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
    image = times(image, 1 - .5 * rivets(SIZE, spots, 3.2))
    # Runs of rust and soot below the anchors, blotches of damp.
    run = smooth(.9, 2.4, streaks(SIZE, seed + 4, "y", .10, 1.0))
    image = mix(image, np.array(colour) * (.52, .44, .36), .55 * run)
    damp = smooth(.6, 2.0, cloud(SIZE, seed + 5, 1.6, 2))
    return times(image, 1 - .28 * damp)


def floor_painted(seed):
    """A hall floor: grey paint rubbed through to the concrete, tyre marks, oil, cut joints."""
    x, y = coordinates(FINE)
    image = times(canvas(FINE, (.20, .205, .205)), grain(FINE, seed, .04, .07))
    rough = cloud(FINE, seed + 6, .7, 10)
    worn = smooth(.5, 1.3, cloud(FINE, seed + 5, 1.5, 2) + .25 * rough)
    image = mix(image, times(canvas(FINE, (.32, .305, .275)), 1 + .06 * rough), .75 * worn)
    # Chips of paint, dark marks of turning tyres, drops of oil.
    chip = smooth(2.0, 2.4, cloud(FINE, seed + 7, .8, 6))
    image = mix(image, (.36, .34, .31), .8 * chip)
    rng = np.random.default_rng(seed)
    for _ in range(7):
        cx, cy, radius = rng.uniform(-256, 768), rng.uniform(-256, 768), rng.uniform(150, 420)
        away = wrapped_ring(x, y, cx, cy, radius)
        tread = .55 + .45 * np.sign(np.sin((x + y) * 1.1)) * (away < 9)
        mark = (1 - smooth(6, 9, away)) * smooth(-.6, 1.2, cloud(FINE, seed + int(radius), 1.3, 2))
        image = times(image, 1 - .42 * mark * tread)
    oil = smooth(1.5, 2.3, cloud(FINE, seed + 8, 1.6, 3))
    image = times(image, 1 - .55 * oil)
    joint = np.maximum(seam(x, 512, 3), seam(y, 512, 3))
    return times(image, 1 - .6 * joint)


def wrapped_ring(x, y, cx, cy, radius):
    """Distance of pixels of a fine canvas from a circle that wraps at the borders."""
    best = np.full(x.shape, np.inf)
    for dx in (-512, 0, 512):
        for dy in (-512, 0, 512):
            best = np.minimum(best, np.abs(np.hypot(x - cx - dx, y - cy - dy) - radius))
    return best


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
    """Fractured rock: ledges, two sizes of blocks with dark cracks between, pale scars, grit."""
    warp = cloud(FINE, seed + 1, 1.4, 2)
    grit = cloud(FINE, seed + 2, .6, 16)
    ledge = streaks(FINE, seed + 3, "x", .3, 1.1)
    height = 2.6 * warp + 1.6 * ledge + .55 * grit + .8 * cloud(FINE, seed + 7, 1.0, 8)
    rng = np.random.default_rng(seed)
    tone = np.ones(warp.shape)
    crack = np.zeros(warp.shape)
    for count, wide, deep in ((26, 4.5, .62), (150, 2.6, .34)):
        first, second, index = cells(FINE, count, seed + count)
        edge = second - first + 3.2 * cloud(FINE, seed + count + 4, .9, 8)
        crack = np.maximum(crack, deep * (1 - smooth(.5, wide, edge)))
        tone *= rng.normal(1, .10, count)[index]
        height += rng.normal(0, 1.2, count)[index] * smooth(0, 8, edge)
    image = times(canvas(FINE, colour), tone * (1 + .10 * warp + .05 * grit))
    warm = cloud(FINE, seed + 6, 1.5, 1)
    image[..., 0] *= 1 + .07 * warm
    image[..., 2] *= 1 - .05 * warm
    scar = smooth(1.3, 2.1, cloud(FINE, seed + 8, 1.2, 4) + .3 * grit)
    image = mix(image, np.array(colour) * 1.55, .5 * scar)
    return times(times(image, emboss(height, .16)), 1 - crack)


def gravel(colour, seed):
    """Trodden earth with stones of two sizes."""
    grit = cloud(FINE, seed + 2, .5, 20)
    image = times(canvas(FINE, colour), grain(FINE, seed, .06, .12) * (1 + .10 * grit))
    height = .5 * cloud(FINE, seed + 1, .8, 6) + .35 * grit
    rng = np.random.default_rng(seed)
    for count, share, top in ((700, .45, 7), (170, .22, 15)):
        first, second, index = cells(FINE, count, seed + count)
        keep = rng.uniform(0, 1, count)[index] < share
        stone = smooth(1.5, 4.5, second - first + 1.2 * grit) * keep
        tone = rng.normal(1.15, .22, count)[index]
        pale = times(canvas(FINE, np.array(colour) * 1.3), tone * (1 + .08 * grit))
        image = mix(image, pale, stone)
        height = height + 1.4 * stone * np.clip(top - first, 0, top) / 3
    return times(image, emboss(height, .26))
