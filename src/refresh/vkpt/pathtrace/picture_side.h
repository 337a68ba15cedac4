// SPDX-License-Identifier: GPL-2.0-or-later
// A part of the picture's columns, and what its passes are compiled for: technique, guider, ray
// tracing backend and the features of the scene. While techniques are compared there are two.
#pragma once

#include "refresh/vkpt/gpu/compute_pass.h"
#include "refresh/vkpt/guiding/guider.h"
#include "refresh/vkpt/light/technique.h"
#include "refresh/vkpt/scene/scene.h"

#include <span>

namespace vigil::vkpt {

/// What path-tracing passes are compiled for.
struct PathTracerVariant {
    Technique technique = Technique::sll;
    SceneFeatures features;
    bool ray_query = false;
    GuideChoice guide{}; // of indirect rays
};

struct PictureSide {
    PathTracerVariant variant;
    bool samples_lights = false;       ///< the technique's promise
    bool filtered = false;             ///< if the picture is
    bool guided = false;               ///< set 2 is this frame's: views may look into it
    VkDescriptorSet guiding = nullptr; ///< set 2
    uint32_t first_column = 0;
    uint32_t end_column = 0;    ///< the one after its last; a side may have none
    uint32_t indirect_turn = 0; ///< shared/indirect_turn.h
};

/// Sides of a picture, at most.
inline constexpr size_t most_sides = 2;

/// Index of the side that the crosshair looks at.
size_t crosshair_side(std::span<const PictureSide> sides, glm::uvec2 picture_size);

/// The features, and what guides rays, as constants of shaders: the ids of trace/trace.glsl and
/// scene/frame.glsl.
std::vector<gpu::Specialization> specialization(const SceneFeatures& features,
                                                const GuideChoice& guide);

/// Rows that a pass's shader is compiled for one by one, besides the ray tracing backend.
enum class CompiledFor { Scene, Technique, Guider, TechniqueAndGuider };

/// Chooses a pass's pipeline for `variant`; `more` are constants of its own.
void choose_variant(ComputePass& pass, const PathTracerVariant& variant, CompiledFor rows,
                    const std::vector<gpu::Specialization>& more = {});

} // namespace vigil::vkpt
