// SPDX-License-Identifier: GPL-2.0-or-later
// Names of the two sides of a compared picture, at the top on either side of the line. They are
// part of the picture, as legends are: a screenshot says what it compares.
#pragma once

#include "refresh/vkpt/debug/legend.h"

#include <array>

namespace vigil::vkpt {

class SideLabels {
public:
    /// Records both into `display`, with barriers; the right side begins at `column`. A label that
    /// its side has no room for is left out.
    void record(gpu::FrameCommands& commands, const gpu::Buffer& display, glm::uvec2 picture_size,
                uint32_t column, const std::array<std::string, 2>& names);

    /// Where a label lies that was recorded last; of size 0 where there is none.
    const Legend::Area& area(size_t side) const { return areas_.at(side); }

private:
    struct Label {
        std::string name;
        uint32_t picture_height = 0;
        LegendPixels pixels;
    };
    std::array<Label, 2> labels_;
    std::array<Legend::Area, 2> areas_;
};

} // namespace vigil::vkpt
