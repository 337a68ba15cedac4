#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Folders are floors: a file includes files of its own folder and of floors below, and none in a circle.

floors_test.py FOLDER: walks every #include "..." of src and shaders; exits with 1 and one line for each
that goes up, stands in a circle, or names no file.
"""
import re
import sys
from pathlib import Path

# From the ground up; folders of one line do not know one another.
FLOORS = [
    ["shaders/shared"],
    ["shaders/trace"],
    ["shaders/scene"],
    ["shaders/guiding"],
    ["shaders/light"],
    ["shaders/pathtrace"],
    ["shaders/debug"],
    ["shaders/post"],
    ["shaders/filter"],
    ["src/common"],
    ["src/formats"],
    ["src/level"],
    ["src/refresh"],
    ["src/third_party", "src/refresh/vkpt/gpu", "src/refresh/preview", "src/console", "src/platform", "src/game"],
    ["src/refresh/vkpt/scene", "src/client/measure"],
    ["src/refresh/vkpt/light", "src/refresh/vkpt/guiding", "src/client/play"],
    ["src/refresh/vkpt/pathtrace", "src/client/demo", "src/client/ui"],
    ["src/refresh/vkpt/filter", "src/refresh/vkpt/post", "src/refresh/vkpt/debug", "src/refresh/vkpt/export"],
    ["src/refresh/vkpt", "src/client"],
    ["src/bench", "src/yamagi"],
    ["src"],
]
HEIGHT = {folder: height for height, floor in enumerate(FLOORS) for folder in floor}
PART_OF = {"src/game/actors": "src/game"}  # one floor in two folders
MADE = re.compile(r"^(shaders/\w+_(shaders|rows)\.inc|selected_\w+\.glsl)$")  # in the build folder
# Two wings over the contract (src/refresh): the renderer, and the front ends, ours with the game. Neither knows the other.
WINGS = [["src/refresh/vkpt"], ["src/console", "src/platform", "src/game", "src/client", "src/yamagi"]]


def floor_of(path: str) -> str:
    folder = path.rsplit("/", 1)[0]
    return PART_OF.get(folder, folder)


def wing_of(folder: str) -> int | None:
    return next((wing for wing, tops in enumerate(WINGS) if any(f"{folder}/".startswith(f"{top}/") for top in tops)), None)


def faults(root: Path) -> list[str]:
    found = []
    edges: dict[str, list[str]] = {}
    for top in ("src", "shaders"):
        for file in sorted((root / top).rglob("*")):
            if file.suffix not in {".h", ".cpp", ".glsl", ".comp"}:
                continue
            name = file.relative_to(root).as_posix()
            edges[name] = []
            if floor_of(name) not in HEIGHT:
                found.append(f"{name}: its folder stands on no floor")
                continue
            for included in re.findall(r'^\s*#include "([^"]+)"', file.read_text(errors="replace"), re.M):
                beside = (file.parent / included).resolve().relative_to(root) if (file.parent / included).exists() else None
                target = next((path for path in (beside and beside.as_posix(), f"src/{included}", f"shaders/{included}")
                               if path and (root / path).exists()), None)
                if target is None:
                    if not MADE.match(included):
                        found.append(f'{name}: "{included}" is no file')
                    continue
                edges[name].append(target)
                if floor_of(target) not in HEIGHT:
                    continue
                here, there = floor_of(name), floor_of(target)
                if here != there and HEIGHT[there] >= HEIGHT[here]:
                    found.append(f"{name}: includes {target}, which is not below it")
                elif None not in (wing_of(here), wing_of(there)) and wing_of(here) != wing_of(there):
                    found.append(f"{name}: includes {target}; renderer and front end do not know each other")
    found += circles(edges)
    return found


def circles(edges: dict[str, list[str]]) -> list[str]:
    found, finished, path = [], set(), []

    def visit(name: str) -> None:
        if name in path:
            found.append("a circle: " + " -> ".join(path[path.index(name):] + [name]))
        elif name not in finished:
            path.append(name)
            for target in edges.get(name, []):
                visit(target)
            path.pop()
            finished.add(name)

    for name in edges:
        visit(name)
    return found


if __name__ == "__main__":
    lines = faults(Path(sys.argv[1]).resolve())
    for line in lines:
        print(line)
    sys.exit(1 if lines else 0)
