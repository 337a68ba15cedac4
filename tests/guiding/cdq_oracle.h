// SPDX-License-Identifier: GPL-2.0-or-later
// The adaptation of a directional quadtree as the paper describes it (section 5.1), for tests: a
// quadtree is the set of its inner nodes' paths, as an octree is in octree_oracle.h. Sums are in
// double precision; where those of floats may come out otherwise, the oracle allows every choice
// that rounding can lead to. It shares no code with the pass it judges.
#pragma once

#include "octree_oracle.h"

#include <glm/vec4.hpp>

#include <map>
#include <optional>
#include <vector>

namespace vigil::test {

/// Inner nodes of a quadtree, the root among them. Child numbers are '0' .. '3': bit 0 is the upper
/// half in u, bit 1 in v.
using Squares = InnerNodes;

/// All nodes but the root, in the order of their bits.
std::vector<Path> nodes_of(const Squares& inner);

/// The bit field of a quadtree: one bit per node, 1 for an inner one.
glm::uvec4 field_of(const Squares& inner);
/// The quadtree of a field of `bits` bits; nothing if the field is none: too many or too few inner
/// nodes, bits beyond the last, or leaves below the lowest level.
std::optional<Squares> squares_of(glm::uvec4 field, uint32_t bits);

struct QuadtreeLimits {
    uint32_t migrations;       // at most
    float margin;              // a leaf's moment times this must exceed what is given up; 1 at most
    float even_density = 0.0f; // a leaf's moment is its sum over 4^depth and this
    uint32_t memory = 0;       // rays to follow: with fewer, what is remembered counts; 0: own ones
};

/// Squared contributions by leaf of a quadtree.
using Sums = ByPath<double>;

/// The two words of a ray sample.
struct StoredRay {
    uint32_t ray;
    uint32_t estimate;
};

/// What a quadtree is adapted to.
struct QuadtreeLessons {
    /// Ray samples of a node; of more than GUIDE_MOST_RAYS the pass takes some.
    std::vector<StoredRay> stored;
    Sums remembered;    // empty: nothing
    uint32_t blank = 0; // further rays, which brought nothing

    size_t rays() const;
};

/// How well the BRDF and the guider drew rays: running sums, and the guider's share. Of the last
/// frame the roots of rays times second moment, if the BRDF drew all and as they were drawn.
struct ShareState {
    double plain = 0.0, guided = 0.0, rays = 0.0, share = 0.0;
    double plain_spread = 0.0, guided_spread = 0.0;
};

/// `shared` after a frame with these rays, which were drawn with it: `first` is the share of a node
/// without experience.
ShareState adapt_share(const ShareState& shared, const QuadtreeLessons& lessons, uint32_t memory,
                       double first);

struct AdaptedQuadtree {
    Squares inner;
    uint32_t migrations = 0;
    auto operator<=>(const AdaptedQuadtree&) const = default;
};

/// What may become of a quadtree.
struct AdaptedQuadtrees {
    /// By what they are, with what is remembered afterwards.
    std::map<AdaptedQuadtree, Sums> allowed;
    double error = 0.0; // of sums, relative
    /// Sums and all parts of them are whole multiples of one power of two, few enough for a float:
    /// the order in which floats are added does not matter, and there is one tree.
    bool exact = true;
    bool tied = false; // there were equal candidates, not 0: the lowest number decides
};

/// What may become of each node's quadtree.
using AdaptedByNode = ByPath<AdaptedQuadtrees>;

AdaptedQuadtrees adapt_quadtree(const Squares& inner, const QuadtreeLessons& lessons,
                                const QuadtreeLimits& limits);

} // namespace vigil::test
