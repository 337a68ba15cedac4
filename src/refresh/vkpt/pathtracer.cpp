// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/pathtracer.h"

#include "common/error.h"
#include "refresh/vkpt/gpu/shader_library.h"
#include "refresh/vkpt/light/ltc_table.h"
#include "shared/direction_map.h"
#include "shared/views.h"

#include <algorithm>

namespace vigil::vkpt {

namespace {

std::vector<VkDescriptorType> scene_binding_types(bool ray_query) {
    std::vector<VkDescriptorType> types(SCENE_BINDING_COUNT, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER);
    types[BINDING_FRAME] = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    types[BINDING_BVH_NODES] = VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
    if (ray_query)
        types[BINDING_ACCELERATION_STRUCTURE] = VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR;
    else
        types.resize(BINDING_ACCELERATION_STRUCTURE);
    return types;
}

std::string technique_name(const PathTracerVariant& variant) {
    return std::string(technique_infos[static_cast<size_t>(variant.technique)].name);
}

} // namespace

std::vector<gpu::Specialization> specialization(const SceneFeatures& features,
                                                const GuideChoice& guide) {
    return {{CONSTANT_INSTANCES, features.instances},
            {CONSTANT_TRANSLUCENT, features.translucent},
            {CONSTANT_EFFECTS, features.effects},
            {CONSTANT_SKY, features.sky},
            {CONSTANT_SUN, features.sun},
            {CONSTANT_GLOSS, features.gloss},
            {CONSTANT_LIQUID, features.liquid},
            {CONSTANT_ANIMATION, features.animation},
            {CONSTANT_LIGHTS, features.lights},
            {CONSTANT_GUIDER_SIZE, guide.size}};
}

PathTracer::PathTracer(const gpu::Device& device, gpu::PipelineCompiler& compiler,
                       const gpu::DescriptorSet& guiding)
    : device_(device), compiler_(compiler), guiding_layout_(guiding.layout()),
      unused_(device, 16, gpu::MemoryUse::Device, "unused"),
      frame_(device, sizeof(shader::FrameParams), gpu::MemoryUse::Device, "frame parameters",
             VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT),
      counters_(device, sizeof(shader::FrameCounters), gpu::MemoryUse::Device, "counters") {
    scene_set_ = gpu::DescriptorSet(device, scene_binding_types(device.features().ray_query),
                                    unused_, "scene set");
    const std::vector<VkDescriptorType> technique_types(TECHNIQUE_BINDING_COUNT,
                                                        VK_DESCRIPTOR_TYPE_STORAGE_BUFFER);
    for (gpu::DescriptorSet& set : technique_sets_)
        set = gpu::DescriptorSet(device, technique_types, unused_, "technique set");
    set_types_ = {scene_set_.types(), technique_types, guiding.types()};
    layout_ = gpu::make_pipeline_layout(device, set_layouts());
    direction_map_ =
        gpu::Buffer(device,
                    sizeof(float) * (shader::DIRECTION_MAP_GROUPS +
                                     shader::DIRECTION_MAP_EDGE * shader::DIRECTION_MAP_EDGE),
                    gpu::MemoryUse::Device, "direction map");
    ltc_ = gpu::make_buffer(device, std::as_bytes(ltc_table()), "LTC table");
    gpu::run_now(device, [&](VkCommandBuffer commands) {
        vkCmdFillBuffer(commands, counters_.handle(), 0, VK_WHOLE_SIZE, 0);
    });
}

void PathTracer::resize(glm::uvec2 size) {
    const uint64_t pixels = uint64_t{size.x} * size.y;
    const glm::uvec2 tiles = (size + 7u) / 8u;
    const auto make = [&](uint64_t bytes, const char* name) {
        return gpu::Buffer(device_, bytes, gpu::MemoryUse::Device, name);
    };
    // All are made before any is kept, so that a size that does not fit leaves the old one working.
    gpu::Buffer surfaces = make(pixels * sizeof(shader::PrimaryHit), "primary hits");
    gpu::Buffer radiance = make(pixels * sizeof(glm::vec3), "radiance");
    gpu::Buffer accumulation = make(2 * pixels * sizeof(glm::vec3), "accumulation");
    gpu::Buffer exposure =
        make(sizeof(float) + uint64_t{tiles.x} * tiles.y * sizeof(glm::vec2), "exposure");
    gpu::Buffer display = make(pixels * sizeof(uint32_t), "display");
    surfaces_ = std::move(surfaces);
    radiance_ = std::move(radiance);
    accumulation_ = std::move(accumulation);
    exposure_ = std::move(exposure);
    display_ = std::move(display);
    size_ = size;
}

void PathTracer::bind(const Scene& scene, const LightTechnique& technique,
                      const LightTechnique* right) {
    scene_set_.bind(BINDING_FRAME, frame_);
    scene.nodes().bind(scene_set_.handle(), BINDING_BVH_NODES);
    scene_set_.bind(BINDING_BVH_TRIANGLES, scene.triangles());
    scene_set_.bind(BINDING_TOP_NODES, scene.top_nodes());
    scene_set_.bind(BINDING_INSTANCES, scene.instances());
    scene_set_.bind(BINDING_PRIMITIVES, scene.primitives());
    scene_set_.bind(BINDING_MATERIALS, scene.materials());
    scene_set_.bind(BINDING_TEXTURES, scene.textures());
    scene_set_.bind(BINDING_TEXELS, scene.texels());
    scene_set_.bind(BINDING_LIGHTS, scene.light_buffer());
    scene_set_.bind(BINDING_BSP, scene.cluster_tree());
    scene_set_.bind(BINDING_LTC, ltc_);
    scene_set_.bind(BINDING_SURFACES, surfaces_);
    scene_set_.bind(BINDING_RADIANCE, radiance_);
    scene_set_.bind(BINDING_ACCUMULATION, accumulation_);
    scene_set_.bind(BINDING_EXPOSURE, exposure_);
    scene_set_.bind(BINDING_COUNTERS, counters_);
    scene_set_.bind(BINDING_DISPLAY, display_);
    scene_set_.bind(BINDING_DIRECTION_MAP, direction_map_);
    // The compute backend's pipelines do not look at this binding.
    if (scene.acceleration_structure() != VK_NULL_HANDLE)
        scene_set_.bind(BINDING_ACCELERATION_STRUCTURE, scene.acceleration_structure());
    const std::array<const LightTechnique*, most_sides> techniques{&technique, right};
    for (size_t side = 0; side < most_sides; ++side) {
        LightTechnique::Bindings bindings{};
        if (techniques[side] != nullptr) bindings = techniques[side]->bindings();
        for (uint32_t i = 0; i < bindings.size(); ++i)
            technique_sets_[side].bind(i, bindings[i] ? *bindings[i] : unused_);
    }
}

gpu::ComputePipeline PathTracer::make_pipeline(const PathTracerVariant& variant,
                                               const std::string& name, bool views) {
    std::vector<gpu::Specialization> constants = specialization(variant.features, variant.guide);
    constants.push_back({CONSTANT_VIEW, views ? 1u : 0u});
    const std::string backend = variant.ray_query ? ".query" : "";
    return {
        compiler_,
        layout_.get(),
        {shader_code(name + backend), std::move(constants), name, set_types_, variant.ray_query}};
}

PathTracer::Pipelines& PathTracer::pipelines(const PictureSide& side, int view) {
    const PathTracerVariant& variant = side.variant;
    const std::string technique = technique_name(variant);
    const std::string guider(guider_name(variant.guide.guide));
    auto known = std::find_if(variants_.begin(), variants_.end(),
                              [&](const auto& made) { return made->variant == variant; });
    if (known == variants_.end()) {
        auto made = std::make_unique<Pipelines>();
        made->variant = variant;
        made->primary = make_pipeline(variant, "primary");
        made->indirect = make_pipeline(variant, "indirect." + technique + "." + guider);
        known = variants_.insert(variants_.end(), std::move(made));
    }
    Pipelines& made = **known;
    if (side.samples_lights && !made.direct)
        made.direct = make_pipeline(variant, "direct." + technique);
    // The views are a large shader of their own, which few ever see.
    gpu::ComputePipeline& tonemap = view == shader::VIEW_NONE ? made.tonemap : made.tonemap_view;
    if (!tonemap) tonemap = make_pipeline(variant, "tonemap." + guider, view != shader::VIEW_NONE);
    if (view == shader::VIEW_CDQ && !made.direction_map)
        made.direction_map = make_pipeline(variant, "direction_map." + technique + "." + guider);
    return made;
}

void PathTracer::prepare(std::span<const PictureSide> sides, int view) {
    const auto make = [&](const char* name) {
        return gpu::ComputePipeline(compiler_, layout_.get(),
                                    {shader_code(name), {}, name, set_types_});
    };
    if (!accumulate_) accumulate_ = make("accumulate");
    if (!exposure_pipeline_) exposure_pipeline_ = make("exposure");
    for (const PictureSide& side : sides)
        if (side.first_column < side.end_column) pipelines(side, view);
    if (!sides.empty()) pipelines(sides[0], view); // camera rays are the first side's
}

size_t crosshair_side(std::span<const PictureSide> sides, glm::uvec2 picture_size) {
    const uint32_t column = shader::crosshair_pixel(picture_size).x;
    return sides.size() > 1 && column >= sides[1].first_column ? 1 : 0;
}

void PathTracer::select_side(VkCommandBuffer commands, std::span<const PictureSide> sides,
                             size_t side, uint32_t path, uint32_t paths) {
    const PictureSide& chosen = sides[side];
    const std::array sets{scene_set_.handle(), technique_sets_[side].handle(), chosen.guiding};
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_.get(), 0,
                            static_cast<uint32_t>(sets.size()), sets.data(), 0, nullptr);
    const shader::PassConstants push{path,
                                     paths,
                                     chosen.first_column,
                                     chosen.end_column,
                                     chosen.samples_lights ? 1u : 0u,
                                     chosen.guided ? 1u : 0u};
    vkCmdPushConstants(commands, layout_.get(), VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(push),
                       &push);
}

void PathTracer::record_direction_map(gpu::FrameCommands& commands,
                                      std::span<const PictureSide> sides, int view,
                                      uint32_t paths) {
    const size_t side = crosshair_side(sides, size_);
    const Pipelines& made = pipelines(sides[side], view);
    const VkCommandBuffer buffer = commands.commands();
    // None of the frame's paths: the octree and its caches do not learn from a view.
    select_side(buffer, sides, side, paths, paths);
    const PassScope scope(device_, commands, Pass::Directions);
    made.direction_map.bind(buffer);
    constexpr uint32_t groups = shader::DIRECTION_MAP_EDGE / 8;
    vkCmdDispatch(buffer, groups, groups, 1);
}

void PathTracer::record(gpu::FrameCommands& commands, std::span<const PictureSide> sides,
                        const shader::FrameParams& params, uint32_t paths) {
    const int view = params.settings.pt_view;
    prepare(sides, view);
    const VkCommandBuffer buffer = commands.commands();
    commands.upload(frame_, 0, gpu::bytes_of_value(params));
    gpu::full_barrier(buffer);
    const glm::uvec2 tiles = (size_ + 7u) / 8u;
    const auto run = [&](Pass pass, const gpu::ComputePipeline& pipeline, glm::uvec2 groups) {
        const PassScope scope(device_, commands, pass);
        pipeline.bind(buffer);
        vkCmdDispatch(buffer, groups.x, groups.y, 1);
    };
    // `passes` of every side that has pixels, over its columns.
    const auto run_sides = [&](uint32_t path, const auto& passes) {
        for (size_t i = 0; i < sides.size(); ++i) {
            const PictureSide& side = sides[i];
            if (side.first_column >= side.end_column) continue;
            select_side(buffer, sides, i, path, paths);
            const uint32_t columns = (side.end_column + 7) / 8 - side.first_column / 8;
            passes(side, pipelines(side, view), glm::uvec2(columns, tiles.y));
        }
    };
    for (uint32_t path = 0; path < paths; ++path) {
        select_side(buffer, sides, 0, path, paths);
        run(Pass::Primary, pipelines(sides[0], view).primary, tiles);
        run_sides(path, [&](const PictureSide& side, const Pipelines& made, glm::uvec2 groups) {
            if (side.samples_lights) run(Pass::Direct, made.direct, groups);
            run(Pass::Indirect, made.indirect, groups);
        });
    }
    if (view == shader::VIEW_CDQ) record_direction_map(commands, sides, view, paths);
    select_side(buffer, sides, 0, paths, paths);
    run(Pass::Accumulate, accumulate_, tiles);
    run(Pass::Exposure, exposure_pipeline_, {1, 1});
    run_sides(paths, [&](const PictureSide&, const Pipelines& made, glm::uvec2 groups) {
        run(Pass::Tonemap, view == shader::VIEW_NONE ? made.tonemap : made.tonemap_view, groups);
    });
}

} // namespace vigil::vkpt
