// SPDX-License-Identifier: GPL-2.0-or-later
// The compute backend of trace.glsl on its own: models, placements and lists of rays, without a
// renderer. For tests and for the trace benchmark.
#pragma once

#include "refresh/vkpt/gpu/commands.h"
#include "refresh/vkpt/gpu/pipeline.h"
#include "refresh/vkpt/scene/bvh_builder.h"
#include "refresh/vkpt/scene/top_level.h"
#include "trace/ray_answer.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace vigil::bench {

class TraceRig {
public:
    /// How shaders read the nodes: TRACE_TEXEL = 0 or 1.
    enum class Nodes { Storage, Texels };
    TraceRig(const gpu::Device& device, Nodes nodes);

    /// Appends a model; returns its number. Model 0 is the static world and always in place.
    std::size_t add_model(std::span<const BvhInputTriangle> triangles);
    /// Places a model as the next instance, from 1.
    void place(std::size_t model, const glm::mat4x3& world_from_object);
    /// Uploads what was added and makes the pipelines. `translucent`: HAS_TRANSLUCENT.
    void finish(bool translucent);

    /// Rays on the device; ray number i has seed i.
    struct Batch {
        std::uint32_t count = 0;
        gpu::Buffer rays, answers, occluded;
        gpu::DescriptorSet set;
    };
    Batch make_batch(std::span<const shader::Ray> rays) const;
    /// Traces them all and waits.
    void trace(const Batch& batch, bool any_hit) const;
    std::vector<shader::RayAnswer> answers(const Batch& batch) const;
    std::vector<std::uint32_t> occluded(const Batch& batch) const;

    /// In the order that answers' `primitive` counts.
    const std::vector<shader::BvhTriangle>& triangles() const { return triangles_; }
    /// Input triangle and model of each primitive.
    struct Source {
        std::size_t model;
        std::uint32_t triangle;
    };
    const std::vector<Source>& sources() const { return sources_; }
    const TopLevelInstance& instance(std::uint32_t index) const { return instances_[index - 1]; }

private:
    struct Model {
        std::uint32_t root;
        Bounds bounds;
    };
    const gpu::Device& device_;
    Nodes node_access_;
    std::vector<Model> models_;
    std::vector<TopLevelInstance> instances_;
    std::vector<glm::uvec4> nodes_;
    std::vector<shader::BvhTriangle> triangles_;
    std::vector<Source> sources_;
    gpu::Buffer unused_, node_buffer_, triangle_buffer_, top_buffer_;
    gpu::DescriptorSet scene_set_, layout_set_;
    gpu::PipelineLayout layout_;
    gpu::ComputePipeline closest_, any_;
};

} // namespace vigil::bench
