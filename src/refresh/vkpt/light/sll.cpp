// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `sll`: Static Light Lists (shaders/light/sll.glsl).
#include "refresh/vkpt/light/cluster_lists.h"

namespace vigil::vkpt {

namespace {

class StaticLightLists : public LightTechnique {
public:
    explicit StaticLightLists(const TechniqueContext& context) : lists_(context) {}

    bool prepare(const LightFrame& frame) override { return lists_.prepare(frame.lights); }
    void upload(gpu::FrameCommands& commands) override { lists_.upload(commands); }
    Bindings bindings() const override {
        Bindings bindings{};
        lists_.bind(bindings);
        return bindings;
    }

private:
    ClusterLists lists_;
};

} // namespace

std::unique_ptr<LightTechnique> make_sll(const TechniqueContext& context) {
    return std::make_unique<StaticLightLists>(context);
}

} // namespace vigil::vkpt
