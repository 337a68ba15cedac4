# SPDX-License-Identifier: GPL-2.0-or-later
"""One colour per technique in all plots (Okabe and Ito 2008: told apart without red and green). Guided rays have the colour of their
technique with other lines and marks."""

import zlib

COLORS = {
    "sll": "#0072B2",
    "lh": "#009E73",
    "vlc": "#D55E00",
    "ris": "#CC79A7",
    "uniform": "#999999",
    "power": "#8C6D31",
    "brute": "#000000",
    "brdf": "#555555",
    "cdq": "#56B4E9",
    "lobe": "#7A68A6",
    "preset": "#E69F00",
}
# Rows that are none of these: variants with names of their own.
OTHERS = ("#4E79A7", "#B07AA1", "#9C755F", "#EDC948", "#76B7B2")


def family(label):
    """The technique of a row's label: "vlc" of "vlc+cdq", "cdq" of "cdq128", "preset" of "preset fast"."""
    name = label.split("+")[0].split()[0]
    return name.rstrip("0123456789") if name.rstrip("0123456789") in COLORS else name


def color_of(label):
    name = family(label)
    return COLORS.get(name) or OTHERS[zlib.crc32(name.encode()) % len(OTHERS)]


def line_of(label):
    return "--" if "+" in label else "-"


def marker_of(label):
    return "s" if "+cdq" in label else "^" if "+lobe" in label else "D" if label.startswith("preset") else "o"
