// SPDX-License-Identifier: GPL-2.0-or-later
// The reflection model: a Lambertian base under an optional GGX coat (Walter et al. 2007;
// height-correlated Smith masking, Heitz 2014; Schlick's Fresnel), coupled so that together they
// never reflect more than arrives (Shirley et al., "A Practitioners' Assessment of Light Reflection
// Models", 1997). No refraction, no multiple scattering between facets, no textures; normals arrive
// ready to use.
#ifndef VIGIL_SHARED_BRDF_H
#define VIGIL_SHARED_BRDF_H

#include "glsl.h"
#include "sampling.h"

SHADER_BEGIN

/// A surface's reflection. With f0 = 0 there is no GGX lobe: where a shader sets that as a
/// constant, the compiler drops all of its code.
struct Brdf {
    vec3 albedo; // of the diffuse base, each in [0, 1]
    float f0;    // GGX reflectance at normal incidence, in [0, 1]; 0 = purely Lambertian
    float alpha; // GGX width = roughness^2, in [0.01, 1]; ignored when f0 = 0
};

/// One direction pair's reflection.
struct BrdfValue {
    vec3 value; // BRDF * cosine of the light direction; 0 below the horizon
    float pdf;  // per steradian, with which `brdf_sample` draws the light direction
};

struct BrdfSample {
    vec3 direction; // unit, towards the light
    BrdfValue seen; // value and pdf of it; pdf 0: the draw fell below the horizon and counts as black
};

/// Views below or along the surface (interpolated normals, rounding) count as seen from this
/// cosine.
SHADER_CONST float BRDF_MIN_COSINE = 1e-3f;

/// Luminance of linear Rec. 709 colours.
SHADER_FN float luminance(vec3 color) { return dot(color, vec3(0.2126f, 0.7152f, 0.0722f)); }

SHADER_FN Brdf brdf_lambert(vec3 albedo) {
    Brdf brdf;
    brdf.albedo = albedo;
    brdf.f0 = 0.0f;
    brdf.alpha = 1.0f;
    return brdf;
}

/// (1 - cosine)^5, the shape of Schlick's Fresnel term. Cosines outside [0, 1] are clamped.
SHADER_FN float schlick_weight(float cosine) {
    float m = clamp(1.0f - cosine, 0.0f, 1.0f);
    float m2 = m * m;
    return m2 * m2 * m;
}

/// The view direction, lifted to a cosine of BRDF_MIN_COSINE where it is below. Evaluation, density
/// and sampling all pass through here, so they agree for any unit view. Quake's flat walls never
/// need it.
SHADER_FN vec3 brdf_view(vec3 normal, vec3 view) {
    float cosine = dot(normal, view);
    if (cosine >= BRDF_MIN_COSINE) return view;
    return normalize(view + (BRDF_MIN_COSINE - cosine) * normal);
}

/// Cosine of a direction for the formulas below: rounding may push a dot product of unit vectors
/// past 1.
SHADER_FN float brdf_cosine(vec3 normal, vec3 direction) { return min(dot(normal, direction), 1.0f); }

/// How strongly the coat's Fresnel term dims the base at grazing angles: fully under a mirror,
/// hardly under a rough coat, whose own reflection does not grow there. Our fit to the least value
/// that keeps the sum of both lobes at or below 1.
SHADER_FN float coat_shading(float alpha) { return 1.0f / (1.0f + 12.0f * alpha * alpha); }

/// Factor on the base's Lambertian lobe under the coat, but for the same term of the light's
/// direction, 1 - s (1 - n.l)^5: c (1 - f0) (1 - s (1 - n.v)^5), s = coat_shading. With c = 1 / (1
/// - s / 21) a white base under a mirror coat reflects exactly what arrives; 0.6% less leaves room
/// for rough coats.
SHADER_FN float diffuse_under_coat(float f0, float shading, float view_cosine) {
    float base = 0.994f / (1.0f - shading * (1.0f / 21.0f));
    return base * (1.0f - f0) * (1.0f - shading * schlick_weight(view_cosine));
}

/// The GGX lobe's part, in [0, 1], of what is reflected of even light.
SHADER_FN float specular_share(Brdf brdf, float view_cosine) {
    float specular = brdf.f0 + (1.0f - brdf.f0) * schlick_weight(view_cosine);
    float diffuse = luminance(brdf.albedo) * (1.0f - specular);
    return specular / max(specular + diffuse, 1e-6f);
}

/// Chance that `brdf_sample` draws from the GGX lobe: its share of the reflected light, but at
/// least 0.1, so that narrow highlights are found on bright walls.
SHADER_FN float specular_probability(Brdf brdf, float view_cosine) { return max(0.1f, specular_share(brdf, view_cosine)); }

/// GGX distribution of facet normals at the unit vector h. sin^2 from the cross product keeps its
/// digits near the peak, where 1 - (n.h)^2 has none.
SHADER_FN float ggx_distribution(float alpha2, vec3 normal, vec3 h) {
    vec3 nxh = cross(normal, h);
    float nh = brdf_cosine(normal, h);
    float slope = dot(nxh, nxh) + alpha2 * nh * nh;
    return alpha2 * INVERSE_PI / (slope * slope);
}

/// Smith's masking, as sqrt(alpha^2 + (1 - alpha^2) cos^2).
SHADER_FN float smith_root(float alpha2, float cosine) { return sqrt(alpha2 + (1.0f - alpha2) * cosine * cosine); }

/// BRDF * cosine and density for unit vectors; `view` and `light` point away from the surface.
/// Reciprocal but for the cosine. Never NaN, infinite or negative, whatever the (unit) directions.
SHADER_FN BrdfValue brdf_evaluate(Brdf brdf, vec3 normal, vec3 view, vec3 light) {
    BrdfValue seen;
    float nl = brdf_cosine(normal, light);
    if (!(nl > 0.0f)) {
        seen.value = vec3(0.0f);
        seen.pdf = 0.0f;
        return seen;
    }
    seen.value = brdf.albedo * (nl * INVERSE_PI);
    seen.pdf = nl * INVERSE_PI;
    if (brdf.f0 > 0.0f) {
        vec3 v = brdf_view(normal, view);
        float nv = brdf_cosine(normal, v);
        vec3 h = normalize(v + light);
        float alpha2 = brdf.alpha * brdf.alpha;
        float distribution = ggx_distribution(alpha2, normal, h);
        // Smith: masking for the density, masking and shadowing together for the value.
        float root_v = smith_root(alpha2, nv);
        float root_l = smith_root(alpha2, nl);
        float fresnel = brdf.f0 + (1.0f - brdf.f0) * schlick_weight(dot(v, h));
        float specular = 0.5f * fresnel * distribution * nl / (nl * root_v + nv * root_l);
        float visible_normals = 0.5f * distribution / (nv + root_v);
        float shading = coat_shading(brdf.alpha);
        float under = diffuse_under_coat(brdf.f0, shading, nv) * (1.0f - shading * schlick_weight(nl));
        seen.value = seen.value * under + vec3(specular);
        seen.pdf = mix(seen.pdf, visible_normals, specular_probability(brdf, nv));
    }
    return seen;
}

/// Density per steradian with which `brdf_sample` draws `light`.
SHADER_FN float brdf_pdf(Brdf brdf, vec3 normal, vec3 view, vec3 light) { return brdf_evaluate(brdf, normal, view, light).pdf; }

/// Reflection of a local view (z = normal) off a GGX normal drawn from those the view sees. Source:
/// Dupuy and Benyoub, "Sampling Visible GGX Normals with Spherical Caps", 2023.
SHADER_FN vec3 sample_visible_reflection(vec3 view, float alpha, vec2 u) {
    vec3 stretched = normalize(vec3(alpha * view.x, alpha * view.y, view.z));
    float angle = TWO_PI * u.x;
    float z = (1.0f - u.y) * (1.0f + stretched.z) - stretched.z;
    float radius = sqrt(clamp(1.0f - z * z, 0.0f, 1.0f));
    vec3 h = vec3(radius * cos(angle), radius * sin(angle), z) + stretched;
    // The two unit vectors cancel only for a view along the surface, which brdf_view has lifted.
    h = normalize(vec3(alpha * h.x, alpha * h.y, max(h.z, 1e-7f)));
    return 2.0f * dot(view, h) * h - view;
}

/// Density per steradian of the direction that sample_visible_reflection draws for a surface with a
/// GGX lobe, for unit vectors; 0 below the horizon.
SHADER_FN float visible_reflection_pdf(Brdf brdf, vec3 normal, vec3 view, vec3 light) {
    if (!(dot(normal, light) > 0.0f)) return 0.0f;
    vec3 v = brdf_view(normal, view);
    float nv = brdf_cosine(normal, v);
    float alpha2 = brdf.alpha * brdf.alpha;
    return 0.5f * ggx_distribution(alpha2, normal, normalize(v + light)) / (nv + smith_root(alpha2, nv));
}

/// Draws a light direction in proportion to the reflected light, as a mixture of the cosine lobe
/// and GGX's visible normals. u.z chooses between the two, u.xy the direction.
SHADER_FN BrdfSample brdf_sample(Brdf brdf, vec3 normal, vec3 view, vec3 u) {
    Basis basis = make_basis(normal);
    BrdfSample drawn;
    vec3 local;
    bool specular = false;
    if (brdf.f0 > 0.0f) {
        vec3 v = brdf_view(normal, view);
        specular = u.z < specular_probability(brdf, brdf_cosine(normal, v));
        if (specular) {
            local = sample_visible_reflection(to_local(basis, v), brdf.alpha, vec2(u.x, u.y));
        }
    }
    if (!specular) local = sample_cosine_hemisphere(vec2(u.x, u.y));
    drawn.direction = normalize(to_world(basis, local));
    drawn.seen = brdf_evaluate(brdf, normal, view, drawn.direction);
    return drawn;
}

SHADER_END
#endif
