# SPDX-License-Identifier: GPL-2.0-or-later
"""Reads what `exportscene` wrote, by docs/internals/export.md alone: surfaces in world space with their look, sun, sky and camera.
It knows nothing of Mitsuba, and of glTF only what that page names; pictures stay files."""

import json
from dataclasses import dataclass, field
from pathlib import Path
from urllib.parse import unquote

import numpy as np

COMPONENTS = {5125: np.uint32, 5126: np.float32}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}


@dataclass
class Material:
    """One look; colours linear, radiance in Vigil's unit."""
    color: np.ndarray
    texture: Path | None
    radiance: np.ndarray
    coverage: float
    f0: float       # GGX reflectance at normal incidence; 0: Lambertian
    roughness: float


@dataclass
class Surface:
    """All triangles of one material: corners (n, 3, 3) in glTF's axes, counter-clockwise from the front."""
    material: Material
    corners: np.ndarray
    uvs: np.ndarray  # (n, 3, 2), v down


@dataclass
class Scene:
    surfaces: list[Surface]
    sky_faces: np.ndarray            # (n, 3, 3): where rays meet the sky, whatever lies behind
    sky_radiance: np.ndarray | None  # the same in all directions
    sky_panorama: Path | None
    sun_direction: np.ndarray | None  # unit, towards the sun
    sun_irradiance: np.ndarray | None
    sun_diameter: float               # degrees
    camera: np.ndarray                # 4 x 4, looks along its -z
    vertical_fov: float               # radians
    aspect: float
    counts: dict = field(default_factory=dict)


class Reader:
    def __init__(self, path):
        self.path = Path(path)
        self.json = json.loads(self.path.read_text())
        buffers = self.json.get("buffers", [])
        self.bytes = (self.path.parent / unquote(buffers[0]["uri"])).read_bytes() if buffers else b""
        self.materials = [self.material(m) for m in self.json.get("materials", [])]

    def accessor(self, index):
        accessor = self.json["accessors"][index]
        view = self.json["bufferViews"][accessor["bufferView"]]
        width = WIDTHS[accessor["type"]]
        dtype = np.dtype(COMPONENTS[accessor["componentType"]])
        if view.get("byteStride", width * dtype.itemsize) != width * dtype.itemsize:
            raise ValueError("interleaved vertices")
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        values = np.frombuffer(self.bytes, dtype, accessor["count"] * width, start)
        return values.reshape(-1, width) if width > 1 else values

    def material(self, source):
        look = source["pbrMetallicRoughness"]
        extensions = source.get("extensions", {})
        factor = np.array(look.get("baseColorFactor", [1, 1, 1, 1]), float)
        texture = None
        if "baseColorTexture" in look:
            image = self.json["textures"][look["baseColorTexture"]["index"]]["source"]
            texture = self.path.parent / unquote(self.json["images"][image]["uri"])
        ior = extensions.get("KHR_materials_ior", {}).get("ior", 1.5)
        f0 = ((ior - 1) / (ior + 1))**2 * extensions.get("KHR_materials_specular", {}).get("specularFactor", 1)
        strength = extensions.get("KHR_materials_emissive_strength", {}).get("emissiveStrength", 1)
        return Material(color=factor[:3], texture=texture,
                        radiance=strength * np.array(source.get("emissiveFactor", [0, 0, 0]), float),
                        coverage=factor[3] if source.get("alphaMode") == "BLEND" else 1.0,
                        f0=f0, roughness=look.get("roughnessFactor", 1.0))

    def triangles(self, primitive, matrix):
        positions = self.accessor(primitive["attributes"]["POSITION"]).astype(float)
        order = self.accessor(primitive["indices"])
        places = positions @ matrix[:3, :3].T + matrix[:3, 3]
        uvs = np.zeros((len(positions), 2))
        if "TEXCOORD_0" in primitive["attributes"]:
            uvs = self.accessor(primitive["attributes"]["TEXCOORD_0"]).astype(float)
        corners, uvs = places[order].reshape(-1, 3, 3), uvs[order].reshape(-1, 3, 2)
        if np.linalg.det(matrix[:3, :3]) < 0:  # a mirrored node keeps its front (glTF 2.0, 3.7.4)
            corners, uvs = corners[:, ::-1], uvs[:, ::-1]
        return corners, uvs

    def read(self):
        source = self.json["scenes"][self.json["scene"]]
        sky = source.get("extras", {}).get("vigil_sky", {})
        scene = Scene(surfaces=[], sky_faces=np.zeros((0, 3, 3)),
                      sky_radiance=np.array(sky["radiance"], float) if "radiance" in sky else None,
                      sky_panorama=self.path.parent / unquote(sky["panorama"]) if "panorama" in sky else None,
                      sun_direction=None, sun_irradiance=None, sun_diameter=0.0,
                      camera=None, vertical_fov=0.0, aspect=1.0)
        by_material = {}
        top = np.eye(4)
        for node in source["nodes"]:
            self.visit(node, np.eye(4), by_material, scene)
            top = local_matrix(self.json["nodes"][node])
        for index, parts in sorted(by_material.items()):
            scene.surfaces.append(Surface(self.materials[index],
                                          np.concatenate([p[0] for p in parts]),
                                          np.concatenate([p[1] for p in parts])))
        if "faces" in sky:  # a mesh that no node places: in the level's coordinates
            parts = [self.triangles(p, top)[0] for p in self.json["meshes"][sky["faces"]]["primitives"]]
            scene.sky_faces = np.concatenate(parts)
        scene.counts = {"triangles": sum(len(s.corners) for s in scene.surfaces),
                        "sky triangles": len(scene.sky_faces), "surfaces": len(scene.surfaces)}
        return scene

    def visit(self, index, above, by_material, scene):
        node = self.json["nodes"][index]
        matrix = above @ local_matrix(node)
        if "mesh" in node:
            for primitive in self.json["meshes"][node["mesh"]]["primitives"]:
                by_material.setdefault(primitive["material"], []).append(self.triangles(primitive, matrix))
        if "camera" in node:
            view = self.json["cameras"][node["camera"]]["perspective"]
            scene.camera, scene.vertical_fov, scene.aspect = matrix, view["yfov"], view["aspectRatio"]
        if "KHR_lights_punctual" in node.get("extensions", {}):
            light = self.json["extensions"]["KHR_lights_punctual"]["lights"][
                node["extensions"]["KHR_lights_punctual"]["light"]]
            scene.sun_direction = matrix[:3, 2] / np.linalg.norm(matrix[:3, 2])
            scene.sun_irradiance = light["intensity"] * np.array(light["color"], float)
            scene.sun_diameter = light["extras"]["angular_diameter_degrees"]
        for child in node.get("children", []):
            self.visit(child, matrix, by_material, scene)


def local_matrix(node):
    """A node's 4 x 4 transform: from its matrix, or from its rotation."""
    if "matrix" in node:
        return np.array(node["matrix"], float).reshape(4, 4).T
    matrix = np.eye(4)
    x, y, z, w = node.get("rotation", [0, 0, 0, 1])
    matrix[:3, :3] = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                      [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                      [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    return matrix


def read_gltf(path):
    """The scene with the camera at the origin: numbers near 0 keep their digits."""
    scene = Reader(path).read()
    eye = scene.camera[:3, 3].copy()
    for surface in scene.surfaces:
        surface.corners = surface.corners - eye
    scene.sky_faces = scene.sky_faces - eye
    scene.camera[:3, 3] = 0
    return scene
