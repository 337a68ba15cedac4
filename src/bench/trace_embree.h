// SPDX-License-Identifier: GPL-2.0-or-later
// Embree 3 or 4, one ray at a time: the yardstick of the trace benchmark. Compiled only where CMake
// finds Embree.
#pragma once

#include "bench/trace_level.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace vigil::bench {

class EmbreeTracer {
public:
    /// High-quality build on the calling thread. Throws Error.
    explicit EmbreeTracer(std::span<const BvhInputTriangle> triangles);
    ~EmbreeTracer();

    /// Distances of the closest hits; t_max where nothing is hit.
    void closest(std::span<const shader::Ray> rays, std::vector<float>& distances) const;
    /// 1 where something stops the ray, else 0.
    void occluded(std::span<const shader::Ray> rays, std::vector<std::uint32_t>& answers) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace vigil::bench
