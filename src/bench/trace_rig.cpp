// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/trace_rig.h"

#include "shaders/vigil_trace_rig_shaders.inc"
#include "shared/bindings.h"

#include <array>
#include <cstdint>

namespace vigil::bench {

namespace {

constexpr std::array<gpu::BindingKind, RAY_BINDING_COUNT> ray_types = {
    gpu::BindingKind::Storage, gpu::BindingKind::Storage, gpu::BindingKind::Storage};

} // namespace

TraceRig::TraceRig(const gpu::Device& device, Nodes nodes)
    : device_(device), node_access_(nodes), unused_(device, 16, gpu::MemoryUse::Device, "unused"),
      layout_set_(device, ray_types, unused_, "no rays") {}

std::size_t TraceRig::add_model(std::span<const BvhInputTriangle> triangles) {
    const Bvh bvh = build_bvh(triangles);
    const auto first = static_cast<std::uint32_t>(triangles_.size());
    models_.push_back({append_bvh(bvh, first, nodes_), bvh.bounds});
    for (const std::uint32_t source : bvh.order) {
        const BvhInputTriangle& t = triangles[source];
        triangles_.push_back({t.v0, t.coverage, t.v1 - t.v0, t.v2 - t.v0});
        sources_.push_back({models_.size() - 1, source});
    }
    return models_.size() - 1;
}

void TraceRig::place(std::size_t model, const glm::mat4x3& world_from_object) {
    TopLevelInstance instance;
    instance.object_bounds = models_[model].bounds;
    instance.world_from_object = world_from_object;
    const glm::mat3 linear = glm::inverse(glm::mat3(world_from_object));
    instance.object_from_world =
        glm::mat4x3(linear[0], linear[1], linear[2], -(linear * world_from_object[3]));
    instance.bvh_root = models_[model].root;
    instance.instance = static_cast<std::uint32_t>(instances_.size() + 1);
    instances_.push_back(instance);
}

void TraceRig::finish(bool translucent) {
    node_buffer_ = gpu::make_buffer(device_, gpu::bytes_of(nodes_), "nodes");
    triangle_buffer_ = gpu::make_buffer(device_, gpu::bytes_of(triangles_), "triangles");
    top_buffer_ =
        gpu::make_buffer(device_, gpu::bytes_of(build_top_level(instances_)), "top level");

    const bool texels = node_access_ == Nodes::Texels;
    std::vector<gpu::BindingKind> types(BINDING_ACCELERATION_STRUCTURE, gpu::BindingKind::Storage);
    types[BINDING_BVH_TRIANGLES] = types[BINDING_TOP_NODES] = gpu::BindingKind::Records;
    if (texels) types[BINDING_BVH_NODES] = gpu::BindingKind::Records;
    scene_set_ = gpu::DescriptorSet(device_, types, unused_, "scene");
    scene_set_.bind(BINDING_BVH_NODES, node_buffer_);
    scene_set_.bind(BINDING_BVH_TRIANGLES, triangle_buffer_);
    scene_set_.bind(BINDING_TOP_NODES, top_buffer_);

    layout_ = gpu::PipelineLayout(device_, {&scene_set_, &layout_set_});
    const std::span<const std::uint32_t> code =
        texels ? std::span(shader_trace_rays_texel, shader_trace_rays_texel_end)
               : std::span(shader_trace_rays, shader_trace_rays_end);
    const auto make = [&](bool any_hit) {
        const std::array constants{gpu::Specialization{CONSTANT_INSTANCES, !instances_.empty()},
                                   gpu::Specialization{CONSTANT_TRANSLUCENT, translucent},
                                   gpu::Specialization{CONSTANT_EFFECTS, false},
                                   gpu::Specialization{CONSTANT_ANY_HIT, any_hit}};
        return gpu::ComputePipeline(device_, layout_, nullptr, code, constants, "rays");
    };
    closest_ = make(false);
    any_ = make(true);
}

TraceRig::Batch TraceRig::make_batch(std::span<const shader::Ray> rays) const {
    Batch batch;
    batch.count = static_cast<std::uint32_t>(rays.size());
    batch.rays = gpu::make_buffer(device_, std::as_bytes(rays), "rays");
    batch.answers = gpu::Buffer(device_, rays.size() * sizeof(shader::RayAnswer),
                                gpu::MemoryUse::Device, "answers");
    batch.occluded = gpu::Buffer(device_, rays.size() * sizeof(std::uint32_t),
                                 gpu::MemoryUse::Device, "occluded");
    batch.set = gpu::DescriptorSet(device_, ray_types, unused_, "rays");
    batch.set.bind(BINDING_RAYS, batch.rays);
    batch.set.bind(BINDING_ANSWERS, batch.answers);
    batch.set.bind(BINDING_OCCLUDED, batch.occluded);
    return batch;
}

void TraceRig::trace(const Batch& batch, bool any_hit) const {
    gpu::run_now(device_, [&](VkCommandBuffer commands) {
        const std::array sets{scene_set_.handle(), batch.set.handle()};
        (any_hit ? any_ : closest_)
            .dispatch(commands, {sets, gpu::bytes_of_value(batch.count)},
                      {{(batch.count + 63) / 64, 1, 1}});
    });
}

std::vector<shader::RayAnswer> TraceRig::answers(const Batch& batch) const {
    return gpu::download_now_as<shader::RayAnswer>(device_, batch.answers, 0, batch.count);
}

std::vector<std::uint32_t> TraceRig::occluded(const Batch& batch) const {
    return gpu::download_now_as<std::uint32_t>(device_, batch.occluded, 0, batch.count);
}

} // namespace vigil::bench
