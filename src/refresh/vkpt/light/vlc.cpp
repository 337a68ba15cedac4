// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `vlc`: Visibility Light Cache (shaders/light/vlc.glsl). The caches are made on the GPU
// (refresh/vkpt/guiding); what is made here is for the part of the samples that looks for new
// lights, the lists of the clusters and the table of all lights; and how often lights were hidden.
#include "refresh/vkpt/light/cluster_lists.h"
#include "refresh/vkpt/light/exploration_table.h"
#include "refresh/vkpt/light/shadow_statistics.h"

namespace vigil::vkpt {

namespace {

/// There is room for a pair of a leaf and a light for so many pixels: pixels of a leaf draw the
/// same lights, frame by frame.
constexpr uint64_t pixels_per_pair = 4;

class VisibilityLightCache : public LightTechnique {
public:
    explicit VisibilityLightCache(const TechniqueContext& context)
        : table_(context.device), lists_(context), shadows_(context.device, context.compiler) {}

    bool prepare(const LightFrame& frame) override {
        counts_ = frame.settings.pt_vlc_stats != 0;
        bool renewed = lists_.prepare(frame.lights);
        renewed |= table_.prepare(frame);
        if (counts_)
            renewed |= shadows_.reserve(uint64_t{frame.picture_size.x} * frame.picture_size.y /
                                        pixels_per_pair);
        else
            shadows_.forget(); // what was counted before it was switched off is out of date later
        return renewed;
    }
    void upload(gpu::FrameCommands& commands) override {
        lists_.upload(commands);
        table_.upload(commands);
    }
    void adapt(gpu::FrameCommands& commands) override {
        if (counts_) shadows_.adapt(commands);
    }
    void forget() override { shadows_.forget(); }
    void bind(Bindings& bindings) const override {
        bindings[BINDING_ALIAS_TABLE] = &table_.buffer();
        bindings[BINDING_SHADOW_STATISTICS] = shadows_.buffer();
        lists_.bind(bindings);
    }
    bool uses_guiding() const override { return true; }

private:
    ExplorationTable table_;
    ClusterLists lists_;
    ShadowStatistics shadows_;
    bool counts_ = false; // as the last frame said
};

} // namespace

std::unique_ptr<LightTechnique> make_vlc(const TechniqueContext& context) {
    return std::make_unique<VisibilityLightCache>(context);
}

} // namespace vigil::vkpt
