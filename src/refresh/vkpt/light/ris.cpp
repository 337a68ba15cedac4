// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `ris`: resampled importance sampling (shaders/light/ris.glsl). Candidates come from the
// table of all lights.
#include "refresh/vkpt/light/exploration_table.h"

namespace vigil::vkpt {

namespace {

class Resampling : public LightTechnique {
public:
    explicit Resampling(const TechniqueContext& context) : table_(context.device) {}

    bool prepare(const LightFrame& frame) override { return table_.prepare(frame); }
    void upload(gpu::FrameCommands& commands) override { table_.upload(commands); }
    void bind(Bindings& bindings) const override {
        bindings[BINDING_ALIAS_TABLE] = &table_.buffer();
    }

private:
    ExplorationTable table_;
};

} // namespace

std::unique_ptr<LightTechnique> make_ris(const TechniqueContext& context) {
    return std::make_unique<Resampling>(context);
}

} // namespace vigil::vkpt
