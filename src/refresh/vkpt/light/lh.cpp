// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `lh`: the Light Hierarchy (shaders/light/lh.glsl), built anew in every frame whose
// lights differ from those of the frame before.
#include "refresh/vkpt/gpu/growing_buffer.h"
#include "refresh/vkpt/light/light_hierarchy.h"
#include "refresh/vkpt/light/technique.h"
#include "refresh/vkpt/scene/light_set.h"

#include <cstring>

namespace vigil::vkpt {

namespace {

class LightHierarchyTechnique : public LightTechnique {
public:
    explicit LightHierarchyTechnique(const TechniqueContext& context)
        : nodes_(context.device, "light nodes"), leaf_lights_(context.device, "leaf lights"),
          places_(context.device, "light places"), parents_(context.device, "light parents") {}

    bool prepare(const LightFrame& frame) override {
        const LightHierarchyOptions options{static_cast<uint32_t>(frame.settings.pt_lh_width),
                                            static_cast<uint32_t>(frame.settings.pt_lh_leaf)};
        if (revision_ == frame.lights.revision() && options_ == options) return false;
        revision_ = frame.lights.revision();
        options_ = options;
        hierarchy_.build(frame.lights.lights(), options);
        const std::span<const std::byte> header = std::as_bytes(std::span(&hierarchy_.header(), 1));
        const std::span<const std::byte> places = std::as_bytes(hierarchy_.places());
        std::vector<std::byte> bytes(header.begin(), header.end());
        bytes.insert(bytes.end(), places.begin(), places.end());
        bool renewed = places_.set(bytes);
        renewed |= nodes_.set(std::as_bytes(hierarchy_.nodes()));
        renewed |= leaf_lights_.set(std::as_bytes(hierarchy_.leaf_lights()));
        renewed |= parents_.set(std::as_bytes(hierarchy_.parents()));
        return renewed;
    }

    void upload(gpu::FrameCommands& commands) override {
        for (gpu::GrowingBuffer* buffer : {&nodes_, &leaf_lights_, &places_, &parents_})
            buffer->upload(commands);
    }
    void bind(Bindings& bindings) const override {
        bindings[BINDING_LIGHT_NODES] = &nodes_.buffer();
        bindings[BINDING_LEAF_LIGHTS] = &leaf_lights_.buffer();
        bindings[BINDING_LIGHT_PLACES] = &places_.buffer();
        bindings[BINDING_LIGHT_PARENTS] = &parents_.buffer();
    }

private:
    LightHierarchy hierarchy_;
    LightHierarchyOptions options_;
    gpu::GrowingBuffer nodes_, leaf_lights_, places_, parents_;
    uint64_t revision_ = 0;
};

} // namespace

std::unique_ptr<LightTechnique> make_lh(const TechniqueContext& context) {
    return std::make_unique<LightHierarchyTechnique>(context);
}

} // namespace vigil::vkpt
