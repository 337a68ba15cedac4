// SPDX-License-Identifier: GPL-2.0-or-later
// Draws from one alias table over all lights, the same for every surface. The techniques `uniform` and `power` differ only in
// the weights their host side puts into the table.
#ifndef VIGIL_LIGHT_ALIAS_GLSL
#define VIGIL_LIGHT_ALIAS_GLSL

#include "shared/alias_table.h"

layout(set = SET_TECHNIQUE, binding = 0, scalar) restrict readonly buffer AliasBlock {
    uint alias_count; // entries; 0: no light shines
    AliasEntry alias_entries[];
};

LightChoice choose_light(Surface surface, inout Random random) {
    if (alias_count == 0u) return LightChoice(NONE, 0.0);
    const AliasSlot slot = alias_slot(random_next_bits(random), alias_count);
    const uint light = alias_choose(alias_entries[slot.column], slot);
    return LightChoice(light, alias_entries[light].pdf);
}

float light_probability(Surface surface, uint light) {
    return light < alias_count ? alias_entries[light].pdf : 0.0;
}

#endif
