#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Markdown tables of reports of `run bench`: what docs/research quotes. Ratios are over the baseline of their part: first that of
the means, an estimate; then that of the typical run, with its 95% interval. Bold is a typical run below 1 that stands out
among all comparisons of its table.

    python3 tools/report/tables.py [--typical] out/quality.json [MORE.json ...]

--typical: of `run bench quality`, typical runs alone, without intervals; all reports in one table, with geometric means.
"""

import json
import math
import sys
from pathlib import Path


# Where rows have ratios of times.
TIME_RATIOS = (("path_ms", "ratio"), ("prepare_ms", "share_of_path"), ("frame_ms", "ratio"))


def load(path, measured):
    """The report at a path, which must be one of `measured` with a part in it. Raises ValueError."""
    report = json.loads(Path(path).read_text())
    if report.get("measured") != measured:
        raise ValueError(f"{path}: not a report of `run bench {measured}`")
    if not report.get("parts") and not report.get("finished"):
        raise ValueError(f"{path}: nothing has been measured yet")
    if "intervals" not in report:
        forget_intervals(report)
    return report


def forget_intervals(report):
    """Takes the intervals out of an older report, which were about means and too narrow (docs/research/quality.md). Those of ratios of times
    over at least four views stay: they were of order statistics."""

    def forget(value):
        if isinstance(value, dict):
            if "low" in value:
                value["low"] = value["high"] = None
            value = list(value.values())
        for inner in value if isinstance(value, list) else ():
            forget(inner)

    for part in report["parts"]:
        has_views = isinstance(part.get("views"), list) and len(part["views"]) >= 4
        for row in part["rows"]:
            times = {name: dict(row[name][ratio]) for name, ratio in TIME_RATIOS if ratio in row.get(name, {})} if has_views else {}
            forget(list(row.values()))
            for name, ratio in TIME_RATIOS:
                if name in times:
                    row[name][ratio] = times[name]


def rounded(value, without=()):
    """A report with four digits of each number, without what has one of these keys."""
    if isinstance(value, dict):
        return {key: rounded(inner, without) for key, inner in value.items() if key not in without}
    if isinstance(value, list):
        return [rounded(inner, without) for inner in value]
    return float(f"{value:.4g}") if isinstance(value, float) else value


def median(values):
    ordered = sorted(values)
    return 0.5 * (ordered[(len(ordered) - 1) // 2] + ordered[len(ordered) // 2])


def typical_run(strata):
    """Median over all runs, [view][seed], and its 95% interval by order statistics, from four views and six runs on."""
    runs = sorted(run for view in strata for run in view)
    tails = [sum(math.comb(len(runs), i) for i in range(rank + 1)) / 2 ** len(runs) for rank in range(len(runs) // 2)]
    rank = sum(tail <= 0.025 for tail in tails) - 1
    if rank < 0 or len(strata) < 4:
        return {"value": median(runs), "low": None, "high": None}
    return {"value": median(runs), "low": runs[rank], "high": runs[-1 - rank]}


def standing_out(chances):
    """Keys of the comparisons that are not chance: at most 5% of tables have a false one (Holm). `chances` are their p by key; None
    is no comparison."""
    known = sorted((p, key) for key, p in chances.items() if p is not None)
    found = set()
    for done, (p, key) in enumerate(known):
        if p * (len(known) - done) > 0.05:
            break
        found.add(key)
    return found


# Of techniques: title, then what to take from a row: an estimate, and an interval. Either may be None.
MEASURES = (
    ("MSE at equal samples", lambda row: (row["mse"]["ratio"], row["mse"].get("typical"))),
    ("MSE at equal time", lambda row: (row["mse"]["ratio_at_equal_time"], row["mse"].get("typical_at_equal_time"))),
    ("Trimmed MSE at equal samples", lambda row: (row["trimmed_mse"]["ratio"], row["trimmed_mse"].get("typical"))),
    ("Trimmed MSE at equal time",
     lambda row: (row["trimmed_mse"]["ratio_at_equal_time"], row["trimmed_mse"].get("typical_at_equal_time"))),
    ("Relative MSE at equal samples", lambda row: (row["relative_mse"]["ratio"], row["relative_mse"].get("typical"))),
    ("Time of a frame", lambda row: (None, row["frame_ms"]["ratio"])),
)


def number(value):
    """Three digits at most; a question mark where there is none."""
    if value is None:
        return "?"
    return f"{value:.0f}" if abs(value) >= 100 else f"{value:.2g}" if abs(value) < 0.1 else f"{value:.3g}"


def cell(pair, stands_out=False):
    """An estimate and an interval, either of which may be missing."""
    estimate, interval = pair
    words = [] if estimate is None else [number(estimate["value"])]
    if interval is not None:
        value, low, high = (interval.get(key) for key in ("value", "low", "high"))
        text = f"**{number(value)}**" if stands_out and value < 1 else number(value)
        if low is not None and high is not None and low != high:
            text += f" [{number(low)}, {number(high)}]"
        if text not in words:
            words.append(text)
    return "; ".join(words)


def median_of(measure):
    """A value's estimate and its typical run, as cell() takes them."""
    return measure, measure.get("median")


def first_labels(parts):
    return [row["label"] for row in parts[0]["rows"]]


def by_technique(title, parts, value_of):
    """Parts down, techniques across; marks by all comparisons with the baselines."""
    labels = first_labels(parts)
    chances = {(part["part"], row["label"]): (value_of(row)[1] or {}).get("p")
               for part in parts for row in part["rows"] if row["label"] != part.get("baseline")}
    marked = standing_out(chances)
    lines = []
    for part in parts:
        cells = {row["label"]: cell(value_of(row), (part["part"], row["label"]) in marked) for row in part["rows"]}
        lines.append([part["part"], *(cells.get(label, "") for label in labels)])
    return [title, *labels], lines


def geometric_mean(values):
    """Of those that are known: neither None nor 0. None without any."""
    known = [value for value in values if value]
    return math.exp(sum(map(math.log, known)) / len(known)) if known else None


def typical_quality(report):
    parts = report["parts"]
    for title, value_of in MEASURES:

        def typical(row):
            return {**(value_of(row)[1] or {"value": None}), "low": None}

        head, lines = by_technique(title, parts, lambda row: (None, typical(row)))
        columns = zip(*([typical(row)["value"] for row in part["rows"]] for part in parts))
        means = [None if None in column else geometric_mean(column) for column in columns]
        yield head, [*lines, ["geometric mean", *map(number, means)]]
    yield by_technique("Mean over the reference's", parts, lambda row: (None, {**row["mean_ratio"]["median"], "low": None}))


def quality(report):
    for title, value_of in MEASURES:
        yield by_technique(title, report["parts"], value_of)
    yield by_technique("Mean over the reference's", report["parts"], lambda row: median_of(row["mean_ratio"]))


def adapt(report):
    lines = []
    for part in report["parts"]:
        for row in part["rows"]:
            lines.append([part["part"], row["label"]])
            for measure in ("mse", "trimmed_mse"):
                curve = row[measure]
                frame = curve["settled_frame"]
                lines[-1] += [number(curve["frames"][0]["value"]), number(curve["settled"]),
                              str(frame) if frame <= len(curve["frames"]) else "never"]
    yield ["level", "", "MSE of frame 1", "settled", "from frame", "trimmed, frame 1", "settled", "from frame"], lines


def ring(report):
    lines = []
    for turn in report["parts"]:
        for row in turn["rows"]:
            back = row["readapted_frame"]
            lines.append([f"{turn['degrees']}°", row["label"], cell(median_of(row["before"])), cell(median_of(row["frames"][0])),
                          str(back) if back <= len(row["frames"]) else "never", number(row["settled"])])
    yield ["turn", "", "MSE before", "frame 1", "back from frame", "settled"], lines


def timing(report):
    yield by_technique("Time of path tracing", report["parts"], lambda row: (None, row["path_ms"]["ratio"]))
    yield by_technique("Preparation over path tracing", report["parts"], 
                       lambda row: (None, row["prepare_ms"]["share_of_path"]))
    for part in report["parts"]:
        names = list(dict.fromkeys(entry["name"] for row in part["rows"] for entry in row["passes"]))
        lines = []
        for name in names:
            passes = [next((entry for entry in row["passes"] if entry["name"] == name), None) for row in part["rows"]]
            lines.append([name, *(f"{number(entry['median_ms'])} ({100 * entry['share']:.1f}%)" if entry else ""
                                  for entry in passes)])
        yield [f"{part['part']}: median ms (share)", *first_labels([part])], lines


def scale(report):
    yield by_technique("Milliseconds of a frame", report["parts"], lambda row: median_of(row["frame_ms"]))
    for title, value_of in MEASURES[2:4]:
        yield by_technique(title, report["parts"], value_of)


def trade(report):
    """One table per level: every value against the default of its technique."""
    shown = (MEASURES[5][1], MEASURES[2][1], MEASURES[3][1], MEASURES[0][1])
    for level in dict.fromkeys(part["level"] for part in report["parts"]):
        rows = [(part, row) for part in report["parts"] if part["level"] == level
                for row in part["rows"] if row["label"] != part["baseline"]]
        marked = standing_out({(row["label"], part["baseline"], column): (value_of(row)[1] or {}).get("p")
                               for part, row in rows for column, value_of in enumerate(shown)})
        lines = [[row["label"], part["baseline"],
                  *(cell(value_of(row), (row["label"], part["baseline"], column) in marked)
                    for column, value_of in enumerate(shown))] for part, row in rows]
        yield [f"{level}", "over", "frame time", "trimmed MSE", "trimmed, equal time", "MSE"], lines


def confirm(report):
    yield from trade(report)


def picture(report):
    """One table per part: the typical run of every row and, where it says something, its ratio to the baseline's."""

    def text(row, column):
        measure = row.get(column["name"])
        if measure is None:
            return ""
        value = number(measure["median"]["value"])
        return f"{value} ({number(measure['ratio']['value'])})" if column["has_ratio"] else value

    for part in report["parts"]:
        headings = [column["heading"] + (f" (/ {part['baseline']})" if column["has_ratio"] else "") for column in part["columns"]]
        lines = [[row["label"], *(text(row, column) for column in part["columns"])] for row in part["rows"]]
        yield [part["part"], *headings], lines


def economy(report):
    """Levels down, features across: those that a level has are no rows of its own. economy_page.py has more."""
    parts = report["parts"]
    labels = list(dict.fromkeys(row["label"] for part in parts for row in part["rows"]))

    def table(title, text_of):
        lines = []
        for part in parts:
            cells = {row["label"]: text_of(row) for row in part["rows"]}
            lines.append([part["part"], *(cells.get(label, "") for label in labels)])
        return [title, *labels], lines

    yield table("Time of path tracing", lambda row: cell((None, row["path_ms"]["ratio"])))
    yield table("Time of a frame", lambda row: cell((None, row["frame_ms"]["ratio"])))
    yield table("Seconds to compile", lambda row: number(row["compile_s"]["value"]))
    yield table("KiB of code", lambda row: number(row["code_bytes"]["value"] and row["code_bytes"]["value"] / 1024))
    yield table("MiB of memory", lambda row: number(row["memory_bytes"]["value"] / 2**20))
    yield table("Bytes uploaded a frame, camera moving", lambda row: f"{row['upload_bytes']['value']:,.0f}")
    yield table("Bytes uploaded a frame, still", lambda row: f"{row['still_upload_bytes']['value']:,.0f}")


KINDS = {function.__name__: function for function in (quality, adapt, ring, timing, scale, trade, confirm, picture, economy)}


def markdown_table(head, lines):
    rows = [head, ["---"] * len(head), *lines]
    return "\n".join("| " + " | ".join(cells) + " |" for cells in rows)


def markdown(report, typical=False):
    """All tables of a report."""
    tables_of = typical_quality if typical else KINDS[report["measured"]]
    return "\n\n".join(markdown_table(head, lines) for head, lines in tables_of(report))


def main(arguments):
    typical = "--typical" in arguments
    paths = [argument for argument in arguments if argument != "--typical"]
    if not paths:
        sys.exit(__doc__)
    reports = []
    for path in paths:
        try:
            measured = json.loads(Path(path).read_text()).get("measured")
            if measured not in KINDS or (typical and measured != "quality"):
                sys.exit(f"{path}: no report of `run bench` that has such tables")
            reports.append(load(path, measured))
        except (OSError, ValueError) as fault:
            sys.exit(f"{path}: {fault}")
    if typical:
        if len({(report["device"], report["commit"]) for report in reports}) > 1:
            sys.exit("these reports are of several devices or commits")
        reports = [{**reports[0], "parts": [part for report in reports for part in report["parts"]]}]
    for report in reports:
        print(f"{report['device']}, commit {report['commit']}\n\n{markdown(report, typical)}\n")


if __name__ == "__main__":
    main(sys.argv[1:])
