// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/pathtrace/picture_side.h"

#include "shared/direction_map.h"

#include <fmt/format.h>

namespace vigil::vkpt {

size_t crosshair_side(std::span<const PictureSide> sides, glm::uvec2 picture_size) {
    const uint32_t column = shader::crosshair_pixel(picture_size).x;
    return sides.size() > 1 && column >= sides[1].first_column ? 1 : 0;
}

std::vector<gpu::Specialization> specialization(const SceneFeatures& features,
                                                const GuideChoice& guide) {
    std::vector<gpu::Specialization> constants{{CONSTANT_GUIDER_SIZE, guide.size}};
    for (const SceneFeatureRow& row : scene_feature_rows)
        constants.push_back({row.constant, features.*row.member});
    return constants;
}

void choose_variant(ComputePass& pass, const PathTracerVariant& variant, CompiledFor rows,
                    const std::vector<gpu::Specialization>& more) {
    std::string suffix;
    if (rows == CompiledFor::Technique || rows == CompiledFor::TechniqueAndGuider)
        suffix += fmt::format(".{}", technique_infos[static_cast<size_t>(variant.technique)].name);
    if (rows == CompiledFor::Guider || rows == CompiledFor::TechniqueAndGuider)
        suffix += fmt::format(".{}", guider_name(variant.guide.guide));
    if (variant.ray_query) suffix += ".query";
    std::vector<gpu::Specialization> constants = specialization(variant.features, variant.guide);
    constants.insert(constants.end(), more.begin(), more.end());
    pass.choose(suffix, std::move(constants), variant.ray_query);
}

} // namespace vigil::vkpt
