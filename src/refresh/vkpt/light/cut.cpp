// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `cut`: light cuts by cluster (shaders/light/cut.glsl).
#include "refresh/vkpt/light/cluster_cuts.h"

namespace vigil::vkpt {

namespace {

class LightCutTechnique : public LightTechnique {
public:
    explicit LightCutTechnique(const TechniqueContext& context)
        : lists_(context), cuts_(context.device) {}

    bool prepare(const LightFrame& frame) override {
        const ClusterLists::Changes changes = lists_.prepare(frame.lights);
        return cuts_.prepare(lists_, changes, frame.lights,
                             static_cast<uint32_t>(frame.settings.pt_cut_size));
    }
    void upload(gpu::FrameCommands& commands) override { cuts_.upload(commands); }
    void bind(Bindings& bindings) const override { cuts_.bind(bindings); }

private:
    ClusterLists lists_;
    ClusterCuts cuts_;
};

} // namespace

std::unique_ptr<LightTechnique> make_cut(const TechniqueContext& context) {
    return std::make_unique<LightCutTechnique>(context);
}

} // namespace vigil::vkpt
