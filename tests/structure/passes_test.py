#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""A pass, its shader and its row in timing tables have one name: every row of the list of passes has a shader, and every
shader a row, but for what is named here.

passes_test.py FOLDER: exits with 1 and one line for each that has none.
"""
import re
import sys
from pathlib import Path

WITHOUT_SHADER = {"upload", "overlay", "present"}  # copies, and a graphics pipeline of a library
WITHOUT_PASS = {"light_floor", "trace_rays"}  # of measurements


def faults(root: Path) -> list[str]:
    table = (root / "src/refresh/vkpt/gpu/passes.h").read_text()
    passes = set(re.findall(r'^    ROW\(\w+, "(\w+)"', table, re.M)) - WITHOUT_SHADER
    if not passes:
        return ["passes.h: no rows of passes are found in it"]
    shaders = {file.stem for file in (root / "shaders").rglob("*.comp")} - WITHOUT_PASS
    return [f"pass {name}: no shader has this name" for name in sorted(passes - shaders)] + [
        f"shader {name}: no pass has this name" for name in sorted(shaders - passes)]


if __name__ == "__main__":
    lines = faults(Path(sys.argv[1]))
    for line in lines:
        print(line)
    sys.exit(1 if lines else 0)
