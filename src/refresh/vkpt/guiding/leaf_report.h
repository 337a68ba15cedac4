// SPDX-License-Identifier: GPL-2.0-or-later
// What the guiding knows at one place, read back to the host: the octree's leaf with its path and
// cube, its sample counts, its neighbours, its directional quadtree, and the Visibility Light Cache
// by buckets. For commands and tests: reading waits for the GPU.
#pragma once

#include "refresh/vkpt/guiding/guiding.h"
#include "shared/scene_types.h"

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace vigil::vkpt {

struct LeafReport {
    uint32_t leaf = 0;              // index: 8 * node + child
    std::vector<uint32_t> path;     // child numbers from the root down; as many as the leaf is deep
    glm::vec3 corner{0.0f};         // lowest corner of its cube, map units
    float size = 0.0f;              // edge of its cube, map units
    uint32_t samples = 0;           // surface samples of the frame that was rendered last
    uint32_t room = 0;              // light samples that fit, and as many ray samples
    uint32_t rays = 0;              // of the frame that was rendered last, those that brought light
    float explore_share = 0.0f;     // of light samples that its finds ask to search lists; 0 .. 0.9
    glm::uvec4 guide{0};            // what its guider keeps; meaningless while pt_guide is brdf
    uint32_t source = shader::NONE; // leaf of the tree before, from which its cache came
    std::array<uint32_t, 6> neighbours{};       // beyond -x +x -y +y -z +z; NONE outside the root
    std::vector<std::vector<uint32_t>> buckets; // light ids

    /// Samples that the leaf had no room for.
    uint32_t dropped() const { return samples > room ? samples - room : 0; }
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

    shader::GuidingHeader header_;
    std::vector<uint32_t> nodes_, leaves_, vlc_lights_;
};

/// Lines of text about the leaf, without its buckets.
std::string leaf_text(const LeafReport& report);

} // namespace vigil::vkpt
