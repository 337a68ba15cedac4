# SPDX-License-Identifier: GPL-2.0-or-later
"""Painters of pictures: the gallery's paintings, signs, a rug, water and glass."""

import numpy as np

from painter import canvas, cloud, coordinates, mix, rectangle, smooth, streaks, times
from wood import write_text

# Paintings are painted in units of two pixels.
WIDE = (384, 256)
SQUARE = (256, 256)


def halves(size):
    """Pixel centres in a painting's units."""
    x, y = coordinates(size)
    return x / 2, y / 2


def block(size, x0, y0, x1, y1):
    """Mask of a rectangle in a painting's units."""
    return rectangle(size, 2 * x0, 2 * y0, 2 * x1, 2 * y1)


def water(seed):
    size = (128, 128)
    ripple = cloud(size, seed, 1.5, 2)
    image = times(canvas(size, (.10, .22, .24)), 1 + .10 * ripple)
    return mix(image, (.35, .5, .5), .35 * smooth(1.2, 2.4, np.abs(ripple)))


def glass():
    size = (32, 32)
    x, y = coordinates(size)
    image = canvas(size, (.62, .72, .70))
    return times(image, 1 + .05 * np.cos(2 * np.pi * (x + y) / 32))


def varnish(image, seed):
    """Brush strokes and a touch of craquelure over a painting."""
    size = (image.shape[1], image.shape[0])
    return times(image, 1 + .06 * streaks(size, seed, "x", .3, .5) + .03 * cloud(size, seed, .3, 6))


def dunes(seed):
    """A desert at dusk."""
    x, y = halves(WIDE)
    image = canvas(WIDE, (.62, .30, .12))
    image = mix(image, (.09, .13, .30), 1 - smooth(0, 80, y))
    sun = np.hypot(x - 140, y - 52)
    image = mix(image, (.75, .55, .25), 1 - smooth(11, 13, sun))
    for i, (base, colour) in enumerate([(70, (.40, .17, .10)), (88, (.27, .10, .075)),
                                        (106, (.13, .05, .05))]):
        ridge = base + 9 * np.sin(x / (23 + 9 * i) + 2 * i + seed) + 4 * np.sin(x / 11 + i)
        image = mix(image, colour, smooth(-1, 1, y - ridge))
    return varnish(image, seed)


def squares(seed):
    """A geometric composition."""
    image = canvas(WIDE, (.66, .63, .55))
    for x0, y0, x1, y1, colour in [(0, 0, 60, 52, (.55, .06, .04)), (120, 76, 192, 128,
                                   (.06, .11, .42)), (66, 92, 114, 128, (.66, .48, .05)),
                                   (150, 0, 192, 30, (.05, .05, .05))]:
        image = mix(image, colour, block(WIDE, x0, y0, x1, y1))
    for x0, y0, x1, y1 in [(60, 0, 66, 128), (114, 0, 120, 128), (0, 52, 192, 58),
                           (66, 86, 192, 92), (150, 0, 154, 58)]:
        image = mix(image, (.03, .03, .03), block(WIDE, x0, y0, x1, y1))
    return varnish(image, seed)


def sea(seed):
    """Waves under a cloudy sky."""
    x, y = halves(WIDE)
    sky = np.clip(.5 + .25 * streaks(WIDE, seed, "x", .4, 1.3), 0, 1)
    image = mix(canvas(WIDE, (.20, .30, .42)), (.62, .60, .54), sky)
    depth = smooth(60, 128, y)
    swell = streaks(WIDE, seed + 1, "x", .22, 1.0) + .5 * np.sin(y / 5 + x / 37)
    tone = mix(canvas(WIDE, (.05, .14, .19)), (.12, .27, .30), smooth(-.5, 1, swell))
    tone = mix(tone, (.48, .56, .54), smooth(1.2, 1.9, swell) * (.3 + .7 * depth))
    image = np.where((y > 60)[..., None], tone, image)
    sail = (y > 40) & (y < 66) & (np.abs(x - 58) < (y - 40) * .35)
    image = mix(image, (.68, .64, .55), sail * 1.0)
    return varnish(image, seed)


def rings(seed):
    """Concentric rings around two centres."""
    x, y = halves(SQUARE)
    a = np.hypot(x - 40, y - 48)
    b = np.hypot(x - 92, y - 84)
    image = canvas(SQUARE, (.07, .08, .12))
    image = mix(image, (.58, .22, .05), smooth(-.2, .2, np.sin(a / 3.4)) * (a < 60))
    image = mix(image, (.10, .36, .38), smooth(-.2, .2, np.sin(b / 2.6)) * (b < 42))
    return varnish(image, seed)


def trees(seed):
    """Birches in fog."""
    rng = np.random.default_rng(seed)
    x, y = halves(SQUARE)
    image = mix(canvas(SQUARE, (.42, .46, .42)), (.20, .25, .17), smooth(90, 118, y))
    for i in range(13):
        near = i / 12
        at = rng.uniform(0, 128) + 4 * np.sin(y / 40 + i)
        width = 1.5 + 4.5 * near
        trunk = (1 - smooth(width - 1, width, np.abs(x - at))) * (y < 96 + 26 * near)
        image = mix(image, np.array((.5, .5, .46)) * (1 - .5 * near) + .12 * near, trunk)
        bark = (cloud(SQUARE, seed + i, .5, 10) > 1.1) * trunk
        image = mix(image, (.05, .05, .04), bark * near)
    return varnish(image, seed)


def field(seed):
    """Two soft fields of colour."""
    x, y = halves(SQUARE)
    image = canvas(SQUARE, (.20, .03, .03))
    wobble = 2 * cloud(SQUARE, seed, 1.2, 2)
    for y0, y1, colour in [(10, 66, (.60, .14, .03)), (74, 116, (.60, .38, .06))]:
        inside = np.minimum(np.minimum(x - 10, 118 - x), np.minimum(y - y0, y1 - y)) + wobble
        image = mix(image, colour, smooth(-2, 5, inside))
    return varnish(image, seed)


def sign(glyph, colour):
    """A wall sign, 64 x 64."""
    size = (64, 64)
    image = mix(canvas(size, colour), (.6, .6, .58), 1 - rectangle(size, 3, 3, 61, 61))
    if glyph != "arrow":
        return write_text(image, glyph, (20, 14), 36, (.66, .66, .64))
    x, y = coordinates(size)
    shaft = rectangle(size, 12, 27, 36, 37)
    head = (x >= 34) & (x < 54) & (np.abs(y - 32) < (54 - x) * .85)
    return mix(image, (.66, .66, .64), np.maximum(shaft, head))


def rug(seed):
    """A knotted rug with borders and a row of medallions, 256 x 128."""
    size = (256, 128)
    x, y = coordinates(size)
    image = canvas(size, (.30, .045, .035))
    edge = np.minimum(np.minimum(x, 256 - x), np.minimum(y, 128 - y))
    for inner, outer, colour in ((0, 4, (.45, .36, .24)), (6, 16, (.05, .065, .13)),
                                 (18, 20, (.46, .34, .15))):
        image = mix(image, colour, ((edge >= inner) & (edge < outer)) * 1.0)
    knots = ((x + y) % 12 < 4) & (edge >= 8) & (edge < 14)
    image = mix(image, (.42, .26, .09), knots * 1.0)
    for middle in (66, 128, 190):
        r = np.abs(x - middle) + np.abs(y - 64)
        image = mix(image, (.06, .08, .15), (r < 30) * 1.0)
        image = mix(image, (.46, .34, .15), ((r < 25) & (r > 21)) * 1.0)
        image = mix(image, (.36, .09, .05), (r < 15) * 1.0)
    knot = .06 * cloud(size, seed, .2, 16) + .05 * streaks(size, seed + 1, "x", .1, .8)
    return times(image, 1 + knot)
