// SPDX-License-Identifier: GPL-2.0-or-later
// A point on a chosen light, for a glossy surface: drawn on the light, or along the surface's GGX
// lobe if that meets the light. A lamp beside a polished wall is larger than the highlight it
// makes: points drawn on the lamp alone rarely hit the highlight, and are fireflies when they do
// (Veach and Guibas, "Optimally Combining Sampling Techniques for Monte Carlo Rendering", 1995: the
// one-sample model and its balance heuristic). The paper draws on the light always. Nothing is
// traced here.
#ifndef VIGIL_SHARED_LIGHT_POINT_H
#define VIGIL_SHARED_LIGHT_POINT_H

#include "brdf.h"
#include "glsl.h"
#include "ltc.h"
#include "triangle_light.h"

SHADER_BEGIN

/// Draws along the lobe are at most this part, so that the rest of the light's points keep theirs.
SHADER_CONST float LOBE_SHARE_MOST = 0.9f;
/// Lights that cover less of the lobe get no draws along it: most of those would miss.
SHADER_CONST float LOBE_COVERED_LEAST = 0.25f;

/// Which part of the draws follows the GGX lobe of a surface (unit normal and view). Taken as
/// evenly bright where it meets the light, the lobe covers a part a of the light, and the light a
/// part h of the lobe. With a part q of the draws along the lobe, a diffuse contribution d and a
/// glossy one s, the second moment is
///     d^2 (1 - a) / (1 - q) + (a d + s)^2 / ((1 - q) a + q h),
/// least at the q returned here: 0 unless the lobe is much narrower than the light.
SHADER_FN float lobe_share(LtcSurface prepared, vec3 view, Brdf brdf, Light light) {
    const LtcParts parts = ltc_parts(prepared, light, true);
    const float h = parts.covered;
    if (!(h > LOBE_COVERED_LEAST)) return 0.0f;
    // Density at the lobe's peak.
    const float nv = brdf_cosine(prepared.normal, brdf_view(prepared.normal, view));
    const float alpha2 = brdf.alpha * brdf.alpha;
    const float peak = 0.5f * INVERSE_PI / (alpha2 * (nv + smith_root(alpha2, nv)));
    const float a = h / max(peak * light_solid_angle(light, prepared.position), 1e-6f);
    if (!(a < h)) return 0.0f;
    const float beside = parts.diffuse * sqrt(1.0f - a);
    const float inside = (a * parts.diffuse + parts.specular) * sqrt(h - a);
    const float share = 1.0f - beside * h / max(inside + beside * (h - a), 1e-30f);
    return clamp(share, 0.0f, LOBE_SHARE_MOST);
}

/// Draws a point on the light as `sample_light` does, but in `share` of the draws (in [0, 1)) along
/// the GGX lobe of a surface (unit normal and view). Use and densities as there; geometry is 0 if
/// the lobe missed the light.
SHADER_FN LightSample sample_light_glossy(Light light, SphericalTriangle near, vec3 position, vec3 normal, vec3 view, Brdf brdf,
                                          float share, vec2 u) {
    if (!(share > 0.0f)) return sample_light(light, near, position, u);
    LightSample seen;
    if (u.x < share) {
        Basis basis = make_basis(normal);
        vec3 local = sample_visible_reflection(to_local(basis, brdf_view(normal, view)), brdf.alpha, vec2(u.x / share, u.y));
        vec3 direction = normalize(to_world(basis, local));
        vec2 at = light_plane_point(light, position, direction);
        bool met = at.x >= 0.0f && at.y >= 0.0f && at.x + at.y <= 1.0f; // false for NaN
        vec3 point = light.v0 + (met ? at.x : 0.0f) * light.e1 + (met ? at.y : 0.0f) * light.e2;
        seen = see_light_point(light, position, point);
        // The light's back lies on the same line, and so does what is behind the surface.
        met = met && dot(seen.direction, direction) > 0.0f && dot(normal, direction) > 0.0f && seen.geometry > 0.0f;
        seen.pdf = met ? light_pdf(light, near, position, point) : 0.0f;
    } else {
        seen = sample_light(light, near, position, vec2((u.x - share) / (1.0f - share), u.y));
    }
    if (seen.pdf > 0.0f) seen.pdf = mix(seen.pdf, visible_reflection_pdf(brdf, normal, view, seen.direction), share);
    seen.geometry = seen.pdf > 0.0f ? 1.0f / seen.pdf : 0.0f;
    return seen;
}

SHADER_END
#endif
