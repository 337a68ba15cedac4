// SPDX-License-Identifier: GPL-2.0-or-later
// How much a light matters to a surface: the linearly transformed cosines of shared/ltc.h on this scene's lights, with
// visibility left out. Used by every technique that weighs lights one by one.
#ifndef VIGIL_LIGHT_IMPORTANCE_GLSL
#define VIGIL_LIGHT_IMPORTANCE_GLSL

#include "light/ltc.glsl"
#include "pathtrace/surface.glsl"

LtcSurface prepare_importance(Surface surface) {
    if (HAS_GLOSS && surface.brdf.f0 > 0.0) return ltc_prepare_glossy(surface.origin, surface.normal, surface.view, surface.brdf);
    return ltc_prepare_diffuse(surface.origin, surface.normal, luminance(surface.brdf.albedo));
}

float light_importance(LtcSurface surface, uint light) {
    return ltc_importance(surface, lights[light], HAS_GLOSS);
}

#endif
