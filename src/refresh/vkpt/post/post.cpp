// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/post/post.h"

#include "shared/views.h"

namespace vigil::vkpt {

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
}

} // namespace vigil::vkpt
