// SPDX-License-Identifier: GPL-2.0-or-later
// One alias table over all lights, the same for every surface. The techniques `uniform` and `power` draw from it alone, `vlc` explores
// with it; they differ in the weights that their host side puts into the table.
#ifndef VIGIL_LIGHT_ALIAS_GLSL
#define VIGIL_LIGHT_ALIAS_GLSL

#include "shared/alias_table.h"

layout(set = SET_TECHNIQUE, binding = BINDING_ALIAS_TABLE, scalar) restrict readonly buffer AliasBlock {
    uint alias_count; // entries; 0: no light shines
    AliasEntry alias_entries[];
};

/// Light drawn by 64 random bits; NONE if none shines.
uint alias_light(uvec2 bits) {
    if (alias_count == 0u) return NONE;
    const AliasSlot slot = alias_slot(bits, alias_count);
    return alias_choose(alias_entries[slot.column], slot);
}

/// Probability with which alias_light draws this one.
float alias_probability(uint light) { return light < alias_count ? alias_entries[light].pdf : 0.0; }

#endif
