// SPDX-License-Identifier: GPL-2.0-or-later
// How much a light matters to a surface: the linearly transformed cosines of shared/ltc.h on this scene's lights, with
// visibility left out. Used by every technique that weighs lights one by one.
#ifndef VIGIL_LIGHT_IMPORTANCE_GLSL
#define VIGIL_LIGHT_IMPORTANCE_GLSL

#include "light/ltc.glsl"
#include "scene/firewall.glsl"
#include "scene/surface.glsl"

LtcSurface prepare_importance(Surface surface) {
    if (HAS_GLOSS && surface.brdf.f0 > 0.0) return ltc_prepare_glossy(surface.origin, surface.normal, surface.view, surface.brdf);
    return ltc_prepare_diffuse(surface.origin, surface.normal, luminance(surface.brdf.albedo));
}

/// Of choosing only: sums of importances, and their quotients with probabilities, stay finite below this.
const float LIGHT_IMPORTANCE_MOST = 1e18;

/// The light as the triangle that it is seen as from a position.
Light load_light(uint light, vec3 position) {
    Light seen = load_light(light);
    if (HAS_ENVIRONMENT) seen = light_from(seen, position);
    return seen;
}

float light_importance(LtcSurface surface, uint light) {
    return min(finite_or_zero(ltc_importance(surface, load_light(light, surface.position), HAS_GLOSS)), LIGHT_IMPORTANCE_MOST);
}

/// Solid angle times luminance of a light that can shine on a surface at this place, 0 for others: knows neither what the surface
/// reflects nor, but for all or nothing, how slanted light falls on it.
float solid_angle_importance(vec3 position, vec3 normal, uint light) {
    const Light seen = load_light(light, position);
    const float brightness = luminance(seen.radiance);
    if (!(brightness > 0.0)) return 0.0;
    // A corner above the surface's horizon.
    const float height = dot(normal, seen.v0 - position) + max(max(dot(normal, seen.e1), dot(normal, seen.e2)), 0.0);
    return height > 0.0 ? min(finite_or_zero(brightness * light_solid_angle(seen, position)), LIGHT_IMPORTANCE_MOST) : 0.0;
}

#endif
