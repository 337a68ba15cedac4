# SPDX-License-Identifier: GPL-2.0-or-later
"""A writer of small binary glTF 2.0 files: quantised positions (KHR_mesh_quantization), optional
normals, one primitive per material, emission by KHR_materials_emissive_strength.

Input is in Quake space (z up); the file is y up: a point (x, y, z) is written as (x, z, -y). All
primitives share one quantisation box, undone by the node's scale and translation, so corners that
coincide between primitives still do.
"""

import json
import struct
from dataclasses import dataclass, field

import numpy as np

UNSIGNED_SHORT, SHORT, UNSIGNED_INT = 5123, 5122, 5125


@dataclass
class MeshMaterial:
    """Linear base colour; emission is linear radiance; roughness 1 and metal 0 mean diffuse."""

    name: str
    colour: tuple
    roughness: float = 1.0
    emission: tuple = (0.0, 0.0, 0.0)

    def json(self):
        out = {"name": self.name, "pbrMetallicRoughness": {
            "baseColorFactor": [*map(float, self.colour), 1.0], "metallicFactor": 0.0,
            "roughnessFactor": self.roughness}}
        peak = max(self.emission)
        if peak > 0:
            out["emissiveFactor"] = [round(e / peak, 4) for e in self.emission]
            out["extensions"] = {"KHR_materials_emissive_strength":
                                 {"emissiveStrength": round(float(peak), 4)}}
        return out


@dataclass
class Primitive:
    """Triangles of one material: positions (n, 3), triangles (m, 3), optional normals (n, 3)."""

    material: MeshMaterial
    positions: np.ndarray
    triangles: np.ndarray
    normals: np.ndarray = field(default=None)


class Buffer:
    """The binary chunk with its views and accessors."""

    def __init__(self):
        self.data = bytearray()
        self.views = []
        self.accessors = []

    def add(self, array, kind, component, normalized=False, stride=None, target=34962, **extra):
        self.views.append({"buffer": 0, "byteOffset": len(self.data),
                           "byteLength": array.nbytes, "target": target,
                           **({"byteStride": stride} if stride else {})})
        self.accessors.append({"bufferView": len(self.views) - 1, "componentType": component,
                               "count": len(array), "type": kind,
                               **({"normalized": True} if normalized else {}), **extra})
        self.data += array.tobytes()
        self.data += bytes(-len(self.data) % 4)
        return len(self.accessors) - 1


def y_up(v):
    return np.column_stack([v[:, 0], v[:, 2], -v[:, 1]])


def write_glb(path, primitives, name):
    """Writes the mesh; raises ValueError for a primitive without triangles."""
    points = y_up(np.concatenate([p.positions for p in primitives]))
    low = points.min(axis=0)
    extent = np.maximum(points.max(axis=0) - low, 1e-6)
    buffer = Buffer()
    parts, materials, used = [], [], set()
    for p in primitives:
        if len(p.triangles) == 0:
            raise ValueError("a primitive of %s has no triangles" % name)
        q = np.round((y_up(p.positions) - low) / extent * 65535).astype("<u2")
        attributes = {"POSITION": buffer.add(
            padded(q), "VEC3", UNSIGNED_SHORT, True, 8,
            min=[int(c) for c in q.min(axis=0)], max=[int(c) for c in q.max(axis=0)])}
        used.add("KHR_mesh_quantization")
        if p.normals is not None:
            n = np.round(y_up(p.normals) * 32767).astype("<i2")
            attributes["NORMAL"] = buffer.add(padded(n), "VEC3", SHORT, True, 8)
        wide = len(p.positions) > 65535
        index = p.triangles.astype("<u4" if wide else "<u2").ravel()
        parts.append({"attributes": attributes, "material": len(materials),
                      "indices": buffer.add(index, "SCALAR",
                                            UNSIGNED_INT if wide else UNSIGNED_SHORT,
                                            target=34963)})
        materials.append(p.material.json())
        if "extensions" in materials[-1]:
            used.add("KHR_materials_emissive_strength")
    document = {
        "asset": {"version": "2.0", "generator": "Vigil content tools"},
        "extensionsUsed": sorted(used), "extensionsRequired": ["KHR_mesh_quantization"],
        "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"name": name, "mesh": 0, "translation": [round(float(c), 5) for c in low],
                   "scale": [round(float(c), 5) for c in extent]}],
        "meshes": [{"name": name, "primitives": parts}], "materials": materials,
        "buffers": [{"byteLength": len(buffer.data)}], "bufferViews": buffer.views,
        "accessors": buffer.accessors,
    }
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(buffer.data)))
        file.write(struct.pack("<I4s", len(text), b"JSON") + text)
        file.write(struct.pack("<I4s", len(buffer.data), b"BIN\0") + bytes(buffer.data))


def padded(array):
    """Three 16-bit components per vertex, padded to eight bytes."""
    return np.pad(array, ((0, 0), (0, 1)))


def smooth_normals(positions, triangles):
    """Area-weighted vertex normals."""
    a, b, c = (positions[triangles[:, i]] for i in range(3))
    face = np.cross(b - a, c - a)
    out = np.zeros_like(positions)
    for i in range(3):
        np.add.at(out, triangles[:, i], face)
    return out / np.maximum(np.linalg.norm(out, axis=1, keepdims=True), 1e-12)
