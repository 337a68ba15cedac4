#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Links lead somewhere: every relative link of a page, and every path docs/... that a page, a comment or a message names, is a file or
a folder of the repository; every #place of a link is a heading of its page; every page can be reached from README.md.

links_test.py FOLDER [EXCEPTIONS]: exits with 1 and one line for each that leads nowhere. EXCEPTIONS (tests/structure/links_exceptions)
has lines "FILE PATH # reason" for what may be dead (PATH *: all of the file); a line that excuses nothing is an error too.
"""
import re
import subprocess
import sys
from pathlib import Path

LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
SOURCE = re.compile(r'(?:src|href)="([^"]+)"')
NAMED = re.compile(r"(?<![\w./-])docs/[\w./-]*\w")
CODE = re.compile(r"^(?: {4}|\t).*$|`[^`\n]*`", re.M)
HEADING = re.compile(r"^#+ +(.*)$", re.M)
TEXTS = {".md", ".h", ".cpp", ".c", ".glsl", ".comp", ".py", ".sh", ".txt", ".cmake", ".cfg", ".json", ".yml", ""}


def tracked(root: Path) -> list[str]:
    """Files that git knows; without git (a package of the sources), all of them outside of build folders."""
    try:
        listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard"], cwd=root, check=True, text=True,
                                capture_output=True).stdout
        names = listed.splitlines()
    except (OSError, subprocess.CalledProcessError):
        names = [str(path.relative_to(root)) for path in root.rglob("*") if path.is_file()]
        names = [name for name in names if not name.startswith(("build", "out/", "."))]
    return [name for name in names if (root / name).is_file()]


def anchor(heading: str) -> str:
    """A heading's place, as GitHub and GitLab name it."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    return re.sub(r"[^\w\- ]", "", text.strip().lower()).replace(" ", "-")


def dead_links(root: Path, page: str, text: str, reached: set[str]) -> list[str]:
    dead = []
    prose = CODE.sub("", text)
    for target in LINK.findall(prose) + SOURCE.findall(prose):
        if re.match(r"[a-z]+:", target):
            continue
        path, _, place = target.partition("#")
        file = ((root / page).parent / path).resolve() if path else root / page
        if not file.exists():
            dead.append(target)
            continue
        if root in file.parents:
            reached.add(str(file.relative_to(root)))
        if place and file.suffix == ".md" and place not in {anchor(h) for h in HEADING.findall(file.read_text())}:
            dead.append(target)
    return dead


def main(root: Path, exceptions: Path) -> int:
    root = root.resolve()
    excused = {}
    for line in exceptions.read_text().splitlines() if exceptions.exists() else []:
        entry, _, reason = line.partition("#")
        if entry.strip():
            excused[tuple(entry.split())] = reason.strip()
    faults, used, reached = [], set(), {"README.md"}
    names = tracked(root)
    for name in names:
        path = root / name
        if path.resolve() == exceptions.resolve() or path.suffix not in TEXTS or name.startswith("docs/results/") and path.suffix == ".json":
            continue
        try:
            text = path.read_text()
        except UnicodeDecodeError:
            continue
        dead = [match for match in NAMED.findall(text) if not (root / match).exists()]
        if path.suffix == ".md":
            dead += dead_links(root, name, text, reached)
        for target in dead:
            entry = next((entry for entry in ((name, target), (name, "*")) if excused.get(entry)), None)
            if entry:
                used.add(entry)
            else:
                faults.append(f"{name}: {target} leads nowhere")
    faults += [f"{name}: no page links to it" for name in names
               if name.startswith("docs/") and name.endswith(".md") and name not in reached]
    faults += [f"{exceptions.name}: {' '.join(entry)} excuses nothing, or has no reason" for entry in excused if entry not in used]
    print("\n".join(faults) or f"links of {len(names)} files lead somewhere")
    return 1 if faults else 0


if __name__ == "__main__":
    here = Path(__file__).resolve().parent
    sys.exit(main(Path(sys.argv[1]), Path(sys.argv[2]) if len(sys.argv) > 2 else here / "links_exceptions"))
