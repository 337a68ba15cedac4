// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `vlc`: Visibility Light Cache (shaders/light/vlc.glsl). The caches are made on the GPU
// (refresh/vkpt/guiding); what is made here is for the part of the samples that looks for new
// lights: the lists of the clusters, and the table of all lights.
#include "refresh/vkpt/light/cluster_lists.h"
#include "refresh/vkpt/light/exploration_table.h"

namespace vigil::vkpt {

namespace {

class VisibilityLightCache : public LightTechnique {
public:
    explicit VisibilityLightCache(const TechniqueContext& context)
        : table_(context.device), lists_(context) {}

    bool prepare(const LightFrame& frame) override {
        const bool new_lists = lists_.prepare(frame.lights);
        return table_.prepare(frame) || new_lists;
    }
    void upload(gpu::FrameCommands& commands) override {
        lists_.upload(commands);
        table_.upload(commands);
    }
    void bind(Bindings& bindings) const override {
        bindings[BINDING_ALIAS_TABLE] = &table_.buffer();
        lists_.bind(bindings);
    }
    bool uses_guiding() const override { return true; }

private:
    ExplorationTable table_;
    ClusterLists lists_;
};

} // namespace

std::unique_ptr<LightTechnique> make_vlc(const TechniqueContext& context) {
    return std::make_unique<VisibilityLightCache>(context);
}

} // namespace vigil::vkpt
