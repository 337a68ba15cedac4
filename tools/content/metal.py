# SPDX-License-Identifier: GPL-2.0-or-later
"""Painters of metal surfaces: plates, sheets, paint, tread, grates, doors and cabinets."""

import numpy as np

from painter import (bevel, canvas, cloud, coordinates, emboss, mix, rectangle, rivets, seam,
                     smooth, streaks, times)
from wood import write_text

SIZE = (256, 256)
SMALL = (128, 128)


def worn(size, colour, seed, fine=.03, coarse=.05):
    tone = 1 + fine * cloud(size, seed, .3, 8) + coarse * cloud(size, seed + 1, 1.5, 2)
    return times(canvas(size, colour), tone)


def brushed(colour, seed):
    return times(canvas(SMALL, colour), 1 + .06 * streaks(SMALL, seed, "x", .04, .4))


def plate(colour, seed):
    """Four riveted plates."""
    x, y = coordinates(SIZE)
    image = worn(SIZE, colour, seed)
    spots = [(a + i, b + j) for a in (0, 128) for b in (0, 128)
             for i in (10, 46, 82, 118) for j in (10, 118)]
    spots += [(a + i, b + j) for a in (0, 128) for b in (0, 128)
              for i in (10, 118) for j in (46, 82)]
    height = 1.6 * rivets(SIZE, spots, 3.4) - 1.5 * np.maximum(seam(x, 128, 3), seam(y, 128, 3))
    return times(image, emboss(height, .22))


def panel(colour, seed):
    """Wall panels: a raised field between flat trims, with a vent row."""
    image = worn(SIZE, colour, seed)
    height = bevel(SIZE, 8, 8, 120, 180, 4) + bevel(SIZE, 136, 8, 248, 180, 4)
    height += bevel(SIZE, 8, 190, 248, 248, 4)
    image = times(image, emboss(height, .25))
    x, y = coordinates(SIZE)
    vent = seam(x - 16, 16, 7) * rectangle(SIZE, 24, 206, 232, 234)
    return times(image, 1 - .7 * vent)


def corrugated(colour, seed):
    """Vertical ribs, 32 pixels apart."""
    x, y = coordinates(SIZE)
    wave = np.cos(2 * np.pi * x / 32)
    shade = 1 + .28 * np.sin(2 * np.pi * x / 32) + .06 * wave
    image = times(worn(SIZE, colour, seed), shade)
    dirt = smooth(.4, 1.8, streaks(SIZE, seed + 3, "y", .15, .9))
    image = mix(image, (.20, .13, .08), .5 * dirt)
    rusty = smooth(1.2, 2.2, cloud(SIZE, seed + 4, 1.3, 3))
    return mix(image, (.26, .115, .05), .6 * rusty)


def painted(colour, seed):
    """Painted steel with worn edges of paint showing."""
    image = worn(SMALL, colour, seed, .02, .035)
    chip = smooth(2.1, 2.6, cloud(SMALL, seed + 2, 1.3, 2))
    return mix(image, (.34, .33, .31), .7 * chip)


def tread(colour, seed):
    """Chequer plate: raised lozenges in alternating directions."""
    x, y = coordinates(SMALL)
    u = x % 32 - 16
    v = y % 32 - 16
    turn = ((x // 32 + y // 32) % 2) > 0
    a = np.where(turn, u + v, u - v) / np.sqrt(2)
    b = np.where(turn, u - v, u + v) / np.sqrt(2)
    height = smooth(0, .25, 1 - (a / 11) ** 2 - (b / 3.2) ** 2)
    image = worn(SMALL, colour, seed)
    return times(times(image, emboss(height, .35)), 1 + .18 * height)


def grate(seed):
    """Dark floor grating: bars over depth."""
    x, y = coordinates(SMALL)
    bars = np.maximum(seam(x, 16, 5), seam(y, 32, 5))
    image = worn(SMALL, (.025, .026, .028), seed)
    return mix(image, times(canvas(SMALL, (.30, .30, .29)), 1 + .1 * cloud(SMALL, seed, .6, 4)),
               bars)


def hazard(seed):
    """Yellow and black diagonal stripes."""
    x, y = coordinates(SMALL)
    stripe = smooth(-1, 1, 16 * np.sign(((x + y) % 64) - 32))
    image = mix(canvas(SMALL, (.035, .035, .035)), (.62, .42, .03), stripe)
    wear = smooth(.9, 1.9, cloud(SMALL, seed, 1.1, 4))
    return mix(image, (.25, .24, .22), .55 * wear)


def shutter(colour, seed):
    """A roller door: horizontal slats of 16 pixels."""
    x, y = coordinates(SIZE)
    phase = (y % 16) / 16
    shade = .72 + .45 * np.sin(np.pi * phase) - .3 * seam(y, 16, 2)
    image = times(worn(SIZE, colour, seed), shade)
    dirt = smooth(.7, 2, streaks(SIZE, seed + 1, "y", .2, 1.0))
    return mix(image, (.14, .12, .10), .3 * dirt)


def rust(seed):
    image = worn(SMALL, (.24, .11, .055), seed, .10, .14)
    spot = smooth(.3, 1.2, cloud(SMALL, seed + 3, 1.2, 3))
    image = mix(image, (.36, .17, .06), .5 * spot)
    return times(image, emboss(cloud(SMALL, seed + 4, .8, 6), .08))


def console(seed):
    """An instrument panel with dials, keys and labels."""
    image = worn(SMALL, (.13, .145, .15), seed, .01, .01)
    rng = np.random.default_rng(seed)
    image = times(image, emboss(bevel(SMALL, 3, 3, 125, 125, 3), .3))
    for i in range(6):
        for j in range(3):
            colour = rng.choice([(.5, .5, .48), (.5, .09, .05), (.1, .38, .14), (.45, .33, .05)])
            x0, y0 = 10 + 19 * i, 72 + 17 * j
            image = mix(image, colour, rectangle(SMALL, x0, y0, x0 + 13, y0 + 10))
    for i in range(3):
        dial = rivets(SMALL, [(26 + 38 * i, 36)], 15)
        image = mix(image, (.60, .60, .55), (dial > 0) * 1.0)
        needle = rectangle(SMALL, 25 + 38 * i, 24, 27 + 38 * i, 38)
        image = mix(image, (.4, .04, .03), needle)
    return image


def locker(seed):
    """Two steel cabinet doors with louvres and handles."""
    image = worn(SIZE, (.17, .25, .27), seed, .015, .03)
    height = bevel(SIZE, 3, 3, 125, 253, 3) + bevel(SIZE, 131, 3, 253, 253, 3)
    image = times(image, emboss(height, .4))
    x, y = coordinates(SIZE)
    for x0 in (30, 158):
        vent = seam(y - 24, 10, 3.5) * rectangle(SIZE, x0, 18, x0 + 68, 62)
        image = times(image, 1 - .75 * vent)
        image = mix(image, (.5, .5, .5), rectangle(SIZE, x0 + 74, 118, x0 + 80, 146))
        image = mix(image, (.62, .60, .5), rectangle(SIZE, x0 + 18, 76, x0 + 50, 92))
    return image


def door(colour, seed):
    """One steel door leaf, meant to be stretched over it."""
    image = worn(SIZE, colour, seed, .015, .03)
    height = bevel(SIZE, 4, 4, 252, 252, 4) - .8 * bevel(SIZE, 30, 24, 226, 112, 4)
    height -= .8 * bevel(SIZE, 30, 140, 226, 232, 4)
    image = times(image, emboss(height, .35))
    stripes = smooth(-1, 1, 16 * np.sign((np.add(*coordinates(SIZE)) % 48) - 24))
    band = rectangle(SIZE, 8, 118, 248, 134)
    image = mix(image, (.035, .035, .035), band)
    image = mix(image, (.60, .42, .03), band * stripes)
    return write_text(image, "VIGIL", (96, 60), 22, (.5, .52, .5))
