// SPDX-License-Identifier: GPL-2.0-or-later
// From a hit to a surface: position, geometric normal, albedo, gloss, PVS cluster. Shading uses the geometric normal
// everywhere: it keeps reflection and sampling consistent, and the same surface for every technique.
#ifndef VIGIL_SCENE_SURFACE_GLSL
#define VIGIL_SCENE_SURFACE_GLSL

#include "scene/scene.glsl"
#include "shared/brdf.h"
#include "shared/sampling.h"
#include "trace/trace.glsl"

layout(set = SET_SCENE, binding = BINDING_BSP) uniform utextureBuffer bsp_nodes; // BspTreeNode[]

BspTreeNode load_bsp_node(int index) {
    const vec4 plane = load_floats(bsp_nodes, BSP_NODE_TEXELS * index);
    const ivec4 children = ivec4(texelFetch(bsp_nodes, BSP_NODE_TEXELS * index + 1));
    return BspTreeNode(plane.xyz, plane.w, children.x, children.y);
}

struct Surface {
    vec3 position;
    vec3 origin; // just above the position: where rays start, and from where lights are looked at
    vec3 normal; // unit, of the side that was hit
    vec3 view;   // unit, to where the ray came from
    Brdf brdf;
    uint primitive;
    uint instance;
};

/// What a ray found.
struct Vertex {
    Surface surface;
    bool lit;      // false: sky, nothing, or the inside of a wall: the path ends, surface is not set
    vec3 emission; // towards the ray's origin: of the sky, or of the light that was hit
    bool sky;
};

vec3 previous_position(Surface surface) { return HAS_INSTANCES ? previous_position(surface.position, surface.instance) : surface.position; }

/// Unit normal of a triangle's front, in world space.
vec3 triangle_normal(BvhTriangle triangle, uint instance) {
    const vec3 normal = cross(triangle.e1, triangle.e2);
    if (!HAS_INSTANCES || instance == 0u) return normalize(normal);
    // Normals go with the transposed inverse.
    return normalize(normal * mat3(load_instance(instance).object_from_world));
}

/// The point that was hit, from the triangle's vertices: off its plane by a few units in the last place, while the ray's
/// origin plus t times its direction is off by far more at grazing angles.
vec3 triangle_point(BvhTriangle triangle, Hit hit) {
    const vec3 point = triangle.v0 + hit.barycentrics.x * triangle.e1 + hit.barycentrics.y * triangle.e2;
    if (!HAS_INSTANCES || hit.instance == 0u) return point;
    return load_instance(hit.instance).world_from_object * vec4(point, 1.0);
}

/// Linear mean-filtered texel of a triangle; `cone` is the width of the ray where it hits, in map units.
vec3 surface_texel(Primitive primitive, BvhTriangle triangle, Material material, vec2 barycentrics, float cone) {
    const vec2 du = primitive.uv1 - primitive.uv0;
    const vec2 dv = primitive.uv2 - primitive.uv0;
    vec2 uv = primitive.uv0 + barycentrics.x * du + barycentrics.y * dv;
    uv = animate_uv(uv, material.flags);
    // Repeats per map unit from the ratio of the triangle's areas in texture and in space.
    const vec3 area = cross(triangle.e1, triangle.e2);
    const float density = sqrt(abs(du.x * dv.y - du.y * dv.x) * inversesqrt(max(dot(area, area), 1e-12)));
    return sample_texture(material_texture(material), uv, cone * density);
}

/// Linear mean-filtered texel where a ray of angle `spread` radians hits a triangle with this normal.
vec3 hit_texel(Ray ray, Hit hit, BvhTriangle triangle, vec3 normal, Primitive primitive, Material material, float spread) {
    const float cosine = max(-dot(normal, ray.direction), 1e-3);
    const float cone = spread * hit.t * inversesqrt(cosine);
    return surface_texel(primitive, triangle, material, hit.barycentrics, cone);
}

/// Share of a cutout that there is where a camera ray hits it, 0..1; of all else 1.
float cutout_share(Ray ray, Hit hit) {
    if ((load_instance(hit.instance).flags & INSTANCE_CUTOUT) == 0u) return 1.0;
    const Primitive primitive = load_primitive(hit.primitive);
    Material material = load_material(primitive.material);
    ++material.texture;
    const BvhTriangle triangle = bvh_load_triangle(hit.primitive);
    const vec3 normal = triangle_normal(triangle, hit.instance);
    return hit_texel(ray, hit, triangle, normal, primitive, material, frame.pixel_angle).x;
}

/// Share of a surface that there is where a ray hits it, 0..1.
float hit_coverage(Hit hit) {
    if (!HAS_TRANSLUCENT) return 1.0;
    uint coverage = bvh_load_triangle(hit.primitive).flags;
    if (HAS_EFFECTS) coverage = bvh_faded(coverage, bvh_opacity(load_instance(hit.instance).flags));
    return float(coverage & TRIANGLE_COVERAGE_MASK) / 255.0;
}

/// Emission of a triangle light seen from its front; `texel` gives a lamp its look without changing its mean.
vec3 light_emission(Primitive primitive, BvhTriangle triangle, Hit hit, Material material, vec3 texel, bool textured) {
    const uint first = HAS_INSTANCES ? load_instance(hit.instance).first_light : 0u;
    vec3 emission = load_light(first + primitive.light).radiance;
    // A translucent lamp's list entry is dimmed by its coverage; a ray that stops at it has paid for that already.
    if (HAS_TRANSLUCENT) {
        uint coverage = triangle.flags & TRIANGLE_COVERAGE_MASK;
        if (HAS_EFFECTS) coverage = bvh_faded(coverage, bvh_opacity(load_instance(hit.instance).flags));
        emission *= 255.0 / float(max(coverage, 1u));
    }
    if (textured && material.inverse_mean != vec3(0.0)) emission *= texel * material.inverse_mean;
    return emission;
}

/// Describes what `ray` hit. `spread` is the ray's angle in radians (how fast its cone widens); at the primary hit
/// surfaces may be glossy and lamps show their texture, later all are diffuse and uniform (paper, section 7).
Vertex describe_hit(Ray ray, Hit hit, float spread, bool primary) {
    Vertex vertex;
    vertex.lit = false;
    vertex.sky = false;
    vertex.emission = vec3(0.0);
    const Primitive primitive = load_primitive(hit.primitive);
    const Material material = load_material(primitive.material);
    if (!hit.front) return vertex; // the inside of a wall is black
    if (HAS_SKY && (material.flags & MATERIAL_SKY) != 0u) {
        vertex.sky = true;
        return vertex;
    }
    const BvhTriangle triangle = bvh_load_triangle(hit.primitive);
    const vec3 normal = triangle_normal(triangle, hit.instance);
    const vec3 texel = hit_texel(ray, hit, triangle, normal, primitive, material, spread);
    if (HAS_LIGHTS && primitive.light != NONE)
        vertex.emission = light_emission(primitive, triangle, hit, material, texel, primary && frame.settings.pt_emissive_texture != 0);
    if (HAS_INSTANCES && primary && (material.flags & MATERIAL_SHINES) != 0u) vertex.emission = SHINE_RADIANCE * texel;
    if (HAS_EFFECTS && primary) vertex.emission += load_instance(hit.instance).glow * texel;
    vertex.lit = true;
    vertex.surface.position = triangle_point(triangle, hit);
    vertex.surface.normal = normal;
    vertex.surface.origin = offset_ray_origin(vertex.surface.position, normal);
    vertex.surface.view = -ray.direction;
    vertex.surface.brdf = brdf_lambert(texel);
    if (HAS_GLOSS && primary && (material.flags & MATERIAL_GLOSSY) != 0u) {
        vertex.surface.brdf.f0 = material.specular;
        vertex.surface.brdf.alpha = material.roughness * material.roughness;
    }
    vertex.surface.primitive = hit.primitive;
    vertex.surface.instance = hit.instance;
    return vertex;
}

/// The surface of a primary hit, which is one (not NONE).
Surface load_primary_surface(PrimaryHit hit) {
    Surface surface;
    surface.position = hit.position;
    surface.normal = hit.normal;
    surface.origin = offset_ray_origin(hit.position, hit.normal);
    surface.view = normalize(frame.camera_origin - hit.position);
    surface.brdf = brdf_lambert(hit.albedo);
    if (HAS_GLOSS) {
        const vec2 gloss = unpackHalf2x16(hit.gloss);
        surface.brdf.alpha = gloss.x;
        surface.brdf.f0 = gloss.y;
    }
    surface.primitive = hit.primitive;
    surface.instance = hit.instance;
    return surface;
}

/// PVS cluster of a surface, NONE where there is none. World triangles know theirs unless they reach through
/// several; then, and on moving models, the level's BSP tells.
uint surface_cluster(Surface surface) {
    if (!HAS_INSTANCES || surface.instance == 0u) {
        const uint cluster = load_primitive(surface.primitive).cluster;
        if (cluster != NONE) return cluster;
    }
    // Half a unit off the surface lies in the open, clear of rounding.
    const vec3 position = surface.position + 0.5 * surface.normal;
    int child = 0;
    while (child >= 0) {
        const BspTreeNode node = load_bsp_node(child);
        child = dot(node.normal, position) >= node.dist ? node.front : node.back;
    }
    return uint(-2 - child); // -1 becomes NONE
}

#endif
