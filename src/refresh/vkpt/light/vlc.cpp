// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `vlc`: Visibility Light Cache (shaders/light/vlc.glsl). The caches are made on the GPU
// (refresh/vkpt/guiding); what is made here is the table from which a part of the samples looks for
// new lights.
#include "common/cvar.h"
#include "refresh/vkpt/light/alias_buffer.h"
#include "refresh/vkpt/light/exploration.h"
#include "refresh/vkpt/light/local_exploration.h"
#include "refresh/vkpt/light/technique.h"
#include "refresh/vkpt/scene/light_set.h"

namespace vigil::vkpt {

namespace {

class VisibilityLightCache : public LightTechnique {
public:
    explicit VisibilityLightCache(const TechniqueContext& context)
        : lister_(context.lister), table_(context.device),
          ranges_(context.device, "cluster ranges"), ids_(context.device, "cluster lights"),
          entries_(context.device, "cluster alias tables") {}

    bool prepare(const LightFrame& frame) override {
        const ExplorationMix mix{cvars()->pt_explore_energy, cvars()->pt_explore_change,
                                 cvars()->pt_explore_distance};
        if (revision_ == frame.lights.revision() && eye_ == frame.eye && mix_ == mix &&
            !exploration_.fading())
            return false;
        const bool renewed = make_local_tables(frame.lights);
        revision_ = frame.lights.revision();
        eye_ = frame.eye;
        mix_ = mix;
        return table_.set(exploration_.weights(frame.lights.lights(), frame.eye, mix)) || renewed;
    }

    void upload(gpu::FrameCommands& commands) override {
        for (GrowingBuffer* buffer : {&ranges_, &ids_, &entries_})
            buffer->upload(commands);
        table_.upload(commands);
    }
    Bindings bindings() const override {
        return {&table_.buffer(), &ranges_.buffer(), &ids_.buffer(), &entries_.buffer()};
    }
    bool uses_guiding() const override { return true; }

private:
    /// At most 96 MiB of alias entries.
    static constexpr size_t most_entries = 8 << 20;

    /// Makes the tables of the static world's lights, once.
    bool make_local_tables(const LightSet& lights) {
        if (ranges_.buffer()) return false;
        const LocalExploration local =
            explore_clusters(lister_, lights.lights(), lights.static_count(), most_entries);
        // Their number stands in front of the ranges.
        std::vector<LightRange> ranges{{static_cast<uint32_t>(local.ranges.size()), 0}};
        ranges.insert(ranges.end(), local.ranges.begin(), local.ranges.end());
        ranges_.set(gpu::bytes_of(ranges));
        ids_.set(gpu::bytes_of(local.ids));
        entries_.set(gpu::bytes_of(local.entries));
        return true;
    }

    const LightLister& lister_;
    AliasBuffer table_;
    GrowingBuffer ranges_, ids_, entries_;
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
