# SPDX-License-Identifier: GPL-2.0-or-later
"""Guards and medicine for a level that has none: its entity text with some more, as NAME.ent, which the engine takes in
place of the level's own. They stand along the level's camera route, on the floor below it.
"""
import re
import struct
from pathlib import Path

APART = 260.0  # map units between two places
FROM_START = 420.0  # and before the first
MOST = 12


def entity_text(level: Path) -> str:
    content = level.read_bytes()
    first, length = struct.unpack_from("<2i", content, 8)
    return content[first:first + length].split(b"\0")[0].decode("latin-1")


def places(route: Path) -> list[tuple[float, float, float]]:
    """Points of the route, far enough from one another."""
    rows = [tuple(float(part) for part in line.split()[1:4]) for line in route.read_text().split("\n")
            if line.strip() and not line.startswith("#") and len(line.split()) >= 7]
    chosen: list[tuple[float, float, float]] = []
    for row in rows:
        def far(other: tuple[float, float, float], least: float, row: tuple[float, ...] = row) -> bool:
            return sum((a - b) ** 2 for a, b in zip(row, other)) >= least * least
        if far(rows[0], FROM_START) and all(far(other, APART) for other in chosen):
            chosen.append(row)  # type: ignore[arg-type]
    return chosen[:MOST]


def write_entities(maps: Path, routes: Path, target: Path) -> None:
    target.mkdir(parents=True, exist_ok=True)
    for route in sorted(routes.glob("*.route")):
        level = maps / f"{route.stem}.bsp"
        if not level.exists() or route.stem.startswith("many_"):
            continue
        text = entity_text(level).rstrip()
        for number, (x, y, z) in enumerate(places(route)):
            kind = ("monster_soldier_light", "item_health", "monster_soldier")[number % 3]
            text += f'\n{{\n"classname" "{kind}"\n"origin" "{x:.0f} {y:.0f} {z - 12:.0f}"\n"angle" "{90 * number % 360}"\n}}'
        assert re.search("info_player_start", text)
        (target / f"{route.stem}.ent").write_text(text + "\n", encoding="latin-1")
