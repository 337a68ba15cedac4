// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/debug/direction_map.h"

#include "shared/direction_map.h"

namespace vigil::vkpt {

void DirectionMap::prepare(std::span<const PictureSide> sides) {
    choose_variant(pass_, sides[crosshair_side(sides, buffers_.size())].variant,
                   CompiledFor::TechniqueAndGuider);
}

void DirectionMap::record(gpu::FrameCommands& commands, std::span<const PictureSide> sides,
                          uint32_t paths) {
    prepare(sides);
    const size_t side = crosshair_side(sides, buffers_.size());
    constexpr uint32_t groups = shader::DIRECTION_MAP_EDGE / 8;
    pass_.record(commands, buffers_.side(sides, side, paths, paths).inputs(),
                 {{groups, groups, 1}});
}

} // namespace vigil::vkpt
