// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/pathtrace/frame_buffers.h"

#include "refresh/vkpt/light/ltc_table.h"
#include "shared/direction_map.h"
#include "shared/filter_types.h"

#include <cstring>

namespace vigil::vkpt {

namespace {

// As the shaders load them.
template <typename T> constexpr int texels_of = sizeof(T) % 16 == 0 ? sizeof(T) / 16 : -1;
static_assert(texels_of<shader::BvhTriangle> == shader::TRIANGLE_TEXELS &&
              texels_of<shader::TopNode> == shader::TOP_NODE_TEXELS &&
              texels_of<shader::Instance> == shader::INSTANCE_TEXELS &&
              texels_of<shader::Primitive> == shader::PRIMITIVE_TEXELS &&
              texels_of<shader::Material> == shader::MATERIAL_TEXELS &&
              texels_of<shader::Texture> == 1 && texels_of<shader::Light> == shader::LIGHT_TEXELS &&
              texels_of<shader::BspTreeNode> == shader::BSP_NODE_TEXELS &&
              texels_of<shader::LtcEntry> == shader::LTC_ENTRY_TEXELS &&
              texels_of<shader::PrimaryHit> == shader::PRIMARY_HIT_TEXELS &&
              texels_of<shader::FilterInput> == shader::FILTER_INPUT_TEXELS);

std::vector<gpu::BindingKind> scene_bindings(bool ray_query) {
    std::vector<gpu::BindingKind> kinds(SCENE_BINDING_COUNT, gpu::BindingKind::Storage);
    kinds[BINDING_FRAME] = gpu::BindingKind::Uniform;
    for (const uint32_t records :
         {BINDING_BVH_TRIANGLES, BINDING_TOP_NODES, BINDING_INSTANCES, BINDING_PRIMITIVES,
          BINDING_MATERIALS, BINDING_TEXTURES, BINDING_LIGHTS, BINDING_BSP, BINDING_LTC,
          BINDING_SURFACE_RECORDS, BINDING_FILTER_INPUT_RECORDS})
        kinds[records] = gpu::BindingKind::Records;
    kinds[BINDING_TEXELS] = gpu::BindingKind::Words;
    if (ray_query)
        kinds[BINDING_ACCELERATION_STRUCTURE] = gpu::BindingKind::Traced;
    else
        kinds.resize(BINDING_ACCELERATION_STRUCTURE);
    return kinds;
}

std::vector<gpu::BindingKind> technique_bindings() {
    std::vector<gpu::BindingKind> kinds(TECHNIQUE_BINDING_COUNT, gpu::BindingKind::Words);
    for (const uint32_t storage : {BINDING_SHADOW_STATISTICS, BINDING_LIST_COUNTS})
        kinds[storage] = gpu::BindingKind::Storage;
    for (const uint32_t records : {BINDING_LIGHT_NODES, BINDING_LIGHT_CUTS})
        kinds[records] = gpu::BindingKind::Records;
    return kinds;
}

} // namespace

FrameBuffers::FrameBuffers(const gpu::Device& device, const gpu::DescriptorSet& guiding)
    : device_(device), unused_(device, 16, gpu::MemoryUse::Device, "unused"),
      frame_(device, sizeof(shader::FrameParams), gpu::MemoryUse::Device, "frame parameters",
             VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT),
      counters_(device, sizeof(shader::FrameCounters), gpu::MemoryUse::Device, "counters"),
      ltc_(gpu::make_buffer(device, std::as_bytes(ltc_table()), "LTC table")),
      direction_map_(device,
                     sizeof(float) * (shader::DIRECTION_MAP_GROUPS +
                                      shader::DIRECTION_MAP_EDGE * shader::DIRECTION_MAP_EDGE),
                     gpu::MemoryUse::Device, "direction map"),
      scene_set_(device, scene_bindings(device.features().ray_query), unused_, "scene set") {
    for (gpu::DescriptorSet& set : technique_sets_)
        set = gpu::DescriptorSet(device, technique_bindings(), unused_, "technique set");
    layout_ = gpu::PipelineLayout(device, {&scene_set_, &technique_sets_[0], &guiding});
    gpu::run_now(device, [&](VkCommandBuffer commands) {
        vkCmdFillBuffer(commands, counters_.handle(), 0, VK_WHOLE_SIZE, 0);
    });
}

void FrameBuffers::describe(gpu::FrameCommands& commands, const FrameDescription& frame) {
    turn_ = frame;
    const shader::FrameParams& params = frame;
    if (copied_ && std::memcmp(&*copied_, &params, sizeof(params)) == 0) return;
    copied_ = params;
    commands.upload(frame_, 0, gpu::bytes_of_value(params));
}

void FrameBuffers::forget_copies() {
    copied_.reset();
}

void FrameBuffers::resize(glm::uvec2 picture, glm::uvec2 size, bool scales) {
    const uint64_t pixels = uint64_t{size.x} * size.y;
    const auto make = [&](uint64_t bytes, const char* name) {
        return gpu::Buffer(device_, bytes, gpu::MemoryUse::Device, name);
    };
    // All are made before any is kept, so that a size that does not fit leaves the old one working.
    gpu::Buffer surfaces = make(pixels * sizeof(shader::PrimaryHit), "primary hits");
    surfaces.texels(VK_FORMAT_R32G32B32A32_UINT); // a device reads so many at most
    gpu::Buffer flags = make(pixels * sizeof(uint32_t), "pixel flags");
    gpu::Buffer radiance = make(pixels * sizeof(glm::vec3), "radiance");
    gpu::Buffer accumulation = make(2 * pixels * sizeof(glm::vec3), "accumulation");
    gpu::Buffer exposure =
        make(sizeof(float) + uint64_t{(size.x + 7) / 8} * ((size.y + 7) / 8) * sizeof(glm::vec2),
             "exposure");
    gpu::Buffer display = make(uint64_t{picture.x} * picture.y * sizeof(uint32_t), "display");
    gpu::Buffer toned = scales ? make(pixels * sizeof(uint32_t), "toned") : gpu::Buffer();
    surfaces_ = std::move(surfaces);
    pixel_flags_ = std::move(flags);
    radiance_ = std::move(radiance);
    accumulation_ = std::move(accumulation);
    exposure_ = std::move(exposure);
    display_ = std::move(display);
    toned_ = std::move(toned);
    picture_size_ = picture;
    size_ = most_traced_ = size;
    scales_ = scales;
}

void FrameBuffers::keep_filter_input(bool keep) {
    filter_input_ = gpu::Buffer();
    if (keep)
        filter_input_ = gpu::Buffer(
            device_, uint64_t{most_traced_.x} * most_traced_.y * sizeof(shader::FilterInput),
            gpu::MemoryUse::Device, "filter input");
}

void FrameBuffers::bind(const Scene& scene, const LightTechnique& technique,
                        const LightTechnique& right) {
    scene_set_.bind(BINDING_FRAME, frame_);
    scene_set_.bind(BINDING_BVH_NODES, scene.nodes());
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
    scene_set_.bind(BINDING_SURFACE_RECORDS, surfaces_);
    scene_set_.bind(BINDING_PIXEL_FLAGS, pixel_flags_);
    scene_set_.bind(BINDING_RADIANCE, radiance_);
    const gpu::Buffer& filter_input = filter_input_ ? filter_input_ : unused_;
    scene_set_.bind(BINDING_FILTER_INPUT, filter_input);
    scene_set_.bind(BINDING_FILTER_INPUT_RECORDS, filter_input);
    scene_set_.bind(BINDING_ACCUMULATION, accumulation_);
    scene_set_.bind(BINDING_EXPOSURE, exposure_);
    scene_set_.bind(BINDING_COUNTERS, counters_);
    scene_set_.bind(BINDING_DISPLAY, scales_ ? toned_ : display_);
    scene_set_.bind(BINDING_DIRECTION_MAP, direction_map_);
    // The compute backend's pipelines do not look at this binding.
    if (scene.acceleration_structure() != VK_NULL_HANDLE)
        scene_set_.bind(BINDING_ACCELERATION_STRUCTURE, scene.acceleration_structure());
    const std::array<const LightTechnique*, most_sides> techniques{&technique, &right};
    for (size_t side = 0; side < most_sides; ++side) {
        LightTechnique::Bindings bindings{};
        techniques[side]->bind(bindings);
        for (uint32_t i = 0; i < bindings.size(); ++i)
            technique_sets_[side].bind(i, bindings[i] ? *bindings[i] : unused_);
    }
}

FrameBuffers::SideInputs FrameBuffers::side(std::span<const PictureSide> sides, size_t side,
                                            uint32_t path, uint32_t paths) const {
    const PictureSide& chosen = sides[side];
    return {{scene_set_.handle(), technique_sets_[side].handle(), chosen.guiding},
            {path, paths, chosen.first_column, chosen.end_column, chosen.samples_lights ? 1u : 0u,
             chosen.guided ? 1u : 0u, 0u, 0u, chosen.indirect_turn, turn_}};
}

} // namespace vigil::vkpt
