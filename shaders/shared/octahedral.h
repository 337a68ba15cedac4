// SPDX-License-Identifier: GPL-2.0-or-later
// The octahedral map between directions and the unit square (Meyer et al., "On Floating-Point
// Normal Vectors", 2010) and the density factor between the two. The
// upper half of the octahedron (z >= 0) is the inner diamond; the lower half folds over into the
// corners.
#ifndef VIGIL_SHARED_OCTAHEDRAL_H
#define VIGIL_SHARED_OCTAHEDRAL_H

#include "glsl.h"

SHADER_BEGIN

/// Largest coordinate that `octahedral_encode` returns, so that floor(uv * 2^k) is always a valid
/// cell.
SHADER_CONST float OCTAHEDRAL_MAX = 1.0f - 1.0f / 16777216.0f;

/// The fold between the two halves: its own inverse. Zero counts as positive, so no axis falls on a
/// corner's wrong side.
SHADER_FN vec2 octahedral_fold(vec2 p) {
    return vec2((1.0f - abs(p.y)) * (p.x >= 0.0f ? 1.0f : -1.0f), (1.0f - abs(p.x)) * (p.y >= 0.0f ? 1.0f : -1.0f));
}

/// A coordinate of the unit square, below 1; 0 for what is no number.
SHADER_FN float octahedral_inside(float x) { return x > 0.0f ? min(x, OCTAHEDRAL_MAX) : 0.0f; }

/// Direction of any length from 1e-37 to 1e38 to the unit square, [0, 1)^2. The zero vector maps to
/// the centre, and anything else, numbers or not, to some point of the square.
SHADER_FN vec2 octahedral_encode(vec3 direction) {
    float sum = abs(direction.x) + abs(direction.y) + abs(direction.z);
    vec2 q = vec2(direction.x, direction.y) / max(sum, 1e-37f);
    q = direction.z >= 0.0f ? q : octahedral_fold(q);
    return vec2(octahedral_inside(0.5f * q.x + 0.5f), octahedral_inside(0.5f * q.y + 0.5f));
}

/// The point q of the octahedron |x| + |y| + |z| = 1 above a point of the unit square.
SHADER_FN vec3 octahedral_point(vec2 uv) {
    vec2 p = 2.0f * uv - 1.0f;
    float z = 1.0f - abs(p.x) - abs(p.y);
    p = z >= 0.0f ? p : octahedral_fold(p);
    return vec3(p.x, p.y, z);
}

/// Unit square to unit direction, to within 3e-7 radians.
SHADER_FN vec3 octahedral_decode(vec2 uv) { return normalize(octahedral_point(uv)); }

/// Square density to solid-angle density: pdf per steradian = pdf per unit square area * this
/// factor, |q|_2^3 / 4. For a unit direction q = d / |d|_1, so that |q|_2 = 1 / |d|_1. In [0.048,
/// 0.25]; relative error below 10 * 2^-24.
SHADER_FN float octahedral_density(vec3 direction) {
    float sum = abs(direction.x) + abs(direction.y) + abs(direction.z);
    return 0.25f / (sum * sum * sum);
}

SHADER_END
#endif
