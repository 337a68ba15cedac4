// SPDX-License-Identifier: GPL-2.0-or-later
// Which lights may be seen from which PVS cluster: the data of the Static Light Lists (the paper,
// section 7; as in Quake II RTX, without its fixed sizes). Lists are conservative: a light left out
// of a list cannot shine on any point of that cluster. Nothing is uploaded or sampled here.
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace vigil {

struct Bsp;
class Pvs;

/// A triangle of a light in world space; cross(v1 - v0, v2 - v0) points to its lit side.
struct LightTriangle {
    glm::vec3 v0, v1, v2;
    uint32_t id; // of the light it belongs to
};

/// ids[first .. first + count). The layout is the GPU's: two 32-bit words.
struct LightRange {
    uint32_t first = 0;
    uint32_t count = 0;
};

/// What lists may take: lights times clusters may be far more than the file of a level. A level
/// that needs more gets one list of all lights for all of its clusters, which is as right and
/// noisier.
struct LightListLimits {
    uint64_t ids = uint64_t{1} << 26;   // 256 MiB
    uint64_t steps = uint64_t{1} << 29; // corners, words and boxes that are looked at: seconds
    /// Bit sets (a bit per light and cluster) are kept from walk to walk up to this size (64 MiB),
    /// and are made anew for each light otherwise.
    uint64_t kept_words = uint64_t{1} << 23;
};

/// One list per cluster and a last one with all lights, for points in no cluster. Ids are sorted
/// and unique in a list. Clusters that see the same lights share one copy of them.
struct LightLists {
    std::vector<LightRange> ranges; // cluster_count + 1
    std::vector<uint32_t> ids;
    std::string refused;     // why all clusters share the list of all lights; empty if they do not
    uint64_t pair_count = 0; // lengths of the clusters' lists, shared copies counted each time
    uint64_t steps = 0;      // corners, words and boxes that were looked at
    uint32_t unplaced = 0;   // lights that touch no cluster (inside walls); they are in every list

    std::span<const uint32_t> list(size_t cluster) const {
        return std::span(ids).subspan(ranges[cluster].first, ranges[cluster].count);
    }
};

/// Makes lists for one level: once for the lights that stay, each frame for those that move. Keeps
/// a reference to the level's BSP, which must outlive it.
class LightLister {
public:
    LightLister(const Bsp& bsp, const Pvs& pvs);

    uint32_t cluster_count() const { return cluster_count_; }

    /// Replaces `clusters` by those that the triangle touches, sorted and unique: the triangle is
    /// clipped down the node tree. A part that lies in a splitting plane belongs to its lit side; a
    /// corner that merely touches a plane belongs to both sides. Empty if the triangle is in no
    /// cluster.
    /// Returns the corners that were looked at.
    uint64_t clusters_touched(const LightTriangle& light, std::vector<uint32_t>& clusters) const;

    /// Lists of the given lights. Triangles may come in any order and share ids. Memory beyond
    /// that of the lights is bounded by the limits.
    LightLists build(std::span<const LightTriangle> lights,
                     const LightListLimits& limits = {}) const;

    const Bsp& bsp() const { return bsp_; }

private:
    struct Box {
        glm::vec3 mins, maxs;
    };

    uint64_t add_visibility(const LightTriangle& light, std::span<const uint32_t> clusters,
                            std::span<uint64_t> seen) const;

    const Bsp& bsp_;
    uint32_t cluster_count_ = 0;
    size_t words_ = 0;           // 64-bit words of a row
    std::vector<uint64_t> rows_; // bit b of row a: a may see b, or b may see a
    std::vector<Box> boxes_;     // bounds of each cluster's surfaces, with a margin
};

} // namespace vigil
