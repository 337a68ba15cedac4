// SPDX-License-Identifier: GPL-2.0-or-later
// A small scene of placed models on the device, and rays through it with either backend of
// trace.glsl: our BVH in compute, or ray queries.
#pragma once

#include "query_answer.h"
#include "refresh/vkpt/gpu/pipeline.h"
#include "refresh/vkpt/scene/acceleration_structure.h"
#include "refresh/vkpt/scene/bvh_builder.h"
#include "shared/bvh.h"

#include <span>
#include <vector>

namespace vigil::test {

enum class Backend { Compute, Query };

class QueryGpu {
public:
    /// Needs a device with ray queries.
    explicit QueryGpu(const gpu::Device& device);

    /// Appends a model; returns its index. The first is the static world.
    size_t add_model(const std::vector<BvhInputTriangle>& triangles, bool deforms = false);
    /// Gives a model another shape with the same number of triangles.
    void change_model(size_t model, const std::vector<BvhInputTriangle>& triangles);
    /// Places a model, with INSTANCE_* of its instance. The first must be model 0 in place.
    void place(size_t model, const glm::mat4x3& transform, uint32_t flags = shader::INSTANCE_PLAIN);
    void clear_placed();

    /// Answers all rays; ray number i has seed i. `instances` and `translucent` are the constants
    /// of trace.glsl.
    std::vector<shader::TraceAnswer> trace(Backend backend, std::span<const shader::Ray> rays,
                                           bool instances, bool translucent);

    /// The triangle in world space.
    shader::BvhTriangle placed_triangle(uint32_t primitive, uint32_t instance) const;
    vkpt::AccelerationStructures& structures() { return structures_; }
    /// Brings the structures up to date; returns what AccelerationStructures::prepare does.
    bool prepare_structures();

private:
    struct Model {
        std::vector<BvhInputTriangle> triangles;
        uint32_t first_triangle = 0;
        uint32_t root = 0;
        Bounds bounds;
        uint64_t revision = 1;
        bool deforms = false;
    };
    void build();

    const gpu::Device& device_;
    vkpt::AccelerationStructures structures_;
    std::vector<Model> models_;
    std::vector<shader::Instance> instances_;
    std::vector<size_t> instance_models_;
    std::vector<shader::BvhTriangle> triangles_;
    std::vector<glm::vec3> corners_;
    std::vector<glm::uvec4> nodes_;
    gpu::Buffer unused_;
};

} // namespace vigil::test
