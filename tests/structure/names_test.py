#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Pages name what exists: every variable pt_, flt_, vid_, ... in README.md and docs/ is in the table of variables, and every line that
docs/learn/lesson.md has people type is a variable or a command. A page explains its acronyms, or links to docs/learn/glossary.md.

names_test.py FOLDER: exits with 1 and a line for each name that does not exist.
"""
import re
import sys
from pathlib import Path

VARIABLE = re.compile(r"(?<![\w./-])(?:pt|flt|vid|vk|scr|joy|cl|con)_[a-z0-9_]*[a-z0-9](?![\w.*/])")
# Words that look like one: the engine's own (docs/play/quake2.md), and the beginnings of names.
OTHERS = {"vid_gamma", "pt_vlc"}
ACRONYMS = {
    "BRDF": "reflectance distribution function|reflection \\(BRDF\\)|How a surface reflects light",
    "CDQ": "Compressed Directional Quadtree",
    "LH": "Light Hierarchy",
    "LTC": "linearly transformed cosine",
    "MIS": "multiple importance sampling",
    "MSE": "mean squared error",
    "NEE": "next event estimation",
    "PVS": "potentially visible set",
    "RIS": "resampled importance sampling",
    "SLL": "Static Light Lists",
    "VLC": "Visibility Light Cache",
}
SKIPPED = ("docs/play/cvars.md", "docs/results/")


def main(root: Path) -> int:
    variables = set(re.findall(r"^\| `(\w+)` \|", (root / "docs/play/cvars.md").read_text(), re.M)) | OTHERS
    sources = "".join(file.read_text() for folder in ("src/client", "src/console") for file in sorted((root / folder).rglob("*.cpp")))
    faults = []
    for page in [root / "README.md", *sorted((root / "docs").rglob("*.md"))]:
        name = str(page.relative_to(root))
        if name.startswith(SKIPPED):
            continue
        text = re.sub(r"<!--.*?-->", "", page.read_text(), flags=re.S)
        faults += [f"{name}: there is no variable {word}" for word in sorted(set(VARIABLE.findall(text)) - variables)
                   if f'"{word}"' not in sources]  # nor a command of that name
        if "glossary.md" not in text:
            bare = re.sub(r"`[^`]*`", "", text)
            faults += [f"{name}: {word} is not explained" for word, meaning in ACRONYMS.items()
                       if re.search(rf"\b{word}\b", bare) and not re.search(meaning, bare, re.I)]
    lesson = root / "docs/learn/lesson.md"
    typed = [line.split()[0] for line in re.findall(r"^    (\w.*)$", lesson.read_text(), re.M) if not line.startswith("build/")]
    faults += [f"{lesson.name}: nobody can type {word}" for word in sorted(set(typed))
               if word not in variables and not re.search(rf'["+]{re.escape(word)}"', sources)]
    print("\n".join(faults) or f"{len(variables)} variables, {len(typed)} lines of the lesson")
    return 1 if faults or not typed else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve()))
