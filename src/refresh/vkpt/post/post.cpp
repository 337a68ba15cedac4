// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/post/post.h"

#include "shared/filter_types.h"
#include "shared/views.h"

#include <cmath>

namespace vigil::vkpt {

Post::Post(const gpu::Device& device, gpu::PipelineCompiler& compiler, const FrameBuffers& buffers)
    : buffers_(buffers), unused_(device, 16, gpu::MemoryUse::Device, "unused"),
      upscale_set_(device, std::vector(UPSCALE_BINDING_COUNT, gpu::BindingKind::Storage), unused_,
                   "upscale set"),
      upscale_layout_(device, {&upscale_set_}),
      accumulate_(Pass::Accumulate, compiler, buffers.layout()),
      exposure_(Pass::Exposure, compiler, buffers.layout()),
      tonemap_(Pass::Tonemap, compiler, buffers.layout()),
      upscale_(Pass::Upscale, compiler, upscale_layout_) {}

void Post::bind() {
    if (!buffers_.scales()) return;
    upscale_set_.bind(BINDING_UPSCALE_TRACED, buffers_.toned());
    upscale_set_.bind(BINDING_UPSCALE_DISPLAY, buffers_.display());
}

void Post::describe(FrameDescription& params, float exposure_speed) {
    constexpr float most_seconds = 1.0f; // between frames, in which eyes get used to light at all
    const float passed = params.time_s - last_time_s_;
    last_time_s_ = params.time_s;
    if ((params.filter_flags & shader::FILTER_HISTORY) != 0 && exposure_speed > 0.0f &&
        passed >= 0.0f && passed < most_seconds)
        params.exposure_part = 1.0f - std::exp(-exposure_speed * passed);
}

void Post::choose(const PictureSide& side, int view) {
    // The views are a large shader of their own, which few ever see.
    const uint32_t has_view = view == shader::VIEW_NONE ? 0 : 1;
    choose_variant(tonemap_, side.variant, CompiledFor::Guider, {{CONSTANT_VIEW, has_view}});
}

void Post::prepare(std::span<const PictureSide> sides, int view) {
    accumulate_.choose();
    exposure_.choose();
    for (const PictureSide& side : sides)
        if (side.first_column < side.end_column) choose(side, view);
    if (buffers_.scales()) upscale_.choose();
}

void Post::record(gpu::FrameCommands& commands, std::span<const PictureSide> sides, int view,
                  uint32_t paths) {
    prepare(sides, view);
    const FrameBuffers::SideInputs whole = buffers_.side(sides, 0, paths, paths);
    accumulate_.record(commands, whole.inputs(), buffers_.groups());
    exposure_.record(commands, whole.inputs(), {});
    for (size_t i = 0; i < sides.size(); ++i) {
        if (sides[i].first_column >= sides[i].end_column) continue;
        choose(sides[i], view);
        tonemap_.record(commands, buffers_.side(sides, i, paths, paths).inputs(),
                        buffers_.groups(sides[i]));
    }
    if (!buffers_.scales()) return;
    const glm::uvec2 sizes[] = {buffers_.size(), buffers_.picture_size()};
    const VkDescriptorSet set = upscale_set_.handle();
    upscale_.record(commands, {std::span(&set, 1), gpu::bytes_of(sizes)},
                    {{(sizes[1] + 7u) / 8u, 1}});
}

} // namespace vigil::vkpt
