# SPDX-License-Identifier: GPL-2.0-or-later
"""The three sentences that a page of reports begins with, and its glossary. Sentences say what the reports say, whatever that is."""

import tables

# In the order in which the page needs them.
GLOSSARY = (
    ("BRDF", "How a surface reflects light. Rays by the BRDF are drawn in proportion to it."),
    ("sll", "Static Light Lists: the lights that the room may see, weighed at each draw. The technique of Quake II RTX."),
    ("lh", "Light Hierarchy: a tree over all lights. It knows no walls."),
    ("vlc", "Visibility Light Cache: the lights that samples of the last frames have seen nearby."),
    ("ris, uniform, power", "Lights of the whole level: weighed, equally often, in proportion to their power."),
    ("+cdq", "Rays guided by Compressed Directional Quadtrees: towards directions from which light came."),
    ("MSE", "Mean squared error against a reference, the mean of very many paths."),
    ("trimmed MSE", "The same without the worst 0.1% of the pixels."),
    ("relative MSE", "Squared error over squared brightness: dark places count as much as bright ones."),
    ("equal samples, equal time", "The error at one path per pixel; the same times the time of a frame."),
    ("typical run", "The median over all runs."),
    ("preparation", "The passes that make octree, caches and quadtrees."),
    ("FLIP", "The difference that a person sees, from 0 to 1."),
    ("front", "The values that nothing else beats in both time and error."),
    ("?", "The data do not give the number."),
)


def ratios(report, label, measure, ratio):
    """Level and ratio of a row's measure, of the levels that have one, the least first."""
    found = [(row[measure][ratio]["value"], part["level"]) for part in report["parts"] for row in part["rows"] if row["label"] == label]
    return sorted((value, level) for value, level in found if value is not None)


def range_of(found):
    (least, first), (most, last) = found[0], found[-1]
    if first == last:
        return f"{tables.number(least)} ({first})"
    return f"{tables.number(least)} ({first}) to {tables.number(most)} ({last})"


def devices(reports):
    """Their names, without versions."""
    return sorted({report["device"].split(",")[0].split(" (")[0] for report in reports})


def sentences(reports):
    """What was measured, how good it is, what it costs."""
    by_name = {report["measured"]: report for report in reports}
    by_commit = {}
    for report in reports:
        by_commit.setdefault(report["commit"], []).append(report["measured"])
    commits = next(iter(by_commit), "")
    if len(by_commit) > 1:
        commits = "; ".join(f"{commit} ({', '.join(names)})" for commit, names in by_commit.items())
    said = [f"This page has {len(reports)} experiment{'s' * (len(reports) != 1)} of commit{'s' * (len(by_commit) != 1)} {commits} "
            f"on {', '.join(devices(reports))}."]
    quality = by_name.get("quality")
    errors = ratios(quality, "vlc", "trimmed_mse", "ratio_at_equal_time") if quality else []
    if errors:
        said.append(f"At equal time the trimmed error of light caches (vlc) is {range_of(errors)} of that of light lists (sll); below 1 is better.")
    else:
        said.append("Nothing in it compares light caches (vlc) with light lists (sll) at equal time.")
    times = ratios(quality, "vlc", "frame_ms", "ratio") if quality else []
    if times:
        said.append(f"A frame with vlc takes {range_of(times)} of the time with sll.")
    else:
        said.append("Nothing in it compares the times of their frames.")
    return said
