// SPDX-License-Identifier: GPL-2.0-or-later
// Random frames for the guiding passes: trees, and samples in their leaves that make them split,
// collapse, overflow and collide. Counts prefer the thresholds, since that is where a pass goes
// wrong. Nothing here resembles a level.
#pragma once

#include "cdq_oracle.h"
#include "dice.h"
#include "shared/guiding_types.h"
#include "vlc_oracle.h"

#include <algorithm>

namespace vigil::test {

/// `nodes` inner nodes. `deep`: share of subdivisions that go on in a leaf of the node before.
InnerNodes random_tree(Dice& dice, uint32_t nodes, double deep);

/// What the path tracer left in a leaf, and the cache that the leaf has.
struct LeafState {
    uint32_t count = 0; // surface samples that fell into it
    uint32_t first_sample = 0;
    uint32_t room = 0; // only so many of the samples are stored
    uint32_t first_light = 0;
    uint32_t buckets = 0;
    Ages cached;            // lights in the cache
    BucketDraws drawn;      // how its buckets are drawn; as stored
    bool inherited = false; // the cache is a larger leaf's
    Explored explored;      // as stored: what two bytes hold of each
    uint32_t kept() const { return std::min(count, room); }
};

/// What an inner node's guider knows, and the rays of its leaves.
struct NodeState {
    Squares quadtree;
    Sums remembered;    // of its leaves; empty where nothing is
    ShareState shared;  // as stored
    uint32_t rays = 0;  // that brought something
    uint32_t blank = 0; // that did not
    uint32_t first_ray = 0;
    uint32_t room = 0; // only so many of the rays are stored
    uint32_t kept() const { return std::min(rays, room); }
};

/// A tree after a frame was rendered with it.
struct TreeState {
    InnerNodes inner;
    ByPath<LeafState> leaves;
    ByPath<NodeState> nodes;       // empty without quadtrees
    std::vector<uint32_t> samples; // the whole buffer; garbage where no leaf has a sample
    std::vector<uint32_t> caches;  // the same for the lights of caches
    std::vector<uint32_t> rays;    // the same for ray samples; none without quadtrees

    /// Number `i` of a node's ray samples: RAY_SAMPLE_WORDS words.
    uint32_t* ray(const NodeState& node, uint32_t i) {
        return &rays.at(size_t{shader::RAY_SAMPLE_WORDS} * (node.first_ray + i));
    }
    /// Those of a node; what it remembers is not among it.
    QuadtreeLessons lessons_of(const NodeState& node) const;
};

/// Which light ids samples have. A leaf draws its `lights` from one of four ranges, so that
/// neighbours share some.
struct RandomLights {
    uint32_t fewest = 1; // different lights in a leaf
    uint32_t most = 40;
    uint32_t stride = 1; // between ids
    uint32_t largest = shader::LIGHT_SAMPLE_ID_MASK - 1;
    double visible = 0.5; // share of visible samples
};

/// Random samples for every leaf of `inner`, and random room and caches.
TreeState random_samples(Dice& dice, const InnerNodes& inner, const RandomLights& lights,
                         const shader::GuidingSettings& settings,
                         const shader::GuidingHeader& header);

/// The upper halves of two floats, as words of leaves and buckets hold them.
uint32_t two_halves(double low, double high);

/// Writes a leaf's cache of the lights `cached` from `first_light` on into the buffer of all
/// caches.
void store_cache(LeafState& leaf, const Buckets& buckets, uint32_t bucket_size,
                 std::vector<uint32_t>& caches);

/// One random sample out of `lights`.
uint32_t random_light_sample(Dice& dice, const RandomLights& lights, uint32_t first,
                             uint32_t different);

} // namespace vigil::test
