// SPDX-License-Identifier: GPL-2.0-or-later
// The loads that bvh_traverse.glsl asks for read the nodes of the tracer that is at work in this
// thread.
#include "bench/host_tracer.h"

namespace vigil::shader {

static thread_local std::span<const uvec4> host_nodes;

static uvec4 bvh_load_node(uint word) {
    return host_nodes[word];
}

} // namespace vigil::shader

#include "trace/bvh_traverse.glsl"

namespace vigil::bench {

HostTracer::HostTracer(std::span<const BvhInputTriangle> triangles) : bvh_(build_bvh(triangles)) {}

shader::Hit HostTracer::closest(const shader::Ray& ray) const {
    shader::host_nodes = bvh_.nodes;
    shader::Hit hit{ray.t_max, shader::NONE, shader::NONE, glm::vec2(0.0f), false};
    if (shader::bvh_traverse(0, ray, 0, 0, false, false, 255, hit))
        hit.primitive = bvh_.order[hit.primitive];
    return hit;
}

} // namespace vigil::bench
