// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/pathtrace/pathtracer.h"

namespace vigil::vkpt {

void PathTracer::choose(const PictureSide& side) {
    if (side.samples_lights) choose_variant(direct_, side.variant, CompiledFor::Technique);
    choose_variant(indirect_, side.variant, CompiledFor::TechniqueAndGuider);
}

void PathTracer::prepare(std::span<const PictureSide> sides) {
    choose_variant(primary_, sides[0].variant, CompiledFor::Scene);
    for (const PictureSide& side : sides)
        if (side.first_column < side.end_column) choose(side);
}

void PathTracer::record(gpu::FrameCommands& commands, std::span<const PictureSide> sides,
                        uint32_t paths) {
    prepare(sides);
    for (uint32_t path = 0; path < paths; ++path) {
        primary_.record(commands, buffers_.side(sides, 0, path, paths).inputs(), buffers_.groups());
        for (size_t i = 0; i < sides.size(); ++i) {
            const PictureSide& side = sides[i];
            if (side.first_column >= side.end_column) continue;
            choose(side);
            const FrameBuffers::SideInputs inputs = buffers_.side(sides, i, path, paths);
            if (side.samples_lights)
                direct_.record(commands, inputs.inputs(), buffers_.groups(side));
            indirect_.record(commands, inputs.inputs(), buffers_.indirect_groups(side));
        }
    }
}

} // namespace vigil::vkpt
