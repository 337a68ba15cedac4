# SPDX-License-Identifier: GPL-2.0-or-later
"""An exported scene as a Mitsuba scene: one mesh per material, uniform area lights, the sky (with the sun, if asked) as one environment map.
Surfaces have one side and no normals of their own, as Vigil's. Call after mitsuba.set_variant."""

import mitsuba as mi
import numpy as np

import panorama


def stored_texels(linear):
    """What Vigil keeps of a texture: RGB with 9-bit mantissas and one exponent (EXT_texture_shared_exponent)."""
    largest = linear.max(-1, keepdims=True)
    _, exponent = np.frexp(largest)
    step = np.ldexp(1.0, np.maximum(exponent, -15) - 9)
    step = np.where(np.floor(largest / step + 0.5) >= 512, 2 * step, step)
    return np.floor(linear / step + 0.5) * step


def texture(material, exact):
    """A reflectance. `exact`: the 8-bit picture as it is in the file, not rounded as Vigil's own copy."""
    if material.texture is None:
        return {"type": "rgb", "value": [float(c) for c in material.color]}
    bitmap = mi.Bitmap(str(material.texture)).convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.Float32, False)
    linear = np.array(bitmap, dtype=np.float64)
    if not exact:
        linear = stored_texels(linear)
    if (linear == linear[0, 0]).all():
        return {"type": "rgb", "value": [float(c) for c in linear[0, 0] * material.color]}
    return {"type": "bitmap", "raw": True, "filter_type": "bilinear", "wrap_mode": "repeat",
            "bitmap": mi.Bitmap((linear * material.color).astype(np.float32))}


def mesh(surface, name, folder):
    """Writes the triangles as PLY and describes them."""
    path = folder / f"{name}.ply"
    count = len(surface.corners)
    vertices = np.concatenate([surface.corners, surface.uvs], -1).reshape(-1, 5).astype("<f4")
    faces = np.zeros(count, [("n", "u1"), ("corner", "<i4", 3)])
    faces["n"], faces["corner"] = 3, np.arange(3 * count).reshape(-1, 3)
    header = ("ply\nformat binary_little_endian 1.0\nelement vertex %d\n" % (3 * count) +
              "".join(f"property float {p}\n" for p in "xyzuv") +
              "element face %d\nproperty list uchar int vertex_indices\nend_header\n" % count)
    path.write_bytes(header.encode() + vertices.tobytes() + faces.tobytes())
    return {"type": "ply", "filename": str(path), "face_normals": True, "flip_tex_coords": False}


def environment(scene, sun):
    """Mitsuba's panorama has +z in its middle and -x to the right of it; Vigil's +x and +z: a quarter turn."""
    if scene.sky_panorama is None and not sun:
        return {"type": "constant", "radiance": {"type": "rgb", "value": [float(c) for c in scene.sky_radiance]}}
    picture = None
    if scene.sky_panorama is not None:
        picture = np.array(mi.Bitmap(str(scene.sky_panorama)).convert(
            mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.Float32, False), dtype=np.float64)
    return {"type": "envmap", "bitmap": mi.Bitmap(panorama.make(scene, picture, sun).astype(np.float32)),
            "to_world": mi.ScalarTransform4f().rotate([0, 1, 0], 90)}


def camera(scene, width, height):
    place = scene.camera
    origin, back, up = place[:3, 3], place[:3, 2], place[:3, 1]
    return {"type": "perspective", "fov": float(np.degrees(scene.vertical_fov)), "fov_axis": "y",
            "near_clip": 0.01, "far_clip": 1e6,
            "to_world": mi.ScalarTransform4f().look_at(origin=list(map(float, origin)),
                                                       target=list(map(float, origin - back)),
                                                       up=list(map(float, up))),
            "film": {"type": "hdrfilm", "width": width, "height": height, "pixel_format": "rgb",
                     "component_format": "float32", "rfilter": {"type": "box"}},
            "sampler": {"type": "independent"}}


def build(scene, folder, width, height, exact_texels=False, sun=True):
    """Returns the Mitsuba scene and, per shape name, the material (None: a face that shows the sky). Files go to
    `folder`, which exists. `sun`: the panorama shows it."""
    sun = sun and scene.sun_irradiance is not None
    description = {"type": "scene", "sensor": camera(scene, width, height)}
    materials = {}
    for index, surface in enumerate(scene.surfaces):
        material = surface.material
        name = f"surface{index}"
        shape = mesh(surface, name, folder)
        shape["bsdf"] = {"type": "diffuse", "reflectance": texture(material, exact_texels)}
        if material.radiance.any():
            shape["emitter"] = {"type": "area", "radiance": {
                "type": "rgb", "value": [float(c) for c in material.radiance]}}
        description[name], materials[name] = shape, material
    if len(scene.sky_faces):
        faces = type("SkyFaces", (), {"corners": scene.sky_faces, "uvs": np.zeros((len(scene.sky_faces), 3, 2))})
        description["sky_faces"] = mesh(faces, "sky_faces", folder)
        materials["sky_faces"] = None
    if scene.sky_panorama or scene.sky_radiance is not None or sun:
        description["sky"] = environment(scene, sun)
    return mi.load_dict(description), materials
