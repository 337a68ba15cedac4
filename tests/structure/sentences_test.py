#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Sentences that can be read once: none in README.md and docs/ has more than 30 words.

sentences_test.py FOLDER [--longest N]: exits with 1 and a line for each that is longer, and for each line that joins a table; --longest lists the N longest instead.
tests/structure/sentences_exceptions has lines "FILE: how it begins # reason" for what may be longer; a beginning of * is the whole
page. A line that excuses nothing is an error too.

A sentence ends at . ! or ? before a space, at the end of a paragraph, of an item and of a cell. A piece of code, a link's text and a number
with its unit's sign count as the words they show; code blocks, pictures and what marks hold do not count.
"""
import re
import sys
from pathlib import Path

LIMIT = 30
SKIPPED = ("docs/results/",)  # made by ./run report
ABBREVIATIONS = ("e.g.", "i.e.", "et al.", "etc.", "vs.", "cf.", "Fig.", "No.")


def blocks(text):
    """Paragraphs, items, headings and cells of a page, as (line, text)."""
    text = re.sub(r"<!--.*?-->", lambda match: "\n" * match[0].count("\n"), text, flags=re.S)
    block, start, fenced = [], 0, False
    for number, line in enumerate([*text.split("\n"), ""], 1):
        if line.startswith("```"):
            fenced = not fenced
            line = ""
        is_code = fenced or (line.startswith(("    ", "\t")) and not block)
        is_row = line.lstrip().startswith("|")
        begins = re.match(r"\s*([-*]|\d+\.) +|#+ ", line)
        if block and (not line.strip() or is_code or is_row or begins):
            yield start, " ".join(block)
            block = []
        if is_code or not line.strip():
            continue
        if is_row:
            yield from ((number, cell) for cell in re.split(r"(?<!\\)\|", line) if cell.strip(" -:"))
            continue
        if not block:
            start = number
        block.append(line[begins.end():] if begins else line.strip())


def joined_to_tables(text):
    """Numbers of lines that Markdown takes for a row of the table above, as no empty line is between."""
    lines = text.split("\n")
    return [number for number, (above, line) in enumerate(zip(lines, lines[1:]), 2)
            if above.startswith("|") and line.strip() and not line.startswith(("|", "#"))]


def sentences(block):
    block = re.sub(r"!\[[^\]]*\]\([^)]*\)", "", block)
    block = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", block)
    block = re.sub(r"`[^`]*`", "code", block)
    for word in ABBREVIATIONS:
        block = block.replace(word, word.replace(".", ""))
    return re.split(r"(?<=[.!?])[*_)\"']*\s+", block)


def words(sentence):
    return [word for word in sentence.split() if re.search(r"\w", word)]


def main(root, longest):
    root = root.resolve()
    entries = {}
    for line in (Path(__file__).resolve().parent / "sentences_exceptions").read_text().splitlines():
        entry, _, reason = line.partition(" # ")
        if entry.strip() and not entry.startswith("#"):
            page, _, beginning = entry.partition(": ")
            entries[(page, beginning.strip())] = reason.strip()
    used, found, count = set(), [], 0
    for page in [root / "README.md", *sorted((root / "docs").rglob("*.md"))]:
        name = str(page.relative_to(root))
        if name.startswith(SKIPPED):
            continue
        found += [(0, f"{name}:{line}: this line joins the table above") for line in joined_to_tables(page.read_text())]
        for line, block in blocks(page.read_text()):
            for sentence in sentences(block):
                length = len(words(sentence))
                count += 1
                if length <= LIMIT and not longest:
                    continue
                excuse = next((entry for entry in entries if entry[0] == name and entries[entry]
                               and (entry[1] == "*" or sentence.startswith(entry[1]))), None)
                if excuse:
                    used.add(excuse)
                else:
                    found.append((length, f"{name}:{line}: {length} words: {sentence[:110]}"))
    if longest:
        found = sorted(found, reverse=True)[:longest]
    faults = [text for _, text in found]
    if not longest:
        faults += [f"sentences_exceptions: {': '.join(entry)} excuses nothing, or has no reason" for entry in entries if entry not in used]
    print("\n".join(faults) or f"{count} sentences of at most {LIMIT} words")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), int(sys.argv[3]) if len(sys.argv) > 3 else 0))
