# SPDX-License-Identifier: GPL-2.0-or-later
"""A sky box painter: six pictures env/NAME{rt,bk,lf,ft,up,dn}.png from one function of direction.

Sides follow Quake II: rt looks to +x, bk to +y, lf to -x, ft to -y; the upper edge of up is
towards -x. The pictures hold no sun disc: the sun is the level's _sun_* keys.
"""

import numpy as np

from painter import save

# Yaw and pitch in which the light of the evening sun travels (sky `evening`).
EVENING_SUN = (50, -19)

# Direction of a pixel from s (right), t (up), both -1..1.
SIDES = {
    "rt": lambda s, t: (1 + 0 * s, -s, t),
    "bk": lambda s, t: (s, 1 + 0 * s, t),
    "lf": lambda s, t: (-1 + 0 * s, s, t),
    "ft": lambda s, t: (-s, -1 + 0 * s, t),
    "up": lambda s, t: (-t, -s, 1 + 0 * s),
    "dn": lambda s, t: (t, -s, -1 + 0 * s),
}


def write_sky(folder, name, size, radiance):
    """Paints all sides; radiance maps (n, 3) unit directions to linear RGB below 1."""
    folder.mkdir(parents=True, exist_ok=True)
    c = 2 * (np.arange(size) + 0.5) / size - 1
    s, t = np.meshgrid(c, -c)
    for side, direction in SIDES.items():
        d = np.stack(direction(s, t), axis=-1)
        d /= np.linalg.norm(d, axis=-1, keepdims=True)
        save(radiance(d.reshape(-1, 3)).reshape(size, size, 3), folder / (name + side + ".png"),
             256)


def waves(d, seed, octaves):
    """Smooth noise over directions: a sum of plane waves, deviation about 1."""
    rng = np.random.default_rng(seed)
    out = np.zeros(len(d))
    norm = 0
    for octave in range(octaves):
        gain = 0.55 ** octave
        for _ in range(7):
            k = rng.standard_normal(3)
            k *= 2.6 * 2 ** octave / np.linalg.norm(k)
            out += gain * np.sin(d @ k + rng.uniform(0, 6.28))
            norm += gain ** 2 / 2
    return out / np.sqrt(norm)


def sun_direction(yaw, pitch):
    """Unit vector towards the sun, for the mangle (yaw, pitch) in which its light travels."""
    y, p = np.radians(yaw), np.radians(pitch)
    return -np.array([np.cos(p) * np.cos(y), np.cos(p) * np.sin(y), np.sin(p)])


def day(sun, zenith, horizon, ground, cloud, seed, cover):
    """A sky with clouds: colours are linear radiance, cover raises the share of clouds."""
    def radiance(d):
        up = d[:, 2]
        t = np.clip(up, 0, 1) ** 0.45
        sky = (1 - t)[:, None] * horizon + t[:, None] * np.asarray(zenith)
        # Clouds live on a plane above: stretch directions towards the horizon.
        flat = d / np.maximum(up, 0.12)[:, None]
        flat[:, 2] = 0.6
        n = waves(flat, seed, 5)
        mask = np.clip((n + cover) / 1.6, 0, 1) ** 1.3 * np.clip(up / 0.2, 0, 1)
        toward = np.clip(d @ sun, 0, 1)
        lit = np.asarray(cloud) * (0.75 + 0.5 * toward ** 6)[:, None]
        sky = sky + (lit - sky) * mask[:, None]
        sky = sky + (0.35 * toward ** 40)[:, None] * np.array([1.0, .85, .6])
        below = np.clip(-up / 0.06, 0, 1)[:, None]
        return np.clip(sky + (np.asarray(ground) - sky) * below, 0, 1)
    return radiance


def afterglow(toward, zenith, horizon, glow, cloud, seed):
    """The sky after sunset: dark above, a band of warm light over the place where the sun went,
    streaks of cloud that it lights from below. Colours are linear radiance."""
    def radiance(d):
        up = d[:, 2]
        flat = d[:, :2] / np.maximum(np.linalg.norm(d[:, :2], axis=1), 1e-6)[:, None]
        near = np.clip(.5 + .5 * flat @ (toward[:2] / np.linalg.norm(toward[:2])), 0, 1)
        t = np.clip(up, 0, 1) ** .4
        sky = (1 - t)[:, None] * horizon + t[:, None] * np.asarray(zenith)
        band = np.exp(-np.clip(up, 0, 1) / .16) * near ** 3
        sky = sky + band[:, None] * np.asarray(glow)
        plane = d / np.maximum(up, .06)[:, None] * [.35, .35, 0] + [0, 0, .6]
        mask = np.clip((waves(plane, seed, 5) - .1) / 1.5, 0, 1) * np.clip(up / .1, 0, 1)
        lit = np.asarray(cloud) * (.25 + 1.6 * near ** 4 * np.exp(-np.clip(up, 0, 1) / .5))[:, None]
        sky = sky + (lit - sky) * (.7 * mask)[:, None]
        below = np.clip(-up / .03, 0, 1)[:, None]
        return np.clip(sky + (np.asarray(horizon) * .35 - sky) * below, 0, 1)
    return radiance
