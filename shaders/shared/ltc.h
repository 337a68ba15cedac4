// SPDX-License-Identifier: GPL-2.0-or-later
// How much a triangular light would brighten a surface if nothing stood between: the importance by
// which lights are chosen (the paper, section 4.2). The cosine-weighted integral over the clipped
// triangle serves the diffuse lobe, and through a linear transformation the GGX lobe (Heitz et al.,
// "Real-Time Polygonal-Light Shading with Linearly Transformed Cosines", 2016). Choosing only: the
// value of a sample comes from brdf.h.
#ifndef VIGIL_SHARED_LTC_H
#define VIGIL_SHARED_LTC_H

#include "brdf.h"
#include "glsl.h"
#include "scene_types.h"
#include "triangle_light.h"

SHADER_BEGIN

/// A shading point, prepared once and asked about many lights.
struct LtcSurface {
    vec3 position;
    vec3 normal;       // unit
    float diffuse;     // luminance of the diffuse albedo, in [0, 1]
    float specular;    // directional albedo of the GGX lobe, in [0, 1]; 0 = none
    mat3 to_cosine;    // from world space to where the GGX lobe is a cosine around +z
    float determinant; // of to_cosine, > 0
};

/// One cell of the fitted table over (roughness, view angle), see tools/ltc_fit.
struct LtcEntry {
    vec4 matrix; // the inverse transformation [a 0 b; 0 1 0; c 0 d] as (a, b, c, d)
    vec2 albedo; // directional albedo = f0 * x + y (Schlick)
    SHADER_PADDING(2)
};
SHADER_CONST int LTC_ENTRY_TEXELS = 2;

/// angle / sin(angle) / 2 of an angle in [0, pi] from its cosine and its sine squared. Maximal
/// relative error 3e-6 plus that of its arguments (degree 6 minimax polynomial for angles up to pi
/// / 2, our own fit; the rest by symmetry, where the sine must come from a cross product to keep
/// its digits).
SHADER_FN float half_angle_over_sine(float cosine, float sine_squared) {
    float x = min(abs(cosine), 1.0f);
    float p = 0.0211602020f * x - 0.0972638255f;
    p = p * x + 0.2101362120f;
    p = p * x - 0.3086555715f;
    p = p * x + 0.3890132285f;
    p = p * x - 0.4997848590f;
    p = p * x + 0.7853960550f;
    return cosine >= 0.0f ? p : 0.5f * PI * inversesqrt(max(sine_squared, 1e-12f)) - p;
}

/// Unit vector; the zero vector stays finite.
SHADER_FN vec3 safe_normalize(vec3 v) { return v * inversesqrt(max(dot(v, v), 1e-30f)); }

/// One edge of the contour integral over pi: the angle under which the edge b -> a is seen from the
/// origin, times the normal's component along the plane through both and the origin, over 2 pi.
/// Unit vectors.
SHADER_FN float edge_form_factor(vec3 normal, vec3 a, vec3 b) {
    vec3 plane = cross(b, a);
    return half_angle_over_sine(dot(a, b), dot(plane, plane)) * dot(normal, plane) * INVERSE_PI;
}

/// Form factor of a triangle by its contour, cut at the horizon. `height` holds the vertices'
/// heights above the horizon; at least one is positive. Exact up to rounding: an absolute error below
/// 3e-6, which small triangles feel (tests/numerics/lights_test.cpp).
SHADER_FN float contour_form_factor(vec3 normal, vec3 v0, vec3 v1, vec3 v2, vec3 height) {
    vec3 p0 = v0;
    vec3 p1 = v1;
    vec3 p2 = v2;
    vec3 p3 = v2;
    bool clipped = min(height.x, min(height.y, height.z)) < 0.0f;
    if (clipped) {
        // Name the vertex that is alone on its side of the horizon a, the others b and c in order.
        bool above0 = height.x > 0.0f;
        bool above1 = height.y > 0.0f;
        bool above2 = height.z > 0.0f;
        bool alone1 = above0 == above2 && above1 != above0;
        bool alone2 = above0 == above1 && above2 != above0;
        vec3 a = alone1 ? v1 : (alone2 ? v2 : v0);
        vec3 b = alone1 ? v2 : (alone2 ? v0 : v1);
        vec3 c = alone1 ? v0 : (alone2 ? v1 : v2);
        float za = alone1 ? height.y : (alone2 ? height.z : height.x);
        float zb = alone1 ? height.z : (alone2 ? height.x : height.y);
        float zc = alone1 ? height.x : (alone2 ? height.y : height.z);
        // The horizon cuts the edges a-b and a-c. What stays is the triangle (a, ab, ac) or the
        // quad (ab, b, c, ac).
        vec3 ab = a + (za / (za - zb)) * (b - a);
        vec3 ac = a + (za / (za - zc)) * (c - a);
        p0 = za > 0.0f ? a : ab;
        p1 = za > 0.0f ? ab : b;
        p2 = za > 0.0f ? ac : c;
        p3 = ac;
    }
    p0 = safe_normalize(p0);
    p1 = safe_normalize(p1);
    p2 = safe_normalize(p2);
    float sum = edge_form_factor(normal, p0, p1) + edge_form_factor(normal, p1, p2);
    if (clipped) {
        p3 = safe_normalize(p3);
        sum += edge_form_factor(normal, p2, p3) + edge_form_factor(normal, p3, p0);
    } else {
        sum += edge_form_factor(normal, p2, p0);
    }
    return sum;
}

/// Mean over a triangle of max(height, 0), a function linear between its vertices; exact and never
/// negative. Zero only where no height is positive.
SHADER_FN float mean_height_above(vec3 height) {
    float lowest = min(height.x, min(height.y, height.z));
    float highest = max(height.x, max(height.y, height.z));
    float middle = max(min(height.x, height.y), min(max(height.x, height.y), height.z));
    if (!(highest > 0.0f)) return 0.0f;
    // The part above the horizon is a triangle at the highest vertex, or all but a triangle at the
    // lowest.
    if (middle <= 0.0f) {
        return highest * (highest / (highest - middle)) * (highest / (highest - lowest)) / 3.0f;
    }
    float below = min(lowest, 0.0f);
    float cut = below * (below / (middle - below)) * (below / (highest - below));
    return max((lowest + middle + highest - cut) / 3.0f, 0.25f * highest);
}

/// Up to this ratio of summed squared edges to squared distance three points stand for a triangle
/// that is whole above the horizon, and up to the second one for a triangle that the horizon cuts.
SHADER_CONST float FORM_FACTOR_WHOLE = 1.0f;
SHADER_CONST float FORM_FACTOR_CUT = 0.01f;

/// Form factor of a triangle by three points, and the square of the distance to the nearest of
/// them. Over points y of the triangle it is the mean of facing * height / (2 pi |y|^4), with the
/// height above the horizon or 0: no cancellation however small the light, but far off for near
/// ones.
SHADER_FN vec2 point_form_factor(vec3 v0, vec3 e1, vec3 e2, vec3 height, float facing) {
    // Gauss points of degree 2: one third each, at barycentric coordinates (2/3, 1/6, 1/6).
    vec3 y0 = v0 + (e1 + e2) * (1.0f / 6.0f);
    vec3 y1 = y0 + 0.5f * e1;
    vec3 y2 = y0 + 0.5f * e2;
    vec3 squared = max(vec3(dot(y0, y0), dot(y1, y1), dot(y2, y2)), vec3(1e-15f));
    vec3 heights = 0.5f * height + (height.x + height.y + height.z) * (1.0f / 6.0f);
    // Where the horizon cuts, each point stands for a third of what is above.
    if (min(height.x, min(height.y, height.z)) < 0.0f) heights = vec3(mean_height_above(height));
    vec3 terms = heights / (squared * squared);
    float nearest = min(squared.x, min(squared.y, squared.z));
    return vec2(facing * (1.0f / (3.0f * TWO_PI)) * (terms.x + terms.y + terms.z), nearest);
}

/// Cosine-weighted solid angle over pi, in [0, 1], of the part of a triangle above the horizon: its
/// irradiance on a surface at the origin with this unit normal, per pi * radiance. `facing` is
/// `light_facing`, and positive. Never zero when some vertex is above the horizon, exactly zero
/// when none is. Its errors: below 20% of itself for triangles whole above the horizon, within 5% of the
/// solid angle over pi for those cut by it (tests/numerics/lights_test.cpp); mostly below 0.1%
/// (docs/internals/light-sampling.md).
SHADER_FN float form_factor(vec3 normal, vec3 v0, vec3 e1, vec3 e2, float facing) {
    vec3 height = dot(normal, v0) + vec3(0.0f, dot(normal, e1), dot(normal, e2));
    if (!(max(height.x, max(height.y, height.z)) > 0.0f)) return 0.0f;
    bool cut = min(height.x, min(height.y, height.z)) < 0.0f;
    vec2 points = point_form_factor(v0, e1, e2, height, facing);
    float extent = dot(e1, e1) + dot(e2, e2);
    if (extent <= (cut ? FORM_FACTOR_CUT : FORM_FACTOR_WHOLE) * points.y) return points.x;
    // Near lights. Where rounding leaves the contour at or below zero, a trace of the estimate
    // remains.
    float contour = contour_form_factor(normal, v0, v0 + e1, v0 + e2, height);
    return clamp(contour, min(1e-3f * points.x, 1e-6f), 1.0f);
}

/// Prepares a purely Lambertian point; `albedo` is the luminance of its albedo. Best given the
/// origin of the shadow rays (offset_ray_origin) as position: lights in the surface's own plane are
/// then below its horizon, whatever the rounding.
SHADER_FN LtcSurface ltc_prepare_diffuse(vec3 position, vec3 normal, float albedo) {
    LtcSurface surface;
    surface.position = position;
    surface.normal = normal;
    surface.diffuse = albedo;
    surface.specular = 0.0f;
    surface.to_cosine = mat3(1.0f);
    surface.determinant = 1.0f;
    return surface;
}

/// Prepares a point with both lobes; `entry` is the table's at ltc_cell(brdf.alpha, view cosine).
SHADER_FN LtcSurface ltc_prepare_glossy(vec3 position, vec3 normal, vec3 view, Brdf brdf, LtcEntry entry) {
    vec3 v = brdf_view(normal, view);
    float nv = brdf_cosine(normal, v);
    LtcSurface surface;
    surface.position = position;
    surface.normal = normal;
    surface.diffuse = luminance(brdf.albedo) * diffuse_under_coat(brdf.f0, coat_shading(brdf.alpha), nv);
    surface.specular = brdf.f0 * entry.albedo.x + entry.albedo.y;
    // The table holds the lobe of a view in the plane of +x and +z. Seen from above every tangent
    // will do.
    vec3 along = v - nv * normal;
    vec3 tangent = dot(along, along) > 1e-10f ? normalize(along) : make_basis(normal).tangent;
    vec3 bitangent = cross(normal, tangent);
    vec3 row0 = entry.matrix.x * tangent + entry.matrix.y * normal;
    vec3 row2 = entry.matrix.z * tangent + entry.matrix.w * normal;
    surface.to_cosine = transpose(mat3(row0, bitangent, row2));
    surface.determinant = entry.matrix.x * entry.matrix.w - entry.matrix.y * entry.matrix.z;
    return surface;
}

/// Share of the GGX lobe's importance that follows the diffuse form factor: the fitted lobe may end
/// above the horizon, and no light that contributes may have importance zero.
SHADER_CONST float LTC_DEFENSIVE = 0.02f;

/// What a light of radiance 1 would add to a surface if it were visible.
struct LtcParts {
    float diffuse;
    float specular; // of the GGX lobe
    float covered;  // part of the GGX lobe that the light covers, in [0, 1]
};

/// All 0 for lights that face away, have no area or lie below the horizon; `diffuse` is positive and
/// all are finite for the others, if the surface is not black.
/// `glossy` is false where no surface has a GGX lobe: as a constant, it removes that lobe's code.
SHADER_FN LtcParts ltc_parts(LtcSurface surface, Light light, bool glossy) {
    LtcParts parts;
    parts.diffuse = 0.0f;
    parts.specular = 0.0f;
    parts.covered = 0.0f;
    float facing = light_facing(light, surface.position);
    if (!(facing > 0.0f)) return parts;
    vec3 v0 = light.v0 - surface.position;
    float form = form_factor(surface.normal, v0, light.e1, light.e2, facing);
    parts.diffuse = surface.diffuse * form;
    if (glossy && surface.specular > 0.0f) {
        float lobe = form_factor(vec3(0.0f, 0.0f, 1.0f), surface.to_cosine * v0, surface.to_cosine * light.e1, surface.to_cosine * light.e2,
                                 surface.determinant * facing);
        parts.covered = form > 0.0f ? mix(lobe, form, LTC_DEFENSIVE) : 0.0f;
        parts.specular = surface.specular * parts.covered;
    }
    return parts;
}

/// Luminance that the light would add to the surface if it were visible, by which to choose among
/// lights. Exactly 0 for lights that are dark, face away, have no area or lie below the horizon;
/// positive and finite for all others.
SHADER_FN float ltc_importance(LtcSurface surface, Light light, bool glossy) {
    LtcParts parts = ltc_parts(surface, light, glossy);
    return (parts.diffuse + parts.specular) * luminance(light.radiance);
}

/// Cells per side of the fitted table.
SHADER_CONST uint LTC_TABLE_SIZE = 32u;

/// Where a look-up falls in the table: entries lie at row * LTC_TABLE_SIZE + column, rows along the
/// view angle.
struct LtcCell {
    uint column; // with its right neighbour; of sqrt(alpha) in [0, 1]
    uint row;    // with its lower neighbour; of sqrt(1 - view cosine) in [0, 1]
    vec2 weight; // of the right and lower neighbours
};

SHADER_FN LtcCell ltc_cell(float alpha, float view_cosine) {
    float last = float(LTC_TABLE_SIZE - 1u);
    vec2 at = sqrt(clamp(vec2(alpha, 1.0f - view_cosine), vec2(0.0f), vec2(1.0f))) * last;
    vec2 corner = min(floor(at), vec2(last - 1.0f));
    LtcCell cell;
    cell.column = uint(corner.x);
    cell.row = uint(corner.y);
    cell.weight = at - corner;
    return cell;
}

/// Bilinear interpolation of four neighbours: first left and right of the upper row, then of the
/// lower.
SHADER_FN LtcEntry ltc_mix(LtcEntry e00, LtcEntry e01, LtcEntry e10, LtcEntry e11, vec2 weight) {
    LtcEntry entry;
    entry.matrix = mix(mix(e00.matrix, e01.matrix, weight.x), mix(e10.matrix, e11.matrix, weight.x), weight.y);
    entry.albedo = mix(mix(e00.albedo, e01.albedo, weight.x), mix(e10.albedo, e11.albedo, weight.x), weight.y);
    return entry;
}

SHADER_END
#endif
