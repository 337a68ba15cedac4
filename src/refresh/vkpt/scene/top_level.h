// SPDX-License-Identifier: GPL-2.0-or-later
// Builds the top level of a frame: a threaded tree over the world bounds of all instances but the
// static world, in the TopNode format of shaders/shared/bvh.h. It is rebuilt in every frame in
// which an instance differs (a few thousand take a few milliseconds), and keeps nothing.
#pragma once

#include "refresh/vkpt/scene/bounds.h"
#include "shared/bvh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vigil {

/// One placed model.
struct TopLevelInstance {
    Bounds object_bounds; // of the model, in its own space; empty models are left out
    glm::mat4x3 world_from_object{1.0f};
    glm::mat4x3 object_from_world{1.0f}; // the inverse of the above
    std::uint32_t bvh_root = 0;          // from append_bvh
    std::uint32_t instance = 0; // index in Instance[]; the static world, 0, does not belong here
    std::uint32_t flags = shader::INSTANCE_PLAIN; // as in Instance[]

    bool operator==(const TopLevelInstance&) const = default;
};

/// Box in world space around the transformed box.
Bounds transform_bounds(const Bounds& bounds, const glm::mat4x3& world_from_object);

/// The nodes of BINDING_TOP_NODES, never empty: without instances one node that nothing enters.
std::vector<shader::TopNode> build_top_level(std::span<const TopLevelInstance> instances);

} // namespace vigil
