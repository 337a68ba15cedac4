#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `shadow_statistics`: before a frame is traced, an invocation per slot turns what was counted up to here into what the frame
// reads, and lets the counts fade.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"

#define SET_SHADOW_STATISTICS 0
#include "light/shadow_statistics.glsl"

layout(local_size_x = 64) in;

void main() {
    const uint slot = gl_GlobalInvocationID.x;
    if (slot >= shadow_slots) return;
    const uint seen_word = shadow_count_word(slot, shadow_slots, false);
    const uint shadowed_word = shadow_count_word(slot, shadow_slots, true);
    const uint seen = shadow_words[seen_word];
    const uint shadowed = shadow_words[shadowed_word];
    shadow_words[shadow_loss_word(slot)] = floatBitsToUint(shadow_loss(seen, shadowed));
    if ((seen | shadowed) == 0u) return; // most slots are empty
    shadow_words[seen_word] = fade_shadow_count(seen);
    shadow_words[shadowed_word] = fade_shadow_count(shadowed);
}
