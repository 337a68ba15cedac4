// SPDX-License-Identifier: GPL-2.0-or-later
// Colours and scales of the debug views, the same text for the shader that draws them and for the host that draws their
// legends. The colour map is a path through OKLab (Ottosson 2020) that is even by construction; the colours of classes
// differ in lightness too, so that nobody has to tell them apart by hue.
#ifndef VIGIL_SHARED_VIEW_COLORS_H
#define VIGIL_SHARED_VIEW_COLORS_H

#include "glsl.h"

SHADER_BEGIN

/// Linear light to sRGB, each channel in [0, 1] (IEC 61966-2-1).
SHADER_FN vec3 srgb_from_linear(vec3 linear) {
    const vec3 curve = 1.055f * pow(linear, vec3(1.0f / 2.4f)) - 0.055f;
    return mix(12.92f * linear, curve, greaterThan(linear, vec3(0.0031308f)));
}

/// OKLab (lightness 0..1, a: green to red, b: blue to yellow) to linear sRGB; may leave [0, 1].
SHADER_FN vec3 linear_from_oklab(vec3 lab) {
    const float l = lab.x + 0.3963377774f * lab.y + 0.2158037573f * lab.z;
    const float m = lab.x - 0.1055613458f * lab.y - 0.0638541728f * lab.z;
    const float s = lab.x - 0.0894841775f * lab.y - 1.2914855480f * lab.z;
    const vec3 cone = vec3(l * l * l, m * m * m, s * s * s);
    return vec3(4.0767416621f * cone.x - 3.3077115913f * cone.y + 0.2309699292f * cone.z,
                -1.2684380046f * cone.x + 2.6097574011f * cone.y - 0.3413193965f * cone.z,
                -0.0041960863f * cone.x - 0.7034186147f * cone.y + 1.7076147010f * cone.z);
}

/// The colour map as OKLab, `t` in [0, 1]: lightness 0.30 to 0.92, chroma 0.10, hue 320 to 100 degrees (purple, blue,
/// green, yellow). Lightness and hue grow evenly at one chroma, so equal steps of `t` look equally large, and lightness
/// alone orders them. All of it is inside sRGB.
SHADER_FN vec3 color_map_oklab(float t) {
    const float hue = 0.0174532925f * (320.0f - 220.0f * t);
    return vec3(0.30f + 0.62f * t, 0.10f * cos(hue), 0.10f * sin(hue));
}

/// The colour map as sRGB.
SHADER_FN vec3 color_map(float t) {
    const vec3 linear = linear_from_oklab(color_map_oklab(clamp(t, 0.0f, 1.0f)));
    return srgb_from_linear(clamp(linear, vec3(0.0f), vec3(1.0f)));
}

/// Counts from 1 to `most` on the colour map: logarithmic.
SHADER_FN float count_on_scale(float count, float most) { return log2(max(count, 1.0f)) / log2(most); }

/// Ends of the scales; more looks as if it were as many. A leaf splits at about a 500th of the pixels with the default pt_oct_split.
SHADER_FN float view_most_samples(uvec2 size) { return max(float(size.x * size.y) / 128.0f, 16.0f); }
SHADER_CONST float VIEW_MOST_LIGHTS = 2048.0f;
SHADER_CONST float VIEW_MOST_BUCKETS = 64.0f;

/// Directions' densities per steradian on the colour map: logarithmic, four decades, as in the paper's figure 10.
SHADER_CONST float VIEW_LEAST_DENSITY = 1.9e-2f;
SHADER_CONST float VIEW_MOST_DENSITY = 1.9e2f;
SHADER_FN float density_on_scale(float density) {
    return log2(max(density, 1e-30f) / VIEW_LEAST_DENSITY) / log2(VIEW_MOST_DENSITY / VIEW_LEAST_DENSITY);
}

/// Grey of a distance in map units: from white at the eye to black far away.
SHADER_FN float view_depth_grey(float distance) { return 1.0f / (1.0f + distance / 256.0f); }

// Colours of classes, sRGB.
SHADER_CONST vec3 VIEW_OFF = vec3(0.20f, 0.22f, 0.28f);        // there is nothing to show
SHADER_CONST vec3 VIEW_EMPTY = vec3(0.08f, 0.08f, 0.08f);      // a count of 0
SHADER_CONST vec3 VIEW_CACHE = vec3(0.70f, 0.90f, 1.00f);      // the cache drew, and it contributed
SHADER_CONST vec3 VIEW_CACHE_ZERO = vec3(0.05f, 0.22f, 0.42f); // ... and it did not
SHADER_CONST vec3 VIEW_EXPLORED = vec3(1.00f, 0.70f, 0.15f);   // exploration, the same
SHADER_CONST vec3 VIEW_EXPLORED_ZERO = vec3(0.55f, 0.25f, 0.02f);
SHADER_CONST vec3 VIEW_ZERO_SAMPLE = vec3(1.00f, 0.65f, 0.10f); // a light sample that contributed nothing
SHADER_CONST vec3 VIEW_LIT_SAMPLE = vec3(0.30f, 0.36f, 0.46f);  // one that did
SHADER_CONST vec3 VIEW_BAD = vec3(1.0f, 0.0f, 1.0f);            // not finite
SHADER_CONST vec3 VIEW_GOOD = vec3(0.05f, 0.05f, 0.05f);
SHADER_CONST vec3 VIEW_NO_CLUSTER = vec3(1.0f, 0.0f, 0.0f);
SHADER_CONST vec3 VIEW_NO_LIGHT = vec3(0.15f, 0.15f, 0.15f);

SHADER_CONST vec3 VIEW_HORIZON = vec3(1.0f, 1.0f, 1.0f); // between directions above and below a surface
SHADER_CONST float VIEW_OTHER_LEAF = 0.5f;               // factor on what is not the subject

SHADER_END
#endif
