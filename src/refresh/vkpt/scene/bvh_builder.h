// SPDX-License-Identifier: GPL-2.0-or-later
// Builds the bottom-level bounding volume hierarchy of one model: triangles in pairs, surface area
// heuristic, four-wide nodes in the format of shaders/shared/bvh.h. Pure CPU work; it neither knows
// Vulkan nor uploads anything, and it does not refit: a model that deforms is built again.
#pragma once

#include "refresh/vkpt/scene/bounds.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vigil {

/// One triangle in object space. Coordinates are finite, |x| <= 1e5 map units; zero area is
/// allowed.
struct BvhInputTriangle {
    glm::vec3 v0{0.0f};
    glm::vec3 v1{0.0f};
    glm::vec3 v2{0.0f};
    std::uint32_t coverage = 255; // 0..255, see TRIANGLE_COVERAGE_MASK
};

/// A hierarchy that stands alone: its root is node 0 and its triangle references count from 0.
struct Bvh {
    std::vector<glm::uvec4> nodes;    // BVH_NODE_WORDS uvec4 per node
    std::vector<std::uint32_t> order; // leaf order: leaf slot i holds input triangle order[i]
    Bounds bounds;                    // of all triangles; empty when there are none
};

/// Builds the hierarchy. `order` names every input triangle exactly once. Zero triangles give one
/// root that nothing hits. Uses up to two threads. Throws Error beyond 8 million nodes.
Bvh build_bvh(std::span<const BvhInputTriangle> triangles);

/// The nodes of `bvh` as they must stand in the node buffer that all models share
/// (BINDING_BVH_NODES), when the model's root gets node index `first_node` and its leaf slot 0 lies
/// at `first_primitive` in BvhTriangle[] / Primitive[]. Throws Error when an index does not fit the
/// format.
std::vector<glm::uvec4> rebase_bvh(const Bvh& bvh, std::uint32_t first_primitive,
                                   std::uint32_t first_node);

/// Appends the rebased `bvh` to the node buffer. Returns the root for Instance::bvh_root (a node
/// index). The static world is appended first, so that its root is 0.
std::uint32_t append_bvh(const Bvh& bvh, std::uint32_t first_primitive,
                         std::vector<glm::uvec4>& nodes);

/// What build_bvh needs at most for this many triangles, in uvec4: room for every pose of a
/// deforming model.
std::size_t max_bvh_words(std::size_t triangle_count);

} // namespace vigil
