// SPDX-License-Identifier: GPL-2.0-or-later
// How bright the sky is, by and large: what the choice of lights knows of it. Not what a ray sees
// (shaders/pathtrace/sky.glsl).
#pragma once

#include "refresh/vkpt/scene/texture_set.h"

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace vigil::vkpt {

class SkyBrightness {
public:
    /// An even sky of this radiance.
    explicit SkyBrightness(glm::vec3 radiance = glm::vec3(0.0f)) : mean_(radiance) {}
    /// The sky box whose first header in `textures` is `first`, times `factor`. One that turns is
    /// known by its mean alone.
    SkyBrightness(const TextureSet& textures, uint32_t first, const glm::vec3& factor, bool turns);

    /// Mean radiance of what shines in through a plane: over the directions around `outwards`
    /// (unit, to the sky) by their cosine. Above 0 unless the sky is black; of one that is not
    /// even, at least a thousandth of the whole sky's mean.
    glm::vec3 through(const glm::vec3& outwards) const;

private:
    struct Patch {
        glm::vec3 direction; // unit
        float solid_angle;
        glm::vec3 radiance;
    };
    glm::vec3 mean_;
    std::vector<Patch> patches_; // none: it is even
};

} // namespace vigil::vkpt
