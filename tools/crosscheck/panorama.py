# SPDX-License-Identifier: GPL-2.0-or-later
"""Sky and sun as one panorama in the layout of Mitsuba's `envmap`: the exported picture, or a flat sky, resampled, with
the sun's disc drawn into it. Directions are in glTF's axes (y up)."""

import numpy as np

WIDTH, HEIGHT = 2048, 1025
SUBSAMPLES = 4  # per side of a pixel that the sun's edge may cross


def directions(u, v):
    """Directions that Vigil's panorama shows at (u, v): the middle is +x, the right half +z, v = 0 up."""
    yaw, polar = 2 * np.pi * (u - 0.5), np.pi * v
    return np.stack([np.sin(polar) * np.cos(yaw), np.cos(polar), np.sin(polar) * np.sin(yaw)], -1)


def resample(picture, u, v):
    """Bilinear; the columns of `picture` wrap, its texels lie at pixel centres."""
    height, width = picture.shape[:2]
    x, y = u * width - 0.5, np.clip(v * height - 0.5, 0, height - 1)
    x0, y0 = np.floor(x).astype(int), np.floor(y).astype(int)
    fx, fy = (x - x0)[..., None], (y - y0)[..., None]
    x0, x1, y1 = x0 % width, (x0 + 1) % width, np.minimum(y0 + 1, height - 1)
    return ((1 - fy) * ((1 - fx) * picture[y0, x0] + fx * picture[y0, x1]) +
            fy * ((1 - fx) * picture[y1, x0] + fx * picture[y1, x1]))


def make(scene, picture, sun=True):
    """(HEIGHT, WIDTH, 3) radiance; rows at v = row / (HEIGHT - 1), as `envmap` has them, columns at their centres."""
    row, column = np.mgrid[0:HEIGHT, 0:WIDTH].astype(float)
    u, v = (column + 0.5) / WIDTH, row / (HEIGHT - 1)
    if picture is not None:
        sky = resample(picture, u, v)
    else:
        flat = scene.sky_radiance if scene.sky_radiance is not None else np.zeros(3)
        sky = np.broadcast_to(flat, (HEIGHT, WIDTH, 3)).copy()
    if not sun or scene.sun_irradiance is None:
        return sky
    if not scene.sun_diameter > 0:
        raise ValueError("a panorama cannot show a sun without extent")
    # A disc of half angle a and radiance L lights a surface that faces it with pi sin(a)^2 L.
    half = np.radians(scene.sun_diameter / 2)
    radiance = scene.sun_irradiance / (np.pi * np.sin(half)**2)
    cover = np.zeros((HEIGHT, WIDTH))
    near = directions(u, v) @ scene.sun_direction > np.cos(half + 0.02)
    offsets = (np.arange(SUBSAMPLES) + 0.5) / SUBSAMPLES - 0.5
    for dx in offsets:
        for dy in offsets:
            there = directions(u[near] + dx / WIDTH, np.clip(v[near] + dy / (HEIGHT - 1), 0, 1))
            cover[near] += (there @ scene.sun_direction > np.cos(half)) / SUBSAMPLES**2
    return sky + cover[..., None] * radiance
