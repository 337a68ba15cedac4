#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Compares the times of passes in two builds: flights by one and by the other in turns, on one machine.

    python3 tools/report/passes.py OLD/vigil NEW/vigil [--turns 6] [--level warehouse] [--set NAME=VALUE ...]

Prints a table: for each pass the median over turns of NEW's median time over OLD's, and between which values the turns lie. With six
turns, the typical ratio lies between the least and the greatest of them in 97 of 100 tables (sign test)."""

import argparse
import json
import statistics
import subprocess
import tempfile
from pathlib import Path


def fly(program, level, settings):
    """Pass -> its median milliseconds in a flight of about 100 frames at 320 x 180."""
    with tempfile.TemporaryDirectory() as folder:
        words = [str(Path(program).resolve()), "+set", "vid_driver", "headless", "+set", "outdir", folder]
        for name, value in (setting.split("=", 1) for setting in settings):
            words += ["+set", name, value]
        words += ["+set", "timedemo_json", "flight.json", "+map", level, "+fly", level, "5", "+quit"]
        subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
        report = json.loads((Path(folder) / "flight.json").read_text())
    times = {row["name"]: row["median_ms"] for row in report["passes"] + report["groups"]}
    return report, times


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("--turns", type=int, default=6)
    parser.add_argument("--level", default="warehouse")
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE")
    options = parser.parse_args()
    settings = ["vid_width=320", "vid_height=180", *options.set]
    turns = []
    for turn in range(options.turns):
        order = [options.old, options.new]
        flights = {program: fly(program, options.level, settings) for program in (order if turn % 2 == 0 else order[::-1])}
        turns.append((flights[options.old], flights[options.new]))
    (old, old_times), (new, new_times) = turns[0]
    print(f"`{options.level}`, {' '.join(options.set) or 'defaults'}: {new['commit']} against {old['commit']}, "
          f"{options.turns} turns, {new['width']} x {new['height']}, {new['device']}.\n")
    print("| pass | ms before | ms after | ratio | turns |\n|---|---|---|---|---|")
    for name in new_times:
        if name not in old_times:
            continue
        ratios = [after[1][name] / before[1][name] for before, after in turns]
        before, after = (statistics.median(turn[side][1][name] for turn in turns) for side in (0, 1))
        print(f"| {name} | {before:.3f} | {after:.3f} | {statistics.median(ratios):.3f} | {min(ratios):.3f} to {max(ratios):.3f} |")


if __name__ == "__main__":
    main()
