// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/scene/sky_brightness.h"

#include "formats/sky.h"

#include <algorithm>

namespace vigil::vkpt {

namespace {

/// Patches along an edge of a side.
constexpr uint32_t patch_edge = 16;
constexpr float least_share = 1e-3f;

/// Mean of the texels that a patch of a picture holds: at least one, whatever its size.
glm::vec3 patch_mean(const TextureSet& textures, const shader::Texture& picture, glm::uvec2 patch) {
    const glm::uvec2 size(picture.width, picture.height);
    const glm::uvec2 first = glm::min(patch * size / patch_edge, size - 1u);
    const glm::uvec2 end = glm::clamp((patch + 1u) * size / patch_edge, first + 1u, size);
    glm::dvec3 sum(0.0);
    for (uint32_t y = first.y; y < end.y; ++y)
        for (uint32_t x = first.x; x < end.x; ++x)
            sum +=
                glm::dvec3(decode_rgb9e5(textures.texels()[picture.first_texel + y * size.x + x]));
    const glm::uvec2 count = end - first;
    return glm::vec3(sum / static_cast<double>(count.x * count.y));
}

} // namespace

SkyBrightness::SkyBrightness(const TextureSet& textures, uint32_t first, const glm::vec3& factor,
                             bool turns)
    : mean_(0.0f) {
    float whole = 0.0f;
    for (uint32_t side = 0; side < sky_sides.size(); ++side) {
        const SkySide& view = sky_sides[side];
        for (uint32_t y = 0; y < patch_edge; ++y)
            for (uint32_t x = 0; x < patch_edge; ++x) {
                const glm::vec2 at = 2.0f * (glm::vec2(x, y) + 0.5f) / float{patch_edge} - 1.0f;
                const glm::vec3 towards = view.forward + at.x * view.right - at.y * view.up;
                const float squared = glm::dot(towards, towards);
                // Area over squared distance, times the cosine on the side.
                const float solid_angle =
                    4.0f / float{patch_edge * patch_edge} / (squared * std::sqrt(squared));
                const glm::vec3 radiance =
                    factor * patch_mean(textures, textures.headers()[first + side], {x, y});
                patches_.push_back({glm::normalize(towards), solid_angle, radiance});
                mean_ += solid_angle * radiance;
                whole += solid_angle;
            }
    }
    mean_ /= whole;
    if (turns) patches_.clear();
}

glm::vec3 SkyBrightness::through(const glm::vec3& outwards) const {
    if (patches_.empty()) return mean_;
    glm::vec3 sum(0.0f);
    float weights = 0.0f;
    for (const Patch& patch : patches_) {
        const float weight =
            patch.solid_angle * std::max(glm::dot(patch.direction, outwards), 0.0f);
        sum += weight * patch.radiance;
        weights += weight;
    }
    return glm::max(sum / std::max(weights, 1e-6f), least_share * mean_);
}

} // namespace vigil::vkpt
