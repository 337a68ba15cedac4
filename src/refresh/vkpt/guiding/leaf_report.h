// SPDX-License-Identifier: GPL-2.0-or-later
// What the guiding knows at one place, read back to the host: the octree's leaf with its path and
// cube, its sample counts, its neighbours, its directional quadtree, and the Visibility Light Cache
// by buckets. For commands and tests: reading waits for the GPU.
#pragma once

#include "refresh/reports.h"
#include "refresh/vkpt/guiding/guiding.h"
#include "shared/scene_types.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace vigil::vkpt {

struct LeafReport : refresh::OctreeLeaf {
    glm::uvec4 guide{0};               // what its node's guider keeps; 0 while pt_guide is brdf
    shader::ShareMemory guide_share{}; // and how large a part of the rays it should draw
    std::vector<std::vector<uint32_t>> buckets; // light ids
};

/// A tree on the host, as the last frame left it, and the light ids of its caches.
class TreeCopy {
public:
    /// Waits for the GPU. Something must have been recorded since the guiding's buffers were made.
    TreeCopy(const gpu::Device& device, const Guiding& guiding);

    /// The leaf that holds `position` (map units), which is looked up as the path tracer does.
    /// `bucket_size`: pt_vlc_bucket of that frame.
    LeafReport leaf_at(glm::vec3 position, uint32_t bucket_size) const;

private:
    uint32_t leaf_word(const shader::LeafArray& array, uint32_t leaf, uint32_t word = 0) const {
        return leaves_[shader::leaf_array_word(array, leaf, header_.node_capacity) + word];
    }

    uint32_t node_word(const shader::NodeArray& array, uint32_t node, uint32_t word = 0) const {
        return leaves_[shader::node_array_word(array, node, header_.node_capacity) + word];
    }

    shader::GuidingHeader header_;
    bool guided_;
    std::vector<uint32_t> nodes_, leaves_, vlc_lights_;
};

} // namespace vigil::vkpt
