// SPDX-License-Identifier: GPL-2.0-or-later
// The Light Hierarchy read and walked the plain way: nodes decoded one number at a time, angles
// with trigonometry, all in double precision, every leaf visited from the root. Shares no code with
// shaders/shared/light_hierarchy.h; judges what the host builds and what the GPU draws.
#pragma once

#include "shared/light_hierarchy.h"
#include "shared/ltc.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace vigil::test {

/// A hierarchy as the GPU has it.
struct HierarchyWords {
    shader::LightHierarchyHeader header;
    std::span<const glm::uvec4> nodes;
    std::span<const uint32_t> leaf_lights, places, parents;
};

struct OracleChild {
    glm::dvec3 lower, upper; // box
    glm::dvec3 axis;         // of the cone of normals, about 1 long
    double spread;           // distance of its normals from the axis
    double energy;           // relative to the largest of the node
    bool inner;
    uint32_t node;   // of an inner child
    uint32_t place;  // of a leaf: its first light
    uint32_t number; // place in the node
};

/// The children that a node has.
std::vector<OracleChild> decode_children(const HierarchyWords& words, uint32_t node);

/// Ids of a leaf's lights.
std::vector<uint32_t> lights_of_leaf(const HierarchyWords& words, const OracleChild& leaf);

struct OracleProbabilities {
    std::vector<double> by_light;
    std::vector<double> errors; // by which single precision on the way to a leaf may be off
    bool doubtful = false;      // some child is so near to being cut off that rounding decides
};

/// Probability of every light at a surface; `importance` is that of lights in leaves.
OracleProbabilities oracle_probabilities(const HierarchyWords& words,
                                         std::span<const shader::Light> lights,
                                         const shader::LtcSurface& surface);

} // namespace vigil::test
