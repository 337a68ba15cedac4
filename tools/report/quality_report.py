#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""One HTML page, with nothing beside it, from a report of `vigil_bench quality`: errors and times of every technique with their
intervals, as tables and plots; and, of a run with --pictures, the pictures themselves with maps of where they differ from the
reference as a person would see it (FLIP for high dynamic range, Andersson et al. 2021).

    python3 tools/report/quality_report.py out/quality.json [out/quality.html]

Needs what requirements.txt beside it lists; `./run report` brings it."""

import base64
import html
import io
import json
import sys
from pathlib import Path

import flip_evaluator
import matplotlib

matplotlib.use("Agg")
import numpy
import OpenEXR
from matplotlib import pyplot
from scipy import stats

from quality_table import cell, number

STYLE = """body{font:15px/1.45 sans-serif;margin:2em auto;max-width:75em;padding:0 1em;color:#222}
table{border-collapse:collapse;margin:1em 0}th,td{padding:.25em .7em;text-align:left;border-bottom:1px solid #ccc}
figure{display:inline-block;margin:.4em;vertical-align:top}figcaption{font-size:13px}img{max-width:100%}
.views img{width:20em;image-rendering:pixelated}code{background:#eee}"""

# Title, what to take from a row, what it says.
MEASURES = (
    ("MSE, equal samples", lambda row: row["mse"]["ratio"]),
    ("MSE, equal time", lambda row: row["mse"]["ratio_at_equal_time"]),
    ("trimmed, equal samples", lambda row: row["trimmed_mse"]["ratio"]),
    ("trimmed, equal time", lambda row: row["trimmed_mse"]["ratio_at_equal_time"]),
    ("relative MSE", lambda row: row["relative_mse"]["ratio"]),
    ("frame time", lambda row: row["frame_ms"]["ratio"]),
)


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


def views_of(level, seeds):
    """FLIP of all runs by row, [view][seed], and the HTML of the pictures."""
    by_row = {row["label"]: [] for row in level["rows"]}
    parts = []
    for view in level["views"]:
        folder = Path(view["pictures"])
        reference = load(folder / "reference.exr")
        exposure = 0.5 / max(float(numpy.median(reference.mean(axis=-1))), 1e-6)
        shown = [image_tag(displayed(reference, exposure), f"reference, {view['reference']['paths']} paths")]
        maps = []
        for label, found in by_row.items():
            found.append([])
            for seed in range(1, seeds + 1):
                picture = load(folder / f"{label.replace('/', '_')}_{seed}.exr")
                colours, mean = flip(reference, picture)
                found[-1].append(mean)
                if seed == 1:
                    shown.append(image_tag(displayed(picture, exposure), label))
                    maps.append(image_tag(colours, f"{label}: FLIP {mean:.3f}"))
        parts.append(f'<h3>{html.escape(view["name"])}</h3><div class="views">{"".join(shown)}</div>'
                     f'<div class="views">{"".join(maps)}</div>')
    return by_row, "".join(parts)


def table(level, flips, baseline):
    head = ["over " + baseline] + [title for title, _ in MEASURES] + (["mean FLIP"] if flips else [])
    lines = ["<tr>" + "".join(f"<th>{html.escape(word)}</th>" for word in head) + "</tr>"]
    for row in level["rows"]:
        cells = [cell(value_of(row)).replace("**", "") for _, value_of in MEASURES]
        if flips:
            interval = mean_interval(flips[row["label"]])
            cells.append(f"{number(interval['value'])} [{number(interval['low'])}, {number(interval['high'])}]")
        lines.append("<tr>" + "".join(f"<td>{html.escape(word)}</td>" for word in [row["label"], *cells]) + "</tr>")
    return "<table>" + "".join(lines) + "</table>"


def plot(level):
    """Error against time, with both intervals: what is further down and to the left is better."""
    figure, axes = pyplot.subplots(figsize=(6.5, 4), layout="constrained")
    for row in level["rows"]:
        time, error = row["frame_ms"]["ratio"], row["trimmed_mse"]["ratio"]
        spread = [[[value["value"] - value["low"]], [value["high"] - value["value"]]]
                  if value["low"] is not None and value["high"] is not None else None for value in (time, error)]
        axes.errorbar(time["value"], error["value"], xerr=spread[0], yerr=spread[1], marker="o", capsize=2, label=row["label"])
    # Where error times time is that of the baseline.
    low, high = axes.get_xlim()
    times = numpy.linspace(max(low, 1e-3), high, 100)
    axes.plot(times, 1 / times, color="gray", linestyle=":", linewidth=1)
    axes.set_yscale("log")
    axes.set_xlabel("frame time over the baseline's")
    axes.set_ylabel("trimmed MSE over the baseline's")
    axes.legend(fontsize=8)
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=110)
    pyplot.close(figure)
    data = base64.b64encode(buffer.getvalue()).decode()
    return f'<figure><img alt="error against time" src="data:image/png;base64,{data}"></figure>'


def page(report):
    changed = ", ".join(f"{name} {value}" for name, value in report["variables"].items()) or "all at their defaults"
    parts = [f"<h1>One sample per pixel</h1><p>{html.escape(report['device'])}; {report['width']} x {report['height']} pixels, "
             f"{report['seeds']} seeds. Variables: {html.escape(changed)}. Ratios over <code>{html.escape(report['baseline'])}</code> "
             "with 95% intervals; the dotted line joins what is as good at equal time.</p>"]
    for level in report["levels"]:
        flips, pictures = {}, ""
        if all("pictures" in view for view in level["views"]):
            flips, pictures = views_of(level, report["seeds"])
        parts.append(f"<h2>{html.escape(level['level'])}</h2>{table(level, flips, report['baseline'])}{plot(level)}{pictures}")
    return f'<!doctype html><html lang="en"><meta charset="utf-8"><title>Vigil: quality</title><style>{STYLE}</style>{"".join(parts)}</html>\n'


def main(arguments):
    if len(arguments) not in (1, 2):
        sys.exit(__doc__)
    source = Path(arguments[0])
    target = Path(arguments[1]) if len(arguments) > 1 else source.with_suffix(".html")
    try:
        report = json.loads(source.read_text())
        if report.get("measured") != "quality":
            sys.exit(f"{source}: not a report of `bench quality`")
        text = page(report)
        target.write_text(text)
    except (OSError, ValueError) as fault:
        sys.exit(f"{source}: {fault}")
    print(f"wrote {target} ({len(text) / 1e6:.1f} MB)")


if __name__ == "__main__":
    main(sys.argv[1:])
