// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `sll`: Static Light Lists (shaders/light/sll.glsl), and what they learn about shadows.
#include "refresh/vkpt/light/list_buffers.h"
#include "refresh/vkpt/light/shadow_statistics.h"

namespace vigil::vkpt {

namespace {

class StaticLightLists : public LightTechnique {
public:
    explicit StaticLightLists(const TechniqueContext& context)
        : lists_(context), buffers_(context.device), shadows_(context.device, context.compiler) {}

    bool prepare(const LightFrame& frame) override {
        learns_ = frame.settings.pt_sll_stats != 0;
        bool renewed = buffers_.prepare(lists_, lists_.prepare(frame.lights));
        if (learns_)
            renewed |= shadows_.reserve(lists_.pair_count());
        else
            shadows_.forget(); // what was counted before it was switched off is out of date later
        return renewed;
    }
    void upload(gpu::FrameCommands& commands) override { buffers_.upload(commands); }
    void adapt(gpu::FrameCommands& commands) override {
        if (learns_) shadows_.adapt(commands);
    }
    void forget() override { shadows_.forget(); }
    bool learns() const override { return learns_; }
    void bind(Bindings& bindings) const override {
        bindings[BINDING_SHADOW_STATISTICS] = shadows_.buffer();
        buffers_.bind(bindings);
    }

private:
    ClusterLists lists_;
    ListBuffers buffers_;
    ShadowStatistics shadows_;
    bool learns_ = false; // as the last frame said
};

} // namespace

std::unique_ptr<LightTechnique> make_sll(const TechniqueContext& context) {
    return std::make_unique<StaticLightLists>(context);
}

} // namespace vigil::vkpt
