// SPDX-License-Identifier: GPL-2.0-or-later
// Sky and sun as lights (pt_env_nee): points of a window to the sky and directions of the sun are drawn like points on a lamp, and a
// ray that is sent anyway may meet what was drawn. Both then count in part, by the balance heuristic (Veach and Guibas 1995).
// Host side: scene/sky_windows.h, scene/sun.h.
#ifndef VIGIL_PATHTRACE_ENVIRONMENT_GLSL
#define VIGIL_PATHTRACE_ENVIRONMENT_GLSL

#include "pathtrace/sky.glsl"
#include "shared/triangle_light.h"

bool is_environment(Light light) { return HAS_ENVIRONMENT && light.flags != 0u; }
bool is_sun(Light light) { return HAS_ENVIRONMENT && (light.flags & LIGHT_SUN) != 0u; }

/// A direction of the sun. geometry is 1, as for a point of all its flux: so it is finite for a sun without extent.
LightSample sample_sun(vec2 u) {
    LightSample seen;
    seen.direction = normalize(to_world(make_basis(frame.sun_direction), sample_cone(u, frame.sun_size)));
    seen.distance = 1e30;
    seen.point = vec3(0.0);
    seen.geometry = 1.0;
    seen.pdf = 1.0;
    return seen;
}

/// 1 / density of a direction that is drawn on an environment light, whose direction it is; 0 for a sun without extent, not finite where none is drawn.
float environment_inverse_density(Light light, vec3 position, vec3 direction) {
    if (is_sun(light)) return TWO_PI * frame.sun_size;
    const vec2 at = light_plane_point(light, position, direction);
    const vec3 point = light.v0 + at.x * light.e1 + at.y * light.e2;
    return 1.0 / light_pdf(light, near_light(light, position, frame.settings.pt_light_density), position, point);
}

/// The light of a window to the sky through which a ray from `position` meets a sky face; NONE if there is none. Who draws points on the
/// window asks the same, so that every direction is one light's.
uint sky_light(Hit hit, vec3 position, vec3 direction) {
    const uint window = load_primitive(hit.primitive).light;
    if (window == NONE) return NONE;
    const uint first = (HAS_INSTANCES ? load_instance(hit.instance).first_light : 0u) + window;
    const Light cell = load_light(first);
    const vec2 at = light_plane_point(cell, position, direction);
    const vec2 cells = vec2((cell.flags >> LIGHT_COLUMNS_SHIFT) & LIGHT_CELLS_MASK, (cell.flags >> LIGHT_ROWS_SHIFT) & LIGHT_CELLS_MASK);
    if (!(all(greaterThanEqual(at, vec2(0.0))) && all(lessThan(at, cells)))) return NONE; // also for what is no number
    const vec2 place = floor(at);
    const uint half_cell = dot(at - place, vec2(1.0)) > 1.0 ? 1u : 0u;
    return first + 2u * (uint(place.y) * uint(cells.x) + uint(place.x)) + half_cell;
}

bool is_sky(Hit hit) { return hit.front && (load_material(load_primitive(hit.primitive).material).flags & MATERIAL_SKY) != 0u; }

/// Part of what comes from a direction that falls to light samples, in [0, 1]; the rest falls to rays, which have the density `ray_pdf`
/// there. `probability` is the light's.
float sampled_share(float probability, float inverse_density, float ray_pdf) {
    const float rays = ray_pdf * inverse_density;
    return rays < 1e30 ? probability / max(probability + rays, 1e-30) : 0.0;
}

#endif
