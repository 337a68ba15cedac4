// SPDX-License-Identifier: GPL-2.0-or-later
// A box against a convex brush is a point against the brush whose planes moved out by the box's
// reach along their normals (the Minkowski sum, but for the corners that bevels cut off). The way
// inside is what is left of [0, 1] after cutting it with every plane.
#include "game/brush_trace.h"

#include "game/view_axes.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <vector>

namespace vigil {

namespace {

/// The box's middle on its way, in the coordinates of the tree.
struct Sweep {
    const Bsp& bsp;
    glm::vec3 start, end;
    glm::vec3 half;     ///< of the box, along the world's axes
    glm::mat3 rotation; ///< of the model
    bool rotated;
    uint32_t mask;
    int owner;

    /// How far the box reaches along a direction of the model.
    float reach(const glm::vec3& normal) const {
        return glm::dot(glm::abs(rotated ? rotation * normal : normal), half);
    }
};

void clip_to_brush(const Sweep& sweep, const BspBrush& brush, Trace& trace) {
    float enter = -1.0f, leave = 1.0f;
    const BspPlane* entered = nullptr;
    const BspBrushSide* entered_side = nullptr;
    bool starts_outside = false, ends_outside = false;
    for (uint32_t i = 0; i < brush.side_count; ++i) {
        const BspBrushSide& side = sweep.bsp.brush_sides[brush.first_side + i];
        const BspPlane& plane = sweep.bsp.planes[side.plane];
        const float dist = plane.dist + sweep.reach(plane.normal);
        const float d0 = glm::dot(plane.normal, sweep.start) - dist;
        const float d1 = glm::dot(plane.normal, sweep.end) - dist;
        starts_outside |= d0 > 0.0f;
        ends_outside |= d1 > 0.0f;
        // In front of the plane all the way, or moving away from it.
        if (d0 > 0.0f && d1 >= d0) return;
        if (d0 > 0.0f && d1 > 0.0f && d1 >= trace_gap) return;
        if (d0 <= 0.0f && d1 <= 0.0f) continue;
        if (d0 > d1) {
            const float fraction = std::max(0.0f, (d0 - trace_gap) / (d0 - d1));
            if (fraction > enter) {
                enter = fraction;
                entered = &plane;
                entered_side = &side;
            }
        } else {
            leave = std::min(leave, std::min(1.0f, (d0 + trace_gap) / (d0 - d1)));
        }
    }

    if (!starts_outside) {
        trace.start_solid = true;
        if (!ends_outside) {
            trace.all_solid = true;
            trace.fraction = 0.0f;
            trace.normal = glm::vec3(0.0f);
            trace.contents = brush.contents;
            trace.surface_flags = 0;
            trace.owner = sweep.owner;
        }
        return;
    }
    if (entered == nullptr || enter >= leave || enter >= trace.fraction) return;
    trace.fraction = enter;
    trace.normal = sweep.rotated ? sweep.rotation * entered->normal : entered->normal;
    trace.contents = brush.contents;
    const int32_t texinfo = entered_side->texinfo;
    trace.surface_flags = texinfo < 0 ? 0 : sweep.bsp.texinfos[static_cast<size_t>(texinfo)].flags;
    trace.owner = sweep.owner;
}

void clip_to_leaf(const Sweep& sweep, const BspLeaf& leaf, Trace& trace) {
    // A leaf's contents hold the bits of its brushes but for those of detail in solid leafs.
    for (uint32_t i = 0; i < leaf.leaf_brush_count && !trace.all_solid; ++i) {
        const uint32_t index = sweep.bsp.leaf_brushes[leaf.first_leaf_brush + i];
        const BspBrush& brush = sweep.bsp.brushes[index];
        // A brush without sides would be everywhere.
        if ((brush.contents & sweep.mask) == 0 || brush.side_count == 0) continue;
        clip_to_brush(sweep, brush, trace);
    }
}

struct Branch {
    int32_t child;
    float from, to; ///< the part of the way that may touch it
};

/// The part of [from, to] in which a distance that goes from d0 (at 0) to d1 (at 1) is at least
/// `low`. Empty where the first is greater than the second.
Branch part_above(const Branch& way, int32_t child, float d0, float d1, float low) {
    Branch part{child, way.from, way.to};
    if (d0 == d1) {
        if (d0 < low) part.from = 2.0f;
        return part;
    }
    const float crossing = (low - d0) / (d1 - d0);
    if (d1 > d0)
        part.from = std::max(part.from, crossing);
    else
        part.to = std::min(part.to, crossing);
    return part;
}

} // namespace

void trace_tree(const Bsp& bsp, int32_t headnode, const Placement& placement,
                const glm::vec3& start, const glm::vec3& end, const Box& box, uint32_t mask,
                int owner, Trace& trace) {
    const glm::vec3 middle = 0.5f * (box.mins + box.maxs) - placement.origin;
    Sweep sweep{bsp,
                start + middle,
                end + middle,
                0.5f * (box.maxs - box.mins),
                glm::mat3(1.0f),
                placement.angles != glm::vec3(0.0f),
                mask,
                owner};
    if (sweep.rotated) {
        sweep.rotation = model_rotation(placement.angles);
        const glm::mat3 back = glm::transpose(sweep.rotation);
        sweep.start = back * sweep.start;
        sweep.end = back * sweep.end;
    }

    // Rounding must not lose a leaf; a little more than the gap that traces keep.
    constexpr float margin = 2.0f * trace_gap;
    std::vector<Branch> stack{{headnode, 0.0f, 1.0f}};
    while (!stack.empty() && !trace.all_solid) {
        const Branch way = stack.back();
        stack.pop_back();
        if (way.from > trace.fraction) continue;
        if (way.child < 0) {
            clip_to_leaf(sweep, bsp.leafs[static_cast<size_t>(-1 - way.child)], trace);
            continue;
        }
        const BspNode& node = bsp.nodes[static_cast<size_t>(way.child)];
        const BspPlane& plane = bsp.planes[node.plane];
        const float d0 = glm::dot(plane.normal, sweep.start) - plane.dist;
        const float d1 = glm::dot(plane.normal, sweep.end) - plane.dist;
        const float reach = sweep.reach(plane.normal) + margin;
        const Branch front = part_above(way, node.children[0], d0, d1, -reach);
        const Branch back = part_above(way, node.children[1], -d0, -d1, -reach);
        // The side where the way begins is looked at first.
        const bool front_first = d0 >= 0.0f;
        const Branch& near = front_first ? front : back;
        const Branch& far = front_first ? back : front;
        if (far.from <= far.to) stack.push_back(far);
        if (near.from <= near.to) stack.push_back(near);
    }
}

} // namespace vigil
