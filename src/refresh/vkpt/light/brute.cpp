// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `brute`: samples no lights, so it has no data (shaders/light/brute.glsl).
#include "refresh/vkpt/light/technique.h"

namespace vigil::vkpt {

namespace {

class Brute : public LightTechnique {
public:
    bool prepare(const LightFrame&) override { return false; }
    void upload(gpu::FrameCommands&) override {}
    void bind(Bindings&) const override {}
    bool samples_lights() const override { return false; }
};

} // namespace

std::unique_ptr<LightTechnique> make_brute(const TechniqueContext&) {
    return std::make_unique<Brute>();
}

} // namespace vigil::vkpt
