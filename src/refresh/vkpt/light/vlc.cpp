// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `vlc`: Visibility Light Cache (shaders/light/vlc.glsl). The caches are made on the GPU
// (refresh/vkpt/guiding); what is made here is for the part of the samples that looks for new
// lights: the lists of the clusters, and the table of all lights. Where lists do as well, there are
// no caches, and its shader draws from lists alone.
#include "refresh/vkpt/light/exploration_table.h"
#include "refresh/vkpt/light/list_buffers.h"
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
        : table_(context.device), lists_(context) {}

    bool prepare(const LightFrame& frame) override {
        const bool new_lists = lists_.prepare(frame.lights);
        decide(frame);
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
        if (!seen_) return fmt::format("light lists of up to {} lights", longest_);
        return fmt::format("light lists of up to {} lights, {:.1f}% of their light in sight",
                           longest_, 100.0 * *seen_);
    }

private:
    /// Caches draw better than lists that are longer than what a draw walks past, or of which much
    /// is out of sight. Moving lights come and go, and shaders take time to compile: they decide
    /// only once most of them would be left out of a walk, and then for good.
    void decide(const LightFrame& frame) {
        if (looked_at_ != frame.lights.sun_revision()) look(frame.lights);
        const auto bucket = static_cast<uint64_t>(frame.settings.pt_vlc_bucket);
        const float enough = frame.settings.pt_vlc_enough;
        crowded_ |= longest_ + lists_.lists().moving_count() > 4 * bucket;
        caches_ = enough == 0.0f || longest_ > bucket ||
                  !(seen_.value_or(0.0) >= static_cast<double>(enough)) || crowded_ ||
                  forces_feature(frame.settings.pt_features, &SceneFeatures::caches);
    }

    /// What there is to see of the lights of the static world.
    void look(const LightSet& lights) {
        looked_at_ = lights.sun_revision();
        const LightLists& lists = lists_.lists().still();
        longest_ = 0;
        for (size_t cluster = 0; cluster + 1 < lists.ranges.size(); ++cluster)
            longest_ = std::max(longest_, lists.ranges[cluster].count);
        seen_.reset();
        const bool sky = lights.sun() != shader::NONE ||
                         std::ranges::any_of(lights.world(), &LightSource::flags);
        if (longest_ > shader::VLC_LARGEST_BUCKET || sky) return;
        std::vector<shader::Light> lamps; // all lit: what is dark now may be switched on later
        for (const LightSource& source : lights.world()) {
            shader::Light& lamp = lamps.emplace_back(lights.lights()[lamps.size()]);
            lamp.radiance = source.radiance * source.coverage;
        }
        seen_ = part_in_sight(lists_.lists().bsp(), lists, lamps);
    }

    ExplorationTable table_;
    ListBuffers lists_;
    uint64_t looked_at_ = 0;       // revision of the sun that the next two are of
    uint32_t longest_ = 0;         // lights in the longest list of a cluster
    std::optional<double> seen_{}; // part_in_sight(), where no list is longer than the largest
                                   // bucket, and none has sky or sun
    bool caches_ = true;           // as the last frame's lights want it
    bool crowded_ = false;         // with lights that move
};

} // namespace

std::unique_ptr<LightTechnique> make_vlc(const TechniqueContext& context) {
    return std::make_unique<VisibilityLightCache>(context);
}

} // namespace vigil::vkpt
