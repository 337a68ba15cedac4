// SPDX-License-Identifier: GPL-2.0-or-later
// Counter-based random numbers: every draw is a hash of (key, dimension), so a draw needs no memory
// and no history. The hashes are pcg3d and pcg4d of Jarzynski and Olano, "Hash Functions for GPU
// Rendering", JCGT 2020. White noise only: no stratification, no blue noise, nothing cryptographic.
#ifndef VIGIL_SHARED_RANDOM_H
#define VIGIL_SHARED_RANDOM_H

#include "glsl.h"

SHADER_BEGIN

/// One stream. Copies continue independently from the same point.
struct Random {
    uvec2 key;      // names the stream: a hash of pixel, frame and seed
    uint dimension; // number of draws so far
};

/// Three words from three words; a bijection.
SHADER_FN uvec3 hash_pcg3d(uvec3 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}

/// Four words from four words; a bijection.
SHADER_FN uvec4 hash_pcg4d(uvec4 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    v ^= v >> 16u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    return v;
}

/// Starts the stream of one pixel in one frame. Streams of different pixels, frames or seeds are
/// independent.
SHADER_FN Random random_begin(uvec2 pixel, uint frame, uint seed) {
    // 64 bits of the hash name the stream, so two pixels of a frame share one only by a chance of
    // 2^-64. The words' top bits are the best mixed; folding them down mends the low ones.
    uvec4 hash = hash_pcg4d(uvec4(pixel.x, pixel.y, frame, seed));
    hash ^= hash >> 16u;
    Random random;
    random.key = uvec2(hash.x ^ hash.z, hash.y ^ hash.w);
    random.dimension = 0u;
    return random;
}

/// Paths of a pixel so far, as (low, high) 32 bits: `per_frame` in each frame before this one.
SHADER_FN uvec2 path_number(uint frame, uint per_frame, uint path_of_frame) {
    uint high, low, carry;
    umulExtended(frame, per_frame, high, low);
    low = uaddCarry(low, path_of_frame, carry);
    return uvec2(low, high + carry);
}

/// Streams that each path has: RANDOM_STREAMS of them.
SHADER_CONST uint RANDOM_STREAMS = 4u;

/// Starts a stream of a path, which path_number has counted. Pixels have coordinates below 2^16, so
/// that their words have room for what a path's number has beyond 30 bits: the 2^44 paths of 2^32
/// frames, 4,096 in each, all have streams of their own.
SHADER_FN Random random_path(uvec2 pixel, uvec2 path, uint stream, uint seed) {
    const uint beyond = (path.y << 2u) | (path.x >> 30u);
    return random_begin(pixel ^ uvec2(0u, beyond << 16u), RANDOM_STREAMS * path.x + stream, seed);
}

/// The next draw as three words. Their top 24 bits are good enough to sample with; the low ones
/// less so.
SHADER_FN uvec3 random_next_words(INOUT(Random) random) {
    uvec3 words = hash_pcg3d(uvec3(random.key, random.dimension));
    random.dimension += 1u;
    return words;
}

/// Maps the top 24 bits of a word to [0, 1 - 2^-24], evenly and exactly.
SHADER_FN float unit_float(uint word) {
    // Signed conversion is one instruction on CPUs, unsigned is several.
    return float(int(word >> 8u)) * (1.0f / 16777216.0f);
}

/// Uniform in [0, 1), strictly below 1.
SHADER_FN float random_next(INOUT(Random) random) { return unit_float(random_next_words(random).x); }

/// Two independent uniforms for the price of one draw.
SHADER_FN vec2 random_next2(INOUT(Random) random) {
    uvec3 words = random_next_words(random);
    return vec2(unit_float(words.x), unit_float(words.y));
}

/// Three independent uniforms for the price of one draw.
SHADER_FN vec3 random_next3(INOUT(Random) random) {
    uvec3 words = random_next_words(random);
    return vec3(unit_float(words.x), unit_float(words.y), unit_float(words.z));
}

/// 64 uniform bits, low bits as good as high ones; for the alias table.
SHADER_FN uvec2 random_next_bits(INOUT(Random) random) {
    uvec3 words = random_next_words(random);
    words ^= words >> 16u;
    return uvec2(words.x, words.y ^ words.z);
}

/// Steps of the R2 sequence (Roberts 2018), in parts of 2^32: multiples of them fill the unit square
/// evenly, and sums of one multiple of each the unit interval.
SHADER_CONST uvec2 R2_STEPS = uvec2(3242174889u, 2447445414u);

SHADER_END
#endif
