// SPDX-License-Identifier: GPL-2.0-or-later
// One alias table over all lights, the same for every surface. The techniques `uniform` and `power` draw from it alone, `vlc` explores
// with it; they differ in the weights that their host side puts into the table.
#ifndef VIGIL_LIGHT_ALIAS_GLSL
#define VIGIL_LIGHT_ALIAS_GLSL

#include "shared/alias_table.h"
#include "trace/records.glsl"

layout(set = SET_TECHNIQUE, binding = BINDING_ALIAS_TABLE) uniform utextureBuffer alias_words; // number of entries, AliasEntry[]

/// Entries; 0: no light shines.
uint alias_count() { return load_word(alias_words, 0u); }

AliasEntry load_alias_entry(uint column) {
    const uint first = 1u + 3u * column;
    return AliasEntry(load_word(alias_words, first), load_word(alias_words, first + 1u),
                      uintBitsToFloat(load_word(alias_words, first + 2u)));
}

/// Light drawn by 64 random bits; NONE if none shines.
uint alias_light(uvec2 bits) {
    if (alias_count() == 0u) return NONE;
    const AliasSlot slot = alias_slot(bits, alias_count());
    return alias_choose(load_alias_entry(slot.column), slot);
}

/// Probability with which alias_light draws this one.
float alias_probability(uint light) { return light < alias_count() ? load_alias_entry(light).pdf : 0.0; }

#endif
