// SPDX-License-Identifier: GPL-2.0-or-later
// See query_gpu.h. Buffers, sets and pipelines are made for each call: nothing here is fast.
#include "query_gpu.h"

#include "refresh/vkpt/scene/top_level.h"
#include "refresh/vkpt/scene/transform.h"
#include "shared/bindings.h"

#include <array>

namespace vigil::test {

namespace {

#include "query_bvh.h"   // uint32_t query_bvh[]
#include "query_query.h" // uint32_t query_query[]

} // namespace

QueryGpu::QueryGpu(const gpu::Device& device)
    : device_(device), structures_(device), unused_(device, 16, gpu::MemoryUse::Device, "unused") {}

size_t QueryGpu::add_model(const std::vector<BvhInputTriangle>& triangles, bool deforms) {
    Model model;
    model.triangles = triangles;
    model.deforms = deforms;
    models_.push_back(std::move(model));
    build();
    return models_.size() - 1;
}

void QueryGpu::change_model(size_t model, const std::vector<BvhInputTriangle>& triangles) {
    models_[model].triangles = triangles;
    ++models_[model].revision;
    build();
}

void QueryGpu::place(size_t model, const glm::mat4x3& transform, uint32_t flags) {
    shader::Instance instance{};
    instance.world_from_object = transform;
    instance.object_from_world = vkpt::inverse_transform(transform);
    instance.previous_world_from_object = transform;
    instance.flags = flags;
    instances_.push_back(instance);
    instance_models_.push_back(model);
}

void QueryGpu::clear_placed() {
    instances_.clear();
    instance_models_.clear();
}

void QueryGpu::build() {
    nodes_.clear();
    triangles_.clear();
    corners_.clear();
    for (Model& model : models_) {
        const Bvh bvh = build_bvh(model.triangles);
        model.first_triangle = static_cast<uint32_t>(triangles_.size());
        model.root = append_bvh(bvh, model.first_triangle, nodes_);
        model.bounds = bvh.bounds;
        for (const uint32_t source : bvh.order) {
            const BvhInputTriangle& t = model.triangles[source];
            triangles_.push_back({t.v0, t.coverage, t.v1 - t.v0, t.v2 - t.v0});
            corners_.insert(corners_.end(), {t.v0, t.v1, t.v2});
        }
    }
}

bool QueryGpu::prepare_structures() {
    std::vector<vkpt::QueryModel> models;
    for (const Model& model : models_) {
        const size_t first = model.first_triangle;
        const size_t count = model.triangles.size();
        models.push_back({std::span(corners_).subspan(3 * first, 3 * count),
                          std::span(triangles_).subspan(first, count), model.first_triangle,
                          model.revision, model.deforms});
    }
    return structures_.prepare(models, instance_models_, instances_);
}

std::vector<shader::TraceAnswer> QueryGpu::trace(Backend backend, std::span<const shader::Ray> rays,
                                                 bool instances, bool translucent) {
    // What the compute backend reads.
    std::vector<TopLevelInstance> top;
    for (size_t i = 1; i < instances_.size(); ++i) {
        const Model& model = models_[instance_models_[i]];
        instances_[i].bvh_root = model.root;
        top.push_back({model.bounds, instances_[i].world_from_object,
                       instances_[i].object_from_world, model.root, static_cast<uint32_t>(i),
                       instances_[i].flags});
    }
    const gpu::Buffer nodes = gpu::make_buffer(device_, gpu::bytes_of(nodes_), "nodes");
    const gpu::Buffer triangles = gpu::make_buffer(device_, gpu::bytes_of(triangles_), "triangles");
    const gpu::Buffer top_nodes =
        gpu::make_buffer(device_, gpu::bytes_of(build_top_level(top)), "top nodes");
    const gpu::Buffer ray_buffer = gpu::make_buffer(device_, std::as_bytes(rays), "rays");
    const gpu::Buffer answers(device_, rays.size() * sizeof(shader::TraceAnswer),
                              gpu::MemoryUse::Device, "answers");

    // Structures first: the set must name the one that is built.
    gpu::FrameCommands commands(device_);
    commands.begin();
    prepare_structures();
    structures_.record(commands);

    std::vector<gpu::BindingKind> types(SCENE_BINDING_COUNT, gpu::BindingKind::Storage);
    for (const uint32_t records : {BINDING_BVH_TRIANGLES, BINDING_TOP_NODES})
        types[records] = gpu::BindingKind::Records;
    types[BINDING_ACCELERATION_STRUCTURE] = gpu::BindingKind::Traced;
    gpu::DescriptorSet scene(device_, types, unused_, "scene");
    scene.bind(BINDING_BVH_NODES, nodes);
    scene.bind(BINDING_BVH_TRIANGLES, triangles);
    scene.bind(BINDING_TOP_NODES, top_nodes);
    scene.bind(BINDING_ACCELERATION_STRUCTURE, structures_.top());
    gpu::DescriptorSet lists(device_, std::vector(2, gpu::BindingKind::Storage), unused_,
                             "rays and answers");
    lists.bind(0, ray_buffer);
    lists.bind(1, answers);
    const gpu::PipelineLayout layout(device_, {&scene, &lists});
    const std::span<const uint32_t> code = backend == Backend::Query
                                               ? std::span<const uint32_t>(query_query)
                                               : std::span<const uint32_t>(query_bvh);
    const std::array constants{gpu::Specialization{CONSTANT_INSTANCES, instances},
                               gpu::Specialization{CONSTANT_TRANSLUCENT, translucent}};
    const gpu::ComputePipeline pipeline(device_, layout, nullptr, code, constants, "query");

    const std::array sets{scene.handle(), lists.handle()};
    const auto count = static_cast<uint32_t>(rays.size());
    pipeline.dispatch(commands.commands(), {sets, gpu::bytes_of_value(count)},
                      {{(count + 63) / 64, 1, 1}});
    commands.submit(VK_NULL_HANDLE, 0, VK_NULL_HANDLE);
    commands.finish();
    return gpu::download_now_as<shader::TraceAnswer>(device_, answers, 0, count);
}

shader::BvhTriangle QueryGpu::placed_triangle(uint32_t primitive, uint32_t instance) const {
    const glm::mat4x3& transform = instances_.at(instance).world_from_object;
    shader::BvhTriangle triangle = triangles_.at(primitive);
    triangle.v0 = transform * glm::vec4(triangle.v0, 1.0f);
    triangle.e1 = transform * glm::vec4(triangle.e1, 0.0f);
    triangle.e2 = transform * glm::vec4(triangle.e2, 0.0f);
    return triangle;
}

} // namespace vigil::test
