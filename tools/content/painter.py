# SPDX-License-Identifier: GPL-2.0-or-later
"""Painting on tileable canvases: noise, lines, panels, shading; all in linear albedo.

A canvas is a (height, width, 3) float array of linear RGB, a mask or height field a (height, width)
array. Everything wraps at the borders. PNG files hold the sRGB encoding.
"""

import numpy as np
from PIL import Image


def canvas(size, colour):
    """A plain canvas; size is (width, height)."""
    return np.tile(np.asarray(colour, float), (size[1], size[0], 1))


def coordinates(size):
    """Pixel centres x, y as (height, width) arrays."""
    return np.meshgrid(np.arange(size[0]) + 0.5, np.arange(size[1]) + 0.5)


def cloud(size, seed, exponent=1.0, low=1.0):
    """Tileable 1/f^exponent noise with mean 0 and deviation 1. Frequencies below low are left
    out, so that no blotch gives the tiling away."""
    rng = np.random.default_rng(seed)
    white = rng.standard_normal((size[1], size[0]))
    fx = np.fft.fftfreq(size[0]) * size[0]
    fy = np.fft.fftfreq(size[1]) * size[1]
    f = np.hypot(*np.meshgrid(fx, fy))
    gain = np.where(f < low, 0.0, 1.0 / np.maximum(f, 1.0) ** exponent)
    out = np.fft.ifft2(np.fft.fft2(white) * gain).real
    return out / out.std()


def streaks(size, seed, along="x", length=0.1, exponent=0.7):
    """Tileable noise drawn out along one axis: wood grain, brushed metal. length is the ratio of
    frequencies along to across."""
    rng = np.random.default_rng(seed)
    white = rng.standard_normal((size[1], size[0]))
    fx, fy = np.meshgrid(np.fft.fftfreq(size[0]) * size[0], np.fft.fftfreq(size[1]) * size[1])
    if along == "x":
        f = np.hypot(fx / length, fy)
    else:
        f = np.hypot(fx, fy / length)
    gain = np.where(f < 1, 0.0, 1.0 / np.maximum(f, 1.0) ** exponent)
    out = np.fft.ifft2(np.fft.fft2(white) * gain).real
    return out / out.std()


def cells(size, count, seed):
    """Tileable Worley cells of count random points; returns what nearest() does."""
    return nearest(size, np.random.default_rng(seed).random((count, 2)) * size)


def nearest(size, points):
    """Distance to the nearest and second nearest point (pixels, wrapping) and the nearest one's
    index, as (height, width) arrays."""
    x, y = coordinates(size)
    first = np.full(x.shape, np.inf)
    second = first.copy()
    index = np.zeros(x.shape, int)
    for i, (px, py) in enumerate(points):
        dx = np.abs(x - px)
        dy = np.abs(y - py)
        d = np.hypot(np.minimum(dx, size[0] - dx), np.minimum(dy, size[1] - dy))
        nearer = d < first
        second = np.where(nearer, first, np.minimum(second, d))
        index = np.where(nearer, i, index)
        first = np.minimum(first, d)
    return first, second, index


def emboss(height, strength):
    """Shading factor (1 = flat) of a height field lit from the upper left."""
    slope = (height - np.roll(height, 1, axis=1)) + (height - np.roll(height, 1, axis=0))
    return np.clip(1.0 + strength * slope, 0.35, 1.6)


def times(image, factor):
    """Multiplies all channels by a (height, width) factor."""
    return image * np.asarray(factor)[..., None]


def mix(image, colour, mask):
    """Blends towards a colour or a canvas where mask is 1."""
    return image + (np.asarray(colour, float) - image) * np.clip(mask, 0, 1)[..., None]


def smooth(edge0, edge1, x):
    t = np.clip((x - edge0) / (edge1 - edge0), 0, 1)
    return t * t * (3 - 2 * t)


def seam(position, period, width):
    """1 on lines of the given width (pixels) at multiples of period, else 0; one axis."""
    d = np.abs((position + period / 2) % period - period / 2)
    return 1.0 - smooth(width / 2 - 0.5, width / 2 + 0.5, d)


def rectangle(size, x0, y0, x1, y1):
    """Mask of a rectangle in pixels."""
    x, y = coordinates(size)
    return ((x >= x0) & (x < x1) & (y >= y0) & (y < y1)).astype(float)


def bevel(size, x0, y0, x1, y1, width):
    """Height field of a raised rectangle whose edge slopes over width pixels."""
    x, y = coordinates(size)
    inside = np.minimum(np.minimum(x - x0, x1 - x), np.minimum(y - y0, y1 - y))
    return np.clip(inside / width, 0, 1)


def rivets(size, centres, radius):
    """Height field of round heads at centres (pixels), wrapping."""
    x, y = coordinates(size)
    out = np.zeros(x.shape)
    for px, py in centres:
        dx, dy = np.abs(x - px), np.abs(y - py)
        d = np.hypot(np.minimum(dx, size[0] - dx), np.minimum(dy, size[1] - dy))
        out = np.maximum(out, np.sqrt(np.clip(1 - (d / radius) ** 2, 0, 1)))
    return out


def to_srgb(linear):
    """Linear to sRGB encoding, both 0..1."""
    c = np.clip(linear, 0, 1)
    return np.where(c <= 0.0031308, 12.92 * c, 1.055 * c ** (1 / 2.4) - 0.055)


def to_linear(srgb):
    """sRGB encoding to linear, both 0..1."""
    c = np.asarray(srgb, float)
    return np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)


def save(image, path, colours=0):
    """Writes a PNG; colours > 0 reduces it to a palette of that many entries."""
    picture = Image.fromarray((to_srgb(image) * 255 + 0.5).astype(np.uint8), "RGB")
    if colours:
        picture = picture.quantize(colours, method=Image.Quantize.MEDIANCUT,
                                   dither=Image.Dither.NONE)
    picture.save(path, optimize=True)
