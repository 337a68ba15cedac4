#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Tells whether two reports of `run bench quality` with different seeds could be of the same program.

    python3 tools/report/agreement.py out/quality.json out/quality_again.json

For every part, row and measure: the rank sum test of the one's runs against the other's, view by view, added up (van Elteren).
It supposes no distribution. Lists those with p below 0.05, of which one in twenty is chance; the exit status is 1 where one
stands out among all (Holm, 5%)."""

import math
import statistics
import sys

import tables

MEASURES = ("mse", "trimmed_mse", "relative_mse", "mean_ratio")


def rank_sum(first, second):
    """The ranks of the first among both, added up, with their mean and variance if both are alike; ties share a rank."""
    both = sorted(first + second)
    size, total = len(first), len(both)
    ranks = sum(both.index(value) + 1 + 0.5 * (both.count(value) - 1) for value in first)
    ties = sum(both.count(value) ** 3 - both.count(value) for value in set(both))
    variance = size * len(second) / 12 * (total + 1 - ties / (total * (total - 1)))
    return ranks, 0.5 * size * (total + 1), variance


def chance(first, second):
    """p of two lists of views, each the values of its runs; None where nothing differs."""
    sums = [rank_sum(a, b) for a, b in zip(first, second)]
    variance = sum(part for _, _, part in sums)
    if variance == 0:
        return None
    distance = abs(sum(ranks - mean for ranks, mean, _ in sums))
    return 2 * statistics.NormalDist().cdf(-max(0, distance - 0.5) / math.sqrt(variance))


def compare(first, second):
    """Yields a name and p, of all that both reports have."""
    others = {part["part"]: {row["label"]: row for row in part["rows"]} for part in second["parts"]}
    for part in first["parts"]:
        for row in part["rows"]:
            other = others.get(part["part"], {}).get(row["label"])
            for measure in MEASURES if other else ():
                pair = [values[measure].get("by_view_and_seed") for values in (row, other)]
                p = None if None in pair else chance(*pair)
                if p is not None:
                    yield f"{part['part']}, {row['label']}, {measure}", p


def main(paths):
    if len(paths) != 2:
        sys.exit(__doc__)
    try:
        reports = [tables.load(path, "quality") for path in paths]
    except (OSError, ValueError) as fault:
        sys.exit(str(fault))
    seeds = [set(range(report["first_seed"], report["first_seed"] + report["seeds"])) for report in reports]
    if seeds[0] & seeds[1]:
        sys.exit("the two reports share seeds: they are not independent")
    chances = dict(compare(*reports))
    if not chances:
        sys.exit("the two reports have no single runs in common")
    for name, p in sorted(chances.items(), key=lambda item: item[1]):
        if p < 0.05:
            print(f"  {name}: p {p:.2g}")
    apart = tables.standing_out(chances)
    print(f"{len(chances)} compared, {sum(p < 0.05 for p in chances.values())} with p below 0.05, {len(apart)} that stand out")
    sys.exit(int(bool(apart)))


if __name__ == "__main__":
    main(sys.argv[1:])
