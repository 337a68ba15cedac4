#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The tables of docs/research/techniques.md, from docs/results/levels.json: `run bench quality` of many levels.

    python3 tools/report/levels.py join REPORT.json [MORE.json ...]    # puts these levels into levels.json: what the tables need
    python3 tools/report/levels.py                                     # writes the tables into the page
    python3 tools/report/levels.py --check                             # writes nothing; exits with 1 if the page has others
"""

import json
import sys
from pathlib import Path

import rivals
import tables

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "docs"))
from quoted_numbers import TABLE  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
REPORT = ROOT / "docs/results/levels.json"
PAGE = ROOT / "docs/research/techniques.md"

KEPT = ("measured", "device", "intervals", "finished", "width", "height", "seeds", "first_seed", "warmup", "trimmed_share")
KEPT_OF_PARTS = ("commit", "part", "level", "baseline", "frames", "reference", "reference_paths", "triangles", "lights", "views")
KEPT_OF_ROWS = ("label", "variables", "misses_light", "mse", "trimmed_mse", "relative_mse", "mean_ratio", "path_ms", "frame_ms")
ROWS = ("sll", "sll_64", "sll_256", "shipped", "lh", "ris", "cut", "paper", "vlc", "vlc+cdq")  # columns, from left
RIVALS = ("sll", "sll_64", "sll_256", "shipped", "lh", "ris", "paper")  # of vlc


def kept(value, keys):
    return {key: tables.rounded(value[key]) for key in keys if key in value}


def join(joined, report):
    """Puts the parts of a finished report into one that join() made, or into None: in place of those of the same name. Presets have their names alone.
    Raises ValueError where a row is missing, or where the two were not measured alike."""
    if not report["finished"]:
        raise ValueError("a report is not finished")
    head = kept(report, KEPT)
    parts = {}
    if joined is not None:
        parts = {part["part"]: part for part in joined["parts"]}
        for key, value in head.items():
            if joined.get(key) != value:
                raise ValueError(f"{key} is {value}, and {joined.get(key)} in {REPORT}")
    for part in report["parts"]:
        rows = {row["label"].removeprefix("preset "): kept(row, KEPT_OF_ROWS) for row in part["rows"]}
        missing = [label for label in ROWS if label not in rows]
        if missing:
            raise ValueError(f"{part['part']}: no row {', '.join(missing)}")
        parts[part["part"]] = {"commit": report["commit"]} | kept(part, KEPT_OF_PARTS) | {"rows": [rows[label] | {"label": label} for label in ROWS]}
    return head | {"parts": list(parts.values())}


def over_baseline(head, lines, baseline):
    """A table of tables.py without the baseline's column of ones, names as code."""
    place = head.index(baseline)
    return [[name if column == 0 else f"`{name}`" for column, name in enumerate(head) if column != place],
            *([text if column or " " in text else f"`{text}`" for column, text in enumerate(line) if column != place] for line in lines)]


def page_tables(report):
    """Table by its name in the page."""
    typical = {head[0]: (head, lines) for head, lines in tables.typical_quality(report)}
    baseline = report["parts"][0]["baseline"]
    commits = {}
    for part in report["parts"]:
        commits.setdefault(part["commit"][:7], []).append(f"`{part['part']}`")
    found = {name: over_baseline(*typical[title], baseline) for name, title in (
        ("levels-trimmed", "Trimmed MSE at equal time"), ("levels-plain", "MSE at equal time"), ("levels-frame", "Time of a frame"))}
    for name, row, others, measures in (("levels-rivals", "vlc", RIVALS, rivals.AT_EQUAL_TIME),
                                        ("levels-guided", "vlc+cdq", ("vlc",), (*rivals.AT_EQUAL_TIME, ("Path tracing", ("path_ms",))))):
        head, lines = rivals.table(report["parts"], row, others, measures)
        found[name] = [head, *lines]
    found["levels-commits"] = [["commit", "levels"], *([commit, ", ".join(levels)] for commit, levels in commits.items())]
    return {name: tables.markdown_table(head, lines) + "\n" for name, (head, *lines) in found.items()}


def fill(text, found):
    """The page with those of the tables that it names. Raises ValueError where there is none."""
    if found.keys().isdisjoint(match["name"] for match in TABLE.finditer(text)):
        raise ValueError(f"no table {', '.join(found)}")
    return TABLE.sub(lambda match: match[0].replace(match["lines"], found.get(match["name"], match["lines"])), text)


def main(arguments):
    if arguments[:1] == ["join"] and len(arguments) > 1:
        try:
            joined = tables.load(REPORT, "quality") if REPORT.exists() else None
            for path in arguments[1:]:
                joined = join(joined, tables.load(path, "quality"))
        except (OSError, ValueError) as fault:
            sys.exit(str(fault))
        REPORT.write_text(json.dumps(joined, separators=(",", ":")) + "\n")
        print(f"wrote {REPORT}: {len(joined['parts'])} levels")
        return 0
    if arguments not in ([], ["--check"]):
        sys.exit(__doc__)
    text = PAGE.read_text()
    try:
        filled = fill(text, page_tables(tables.load(REPORT, "quality")))
    except (OSError, ValueError) as fault:
        sys.exit(f"{PAGE}: {fault}")
    if arguments:
        print("the page has the report's tables" if filled == text else f"{PAGE}: its tables are not those of {REPORT}; run tools/report/levels.py")
        return int(filled != text)
    PAGE.write_text(filled)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
