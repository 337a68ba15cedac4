// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/debug/side_labels.h"

namespace vigil::vkpt {

namespace {

/// Between a label and the line, in pixels.
constexpr uint32_t gap = 4;

} // namespace

void SideLabels::record(gpu::FrameCommands& commands, const gpu::Buffer& display,
                        glm::uvec2 picture_size, uint32_t column,
                        const std::array<std::string, 2>& names) {
    for (size_t side = 0; side < labels_.size(); ++side) {
        Label& label = labels_.at(side);
        if (label.name != names.at(side) || label.picture_height != picture_size.y)
            label = {names.at(side), picture_size.y,
                     draw_legend({names.at(side), {}, {}, {}, {}}, picture_size.y)};
        const glm::uvec2 size(label.pixels.width, label.pixels.height);
        const uint32_t room = side == 0 ? column : picture_size.x - column;
        areas_.at(side) = {};
        if (size.x + 2 * gap > room || size.y + gap > picture_size.y) continue;
        const glm::uvec2 corner(side == 0 ? column - gap - size.x : column + gap, gap);
        areas_.at(side) = {corner, size};
        record_pixels(commands, display, picture_size, corner, label.pixels);
    }
}

} // namespace vigil::vkpt
