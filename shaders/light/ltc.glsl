// SPDX-License-Identifier: GPL-2.0-or-later
// The fitted table of linearly transformed cosines on the GPU: its records, and the look-up that
// shared/ltc.h leaves to the language that holds the table. A shader that never calls it makes no access to the table.
#ifndef VIGIL_LIGHT_LTC_GLSL
#define VIGIL_LIGHT_LTC_GLSL

#include "shared/bindings.h"
#include "shared/ltc.h"
#include "trace/records.glsl"

// LTC_TABLE_SIZE^2 entries, refresh/vkpt/light/ltc_table.h.
layout(set = SET_SCENE, binding = BINDING_LTC) uniform utextureBuffer ltc_records;

LtcEntry load_ltc_entry(uint index) {
    const int at = int(index) * LTC_ENTRY_TEXELS;
    return LtcEntry(load_floats(ltc_records, at), load_floats(ltc_records, at + 1).xy);
}

/// The table at a GGX width and the cosine of the view, interpolated.
LtcEntry ltc_lookup(float alpha, float view_cosine) {
    const LtcCell cell = ltc_cell(alpha, view_cosine);
    const uint first = cell.row * LTC_TABLE_SIZE + cell.column;
    const uint below = first + LTC_TABLE_SIZE;
    return ltc_mix(load_ltc_entry(first), load_ltc_entry(first + 1u), load_ltc_entry(below), load_ltc_entry(below + 1u), cell.weight);
}

/// Prepares a point with a diffuse and a GGX lobe for `ltc_importance`; directions are unit vectors.
LtcSurface ltc_prepare_glossy(vec3 position, vec3 normal, vec3 view, Brdf brdf) {
    const float view_cosine = brdf_cosine(normal, brdf_view(normal, view));
    return ltc_prepare_glossy(position, normal, view, brdf, ltc_lookup(brdf.alpha, view_cosine));
}

#endif
