# SPDX-License-Identifier: GPL-2.0-or-later
"""Any number of lamps for the hall of the `many` levels: where they hang, how bright, which colour.

Up to a thousand they are brushes (a face each); beyond, the format's 16-bit indices forbid that and
they become the triangles of a mesh, where every triangle is a lamp. The total power is the same for
every number, so pictures of different numbers compare.
"""

import numpy as np

from mesh_file import MeshMaterial, Primitive, write_glb

# Names of emissive textures, their linear colours and their share of the lamps.
COLOURS = [("lamp_warm", (1.0, .72, .42), .40), ("lamp_sodium", (1.0, .50, .16), .20),
           ("lamp_panel", (1.0, .90, .78), .16), ("lamp_cool", (.72, .86, 1.0), .10),
           ("lamp_blue", (.16, .36, 1.0), .05), ("lamp_green", (.12, 1.0, .28), .05),
           ("lamp_red", (1.0, .08, .04), .04)]
# Sum of radiance * area over all lamps, in map units squared.
TOTAL_POWER = 330000.0


def draw(count, places, rng):
    """Colour index and relative strength of each lamp: strengths spread over a factor of ten."""
    share = np.array([c[2] for c in COLOURS])
    colour = rng.choice(len(COLOURS), count, p=share / share.sum())
    strength = np.exp(rng.uniform(np.log(.32), np.log(3.2), count))
    return colour, strength * count / strength.sum()


def tetrahedra(places, size):
    """Corners and triangles of one small tetrahedron per place (n, 3), pointing down."""
    a = 2 * np.pi * np.arange(3) / 3
    base = np.column_stack([np.cos(a), np.sin(a), np.full(3, .5)])
    shape = np.vstack([base, [0, 0, -1.1]]) * size
    corners = (places[:, None] + shape).reshape(-1, 3)
    faces = np.array([[0, 1, 2], [1, 0, 3], [2, 1, 3], [0, 2, 3]])
    triangles = (faces + 4 * np.arange(len(places))[:, None, None]).reshape(-1, 3)
    return corners, triangles


def write_mesh(path, places, rng):
    """Writes lamps of four triangles at places; one primitive per colour and strength step."""
    size = float(np.clip(1.6 * np.sqrt(2500 / len(places)), .9, 2.4))
    colour, strength = draw(len(places), places, rng)
    step = np.clip(np.round(np.log2(strength)), -2, 1).astype(int)
    corners, triangles = tetrahedra(places[:1], size)
    a, b, c = (corners[triangles[:, k]] for k in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2
    unit = TOTAL_POWER / (area * np.sum(2.0 ** step))
    parts = []
    for i, (name, rgb, _) in enumerate(COLOURS):
        for s in sorted(set(step)):
            chosen = places[(colour == i) & (step == s)]
            for at in range(0, len(chosen), 16000):
                corners, triangles = tetrahedra(chosen[at:at + 16000], size)
                radiance = np.array(rgb) * unit * 2.0 ** s
                material = MeshMaterial("%s_%d" % (name, s), rgb, 1.0, tuple(radiance))
                parts.append(Primitive(material, corners, triangles))
    write_glb(path, parts, "lamps")
    return sum(len(p.triangles) for p in parts)
