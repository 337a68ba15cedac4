// SPDX-License-Identifier: GPL-2.0-or-later
// The techniques that draw from the alias table and nothing else: `uniform`, `power`.
#include "light/alias.glsl"

LightChoice choose_light(Surface surface, inout Random random) {
    const uint light = alias_light(random_next_bits(random));
    return light_choice(light, alias_probability(light));
}

float light_probability(Surface surface, uint light) { return alias_probability(light); }
