// SPDX-License-Identifier: GPL-2.0-or-later
// How likely every light of the level is to be looked at by samples that search for new lights
// (paper, section 4.3): a blend of three densities, of power, of change, and of nearness to the
// camera. Knows nothing of surfaces: it has to be drawn from in constant time.
#pragma once

#include "shared/scene_types.h"

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace vigil {

/// Weights of the three densities, at least 0; only their ratios matter.
struct ExplorationMix {
    float energy = 1.0f;
    float change = 1.0f;
    float distance = 1.0f;
    bool operator==(const ExplorationMix&) const = default;
};

class Exploration {
public:
    /// Weights of this frame's lights, one for each: their sum is 1, or 0 if none shines; 0 for
    /// dark lights, and positive for every other one, whatever the mix. `eye` is the camera's
    /// position. Call once per frame: changes are against the call before. A density that has
    /// nothing to say (no light changed) leaves its part to the others.
    std::vector<float> weights(std::span<const shader::Light> lights, const glm::vec3& eye,
                               const ExplorationMix& mix);

    /// Whether the weights would differ in the next call with the same arguments: changes fade over
    /// some frames.
    bool fading() const { return fading_; }

private:
    std::vector<shader::Light> before_;
    std::vector<float> change_; // power that changed, fading
    bool first_ = true;
    bool fading_ = false;
};

} // namespace vigil
