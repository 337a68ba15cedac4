// SPDX-License-Identifier: GPL-2.0-or-later
// Base of the techniques that draw from one alias table over all lights (shaders/light/alias.glsl).
// They differ in the weight of a light.
#pragma once

#include "refresh/vkpt/gpu/growing_buffer.h"
#include "refresh/vkpt/light/technique.h"
#include "shared/scene_types.h"

namespace vigil::vkpt {

class AliasTechnique : public LightTechnique {
public:
    /// Weight of a light, any unit; must be positive for every light that shines.
    using Weight = float (*)(const shader::Light&);
    AliasTechnique(const TechniqueContext& context, Weight weight);

    bool prepare(const LightFrame& frame) override;
    void upload(gpu::FrameCommands& commands) override { table_.upload(commands); }
    void bind(Bindings& bindings) const override {
        bindings[BINDING_ALIAS_TABLE] = &table_.buffer();
    }

private:
    Weight weight_;
    gpu::GrowingBuffer table_;
    uint64_t revision_ = 0;
};

} // namespace vigil::vkpt
