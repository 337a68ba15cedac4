// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `vlc`: Visibility Light Cache (shaders/light/vlc.glsl). The caches are made on the GPU
// (refresh/vkpt/guiding); what is made here is for the part of the samples that looks for new
// lights: cuts of the clusters' lists, and the table of all lights. Where most light is in sight
// there are no caches, and its shader draws from the cuts alone.
#include "refresh/vkpt/light/cluster_cuts.h"
#include "refresh/vkpt/light/exploration_table.h"
#include "refresh/vkpt/light/list_sight.h"
#include "refresh/vkpt/scene/light_set.h"
#include "shared/features.h"
#include "shared/guiding_types.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace vigil::vkpt {

namespace {

class VisibilityLightCache : public LightTechnique {
public:
    explicit VisibilityLightCache(const TechniqueContext& context)
        : lists_(context), table_(context.device), cuts_(context.device) {}

    bool prepare(const LightFrame& frame) override {
        ClusterLists::Changes changes = lists_.prepare(frame.lights);
        const bool had_caches = caches_;
        decide(frame);
        const bool turned = caches_ != had_caches;
        if (turned) changes = {true, true};
        bool renewed = turned;
        if (caches_) renewed |= table_.prepare(frame);
        renewed |= cuts_.prepare(lists_, changes, frame.lights,
                                 static_cast<uint32_t>(frame.settings.pt_cut_size));
        return renewed;
    }
    void upload(gpu::FrameCommands& commands) override {
        cuts_.upload(commands);
        if (caches_) table_.upload(commands);
    }
    void bind(Bindings& bindings) const override {
        cuts_.bind(bindings);
        if (caches_) bindings[BINDING_ALIAS_TABLE] = &table_.buffer();
    }
    bool uses_guiding() const override { return caches_; }
    std::string guiding_reason() const override {
        if (!seen_) return "light from the sun";
        return fmt::format("places see {:.1f}% of the light in their lists", 100.0 * *seen_);
    }

private:
    /// Caches draw better than cuts where much of the light is out of sight.
    void decide(const LightFrame& frame) {
        if (looked_at_ != frame.lights.sun_revision()) look(frame.lights);
        const float enough = frame.settings.pt_vlc_enough;
        caches_ = enough == 0.0f || !(seen_.value_or(0.0) >= static_cast<double>(enough)) ||
                  forces_feature(frame.settings.pt_features, &SceneFeatures::caches);
    }

    /// What there is to see of the lights of the static world.
    void look(const LightSet& lights) {
        looked_at_ = lights.sun_revision();
        seen_.reset();
        if (lights.sun() != shader::NONE) return;
        std::vector<shader::Light> lamps; // all lit: what is dark now may be switched on later
        for (const LightSource& source : lights.world()) {
            shader::Light& lamp = lamps.emplace_back(lights.lights()[lamps.size()]);
            if (source.flags == 0) lamp.radiance = source.radiance * source.coverage;
        }
        seen_ = part_in_sight(lists_.bsp(), lists_.still(), lamps);
    }

    ClusterLists lists_;
    ExplorationTable table_;
    ClusterCuts cuts_;
    uint64_t looked_at_ = 0;       // revision of the sun that the next one is of
    std::optional<double> seen_{}; // part_in_sight(), unless there is a sun
    bool caches_ = true;           // as the last frame's lights want it
};

} // namespace

std::unique_ptr<LightTechnique> make_vlc(const TechniqueContext& context) {
    return std::make_unique<VisibilityLightCache>(context);
}

} // namespace vigil::vkpt
