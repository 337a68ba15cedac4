// SPDX-License-Identifier: GPL-2.0-or-later
// How often shadow rays reached a light, counted by the PVS cluster they came from, the light, and
// the side of the world that the surface faces: what Quake II RTX's light lists learn from one
// frame for the next. Counts lie in a table under a hash of those three, so that lights may come
// and go and lists may be made anew without moving a number. Keys are not stored: two that share a
// slot share their counts, which costs some of their use, and no bias. Counting and reading never
// meet: a frame reads what was made of counts before it.
#ifndef VIGIL_SHARED_SHADOW_STATISTICS_H
#define VIGIL_SHARED_SHADOW_STATISTICS_H

#include "glsl.h"
#include "random.h"

SHADER_BEGIN

/// A ray adds this much to a count. Counts lose a quarter every frame, in whole numbers, so that a
/// ray is forgotten after a dozen frames.
SHADER_CONST uint SHADOW_RAY = 64u;
/// No light loses more of its weight than this, however often it was hidden.
SHADER_CONST float SHADOW_MOST_LOSS = 0.9f;
/// Words of a slot.
SHADER_CONST uint SHADOW_SLOT_WORDS = 3u;

/// Which of the six sides of the world a unit vector points to: 2 * axis, + 1 if negative.
SHADER_FN uint dominant_direction(vec3 normal) {
    const vec3 size = abs(normal);
    if (size.x >= size.y && size.x >= size.z) return normal.x < 0.0f ? 1u : 0u;
    if (size.y >= size.z) return normal.y < 0.0f ? 3u : 2u;
    return normal.z < 0.0f ? 5u : 4u;
}

/// The slot of a light seen from a cluster by surfaces of one of six directions; `slots` is a power
/// of two.
SHADER_FN uint shadow_slot(uint cluster, uint light, uint direction, uint slots) {
    const uint word = hash_pcg3d(uvec3(cluster, light, direction)).x;
    return (word ^ (word >> 16u)) & (slots - 1u); // its top bits are the best mixed
}

// Where a slot's words are: losses first, for those are what every candidate asks for.
SHADER_FN uint shadow_loss_word(uint slot) { return slot; }
SHADER_FN uint shadow_count_word(uint slot, uint slots, bool shadowed) { return slots + 2u * slot + (shadowed ? 1u : 0u); }

/// What a light loses of its weight: the share of shadowed rays, at most SHADOW_MOST_LOSS, and
/// nothing as long as nothing is known.
SHADER_FN float shadow_loss(uint seen, uint shadowed) {
    const float rays = float(seen) + float(shadowed);
    return rays > 0.0f ? min(float(shadowed) / rays, SHADOW_MOST_LOSS) : 0.0f;
}

/// A count one frame later.
SHADER_FN uint fade_shadow_count(uint count) { return count - count / 4u - ((count & 3u) != 0u ? 1u : 0u); }

SHADER_END
#endif
