// SPDX-License-Identifier: GPL-2.0-or-later
// What the scene is on the GPU: instances, triangles, materials, textures and lights, in scalar block
// layout, so that the C++ and GLSL structures are the same bytes. No functions live here.
#ifndef VIGIL_SHARED_SCENE_TYPES_H
#define VIGIL_SHARED_SCENE_TYPES_H

#include "glsl.h"

SHADER_BEGIN

/// "No such thing" for light, texture and cluster indices.
SHADER_CONST uint NONE = 0xffffffffu;

/// One placed model. Instance 0 is the static world with identity transforms; the others are brush
/// models, MD2 and mesh entities of this frame. Matrices are 4 columns of vec3 (rotation | origin).
struct Instance {
    mat4x3 world_from_object;
    mat4x3 object_from_world;
    mat4x3 previous_world_from_object;
    uint bvh_root;    // node index of the root of its bottom-level BVH
    uint first_light; // light id of the model's light 0; a primitive's light index is added to it
    uint flags;       // INSTANCE_*
    uint entity;      // stable entity number, for views and debugging
    vec3 glow;        // radiance that a white texel of it shows to camera rays besides what it reflects
    SHADER_PADDING(1)
};
SHADER_CONST int INSTANCE_TEXELS = 11;

/// Bits 0..7 of Instance::flags: the rays that meet it. A ray's mask has one of them.
SHADER_CONST uint INSTANCE_SEEN = 1u;  // by camera rays
SHADER_CONST uint INSTANCE_LIT = 2u;   // by shadow and indirect rays
SHADER_CONST uint INSTANCE_FRONT = 4u; // by camera rays, which look for these before all else
/// Bits 8..15: opacity * 255, a factor on the coverage of its triangles.
SHADER_CONST uint INSTANCE_OPACITY_SHIFT = 8u;
/// Its materials have a second texture behind the first: how much of each texel there is for camera rays.
SHADER_CONST uint INSTANCE_CUTOUT = 0x10000u;
/// Opaque, and met by all rays.
SHADER_CONST uint INSTANCE_PLAIN = 0xff03u;

/// What the BVH intersects: vertex and edges in object space. Stored in leaf order; the same index
/// addresses `Primitive`.
struct BvhTriangle {
    vec3 v0;
    uint flags; // TRIANGLE_*
    vec3 e1;    // v1 - v0
    vec3 e2;    // v2 - v0
    SHADER_PADDING(2)
};
SHADER_CONST int TRIANGLE_TEXELS = 3;

/// Bits 0..7: coverage / 255: the chance that a ray stops here. 255 is opaque (both sides stop rays);
/// below 255 the triangle is translucent, and only its front side exists.
SHADER_CONST uint TRIANGLE_COVERAGE_MASK = 0xffu;

/// What shading needs to know about a triangle; same order as BvhTriangle.
struct Primitive {
    vec2 uv0; // texture coordinates in repeats (1 = one texture width)
    vec2 uv1;
    vec2 uv2;
    uint material;
    uint light;   // index among its model's lights, or NONE; of a sky face: of its window's first light
    uint cluster; // PVS cluster, or NONE when the triangle touches several (then locate the point)
    SHADER_PADDING(3)
};
SHADER_CONST int PRIMITIVE_TEXELS = 3;

SHADER_CONST uint MATERIAL_SKY = 1u;      // shows the sky; ends every path
SHADER_CONST uint MATERIAL_EMISSIVE = 2u; // its triangles are lights
SHADER_CONST uint MATERIAL_WARP = 4u;     // liquid: texture coordinates move
SHADER_CONST uint MATERIAL_FLOWING = 8u;  // texture scrolls
SHADER_CONST uint MATERIAL_GLOSSY = 16u;  // has a GGX lobe at the primary hit
SHADER_CONST uint MATERIAL_SHINES = 32u;  // a particle: emits towards the camera, and is no light

/// What a texel of a material that shines emits, as radiance.
SHADER_CONST float SHINE_RADIANCE = 20.0f;

struct Material {
    uint texture;      // index of the texture header of the first animation frame
    uint frame_count;  // animation frames: `texture` .. `texture + frame_count - 1`
    uint flags;        // MATERIAL_*
    float roughness;   // GGX alpha = roughness^2
    float specular;    // reflectance at normal incidence, in [0, 1]
    vec3 inverse_mean; // 1 / mean linear texel: an emissive texel times this has mean 1; 0: plain emission
};
SHADER_CONST int MATERIAL_TEXELS = 2;

/// A picture in the texel buffer: RGB9E5 (shared exponent, linear), rows from the top, mip levels one after
/// another, each half the size before, rounded down, at least 1.
struct Texture {
    uint first_texel;
    uint width;
    uint height;
    uint mip_count;
};

/// A node of the level's BSP, to find the PVS cluster of a point. A child >= 0 is a node; a child < 0 is a leaf of
/// cluster -2 - child (-1: in no cluster).
struct BspTreeNode {
    vec3 normal;
    float dist;
    int front; // where dot(normal, p) >= dist
    int back;
    SHADER_PADDING(2)
};
SHADER_CONST int BSP_NODE_TEXELS = 2;

/// What a camera ray hit; written by the primary pass, read by the passes after it.
struct PrimaryHit {
    vec3 position;
    uint primitive; // NONE: nothing to light (sky, miss, the inside of a wall)
    vec3 normal;    // unit, of the side that was hit
    uint instance;
    vec3 albedo; // linear
    uint gloss;  // packHalf2x16(GGX alpha, to 2^-11 of itself; reflectance at normal incidence, to 2^-12)
};
SHADER_CONST int PRIMARY_HIT_TEXELS = 3;

/// What became of a pixel's paths in this frame: of its last path, but for PIXEL_NONFINITE.
SHADER_CONST uint PIXEL_NONFINITE = 1u; // a value was not finite
SHADER_CONST uint PIXEL_UNLIT = 2u;     // the light sample of the primary hit contributed nothing
SHADER_CONST uint PIXEL_EXPLORED = 4u;  // it looked for a new light

/// A triangle that emits `radiance` (uniform, Lambertian) from its front side, in world space this frame.
/// Its index is its id and stays the same while the light exists; free ids have zero radiance.
struct Light {
    vec3 v0;
    vec3 e1; // v1 - v0
    vec3 e2; // v2 - v0; cross(e1, e2) points to the lit side
    vec3 radiance;
    uint flags; // LIGHT_*; 0: a lamp
    SHADER_PADDING(3)
};
SHADER_CONST int LIGHT_TEXELS = 4;

/// Half of a cell of a window to the sky (scene/sky_windows.h). `radiance` is a mean, by which it is chosen; what comes through a
/// point of it is the sky's in that direction, where a sky face is.
SHADER_CONST uint LIGHT_SKY = 1u;
/// The sun: the triangle that is seen around its cone from everywhere; `v0` is as seen from there. `radiance` is its mean on that.
SHADER_CONST uint LIGHT_SUN = 2u;
/// Of LIGHT_SKY: sky faces cover all of it.
SHADER_CONST uint LIGHT_WHOLE = 4u;
/// In the window's first light: how many columns and rows of cells the window has, 1 to 4,095 each.
SHADER_CONST uint LIGHT_COLUMNS_SHIFT = 8u;
SHADER_CONST uint LIGHT_ROWS_SHIFT = 20u;
SHADER_CONST uint LIGHT_CELLS_MASK = 0xfffu;

SHADER_END
#endif
