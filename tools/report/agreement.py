#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Tells whether two reports of `run bench quality` with different seeds agree within their intervals.

    python3 tools/report/agreement.py out/quality.json out/quality_again.json

For every part, row and measure: the difference of the two logarithms over the root of the sum of the squared half widths of
their intervals. Where that is at most 1, a 95% interval of the difference holds 0. Lists the others; the exit status is 1 where
they are more than 5% by more than chance would have it (binomial, 1%)."""

import math
import sys

from scipy import stats

import drawing

MEASURES = ("mse", "trimmed_mse", "relative_mse")


def logarithms(interval):
    """Value and half width on a logarithmic scale, or None without an interval of positive numbers."""
    value, low, high = (interval[key] for key in ("value", "low", "high"))
    if None in (value, low, high) or value <= 0 or high <= value:
        return None
    # An interval that reaches below zero is as wide as its upper half says.
    half = math.log(high / value)
    return math.log(value), max(half, math.log(value / low)) if low > 0 else half


def compare(first, second):
    """Yields a name and the distance in half widths, of all that both reports have."""
    others = {part["part"]: {row["label"]: row for row in part["rows"]} for part in second["parts"]}
    for part in first["parts"]:
        for row in part["rows"]:
            other = others.get(part["part"], {}).get(row["label"])
            for measure in MEASURES if other else ():
                pair = logarithms(row[measure]), logarithms(other[measure])
                if None not in pair:
                    (a, half_a), (b, half_b) = pair
                    yield f"{part['part']}, {row['label']}, {measure}", abs(a - b) / math.hypot(half_a, half_b)


def main(paths):
    if len(paths) != 2:
        sys.exit(__doc__)
    try:
        reports = [drawing.load(path, "quality") for path in paths]
    except (OSError, ValueError) as fault:
        sys.exit(str(fault))
    seeds = [set(range(report["first_seed"], report["first_seed"] + report["seeds"])) for report in reports]
    if seeds[0] & seeds[1]:
        sys.exit("the two reports share seeds: they are not independent")
    distances = list(compare(*reports))
    if not distances:
        sys.exit("the two reports have nothing in common")
    apart = [(name, distance) for name, distance in distances if distance > 1]
    for name, distance in sorted(apart, key=lambda item: -item[1]):
        print(f"  {name}: {distance:.2f} half widths apart")
    chance = stats.binomtest(len(apart), len(distances), 0.05, alternative="greater").pvalue
    print(f"{len(distances) - len(apart)} of {len(distances)} agree within their 95% intervals (chance of so few or fewer: {chance:.2g})")
    sys.exit(int(chance < 0.01))  # sys.exit would print a truth value of numpy


if __name__ == "__main__":
    main(sys.argv[1:])
