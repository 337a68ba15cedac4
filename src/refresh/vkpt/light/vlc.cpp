// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `vlc`: Visibility Light Cache (shaders/light/vlc.glsl). The caches are made on the GPU
// (refresh/vkpt/guiding); what is made here is for the part of the samples that looks for new
// lights: the lists of the clusters, and the table of all lights. Where lists do as well, there are
// no caches, and its shader draws from lists alone.
#include "refresh/vkpt/light/cluster_lists.h"
#include "refresh/vkpt/light/exploration_table.h"
#include "shared/features.h"

#include <fmt/format.h>

namespace vigil::vkpt {

namespace {

class VisibilityLightCache : public LightTechnique {
public:
    explicit VisibilityLightCache(const TechniqueContext& context)
        : table_(context.device), lists_(context) {}

    bool prepare(const LightFrame& frame) override {
        const bool new_lists = lists_.prepare(frame.lights);
        decide(frame.settings);
        return (caches_ && table_.prepare(frame)) || new_lists;
    }
    void upload(gpu::FrameCommands& commands) override {
        lists_.upload(commands);
        if (caches_) table_.upload(commands);
    }
    void bind(Bindings& bindings) const override {
        bindings[BINDING_ALIAS_TABLE] = table_.buffer() ? &table_.buffer() : nullptr;
        lists_.bind(bindings);
    }
    bool uses_guiding() const override { return caches_; }
    std::string guiding_reason() const override {
        const ClusterLists::Sight& sight = lists_.sight();
        if (!sight.seen) return fmt::format("light lists of up to {} lights", sight.longest);
        return fmt::format("light lists of up to {} lights, {:.1f}% of their light in sight",
                           sight.longest, 100.0 * *sight.seen);
    }

private:
    /// Caches draw better than lists that are longer than what a draw walks past, or of which much
    /// is out of sight. Moving lights come and go, and shaders take time to compile: they decide
    /// only once most of them would be left out of a walk, and then for good.
    void decide(const refresh::Settings& settings) {
        const ClusterLists::Sight& sight = lists_.sight();
        const auto bucket = static_cast<uint64_t>(settings.pt_vlc_bucket);
        const float enough = settings.pt_vlc_enough;
        crowded_ |= sight.longest + lists_.moving_count() > 4 * bucket;
        caches_ = enough == 0.0f || sight.longest > bucket ||
                  !(sight.seen.value_or(0.0) >= static_cast<double>(enough)) || crowded_ ||
                  forces_feature(settings.pt_features, &SceneFeatures::caches);
    }

    ExplorationTable table_;
    ClusterLists lists_;
    bool caches_ = true;   // as the last frame's lights want it
    bool crowded_ = false; // with lights that move
};

} // namespace

std::unique_ptr<LightTechnique> make_vlc(const TechniqueContext& context) {
    return std::make_unique<VisibilityLightCache>(context);
}

} // namespace vigil::vkpt
