// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/light/cluster_cuts.h"

#include "refresh/vkpt/scene/light_set.h"

#include <glm/common.hpp>

namespace vigil::vkpt {

namespace {

/// Radiance of a light that a level says nothing of: a window to the sky, or a lamp of style 0.
constexpr float faint = 1e-3f;

/// The static world's lights by id, lit: what is dark now may be switched on later.
std::vector<shader::Light> lit_lights(const LightSet& lights) {
    std::vector<shader::Light> lit(lights.lights().begin(),
                                   lights.lights().begin() + lights.static_count());
    for (size_t id = 0; id < lights.world().size(); ++id) {
        const LightSource& source = lights.world()[id];
        lit[id].radiance = glm::max(glm::max(lit[id].radiance, source.radiance * source.coverage),
                                    glm::vec3(faint));
    }
    return lit;
}

} // namespace

ClusterCuts::ClusterCuts(const gpu::Device& device)
    : clusters_(device, "light cuts"), entries_(device, "light cut entries"),
      order_(device, "light cut order"), places_(device, "light cut places"),
      groups_(device, "light groups") {}

bool ClusterCuts::prepare(const ClusterLists& lists, ClusterLists::Changes changes,
                          const LightSet& lights, uint32_t size) {
    if (size_ != size) changes = {true, true};
    size_ = size;
    changes.moving |= changes.still;
    if (changes.still) cuts_.set_still(lists.bsp(), {lists.still(), 0, lit_lights(lights)}, size);
    const uint32_t first = lights.static_count();
    if (changes.moving)
        cuts_.set_moving(lists.bsp(), {lists.moving(), first, lights.lights().subspan(first)},
                         size);
    const bool energies = changes.moving || revision_ != lights.revision();
    revision_ = lights.revision();
    if (energies) cuts_.set_energies(lights.lights());

    // What belongs to lights that stay is copied again only if it changed.
    const LightCuts::Sizes kept = changes.still ? LightCuts::Sizes{} : cuts_.still();
    bool renewed = false;
    if (changes.moving) {
        renewed |= clusters_.set(gpu::bytes_of(cuts_.cuts()), sizeof(ClusterCut) * kept.cuts);
        renewed |= entries_.set(gpu::bytes_of(cuts_.entries()), sizeof(uint32_t) * kept.entries);
        renewed |= order_.set(gpu::bytes_of(cuts_.order()), sizeof(uint32_t) * kept.order);
        std::vector<uint32_t> places{static_cast<uint32_t>(lists.still().ranges.size()), first};
        places.insert(places.end(), cuts_.places().begin(), cuts_.places().end());
        renewed |= places_.set(gpu::bytes_of(places), sizeof(uint32_t) * kept.places);
    }
    if (energies) renewed |= groups_.set(gpu::bytes_of(cuts_.groups()), 0);
    return renewed;
}

void ClusterCuts::upload(gpu::FrameCommands& commands) {
    for (gpu::GrowingBuffer* buffer : {&clusters_, &entries_, &order_, &places_, &groups_})
        buffer->upload(commands);
}

void ClusterCuts::bind(LightTechnique::Bindings& bindings) const {
    bindings[BINDING_LIGHT_CUTS] = &clusters_.buffer();
    bindings[BINDING_CUT_ENTRIES] = &entries_.buffer();
    bindings[BINDING_CUT_ORDER] = &order_.buffer();
    bindings[BINDING_CUT_PLACES] = &places_.buffer();
    bindings[BINDING_LIGHT_NODES] = &groups_.buffer();
}

} // namespace vigil::vkpt
