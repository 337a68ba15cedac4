# SPDX-License-Identifier: GPL-2.0-or-later
"""A reader of compiled levels (IBSP 38), for checking what the compiler made of a .map.

It trusts its input: the files come from the compiler a moment ago. Layouts are those of the
Quake II file format; visibility rows are run-length coded zeros.
"""

import re

import numpy as np

from material import LIGHT, SOLID, WINDOW

PLANE = np.dtype([("normal", "<f4", 3), ("dist", "<f4"), ("type", "<i4")])
TEXINFO = np.dtype([("vecs", "<f4", (2, 4)), ("flags", "<i4"), ("value", "<i4"),
                    ("texture", "S32"), ("next", "<i4")])
FACE = np.dtype([("plane", "<u2"), ("side", "<i2"), ("firstedge", "<i4"), ("numedges", "<i2"),
                 ("texinfo", "<i2"), ("styles", "u1", 4), ("lightofs", "<i4")])
LEAF = np.dtype([("contents", "<i4"), ("cluster", "<i2"), ("area", "<i2"), ("mins", "<i2", 3),
                 ("maxs", "<i2", 3), ("firstface", "<u2"), ("numfaces", "<u2"),
                 ("firstbrush", "<u2"), ("numbrushes", "<u2")])
NODE = np.dtype([("plane", "<i4"), ("children", "<i4", 2), ("mins", "<i2", 3),
                 ("maxs", "<i2", 3), ("firstface", "<u2"), ("numfaces", "<u2")])
MODEL = np.dtype([("mins", "<f4", 3), ("maxs", "<f4", 3), ("origin", "<f4", 3),
                  ("headnode", "<i4"), ("firstface", "<i4"), ("numfaces", "<i4")])
BRUSH = np.dtype([("firstside", "<i4"), ("numsides", "<i4"), ("contents", "<i4")])
BRUSH_SIDE = np.dtype([("plane", "<u2"), ("texinfo", "<i2")])


class Bsp:
    """The lumps of a level as numpy arrays."""

    def __init__(self, path):
        data = path.read_bytes()
        head = np.frombuffer(data, "<i4", 40)
        if data[:4] != b"IBSP" or head[1] != 38:
            raise ValueError("%s is not an IBSP 38 file" % path)

        def lump(index, kind):
            offset, size = head[2 + 2 * index], head[3 + 2 * index]
            raw = data[offset:offset + size]
            return raw if kind is bytes else np.frombuffer(raw, kind)

        self.size = len(data)
        self.entities = parse_entities(lump(0, bytes).rstrip(b"\0").decode("latin-1"))
        self.planes = lump(1, PLANE)
        self.vertices = lump(2, "<f4").reshape(-1, 3)
        self.vis = lump(3, bytes)
        self.nodes = lump(4, NODE)
        self.texinfo = lump(5, TEXINFO)
        self.faces = lump(6, FACE)
        self.leafs = lump(8, LEAF)
        self.leaf_faces = lump(9, "<u2")
        self.edges = lump(11, "<u2").reshape(-1, 2)
        self.surfedges = lump(12, "<i4")
        self.models = lump(13, MODEL)
        self.brushes = lump(14, BRUSH)
        self.brush_sides = lump(15, BRUSH_SIDE)
        self.leaf_brushes = lump(10, "<u2")

    def polygon(self, face):
        """The corners of a face, (n, 3)."""
        first, count = face["firstedge"], face["numedges"]
        edges = self.surfedges[first:first + count]
        index = np.where(edges >= 0, self.edges[np.abs(edges), 0], self.edges[np.abs(edges), 1])
        return self.vertices[index]

    def emissive(self):
        """Indices of faces that emit light."""
        info = self.texinfo[self.faces["texinfo"]]
        return np.flatnonzero((info["flags"] & LIGHT != 0) & (info["value"] > 0))

    def clusters(self):
        """The number of clusters, as the vis lump says; 0 without one."""
        return int(np.frombuffer(self.vis, "<i4", 1)[0]) if self.vis else 0

    def visible(self, cluster):
        """The clusters that a cluster can see, as a boolean array."""
        count = self.clusters()
        at = int(np.frombuffer(self.vis, "<i4", 2 * count, 4)[2 * cluster])
        row = bytearray()
        while len(row) < (count + 7) // 8:
            if self.vis[at]:
                row.append(self.vis[at])
                at += 1
            else:
                row += bytes(self.vis[at + 1])
                at += 2
        bits = np.unpackbits(np.frombuffer(bytes(row), "u1"), bitorder="little")
        return bits[:count].astype(bool)

    def lights_by_cluster(self):
        """For each cluster the number of emissive world faces in its PVS."""
        count = self.clusters()
        world = self.models[0]
        lamps = {int(f) for f in self.emissive() if f < world["firstface"] + world["numfaces"]}
        own = [set() for _ in range(count)]
        for leaf in self.leafs:
            if leaf["cluster"] >= 0:
                first = leaf["firstface"]
                faces = self.leaf_faces[first:first + leaf["numfaces"]]
                own[leaf["cluster"]] |= lamps.intersection(faces.tolist())
        return np.array([len(set().union(*(own[c] for c in np.flatnonzero(self.visible(k)))))
                         for k in range(count)])

    def leafs_at(self, points):
        """The world's leaf that each point (n, 3) lies in, as indices."""
        at = np.full(len(points), int(self.models[0]["headnode"]))
        while np.any(at >= 0):
            inner = np.flatnonzero(at >= 0)
            node = self.nodes[at[inner]]
            plane = self.planes[node["plane"]]
            front = np.sum(points[inner] * plane["normal"], axis=1) >= plane["dist"]
            at[inner] = np.where(front, node["children"][:, 0], node["children"][:, 1])
        return -1 - at

    def blocking_planes(self):
        """Planes of the world's solid and window brushes: (planes, first index of each brush)."""
        wanted = np.zeros(len(self.brushes), bool)
        stack = [int(self.models[0]["headnode"])]
        while stack:
            node = stack.pop()
            if node >= 0:
                stack += self.nodes[node]["children"].tolist()
                continue
            leaf = self.leafs[-1 - node]
            first = leaf["firstbrush"]
            wanted[self.leaf_brushes[first:first + leaf["numbrushes"]]] = True
        planes, starts = [], []
        for brush in self.brushes[wanted]:
            if brush["contents"] & (SOLID | WINDOW):
                starts.append(len(planes))
                first = brush["firstside"]
                for side in self.brush_sides[first:first + brush["numsides"]]:
                    plane = self.planes[side["plane"]]
                    planes.append([*plane["normal"], plane["dist"]])
        return np.array(planes), np.array(starts)


def parse_entities(text):
    """The entity lump as a list of dictionaries."""
    return [dict(re.findall(r'"([^"]*)"\s+"([^"]*)"', block))
            for block in re.findall(r"\{([^}]*)\}", text)]


def clearance(planes, starts, points):
    """Distance from each point to the nearest brush, or less (it measures to the brush's planes,
    so it is exact at faces and too small beside edges)."""
    out = np.empty(len(points))
    for i, point in enumerate(points):
        away = planes[:, :3] @ point - planes[:, 3]
        out[i] = np.maximum.reduceat(away, starts).min()
    return out
