// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/light/list_buffers.h"

namespace vigil::vkpt {

ListBuffers::ListBuffers(const TechniqueContext& context)
    : lists_(context), still_ranges_(context.device, "static light ranges"),
      still_ids_(context.device, "static light ids"),
      moving_ranges_(context.device, "moving light ranges"),
      moving_ids_(context.device, "moving light ids"),
      counts_(context.device, "light list counts") {}

bool ListBuffers::prepare(const LightSet& lights) {
    const ClusterLists::Changes changes = lists_.prepare(lights);
    bool renewed = false;
    if (changes.still) {
        renewed |= still_ranges_.set(gpu::bytes_of(lists_.still().ranges));
        renewed |= still_ids_.set(gpu::bytes_of(lists_.still().ids));
    }
    if (changes.moving) {
        renewed |= moving_ranges_.set(gpu::bytes_of(lists_.moving().ranges));
        renewed |= moving_ids_.set(gpu::bytes_of(lists_.moving().ids));
        const uint32_t counts[2] = {static_cast<uint32_t>(lists_.moving().ranges.size()),
                                    lists_.moving_count() > 0 ? 1u : 0u};
        renewed |= counts_.set(std::as_bytes(std::span(counts)));
    }
    return renewed;
}

void ListBuffers::upload(gpu::FrameCommands& commands) {
    for (gpu::GrowingBuffer* buffer :
         {&still_ranges_, &still_ids_, &moving_ranges_, &moving_ids_, &counts_})
        buffer->upload(commands);
}

void ListBuffers::bind(LightTechnique::Bindings& bindings) const {
    bindings[BINDING_STATIC_RANGES] = &still_ranges_.buffer();
    bindings[BINDING_STATIC_IDS] = &still_ids_.buffer();
    bindings[BINDING_MOVING_RANGES] = &moving_ranges_.buffer();
    bindings[BINDING_MOVING_IDS] = &moving_ids_.buffer();
    bindings[BINDING_LIST_COUNTS] = &counts_.buffer();
}

} // namespace vigil::vkpt
