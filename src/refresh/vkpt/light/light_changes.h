// SPDX-License-Identifier: GPL-2.0-or-later
// How much every light differs from what it was a frame ago, for the filter's memory of light. No
// GPU.
#pragma once

#include "shared/scene_types.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vigil {

/// Whether two lights are the same triangle.
bool same_place(const shader::Light& a, const shader::Light& b);

/// 0: the same light; 1: it has come, gone or moved. In between: its brightness has changed by this
/// part of the greater of both.
float light_change(const shader::Light& before, const shader::Light& now);

class LightChanges {
public:
    /// Takes the lights of a frame; their `revision` grows with every change. Returns whether any
    /// has changed since the frame before, or just before that: a change lasts, halved from frame
    /// to frame, because few samples find it in the first.
    bool update(std::span<const shader::Light> lights, uint64_t revision);
    /// By light id, of the last update that returned true.
    std::span<const float> factors() const { return factors_; }
    /// The next frame's lights are the first.
    void forget();

private:
    std::vector<shader::Light> before_;
    std::vector<float> factors_;
    uint64_t revision_ = 0;
    bool lasting_ = false; // some factor is above 0
};

} // namespace vigil
