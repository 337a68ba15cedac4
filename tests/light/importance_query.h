// SPDX-License-Identifier: GPL-2.0-or-later
// What the importance test and benchmark ask of the GPU: surfaces, and the alternatives to measure.
// C++ and GLSL.
#ifndef VIGIL_TESTS_IMPORTANCE_QUERY_H
#define VIGIL_TESTS_IMPORTANCE_QUERY_H

#include "shared/ltc.h"

SHADER_BEGIN

struct ImportanceQuery {
    vec3 position;
    vec3 normal;
    vec3 view;
    float albedo; // diffuse
    float f0;     // 0: diffuse only
    float alpha;
    uint first_light; // lights first_light + k * 7 (modulo their number) are asked about
};

SHADER_CONST uint IMPORTANCE_SHIPPED = 0u;  // ltc_importance
SHADER_CONST uint IMPORTANCE_GLOSSY = 1u;   // the same with the GGX lobe
SHADER_CONST uint IMPORTANCE_CONTOUR = 2u;  // every light by its contour
SHADER_CONST uint IMPORTANCE_CENTROID = 3u; // every light by its centroid
SHADER_CONST uint IMPORTANCE_POINTS = 4u;   // every light by three points
SHADER_CONST uint IMPORTANCE_LOAD = 5u;     // sums the light's numbers: what reading lights costs
SHADER_CONST uint IMPORTANCE_MODES = 6u;

/// The alternatives that lost (docs/internals/light-sampling.md), for comparison. None keeps all
/// promises of the shipped one.
SHADER_FN float alternative_importance(uint mode, LtcSurface surface, Light light) {
    vec3 v0 = light.v0 - surface.position;
    if (mode == IMPORTANCE_LOAD) return luminance(light.radiance + light.e1 + light.e2 + v0);
    float facing = light_facing(light, surface.position);
    if (!(facing > 0.0f)) return 0.0f;
    vec3 height = dot(surface.normal, v0) +
                  vec3(0.0f, dot(surface.normal, light.e1), dot(surface.normal, light.e2));
    float form = 0.0f;
    if (mode == IMPORTANCE_CONTOUR) {
        if (!(max(height.x, max(height.y, height.z)) > 0.0f)) return 0.0f;
        form = contour_form_factor(surface.normal, v0, v0 + light.e1, v0 + light.e2, height);
    } else if (mode == IMPORTANCE_CENTROID) {
        vec3 center = v0 + (light.e1 + light.e2) / 3.0f;
        float squared = dot(center, center);
        form = facing * max(dot(surface.normal, center), 0.0f) / (TWO_PI * squared * squared);
    } else {
        form = point_form_factor(v0, light.e1, light.e2, height, facing).x;
    }
    return surface.diffuse * form * luminance(light.radiance);
}

SHADER_END
#endif
