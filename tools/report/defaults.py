#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Writes docs/research/trade.md: what every value of every variable costs and buys next to the default, from the reports of `run bench
trade` and of `run bench confirm`, which measures again what looks better than the default.

    python3 tools/report/defaults.py out/trade.json out/confirm.json > docs/research/trade.md
    ... --cvars FILE    # the page of variables of the report's commit, where defaults have changed since
    ... --check FILE    # prints nothing; fails where FILE is another page, but for the values of defaults, which are FILE's

The exit status is 1 where the reports do not bear out the defaults: a value that looks better was not measured again, one that
is better has no reason below, or a reason says what the reports deny. The reports must be of one commit; with --commits-differ,
the page says that they are not."""

import contextlib
import io
import re
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

import tables

CVARS = Path(__file__).resolve().parents[2] / "docs" / "play" / "cvars.md"

HEAD = """# Speed against accuracy

Generated from the reports of `./run bench trade` and `./run bench confirm` by `tools/report/defaults.py`. Edit that tool, not this page; the test `trade_page` compares it with the report.

{device}; {width} x {height} pixels, {views} views, {seeds} seeds a level, commit {commit}.{state}{since}

The tables have *time x error = error at equal time* of other values, over the default of the same technique. Below 1 the value is better ([glossary](../learn/glossary.md)).

- *Time* is that of whole frames.
- *Error* is the mean squared error (MSE) without the worst 0.1% of the pixels.
- *Mean* is the geometric mean of time x error over the levels.
- *Plain* is the same for the MSE with all pixels, single bright ones included.

{marks}{without}

Some values look better by luck. So a value whose *mean* and *plain* are both below 1 is measured again, with fresh seeds. {again}
It is better if both are below 1 again, if some level stands out from chance (Holm, 5%), and if no level is worse. A default that is not the better value has its reason below the table. The tool checks the reason against the reports.

These tables do not decide about `pt_guide cdq`: see [caches.md](caches.md) for the light that only guided rays find.

## Presets and techniques

`pt_preset NAME` sets several variables at once; `balanced` are the defaults.
"""

MARKS = "Bold numbers are better, and their typical run stands out among all comparisons of this page (Holm, 5%)."
NO_MARKS = "This report is older than [intervals that hold](quality.md#older-intervals), so nothing is bold."
WITHOUT = " Left out: {levels}, whose frames [may lack light](quality.md#rare-paths) of the reference."
NOT_AGAIN = "That has not been done yet."
AGAIN = """The rows *again* are of commit {commit}, {views} views and {seeds} seeds
from {first_seed} on; in brackets the 95% interval of the typical run's time x error.{differ}"""
DIFFER = " **The two reports are of different commits**: that of the tables is the older one."


@dataclass
class Reason:
    """Why a default is not the value that is better. `text` has no measured numbers: those are the reports'. `denied` tells what in
    them speaks against it, from the value's rows by level and the defaults; empty where nothing does."""

    text: str
    denied: Callable


def needs_longer_frames(rows, values):
    faster = [level for level, row in rows.items() if row["frame_ms"]["ratio"]["value"] <= 1]
    return f"its frames are not longer on {', '.join(faster)}" if faster else ""


def is_only_compared_with(rows, values):
    same = values["pt_sll_max"] == values["pt_vlc_bucket"] == values["pt_ris_candidates"]
    if values["pt_nee"] == "sll":
        return "sll is the default technique"
    return "" if same else "its default is not that of pt_vlc_bucket and pt_ris_candidates"


REASONS = {
    "pt_spp": Reason("One sample makes the shortest frames, and a player waits for frames; more are a preset (`accurate`).",
                     needs_longer_frames),
    "pt_sll_max": Reason("""`sll` is there to be compared with: its default is as many lights as `vlc` and `ris` weigh at a hit
([light-sampling.md](../internals/light-sampling.md)). Players who use `sll` among many lamps should set more.""", is_only_compared_with),
}


def defaults(page=CVARS):
    """Default by variable, from docs/play/cvars.md or an earlier one."""
    rows = re.findall(r"^\| `(\w+)` \| `?([^`|]*)`? \|", Path(page).read_text(), re.MULTILINE)
    return {name: value.strip() for name, value in rows}


def defaults_of_page(text):
    """Default by variable, as a page of this tool has them."""
    return dict(re.findall(r"^\| `(\w+)`: ([^|,]*), `", text, re.MULTILINE))


def levels_of(report):
    """Levels in which some row has a ratio of errors, in order; all of them where none has."""
    every = list(dict.fromkeys(part["level"] for part in report["parts"]))
    known = {part["level"] for part in report["parts"] for row in part["rows"]
             if row["label"] != part["baseline"] and row["trimmed_mse"]["ratio"]["value"] is not None}
    return [level for level in every if level in known or not known]


def parts_named(report, name):
    return {part["level"]: part for part in report["parts"] if part["part"] == f"{part['level']} {name}"}


def rows_of(report, name, label):
    """The rows with a label in the parts of a name, by level."""
    found = {}
    for level, part in parts_named(report, name).items():
        found.update({level: row for row in part["rows"] if row["label"] == label})
    return found


def labels_of(report, name):
    """Of all rows but that which the others are compared with."""
    return list(dict.fromkeys(row["label"] for part in parts_named(report, name).values() for row in part["rows"]
                              if row["label"] != part["baseline"]))


def names_of(report):
    return list(dict.fromkeys(part["part"].split(" ", 1)[1] for part in report["parts"]))


def mean_product(rows, measure):
    """Geometric mean of time x error over the levels that have one; None without any."""
    return tables.geometric_mean(row[measure]["ratio_at_equal_time"]["value"] for row in rows.values())


def means(rows):
    """Without the worst pixels, and plain."""
    return [mean_product(rows, "trimmed_mse"), mean_product(rows, "mse")]


def looks_better(rows):
    return all(mean is not None and mean < 1 for mean in means(rows))


def typical(row):
    return row["trimmed_mse"].get("typical_at_equal_time", {})


def marked_rows(report):
    """Label and level of the rows whose typical run stands out among all of the report."""
    return tables.standing_out({(row["label"], part["level"], part["part"]): typical(row).get("p")
                                for part in report["parts"] for row in part["rows"] if row["label"] != part["baseline"]})


def cells(rows, levels, name, marked):
    """Of one row of a table: time x error by level, with the interval where there is one, and the means."""
    shown = []
    for level in levels:
        if level not in rows:
            shown.append("")
            continue
        row = rows[level]
        product = tables.number(row["trimmed_mse"]["ratio_at_equal_time"]["value"])
        better = (row["trimmed_mse"]["ratio_at_equal_time"]["value"] or 1) < 1
        if better and (row["label"], level, f"{level} {name}") in marked:
            product = f"**{product}**"
        interval = typical(row)
        if interval.get("low") is not None:
            product += f" [{tables.number(interval['low'])}, {tables.number(interval['high'])}]"
        shown.append(f"{tables.number(row['frame_ms']['ratio']['value'])} x {tables.number(row['trimmed_mse']['ratio']['value'])} = {product}")
    return [*shown, *map(tables.number, means(rows))]


def is_better(rows, name, marked):
    """Whether values measured again are better than the default, as the page's head has it."""
    standing_out = [typical(row)["value"] < 1 for level, row in rows.items() if (row["label"], level, f"{level} {name}") in marked]
    return looks_better(rows) and any(standing_out) and all(standing_out)


@dataclass
class Page:
    trade: dict
    again: dict  # the report of confirm; None: there is none
    values: dict  # defaults at the reports' commit
    now: dict  # today's
    faults: list

    def lines(self, name, show):
        """Cells of the rows of a name, each followed by what it was when measured again."""
        levels = levels_of(self.trade)
        marked = marked_rows(self.trade)
        for label in labels_of(self.trade, name):
            rows = rows_of(self.trade, name, label)
            yield [show(label), *cells(rows, levels, name, marked)]
            again = rows_of(self.again, name, label) if self.again else {}
            if again:
                yield [f"{show(label)} again", *cells(again, levels, name, marked_rows(self.again))]

    def table(self, first, lines):
        """Markdown of some rows; `first` names the columns in front of the levels."""
        head = [*first, *levels_of(self.trade), "mean", "plain"]
        return "\n".join("| " + " | ".join(line) + " |" for line in [head, ["---"] * len(head), *lines])

    def verdict(self, name):
        """What became of the values that look better than the default."""
        said, reasons, today = [], [], self.now.get(name)
        for label in labels_of(self.trade, name):
            if not looks_better(rows_of(self.trade, name, label)):
                continue
            value = f"`{label.split('=')[1]}`"
            again = rows_of(self.again, name, label) if self.again else {}
            if not again:
                said.append(f"{value} looks better, and was not measured again.")
                self.faults.append(f"{label} looks better than the default and was not measured again")
            elif not is_better(again, name, marked_rows(self.again)):
                said.append(f"{value} looked better; on fresh seeds that is not confirmed.")
            elif label.split("=")[1] == today:
                said.append(f"{value} is better on fresh seeds too, and is the default since then.")
            elif name not in REASONS:
                said.append(f"{value} is better than the default on fresh seeds too.")
                self.faults.append(f"{label} is better than the default: change it, or say in REASONS why not")
            else:
                said.append(f"{value} is better on fresh seeds too.")
                reasons.append(REASONS[name].text)
                denied = REASONS[name].denied(again, self.values)
                if denied:
                    self.faults.append(f"REASONS of {name}, {label}: {denied}")
        return "\n".join(said + reasons[:1])

    def write(self):
        first = self.trade["parts"][0]
        again = NOT_AGAIN
        if self.again and self.again["parts"]:
            part = self.again["parts"][0]
            differ = DIFFER if self.again["commit"] != self.trade["commit"] else ""
            again = AGAIN.format(commit=self.again["commit"], views=len(part["views"]), seeds=part["seeds"],
                                 first_seed=part["first_seed"], differ=differ)
        shown = levels_of(self.trade)
        left_out = [f"`{level}`" for level in dict.fromkeys(part["level"] for part in self.trade["parts"]) if level not in shown]
        changed = [f"`{name}` is {self.now[name]} today" for name in names_of(self.trade)
                   if self.now.get(name, "?") != self.values.get(name, "?")]
        print(HEAD.format(since=f" Its defaults and presets are those of that commit: {', '.join(changed)}." if changed else "", without=WITHOUT.format(levels=", ".join(left_out)) if left_out else "",
                          device=self.trade["device"], width=self.trade["width"], height=self.trade["height"], views=len(first["views"]),
                          seeds=self.trade["seeds"], commit=self.trade["commit"],
                          state="" if self.trade["finished"] else " The run was not finished: parts are missing.",
                          marks=MARKS if "intervals" in self.trade else NO_MARKS, again=again))
        print(self.table(["over `vlc`, rays by the BRDF"],
                         [line for name in ("presets", "techniques") for line in self.lines(name, "`{}`".format)]))
        names = [name for name in names_of(self.trade) if name.startswith("pt_")]
        lines = []
        for name in names:
            baseline = next(iter(parts_named(self.trade, name).values()))["baseline"]
            rows = self.lines(name, lambda label: f"`{label.split('=')[1]}`")
            titles = [f"`{name}`: {self.values.get(name, '?')}, `{baseline}`"]
            lines += [[titles.pop() if titles else "", *row] for row in rows]
        print("\n## Variables\n")
        print(self.table(["variable: default, with", "value"], lines))
        verdicts = [f"- `{name}`: {verdict}" for name in names if (verdict := self.verdict(name))]
        if verdicts:
            print("\n" + "\n".join(verdicts))


def main(arguments):
    may_differ = "--commits-differ" in arguments
    paths = [argument for argument in arguments if argument != "--commits-differ"]
    given = {}
    for option in ("--cvars", "--check"):
        if option in paths[:-1]:
            place = paths.index(option)
            given[option] = paths[place + 1]
            del paths[place : place + 2]
    if len(paths) not in (1, 2):
        sys.exit(__doc__)
    try:
        reports = [tables.load(path, kind) for path, kind in zip(paths, ("trade", "confirm"))]
    except (OSError, ValueError) as fault:
        sys.exit(str(fault))
    trade, again = reports[0], reports[1] if len(reports) > 1 else None
    if again and again["trade"]["key"] != trade["key"]:
        sys.exit(f"{paths[1]}: confirms values of another report than {paths[0]}")
    if again and again["commit"] != trade["commit"] and not may_differ:
        sys.exit(f"{paths[1]}: of commit {again['commit']}, {paths[0]} of {trade['commit']}; see --commits-differ")
    now = defaults()
    if "--check" in given:
        committed = Path(given["--check"]).read_text()
        with contextlib.redirect_stdout(io.StringIO()) as written:
            Page(trade, again, now | defaults_of_page(committed), now, []).write()
        sys.exit(0 if written.getvalue() == committed else f"{given['--check']}: is not the page of {' and '.join(paths)}")
    page = Page(trade, again, defaults(given.get("--cvars", CVARS)), now, [])
    page.write()
    for fault in page.faults:
        print(fault, file=sys.stderr)
    sys.exit(int(bool(page.faults)))


if __name__ == "__main__":
    main(sys.argv[1:])
