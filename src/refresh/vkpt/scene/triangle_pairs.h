// SPDX-License-Identifier: GPL-2.0-or-later
// Finds triangles that share an edge, so that a leaf of the hierarchy can hold two for little more
// than the price of one: greedily, pairs whose common box wastes least first. Only triangles of the
// same winding with bit-equal vertices pair up.
#pragma once

#include "refresh/vkpt/scene/bvh_builder.h"
#include "shared/scene_types.h"

#include <algorithm>
#include <array>
#include <bit>

namespace vigil {

/// One or two triangles as a leaf holds them: (v0, v1, v2) and (v0, v2, v3).
struct TrianglePair {
    std::uint32_t first = 0;
    std::uint32_t second = shader::NONE; // NONE: the first is alone
    std::uint32_t first_rotation = 0;    // vertex of the triangle that is v0 of the pair, 0..2
    std::uint32_t second_rotation = 0;
    Bounds bounds;
};

class TrianglePairFinder {
public:
    explicit TrianglePairFinder(std::span<const BvhInputTriangle> triangles)
        : triangles_(triangles) {}

    /// Every triangle in exactly one pair.
    std::vector<TrianglePair> find() {
        collect_edges();
        collect_candidates();
        std::vector<bool> taken(triangles_.size(), false);
        std::vector<TrianglePair> pairs;
        pairs.reserve(triangles_.size());
        for (const std::vector<Candidate>& bucket : candidates_) {
            for (const Candidate& candidate : bucket) {
                const std::uint32_t first = candidate.edge / 3;
                const std::uint32_t second = candidate.opposite / 3;
                if (taken[first] || taken[second]) continue;
                taken[first] = taken[second] = true;
                // The common edge runs from v2 to v0 in the first, from v0 to v2 in the second.
                TrianglePair pair{first, second, (candidate.edge % 3 + 1) % 3,
                                  candidate.opposite % 3, bounds(first)};
                pair.bounds.grow(bounds(second));
                pairs.push_back(pair);
            }
        }
        for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
            if (!taken[i]) pairs.push_back({i, shader::NONE, 0, 0, bounds(i)});
        }
        return pairs;
    }

    static glm::vec3 vertex(const BvhInputTriangle& triangle, std::uint32_t index) {
        const std::uint32_t i = index % 3;
        return i == 0 ? triangle.v0 : i == 1 ? triangle.v1 : triangle.v2;
    }

private:
    /// Edge numbers are 3 * triangle + start vertex.
    struct Candidate {
        std::uint32_t edge;
        std::uint32_t opposite;
    };
    static constexpr std::size_t BUCKETS = 32;
    /// A pair's box may have this much more area than the two boxes together; above it two leaves
    /// are cheaper.
    static constexpr float MAX_AREA_RATIO = 1.2f;

    glm::vec3 start(std::uint32_t edge) const { return vertex(triangles_[edge / 3], edge % 3); }
    glm::vec3 end(std::uint32_t edge) const { return vertex(triangles_[edge / 3], edge % 3 + 1); }
    Bounds bounds(std::uint32_t triangle) const {
        Bounds box;
        for (std::uint32_t i = 0; i < 3; ++i)
            box.grow(vertex(triangles_[triangle], i));
        return box;
    }
    static std::size_t hash(const glm::vec3& from, const glm::vec3& to) {
        std::uint64_t h = 0;
        for (const float x : {from.x, from.y, from.z, to.x, to.y, to.z}) {
            // Adding zero makes -0 and 0 the same.
            h = (h ^ std::bit_cast<std::uint32_t>(x + 0.0f)) * 0x9e3779b97f4a7c15u;
            h ^= h >> 29;
        }
        return static_cast<std::size_t>(h);
    }

    /// Fills the open-addressing table of directed edges.
    void collect_edges() {
        const auto count = static_cast<std::uint32_t>(3 * triangles_.size());
        table_.assign(std::bit_ceil(std::max<std::size_t>(2 * std::size_t{count}, 2)),
                      shader::NONE);
        for (std::uint32_t edge = 0; edge < count; ++edge) {
            std::size_t slot = hash(start(edge), end(edge)) & (table_.size() - 1);
            // Of several equal edges two are kept: more would make this quadratic on hostile
            // meshes.
            for (int equal = 0; table_[slot] != shader::NONE && equal < 2;
                 slot = (slot + 1) & (table_.size() - 1)) {
                equal += start(table_[slot]) == start(edge) && end(table_[slot]) == end(edge);
            }
            if (table_[slot] == shader::NONE) table_[slot] = edge;
        }
    }

    /// Finds each edge's opposite, and sorts the pairs worth making into buckets by the area they
    /// waste.
    void collect_candidates() {
        for (std::uint32_t edge = 0; edge < 3 * triangles_.size(); ++edge) {
            const glm::vec3 from = end(edge);
            const glm::vec3 to = start(edge);
            if (from == to) continue;
            for (std::size_t slot = hash(from, to) & (table_.size() - 1);
                 table_[slot] != shader::NONE; slot = (slot + 1) & (table_.size() - 1)) {
                const std::uint32_t opposite = table_[slot];
                if (start(opposite) != from || end(opposite) != to) continue;
                if (opposite / 3 > edge / 3) add_candidate(edge, opposite);
                break;
            }
        }
    }

    void add_candidate(std::uint32_t edge, std::uint32_t opposite) {
        Bounds both = bounds(edge / 3);
        const Bounds other = bounds(opposite / 3);
        const float apart = both.half_area() + other.half_area();
        both.grow(other);
        const float ratio = both.half_area() / apart; // NaN when both have no area
        if (!(ratio < MAX_AREA_RATIO)) return;
        const auto bucket = static_cast<std::size_t>(ratio / MAX_AREA_RATIO * BUCKETS);
        candidates_[std::min(bucket, BUCKETS - 1)].push_back({edge, opposite});
    }

    std::span<const BvhInputTriangle> triangles_;
    std::vector<std::uint32_t> table_;
    std::array<std::vector<Candidate>, BUCKETS> candidates_;
};

} // namespace vigil
