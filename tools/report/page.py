#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""One HTML page, with nothing beside it, of all experiments that `run bench` has measured: tables with intervals, plots, and,
of `quality --pictures`, the pictures themselves with maps of where they differ from the reference as a person would see it
(FLIP for high dynamic range, Andersson et al. 2021).

    python3 tools/report/page.py FOLDER                   # the reports in it; writes FOLDER/report.html
    python3 tools/report/page.py FOLDER --summary TARGET  # the same as small files: Markdown, plots, JSON

Needs what requirements.txt beside it lists; `./run report` brings it."""

import argparse
import base64
import html
import io
import json
import re
import sys
from pathlib import Path
from types import SimpleNamespace

import numpy
from matplotlib import pyplot

import adapt
import drawing
import pictures
import quality
import ring
import scale
import summary
import tables
import timing
import trade

# In the order of the page: what was measured, its title, its plots.
SECTIONS = (
    ("quality", "Error at one sample per pixel", quality),
    ("adapt", "From empty caches", adapt),
    ("ring", "A light that turns", ring),
    ("timing", "Time of a frame", timing),
    ("scale", "Lights, pixels and triangles", scale),
    ("trade", "What each variable costs and buys", trade),
    ("confirm", "What looked better, on fresh seeds", SimpleNamespace(draw=lambda report: ())),
    ("picture", "Filtered pictures", SimpleNamespace(draw=lambda report: ())),
    ("economy", "Features that a level lacks", SimpleNamespace(draw=lambda report: ())),
)

TABLES_TEXT = ("Ratios are over the baseline of their part. The first is that of the means, an estimate; the second is that of the typical run, with "
               "its 95% interval where there is one. Below 1 is better. Bold numbers are better than the baseline by more than chance.")

FLIP_TEXT = "FLIP: 0 (black) is no difference, 1 (light yellow) the largest that a person sees."

STYLE = """body{font:15px/1.45 sans-serif;margin:2em auto;max-width:75em;padding:0 1em;color:#222}
table{border-collapse:collapse;margin:1em 0}th,td{padding:.25em .7em;text-align:left;border-bottom:1px solid #ccc}
figure{display:inline-block;margin:.4em;vertical-align:top}figcaption{font-size:13px}img{max-width:100%}
.views img{width:20em;image-rendering:pixelated}.scale img{width:20em;height:1em}code{background:#eee}
dt{font-weight:bold}dd{margin:0 0 .4em 1.5em}"""

def image_tag(pixels, title):
    """A picture of values in [0, 1] inside the page."""
    buffer = io.BytesIO()
    pyplot.imsave(buffer, numpy.clip(pixels, 0.0, 1.0), format="png")
    data = base64.b64encode(buffer.getvalue()).decode()
    return f'<figure><img alt="{html.escape(title)}" src="data:image/png;base64,{data}"><figcaption>{html.escape(title)}</figcaption></figure>'


def picture_tags(views):
    """The HTML of the pictures of a part: of every row that of the first seed, and its map of FLIP."""
    parts = []
    for view in views:
        first = {label: runs[0] for label, runs in view.runs.items()}
        shown = [image_tag(view.displayed(view.reference), f"reference, {view.paths} paths")]
        shown += [image_tag(view.displayed(run.radiance), label) for label, run in first.items()]
        maps = [image_tag(run.flip_map, f"{label}: FLIP {run.flip:.3f}") for label, run in first.items()]
        parts.append(f'<h3>{html.escape(view.name)}</h3><div class="views">{"".join(shown)}</div>'
                     f'<div class="views">{"".join(maps)}</div>')
    return "".join(parts)


def flip_scale():
    """The colours of maps of FLIP, from 0 to 1, with their ends named."""
    colors = pyplot.get_cmap("magma")(numpy.tile(numpy.linspace(0.0, 1.0, 256), (12, 1)))[..., :3]
    return f'<div class="scale">{image_tag(colors, FLIP_TEXT)}</div>'


def table(head, lines):
    """A table whose cells may have the marks of Markdown for bold."""

    def shown(word):
        return re.sub(r"\*\*(.*?)\*\*", r"<b>\1</b>", html.escape(word))

    def cells(words, tag):
        return "".join(f"<{tag}>{shown(word)}</{tag}>" for word in words)

    return f"<table><tr>{cells(head, 'th')}</tr>" + "".join(f"<tr>{cells(line, 'td')}</tr>" for line in lines) + "</table>"


def figure_tag(name, figure):
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=110)
    pyplot.close(figure)
    data = base64.b64encode(buffer.getvalue()).decode()
    return f'<figure><img alt="{html.escape(name)}" src="data:image/png;base64,{data}"></figure>'


def measured_on(report):
    changed = ", ".join(f"{name} {value}" for name, value in report["variables"].items()) or "all at their defaults"
    state = "" if report["finished"] else " Not finished."
    return f"{report['device']}; commit {report['commit']}; {report['seeds']} seeds; variables: {changed}.{state}"


def section(title, report, plots):
    name = report["measured"]
    parts = [f'<h2 id="{name}">{title}</h2><p><code>run bench {name}</code>. {html.escape(measured_on(report))}</p>']
    parts += [figure_tag(name, figure) for name, figure in plots.draw(report)]
    parts += [table(head, lines) for head, lines in tables.KINDS[report["measured"]](report)]
    seen = pictures.of_report(report)
    if seen:
        parts += [table(*pictures.flip_table(seen)), flip_scale()]
    parts += [f"<h3>{html.escape(name)}</h3>{picture_tags(views)}" for name, views in seen.items()]
    return "".join(parts)


def slim(value):
    """A report without the times of single passes; the values behind intervals stay."""
    return tables.rounded(value, without=("pictures", "planned", "pass_ms"))


def write_summary(found, target):
    """README.md, a picture per plot and a small JSON per experiment."""
    target.mkdir(parents=True, exist_ok=True)
    reports = [report for _, _, _, report in found]
    lines = [f"# Measured on {' and '.join(summary.devices(reports))}", "", " ".join(summary.sentences(reports)), "",
             f"Written by `./run report --summary`. {TABLES_TEXT} [quality.md](../../research/quality.md) explains them."]
    for name, title, plots, report in found:
        figures = list(plots.draw(report))
        lines += ["", f"## {title}", "", f"`./run bench {name}`: {measured_on(report)}", ""]
        lines += [f"![{figure_name}]({figure_name}.png)" for figure_name, _ in figures]
        lines += ["", "[trade.md](../../research/trade.md) has the tables." if name == "trade" else tables.markdown(report)]
        drawing.save(figures, target)
        seen = pictures.of_report(report)
        if seen:
            lines += ["", tables.markdown_table(*pictures.flip_table(seen))]
        for part, views in seen.items():
            lines += ["", f"{part}, {views[0].name}: the middle of the reference ({views[0].paths} paths) and of one frame of each row; below, where "
                      f"a person would see the difference. {FLIP_TEXT}", "", f"![{part}](pictures_{part}.png)"]
            pictures.save_sheet(views[0], target / f"pictures_{part}.png")
        (target / f"{name}.json").write_text(json.dumps(slim(report), separators=(",", ":")) + "\n")
    (target / "README.md").write_text("\n".join(lines) + "\n")
    print(f"wrote {target / 'README.md'}")


def write_page(found, target):
    body = "".join(section(title, report, plots) for _, title, plots, report in found)
    said = " ".join(summary.sentences([report for _, _, _, report in found]))
    contents = "".join(f'<li><a href="#{name}">{html.escape(title)}</a></li>' for name, title, _, _ in found)
    words = "".join(f"<dt>{html.escape(word)}</dt><dd>{html.escape(meaning)}</dd>" for word, meaning in summary.GLOSSARY)
    text = (f'<!doctype html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">'
            f"<title>Vigil: measurements</title><style>{STYLE}</style>"
            f"<h1>Vigil: measurements</h1><p><b>{html.escape(said)}</b></p><ul>{contents}<li><a href=\"#glossary\">Glossary</a></li></ul>"
            f'<p>{TABLES_TEXT}</p>{body}<h2 id="glossary">Glossary</h2><dl>{words}</dl></html>\n')
    target.write_text(text)
    print(f"wrote {target} ({len(text) / 1e6:.1f} MB)")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path, nargs="?", default=Path("out"))
    parser.add_argument("--summary", type=Path, metavar="TARGET")
    arguments = parser.parse_args()
    found = []
    for name, title, plots in SECTIONS:
        path = arguments.folder / f"{name}.json"
        if path.is_file():
            try:
                found.append((name, title, plots, drawing.load(path, name)))
            except (OSError, ValueError) as fault:
                sys.exit(str(fault))
    if not found:
        sys.exit(f"{arguments.folder}: no reports of `run bench` ({', '.join(name for name, _, _ in SECTIONS)})")
    try:
        if arguments.summary:
            write_summary(found, arguments.summary)
        else:
            write_page(found, arguments.folder / "report.html")
    except (OSError, KeyError) as fault:
        sys.exit(f"{arguments.folder}: {fault}")


if __name__ == "__main__":
    main()
