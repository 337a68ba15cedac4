#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Draws what docs/learn/glossary.md explains: octree, buckets and quadtree, as SVG in docs/images. Needs nothing but Python.

    python3 tools/docs/drawings.py            # the same every time
"""

import random
from pathlib import Path

IMAGES = Path(__file__).resolve().parents[2] / "docs" / "images"
INK, FAINT, ACCENT, FILL = "#222", "#999", "#c2410c", "#dbeafe"


def page(width, height, parts):
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
            f'font-family="sans-serif" font-size="13">\n<rect width="{width}" height="{height}" fill="#fff"/>\n' + "\n".join(parts) + "\n</svg>\n")


def rect(x, y, w, h, fill="none", stroke=INK, width=1.0):
    return f'<rect x="{x:.1f}" y="{y:.1f}" width="{w:.1f}" height="{h:.1f}" fill="{fill}" stroke="{stroke}" stroke-width="{width}"/>'


def text(x, y, words, anchor="middle", color=INK):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{color}">{words}</text>'


def arrow(x0, x1, y):
    return f'<path d="M{x0} {y}H{x1 - 5}" stroke="{FAINT}" stroke-width="2"/><path d="M{x1 - 7} {y - 5}L{x1} {y}L{x1 - 7} {y + 5}z" fill="{FAINT}"/>'


def cells(points, x, y, size, most, depth, inside):
    """Quarters of a square that holds more than `most` of the points, down to a depth: (x, y, size, points)."""
    here = [point for point in points if inside(point, x, y, size)]
    if len(here) <= most or depth == 0:
        return [(x, y, size, here)]
    half = size / 2
    return [cell for dx in (0, half) for dy in (0, half) for cell in cells(here, x + dx, y + dy, half, most, depth - 1, inside)]


def within(point, x, y, size):
    return x <= point[0] < x + size and y <= point[1] < y + size


def octree():
    """A room from above; samples lie on its walls, most of them where the camera looks."""
    dice = random.Random(7)
    walls = [(10, 15, 250, 15, 30), (250, 15, 250, 105, 60), (250, 105, 160, 105, 45), (160, 105, 160, 245, 8), (10, 245, 160, 245, 6), (10, 15, 10, 245, 12)]
    points = []
    for x0, y0, x1, y1, count in walls:
        for _ in range(count):
            t = dice.random()
            points.append((x0 + t * (x1 - x0), y0 + t * (y1 - y0)))
    parts = [rect(x + 10, y + 10, size, size, FILL if here else "none", FAINT) for x, y, size, here in cells(points, 0, 0, 260, 9, 5, within)]
    parts += [f'<path d="M{x0 + 10} {y0 + 10}L{x1 + 10} {y1 + 10}" stroke="{INK}" stroke-width="2"/>' for x0, y0, x1, y1, _ in walls]
    parts += [f'<circle cx="{x + 10:.1f}" cy="{y + 10:.1f}" r="2" fill="{ACCENT}"/>' for x, y in points]
    parts += [text(290, 40, "dots: samples on walls", "start"), text(290, 62, "squares: leaves of the octree", "start"),
              text(290, 84, "blue: leaves with samples;", "start"), text(290, 106, "each has a cache and a quadtree", "start")]
    return page(540, 280, parts)


def buckets():
    """Lights by number, entered into four buckets, merged into two; one bucket is drawn, then one light."""
    lights = [1, 2, 5, 6, 7, 11]
    parts = []

    def column(x, count, title):
        parts.append(text(x + 50, 24, title))
        for bucket in range(count):
            top = 40 + bucket * 44
            parts.append(rect(x, top, 100, 36, FILL if count < 4 and bucket == 1 else "none"))
            for place, light in enumerate(light for light in lights if light % count == bucket):
                chosen = count == 2 and light == 7
                parts.append(f'<circle cx="{x + 16 + 23 * place}" cy="{top + 18}" r="10" fill="{ACCENT if chosen else "#fff"}" stroke="{INK}"/>')
                parts.append(text(x + 16 + 23 * place, top + 22.5, light, color="#fff" if chosen else INK))

    parts.append(text(62, 24, "lights seen"))
    for place, light in enumerate(lights):
        parts.append(f'<circle cx="{30 + place % 3 * 30}" cy="{70 + place // 3 * 34}" r="10" fill="#fff" stroke="{INK}"/>')
        parts.append(text(30 + place % 3 * 30, 74.5 + place // 3 * 34, light))
    parts.append(arrow(125, 165, 86))
    column(175, 4, "number modulo 4")
    parts.append(arrow(285, 325, 86))
    column(335, 2, "modulo 2: still fits")
    parts += [arrow(445, 485, 103), text(495, 98, "one bucket by chance,", "start"), text(495, 116, "one light by importance", "start", ACCENT)]
    return page(660, 225, parts)


def quadtree():
    """Directions of light as dots on the octahedral square, and the leaves that they make; beside it where rays go."""
    dice = random.Random(3)
    light = [(150 + dice.gauss(0, 9), 75 + dice.gauss(0, 9)) for _ in range(60)] + [(dice.uniform(0, 220), dice.uniform(0, 220)) for _ in range(14)]
    light = [(min(max(x, 0), 219), min(max(y, 0), 219)) for x, y in light]
    leaves = cells(light, 0, 0, 220, 7, 5, within)
    parts = [text(120, 20, "light arrives"), text(380, 20, "rays: equally many in each leaf")]
    for left in (10, 270):
        parts += [rect(x + left, y + 30, size, size, "none", FAINT if left == 10 else INK, 0.7) for x, y, size, _ in leaves]
        middle, edge = left + 110, 140
        parts.append(f'<path d="M{middle} {edge - 110}L{middle + 110} {edge}L{middle} {edge + 110}L{middle - 110} {edge}z" fill="none" '
                     f'stroke="{FAINT}" stroke-dasharray="4 3"/>')
    parts += [f'<circle cx="{x + 10:.1f}" cy="{y + 30:.1f}" r="2" fill="{ACCENT}"/>' for x, y in light]
    for x, y, size, _ in leaves:
        for _ in range(2):
            parts.append(f'<circle cx="{270 + x + dice.random() * size:.1f}" cy="{30 + y + dice.random() * size:.1f}" r="1.6" fill="#1d4ed8"/>')
    parts += [text(120, 270, "dashed: the horizon"), text(380, 270, "small leaves get them densely")]
    return page(500, 285, parts)


def main():
    for draw in (octree, buckets, quadtree):
        path = IMAGES / f"{draw.__name__}.svg"
        path.write_text(draw())
        print(path)


if __name__ == "__main__":
    main()
