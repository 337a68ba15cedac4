# SPDX-License-Identifier: GPL-2.0-or-later
"""Do two renderers converge to the same picture? Compares means over square regions of independent batches, with Welch's
t for each region brought to a normal score, so that few batches do not look like disagreement."""

from dataclasses import dataclass

import numpy as np
from scipy import stats

# A level disagrees if chance alone would do what was seen less than once in this many comparisons.
CHANCE = 1e-4
CERTAIN = 37.0  # the largest normal score that double precision can tell
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])


@dataclass
class Agreement:
    regions: int
    mean_z: float          # times sqrt(regions): a normal score
    max_z: float           # over regions and colours
    max_z_limit: float
    chi2_p: float
    difference: np.ndarray  # of the means over the picture, relative to the first, per colour
    error: np.ndarray       # its standard error
    difference_p: float
    scores: np.ndarray      # (rows, columns) normal scores of luminance

    @property
    def agrees(self):
        return min(self.chi2_p, self.difference_p) > CHANCE and self.max_z < self.max_z_limit


def region_means(pictures, side):
    """(batches, rows, columns, 3) from (batches, height, width, 3); the rest at the right and bottom is cut off."""
    batches, height, width, _ = pictures.shape
    rows, columns = height // side, width // side
    cut = pictures[:, :rows * side, :columns * side]
    return cut.reshape(batches, rows, side, columns, side, 3).mean((2, 4))


def scores(a, b, floor):
    """Normal scores of the differences of two sets of batches (first axis); `floor`: variance that both share and that
    batches do not show (rounding)."""
    va, vb = a.var(0, ddof=1) / len(a), b.var(0, ddof=1) / len(b)
    variance = va + vb + floor
    difference = a.mean(0) - b.mean(0)
    safe = np.where(variance > 0, variance, 1)
    t = difference / np.sqrt(safe)
    # Welch-Satterthwaite; the floor is known exactly and only adds certainty.
    spread = va**2 / (len(a) - 1) + vb**2 / (len(b) - 1)
    freedom = np.where(spread > 0, variance**2 / np.where(spread > 0, spread, 1), np.inf)
    freedom = np.clip(freedom, 1, 1e6)
    z = -np.sign(t) * stats.norm.ppf(stats.t.sf(np.abs(t), freedom))
    certain = np.where(difference == 0, 0.0, np.sign(difference) * CERTAIN)
    return np.where(variance > 0, np.clip(z, -CERTAIN, CERTAIN), certain)


def compare(first, second, side, rounding):
    """`first`, `second`: (batches, height, width, 3); `rounding`: relative standard error of both pictures' numbers that
    no number of samples takes away."""
    a, b = region_means(first, side), region_means(second, side)
    colour_floor = (rounding * b.mean(0))**2
    luminance_floor = (rounding * (b.mean(0) @ LUMINANCE))**2
    z = scores(a @ LUMINANCE, b @ LUMINANCE, luminance_floor)
    colour_z = scores(a, b, colour_floor)
    # Regions that are black on both sides say nothing.
    lit = (a.max((0, 3)) > 0) | (b.max((0, 3)) > 0)
    regions = max(int(lit.sum()), 1)
    tests = 4 * regions
    chi2_p = float(stats.chi2.sf((z[lit]**2).sum(), regions))

    # The whole picture: one number per colour and batch.
    whole_a, whole_b = a.mean((1, 2)), b.mean((1, 2))
    mean = np.maximum(whole_b.mean(0), 1e-30)
    whole_z = scores(whole_a, whole_b, (rounding * mean)**2)
    error = np.sqrt(whole_a.var(0, ddof=1) / len(a) + whole_b.var(0, ddof=1) / len(b))
    return Agreement(regions=regions, mean_z=float(z.sum() / np.sqrt(regions)),
                     max_z=float(max(np.abs(z).max(), np.abs(colour_z).max())),
                     max_z_limit=float(stats.norm.isf(CHANCE / 2 / tests)), chi2_p=chi2_p,
                     difference=whole_a.mean(0) / mean - 1, error=error / mean,
                     difference_p=float(min(1.0, 3 * 2 * stats.norm.sf(np.abs(whole_z).max()))), scores=z)
