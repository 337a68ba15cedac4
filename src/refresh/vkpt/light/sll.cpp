// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `sll`: Static Light Lists (shaders/light/sll.glsl). Lists of the static world's lights
// are made when the level loads; lists of lights that move are made anew whenever one of them
// appears, vanishes or moves.
#include "refresh/vkpt/light/growing_buffer.h"
#include "refresh/vkpt/light/light_lists.h"
#include "refresh/vkpt/light/technique.h"
#include "refresh/vkpt/scene/light_set.h"

namespace vigil::vkpt {

namespace {

std::vector<LightTriangle> triangles_of(const LightSet& lights, uint32_t first, uint32_t end,
                                        bool dark) {
    std::vector<LightTriangle> triangles;
    for (uint32_t id = first; id < end; ++id) {
        const shader::Light& light = lights.lights()[id];
        if (dark || light.radiance != glm::vec3(0.0f))
            triangles.push_back({light.v0, light.v0 + light.e1, light.v0 + light.e2, id});
    }
    return triangles;
}

class StaticLightLists : public LightTechnique {
public:
    explicit StaticLightLists(const TechniqueContext& context)
        : lister_(context.lister), static_(context.device, "static light"),
          moving_(context.device, "moving light"), counts_(context.device, "light list counts") {}

    bool prepare(const LightFrame& frame) override {
        const LightSet& lights = frame.lights;
        bool renewed = false;
        const uint32_t first_moving = lights.static_count();
        if (!built_) {
            // A static light that is dark now may be switched on later: it is listed all the same.
            renewed |= static_.set(lister_.build(triangles_of(lights, 0, first_moving, true)));
            built_ = true;
        }
        if (revision_ != lights.moving_revision()) {
            revision_ = lights.moving_revision();
            const auto count = static_cast<uint32_t>(lights.lights().size());
            const std::vector<LightTriangle> moving =
                triangles_of(lights, first_moving, count, false);
            const LightLists lists = lister_.build(moving);
            renewed |= moving_.set(lists);
            const uint32_t counts[2] = {static_cast<uint32_t>(lists.ranges.size()),
                                        moving.empty() ? 0u : 1u};
            renewed |= counts_.set(std::as_bytes(std::span(counts)));
        }
        return renewed;
    }

    void upload(gpu::FrameCommands& commands) override {
        static_.upload(commands);
        moving_.upload(commands);
        counts_.upload(commands);
    }

    Bindings bindings() const override {
        return {&static_.ranges.buffer(), &static_.ids.buffer(), &moving_.ranges.buffer(),
                &moving_.ids.buffer(), &counts_.buffer()};
    }

private:
    struct ListBuffers {
        ListBuffers(const gpu::Device& device, const char* name)
            : ranges(device, name), ids(device, name) {}
        bool set(const LightLists& lists) {
            const bool new_ranges = ranges.set(gpu::bytes_of(lists.ranges));
            return ids.set(gpu::bytes_of(lists.ids)) || new_ranges;
        }
        void upload(gpu::FrameCommands& commands) {
            ranges.upload(commands);
            ids.upload(commands);
        }
        GrowingBuffer ranges, ids;
    };

    const LightLister& lister_;
    ListBuffers static_, moving_;
    GrowingBuffer counts_;
    uint64_t revision_ = 0;
    bool built_ = false;
};

} // namespace

std::unique_ptr<LightTechnique> make_sll(const TechniqueContext& context) {
    return std::make_unique<StaticLightLists>(context);
}

} // namespace vigil::vkpt
