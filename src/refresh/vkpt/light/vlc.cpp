// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `vlc`: Visibility Light Cache (shaders/light/vlc.glsl). The caches are made on the GPU
// (refresh/vkpt/guiding); what is made here is for the part of the samples that looks for new
// lights: the lists of the clusters, and the table of all lights.
#include "common/cvar.h"
#include "refresh/vkpt/light/alias_buffer.h"
#include "refresh/vkpt/light/cluster_lists.h"
#include "refresh/vkpt/light/exploration.h"
#include "refresh/vkpt/scene/light_set.h"

namespace vigil::vkpt {

namespace {

class VisibilityLightCache : public LightTechnique {
public:
    explicit VisibilityLightCache(const TechniqueContext& context)
        : table_(context.device), lists_(context) {}

    bool prepare(const LightFrame& frame) override {
        const bool renewed = lists_.prepare(frame.lights);
        const ExplorationMix mix{cvars()->pt_explore_energy, cvars()->pt_explore_change,
                                 cvars()->pt_explore_distance};
        if (revision_ == frame.lights.revision() && eye_ == frame.eye && mix_ == mix &&
            !exploration_.fading())
            return renewed;
        revision_ = frame.lights.revision();
        eye_ = frame.eye;
        mix_ = mix;
        return table_.set(exploration_.weights(frame.lights.lights(), frame.eye, mix)) || renewed;
    }

    void upload(gpu::FrameCommands& commands) override {
        lists_.upload(commands);
        table_.upload(commands);
    }
    Bindings bindings() const override {
        Bindings bindings{&table_.buffer()};
        lists_.bind(bindings);
        return bindings;
    }
    bool uses_guiding() const override { return true; }

private:
    AliasBuffer table_;
    ClusterLists lists_;
    Exploration exploration_;
    ExplorationMix mix_;
    uint64_t revision_ = 0;
    glm::vec3 eye_{0.0f};
};

} // namespace

std::unique_ptr<LightTechnique> make_vlc(const TechniqueContext& context) {
    return std::make_unique<VisibilityLightCache>(context);
}

} // namespace vigil::vkpt
