// SPDX-License-Identifier: GPL-2.0-or-later
// Traces rays on the host by the text that the GPU runs (trace/bvh_traverse.glsl). It finds places
// for cameras and stands in for Embree where that is missing; it is not fast.
#pragma once

#include "refresh/vkpt/scene/bvh_builder.h"
#include "shared/bvh.h"

#include <span>

namespace vigil::bench {

class HostTracer {
public:
    explicit HostTracer(std::span<const BvhInputTriangle> triangles);

    const Bvh& bvh() const { return bvh_; }

    /// Closest hit; `primitive` is NONE where nothing is hit, else the index of the input triangle.
    shader::Hit closest(const shader::Ray& ray) const;

private:
    Bvh bvh_;
};

} // namespace vigil::bench
