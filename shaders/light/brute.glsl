// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `brute`: samples no light at all. The path tracer then counts the emission that its rays run into, which
// has the same mean: the reference that the statistical tests hold the others against.
#define LIGHTS_FOUND_BY_RAYS 1

LightChoice choose_light(Surface surface, inout Random random) { return no_light(); }
float light_probability(Surface surface, uint light) { return 0.0; }
