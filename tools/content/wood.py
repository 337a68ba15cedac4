# SPDX-License-Identifier: GPL-2.0-or-later
"""Painters of wood and board: planks, beams, parquet, crates, cartons; and stencilled text."""

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from painter import (bevel, canvas, cloud, coordinates, emboss, mix, rectangle, rivets, seam,
                     smooth, streaks, times)

SIZE = (256, 256)
SMALL = (128, 128)


def write_text(image, text, position, height, colour):
    """Writes text in a pixel font, enlarged to the height in pixels; upper left at position."""
    font = ImageFont.load_default()
    width = int(font.getlength(text)) + 1
    small = Image.new("L", (width, 11))
    ImageDraw.Draw(small).text((0, 0), text, font=font, fill=255)
    box = small.getbbox()
    small = small.crop(box)
    size = (max(1, round(small.width * height / small.height)), height)
    mask = np.zeros(image.shape[:2])
    big = np.asarray(small.resize(size, Image.Resampling.NEAREST), float) / 255
    x, y = position
    big = big[:mask.shape[0] - y, :mask.shape[1] - x]
    mask[y:y + big.shape[0], x:x + big.shape[1]] = big
    return mix(image, colour, mask)


def timber(size, colour, seed, along="x"):
    """Wood with grain along an axis."""
    ring = streaks(size, seed, along, .05, .55)
    slow = streaks(size, seed + 1, along, .12, 1.3)
    image = times(canvas(size, colour), 1 + .11 * ring + .12 * slow)
    image[..., 2] *= 1 - .05 * slow
    return image


def planks(colour, boards, seed):
    """Horizontal boards with nails and one butt joint each."""
    x, y = coordinates(SIZE)
    pitch = 256 // boards
    row = (y // pitch).astype(int)
    image = np.zeros((256, 256, 3))
    rng = np.random.default_rng(seed)
    joint = np.zeros((256, 256))
    spots = []
    for i in range(boards):
        board = timber(SIZE, np.array(colour) * rng.normal(1, .10), seed + 7 * i)
        image = np.where((row == i)[..., None], board, image)
        at = int(rng.integers(30, 226))
        joint = np.maximum(joint, rectangle(SIZE, at, i * pitch, at + 2, (i + 1) * pitch))
        spots += [(at + d, i * pitch + j) for d in (-7, 9) for j in (14, pitch - 14)]
    gap = np.maximum(seam(y, pitch, 3), joint)
    image = times(image, 1 - .78 * gap)
    image = times(image, 1 + .16 * seam(y - 2.5, pitch, 1.5))
    return times(image, 1 - .6 * rivets(SIZE, spots, 2))


def beam(colour, seed):
    """A squared timber along u, with drying cracks."""
    image = timber(SMALL, colour, seed)
    crack = smooth(1.7, 2.3, streaks(SMALL, seed + 5, "x", .06, .8))
    return times(image, 1 - .6 * crack)


def parquet(colour, seed):
    """Herringbone-like block floor: squares of four blocks in alternating directions."""
    x, y = coordinates(SIZE)
    turn = ((x // 64 + y // 64) % 2) > 0
    across = np.where(turn, x, y)
    block = ((across % 64) // 16 + 4 * (x // 64) + 16 * (y // 64)).astype(int)
    rng = np.random.default_rng(seed)
    tone = rng.normal(1, .12, 256)[block]
    wood = np.where(turn[..., None], timber(SIZE, colour, seed, "y"),
                    timber(SIZE, colour, seed + 1, "x"))
    gap = np.maximum(seam(across, 16, 1.3), np.maximum(seam(x, 64, 1.3), seam(y, 64, 1.3)))
    return times(times(wood, tone), 1 - .5 * gap)


def crate(colour, seed):
    """One face of a wooden crate: boards behind a frame with a diagonal brace."""
    x, y = coordinates(SIZE)
    image = np.zeros((256, 256, 3))
    rng = np.random.default_rng(seed)
    for i in range(6):
        board = timber(SIZE, np.array(colour) * rng.normal(.86, .06), seed + i, "y")
        image = np.where(((x // 43).astype(int) == i)[..., None], board, image)
    image = times(image, 1 - .6 * seam(x, 43, 3))
    image = write_text(image, "VIGIL", (62, 70), 30, (.10, .07, .05))
    height = np.zeros((256, 256))
    frame = timber(SIZE, colour, seed + 11, "x")
    post = timber(SIZE, colour, seed + 12, "y")
    brace = np.clip((17 - np.abs(x + y - 256) / np.sqrt(2)) / 3, 0, 1)
    image = mix(image, frame, brace)
    height = np.maximum(height, brace)
    for x0, y0, x1, y1, wood in ((0, 0, 256, 34, frame), (0, 222, 256, 256, frame),
                                 (0, 0, 34, 256, post), (222, 0, 256, 256, post)):
        rail = bevel(SIZE, x0, y0, x1, y1, 3)
        image = np.where((rail > 0)[..., None], wood, image)
        height = np.where(rail > 0, np.maximum(rail, .2), height)
    spots = [(i, j) for i in (17, 239) for j in (10, 25, 231, 246)]
    image = times(image, 1 - .55 * rivets(SIZE, spots, 2.5))
    return times(image, emboss(height, .32))


def carton(seed):
    """One face of a cardboard box with tape and a label."""
    image = times(canvas(SMALL, (.38, .26, .15)), 1 + .04 * streaks(SMALL, seed, "y", .1, .5))
    image = times(image, emboss(bevel(SMALL, 0, 0, 128, 128, 3), .2))
    image = mix(image, (.46, .36, .22), rectangle(SMALL, 0, 56, 128, 70) * .8)
    image = mix(image, (.66, .65, .60), rectangle(SMALL, 78, 84, 116, 112))
    for i in range(3):
        image = mix(image, (.12, .12, .12), rectangle(SMALL, 82, 89 + 7 * i, 112 - 6 * i,
                                                      91 + 7 * i))
    tone = 1 + .03 * cloud(SMALL, seed, 1.2, 2)
    return times(image, tone)


def painted(colour, seed):
    """Painted joinery: faint brush strokes along u, a few worn spots."""
    image = times(canvas(SMALL, colour), 1 + .025 * streaks(SMALL, seed, "x", .05, .5))
    worn = smooth(1.8, 2.6, cloud(SMALL, seed + 1, 1.1, 3))
    return mix(image, np.array(colour) * .55, .5 * worn)


def louvre(colour, seed):
    """One leaf of a shutter: slats in a frame."""
    size = (64, 128)
    x, y = coordinates(size)
    phase = (y % 8) / 8
    slats = times(canvas(size, colour), .50 + .75 * phase)
    frame = np.maximum.reduce([1 - rectangle(size, 8, 8, 56, 120), rectangle(size, 8, 60, 56, 68)])
    image = mix(slats, np.array(colour) * 1.1, frame)
    fade = 1 + .10 * streaks(size, seed, "y", .2, .8)
    return times(times(image, emboss(2 * frame, .12)), fade)


def books(seed):
    """Four shelves of book spines, 256 x 256."""
    image = canvas(SIZE, (.03, .02, .015))
    rng = np.random.default_rng(seed)
    leather = [(.26, .07, .045), (.10, .13, .20), (.16, .10, .05), (.10, .15, .085),
               (.36, .25, .12), (.05, .045, .05), (.46, .40, .29)]
    for shelf in range(4):
        foot = 64 * shelf + 58
        at = 1
        while at < 250:
            width = int(rng.integers(6, 15))
            top = foot - int(rng.integers(34, 52))
            colour = np.array(leather[rng.integers(len(leather))]) * rng.uniform(.75, 1.25)
            spine = rectangle(SIZE, at, top, min(at + width, 256), foot)
            x, _ = coordinates(SIZE)
            bulge = 1 - .5 * (2 * np.abs(x - at - width / 2) / width) ** 2
            image = np.where(spine[..., None] > 0, times(canvas(SIZE, colour), bulge), image)
            for band in (6, 10, int(foot - top - 8)):
                line = rectangle(SIZE, at + 1, top + band, at + width - 1, top + band + 1)
                image = mix(image, (.45, .33, .12), .6 * line)
            at += width + (1 if rng.random() < .9 else 7)
    board = seam(coordinates(SIZE)[1] - 61, 64, 6)
    return mix(image, times(canvas(SIZE, (.17, .09, .045)), 1 + .1 * streaks(SIZE, seed, "x")),
               board)
