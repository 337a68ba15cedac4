#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""One source for every number: fills the numbers that pages (README.md, baseq2/README.md, docs/) quote from the reports that they come from.

    python3 tools/docs/quoted_numbers.py            # writes them into the pages
    python3 tools/docs/quoted_numbers.py --check    # writes nothing; exits with 1 and a line for each that is another

A quoted number stands between two marks, which pages do not show:

    <!--n KEY-->0.30<!--/n-->        or        <!--n KEY; FORMAT-->30%<!--/n-->

KEY is one of these:

- TABLE/ROW/COLUMN[/N]: of the table below a line <!--table TABLE--> in a page, the N-th number (1) of the cell; "all" is the
  whole cell. ROW is the first cell of the row, COLUMN that of the head, both without `, * and links.
- REPORT:PART/ROW/PATH: of REPORT.json in docs/results/full (FOLDER.REPORT: in that folder of docs/results), the row with
  this label in the part of this name; PATH has the names of fields and indices, with dots between them. Of an interval it
  is the value. "PART/ROW/PATH over PART/ROW/PATH" is the quotient.
- cvar:NAME: the default of a variable, as docs/play/cvars.md has it.

FORMAT: D digits ("2"); "D%" the same as a percentage with D decimals; "1/D" the reciprocal; "D+" the share above 1, as a percentage.
Without FORMAT a table's number stays as it is there, a report's has three digits.

Pages quote all that was measured: a decimal, a percentage, or a table's cell with a number alone is an error without marks.
What was not measured has its reason in tests/structure/numbers_exceptions: "PAGE NUMBER ... # reason". Pages in OTHERS and tables
in WRITTEN have another check."""

import json
import re
import sys
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MARK = re.compile(r"<!--n (?P<key>[^;>]+?)(?:; *(?P<format>[^>]*?))?-->(?P<text>.*?)<!--/n-->", re.S)
TABLE = re.compile(r"^<!--table (?P<name>[^>]+?)-->\n(?P<lines>(?:\|.*\n)+)", re.M)
NUMBER = re.compile(r"-?\d[\d,]*(?:\.\d+)?(?:e[-+]?\d+)?")
MEASURED = re.compile(r"\d+(?:\.\d+)? ?%|\d+\.\d+")
CODE = re.compile(r"^(?: {4}|\t)[^\n]*$|`[^`\n]*`|\]\([^)]*\)|<!--.*?-->", re.M | re.S)
VERSION = re.compile(r"(?:Vulkan|Ubuntu|Debian|Mesa|[Ll]avapipe|Embree|glTF|driver|GPL-?) ?\d[\d.]*")
ALONE = re.compile(r"\d[\d,]*")
OTHERS = {
    "docs/play/cvars.md": "written by vigil_cvar_docs",
    "docs/play/commands.md": "written by vigil_cvar_docs",
    "docs/research/trade.md": "written by tools/report/defaults.py",
    "docs/research/economy.md": "written by tools/report/economy_page.py",
    "docs/research/history.md": "dated notes, each of a program that is gone",
}
WRITTEN = re.compile(r"^<!--table levels-[^\n]*\n(?:\|[^\n]*\n)+"  # by tools/report/levels.py
                     r"|^<!-- tables: made by .*^<!-- end of the tables -->", re.M | re.S)  # by tools/numerics/numerics_page.py


def pages(root):
    return [page for page in (root / "README.md", root / "baseq2/README.md") if page.exists()] + sorted((root / "docs").rglob("*.md"))


def plain(cell):
    """A cell's words without marks of Markdown and of numbers."""
    cell = re.sub(r"<!--.*?-->", "", cell)
    return re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", cell).replace("`", "").replace("*", "").strip()


def cells(line):
    return [plain(cell) for cell in re.split(r"(?<!\\)\|", line.strip())[1:-1]]


def read_tables(texts):
    """{table: {row: {column: cell}}}. Raises ValueError where a name is used twice."""
    found = {}
    for page, text in texts.items():
        for match in TABLE.finditer(text):
            head, _, *lines = match["lines"].splitlines()
            columns = cells(head)
            rows = {}
            for line in lines:
                row = cells(line)
                if row[0] in rows:
                    raise ValueError(f"{page.name}: table {match['name']} has two rows {row[0]}")
                rows[row[0]] = dict(zip(columns, row))
            if match["name"] in found:
                raise ValueError(f"{page.name}: a second table {match['name']}")
            found[match["name"]] = rows
    return found


@cache
def report(root, name):
    folder, _, file = name.rpartition(".")
    return json.loads((root / "docs/results" / (folder or "full") / f"{file}.json").read_text())


def of_report(root, key):
    name, place = key.split(":", 1)
    if " over " in place:
        value, divisor = (of_report(root, f"{name}:{one}") for one in place.split(" over "))
        return value / divisor
    part, row, path = place.split("/", 2)
    value = next(found for found in report(root, name)["parts"] if found["part"] == part)
    value = next(found for found in value["rows"] if found["label"] == row)
    for field in path.split("."):
        value = value[int(field)] if isinstance(value, list) else value[field]
    return value["value"] if isinstance(value, dict) else value


@cache
def defaults(root):
    """Default by variable."""
    rows = re.findall(r"^\| `(\w+)` \| `?([^`|]*)`? \|", (root / "docs/play/cvars.md").read_text(), re.M)
    return {name: value.strip() for name, value in rows}


def of_table(tables, key):
    """The text of a cell, or its N-th number."""
    table, row, column, *place = re.split(r"(?<! )/(?! )", key)
    cell = tables[table][row][column]
    if place == ["all"]:
        return cell
    return NUMBER.findall(cell)[int(place[0]) - 1 if place else 0]


def digits(value, count):
    """`count` digits, as people write them: no exponents from 1e-4 to 1e6."""
    text = f"{value:.{count}g}"
    if "e" in text and 1e-4 <= abs(value) < 1e7:
        text = f"{value:,.0f}" if abs(value) >= 1 else f"{value:f}"
    return text


def shown(value, form):
    if isinstance(value, str):
        if not form:
            return value
        value = float(value.replace(",", ""))
    if not form:
        return digits(value, 3)
    if form.endswith("%"):
        return f"{100 * value:.{int(form[:-1] or 0)}f}%"
    if form.endswith("+"):
        return f"{100 * (value - 1):.{int(form[:-1] or 0)}f}%"
    if form.startswith("1/"):
        return digits(1 / value, int(form[2:]))
    return digits(value, int(form))


def fill(root, texts):
    """Pages with their numbers as the reports have them, and a line for each key that leads nowhere."""
    faults = []
    try:
        tables = read_tables(texts)
    except ValueError as fault:
        return texts, [str(fault)]
    filled = {}
    for page, text in texts.items():
        def number(match):
            key, form = match["key"].strip(), match["format"]
            try:
                if key.startswith("cvar:"):
                    value = defaults(root)[key.removeprefix("cvar:")]
                else:
                    value = of_report(root, key) if ":" in key.split("/")[0] else of_table(tables, key)
                return match[0][: match.start("text") - match.start()] + shown(value, form) + "<!--/n-->"
            except (KeyError, IndexError, StopIteration, ValueError, TypeError, OSError) as fault:
                faults.append(f"{page.relative_to(root)}: no number {key} ({type(fault).__name__} {fault})")
                return match[0]

        filled[page] = MARK.sub(number, text)
    return filled, faults


def read_exceptions(path):
    """{page: numbers that nobody measured}. Raises ValueError for a line that has no reason."""
    found = {}
    for line in path.read_text().splitlines() if path.exists() else ():
        if not line or line.startswith("#"):
            continue
        words, _, reason = line.partition(" # ")
        page, *numbers = words.split()
        if not (numbers and reason):
            raise ValueError(f"{path.name}: no page, numbers and reason in: {line}")
        found.setdefault(page, set()).update(numbers)
    return found


def typed(text):
    """The numbers of a page that look like measured ones and have no marks."""
    text = MARK.sub("n", WRITTEN.sub("", text))
    lines = CODE.sub("x", text).splitlines()
    rows = [line for line, below in zip(lines, lines[1:] + [""]) if line.startswith("|") and not below.startswith("|--")]
    alone = {cell for row in rows for cell in cells(row)[1:] if ALONE.fullmatch(cell)}
    return alone | {number.replace(" ", "") for number in MEASURED.findall(VERSION.sub("", CODE.sub("", text)))}


def unmarked(root, texts):
    """A line for each number that no report and no exception stands behind, and for each exception that is not needed."""
    try:
        exceptions = read_exceptions(root / "tests/structure/numbers_exceptions")
    except ValueError as fault:
        return [str(fault)]
    found = []
    for page, text in texts.items():
        name = page.relative_to(root).as_posix()
        if name in OTHERS or name.startswith("docs/results/"):
            continue
        numbers, excepted = typed(text), exceptions.pop(name, set())
        found += [f"{name}: {number} has no source" for number in sorted(numbers - excepted)]
        found += [f"{name}: {number} needs no exception" for number in sorted(excepted - numbers)]
    return found + [f"{page}: no such page for exceptions" for page in exceptions]


def misplaced(root, texts):
    """Lines that begin with a mark: Markdown takes them for HTML, and ends the paragraph there."""
    return [f"{page.relative_to(root)}:{number}: a mark begins the line" for page, text in texts.items()
            for number, line in enumerate(text.splitlines(), 1) if line.lstrip().startswith("<!--n ")]


def main(arguments):
    check = "--check" in arguments
    root = Path(next((argument for argument in arguments if not argument.startswith("--")), ROOT)).resolve()
    texts = {page: page.read_text() for page in pages(root)}
    filled, faults = fill(root, texts)
    for page, text in filled.items():
        if text == texts[page]:
            continue
        if not check:
            page.write_text(text)
            continue
        for old, new in zip(MARK.finditer(texts[page]), MARK.finditer(text)):
            if old["text"] != new["text"]:
                faults.append(f"{page.relative_to(root)}: {old['key']} is {new['text']}, not {old['text']}")
    faults += unmarked(root, filled) + misplaced(root, filled)
    count = sum(len(MARK.findall(text)) for text in filled.values())
    print("\n".join(faults) if faults else f"{count} numbers are those of their reports")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
