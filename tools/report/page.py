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
import sys
from pathlib import Path

import flip_evaluator
import numpy
import OpenEXR
from matplotlib import pyplot
from scipy import stats

import adapt
import drawing
import quality
import ring
import scale
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
)

STYLE = """body{font:15px/1.45 sans-serif;margin:2em auto;max-width:75em;padding:0 1em;color:#222}
table{border-collapse:collapse;margin:1em 0}th,td{padding:.25em .7em;text-align:left;border-bottom:1px solid #ccc}
figure{display:inline-block;margin:.4em;vertical-align:top}figcaption{font-size:13px}img{max-width:100%}
.views img{width:20em;image-rendering:pixelated}code{background:#eee}"""

def mean_interval(strata):
    """Mean of the views' means over [view][seed] and its 95% interval about other seeds, as docs/quality.md has it: Student's t
    with the degrees of freedom of Welch and Satterthwaite."""
    views = [numpy.asarray(view, dtype=float) for view in strata]
    mean = float(numpy.mean([view.mean() for view in views]))
    if any(len(view) < 2 for view in views):
        return {"value": mean, "low": None, "high": None}
    parts = [view.var(ddof=1) / len(view) / len(views) ** 2 for view in views]
    variance = sum(parts)
    if variance == 0:
        return {"value": mean, "low": mean, "high": mean}
    freedom = variance**2 / sum(part**2 / (len(view) - 1) for part, view in zip(parts, views))
    half = stats.t.ppf(0.975, freedom) * variance**0.5
    return {"value": mean, "low": mean - half, "high": mean + half}


def load(path):
    with OpenEXR.File(str(path)) as file:
        channels = file.channels()
        if "RGB" in channels:
            return numpy.ascontiguousarray(channels["RGB"].pixels, dtype=numpy.float32)
        return numpy.stack([channels[name].pixels for name in "RGB"], axis=-1).astype(numpy.float32)


def image_tag(pixels, title):
    """A picture of values in [0, 1] inside the page."""
    buffer = io.BytesIO()
    pyplot.imsave(buffer, numpy.clip(pixels, 0.0, 1.0), format="png")
    data = base64.b64encode(buffer.getvalue()).decode()
    return f'<figure><img alt="{html.escape(title)}" src="data:image/png;base64,{data}"><figcaption>{html.escape(title)}</figcaption></figure>'


def displayed(radiance, exposure):
    """Linear radiance as it is shown: x / (1 + x), in sRGB."""
    value = radiance * exposure
    value = value / (1.0 + value)
    return numpy.where(value <= 0.0031308, 12.92 * value, 1.055 * value ** (1 / 2.4) - 0.055)


def flip(reference, picture):
    """Map of the difference in colours, and its mean."""
    colours, mean, _ = flip_evaluator.evaluate(reference, picture, "HDR")
    return colours, mean


def views_of(part):
    """FLIP of all runs of a part by row, [view][seed], and the HTML of the pictures."""
    by_row = {row["label"]: [] for row in part["rows"]}
    parts = []
    for view in part["views"]:
        folder = Path(view["pictures"])
        reference = load(folder / "reference.exr")
        exposure = 0.5 / max(float(numpy.median(reference.mean(axis=-1))), 1e-6)
        shown = [image_tag(displayed(reference, exposure), f"reference, {view['reference']['paths']} paths")]
        maps = []
        for label, found in by_row.items():
            found.append([])
            for seed in range(1, part["seeds"] + 1):
                picture = load(folder / f"{label.replace('/', '_')}_{seed}.exr")
                colours, mean = flip(reference, picture)
                found[-1].append(mean)
                if seed == 1:
                    shown.append(image_tag(displayed(picture, exposure), label))
                    maps.append(image_tag(colours, f"{label}: FLIP {mean:.3f}"))
        parts.append(f'<h3>{html.escape(view["name"])}</h3><div class="views">{"".join(shown)}</div>'
                     f'<div class="views">{"".join(maps)}</div>')
    return by_row, "".join(parts)


def flip_table(flips):
    """Mean FLIP by row as HTML."""
    cells = "".join(f"<tr><td>{html.escape(label)}</td><td>{tables.plain(mean_interval(values))}</td></tr>"
                    for label, values in flips.items())
    return f"<table><tr><th></th><th>mean FLIP</th></tr>{cells}</table>"


def table(head, lines):
    def cells(words, tag):
        return "".join(f"<{tag}>{html.escape(word.replace('**', ''))}</{tag}>" for word in words)

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
    parts = [f"<h2>{title}</h2><p><code>run bench {report['measured']}</code>. {html.escape(measured_on(report))}</p>"]
    parts += [figure_tag(name, figure) for name, figure in plots.draw(report)]
    parts += [table(head, lines) for head, lines in tables.KINDS[report["measured"]](report)]
    if report["measured"] == "quality":
        for part in report["parts"]:
            if all("pictures" in view for view in part["views"]):
                flips, pictures = views_of(part)
                parts.append(f"<h3>{html.escape(part['part'])}: pictures</h3>{flip_table(flips)}{pictures}")
    return "".join(parts)


def slim(value):
    """A report without the single values behind its intervals."""
    if isinstance(value, dict):
        drop = ("by_view_and_seed", "by_seed", "pictures", "planned", "pass_ms")
        return {key: slim(inner) for key, inner in value.items() if key not in drop}
    if isinstance(value, list):
        return [slim(inner) for inner in value]
    return float(f"{value:.4g}") if isinstance(value, float) else value


def write_summary(found, target):
    """README.md, a picture per plot and a small JSON per experiment."""
    target.mkdir(parents=True, exist_ok=True)
    lines = ["# What was measured", "", "Written by `./run report --summary`; ratios with 95% intervals, explained in "
             "[quality.md](../../quality.md)."]
    for name, title, plots, report in found:
        figures = list(plots.draw(report))
        lines += ["", f"## {title}", "", f"`./run bench {name}`: {measured_on(report)}", ""]
        lines += [f"![{figure_name}]({figure_name}.png)" for figure_name, _ in figures]
        lines += ["", tables.markdown(report)]
        drawing.save(figures, target)
        (target / f"{name}.json").write_text(json.dumps(slim(report), separators=(",", ":")) + "\n")
    (target / "README.md").write_text("\n".join(lines) + "\n")


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
    if arguments.summary:
        write_summary(found, arguments.summary)
        print(f"wrote {arguments.summary / 'README.md'}")
        return
    try:
        body = "".join(section(title, report, plots) for _, title, plots, report in found)
    except (OSError, KeyError) as fault:
        sys.exit(f"{arguments.folder}: {fault}")
    text = (f'<!doctype html><html lang="en"><meta charset="utf-8"><title>Vigil: measurements</title><style>{STYLE}</style>'
            f"<h1>Vigil: measurements</h1><p>Ratios are over the baseline of their part, with 95% intervals.</p>{body}</html>\n")
    target = arguments.folder / "report.html"
    target.write_text(text)
    print(f"wrote {target} ({len(text) / 1e6:.1f} MB)")


if __name__ == "__main__":
    main()
