// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/light/list_buffers.h"

namespace vigil::vkpt {

ListBuffers::ListBuffers(const gpu::Device& device)
    : still_ranges_(device, "static light ranges"), still_ids_(device, "static light ids"),
      moving_ranges_(device, "moving light ranges"), moving_ids_(device, "moving light ids"),
      counts_(device, "light list counts") {}

bool ListBuffers::prepare(const ClusterLists& lists, ClusterLists::Changes changes) {
    bool renewed = false;
    if (changes.still) {
        renewed |= still_ranges_.set(gpu::bytes_of(lists.still().ranges));
        renewed |= still_ids_.set(gpu::bytes_of(lists.still().ids));
    }
    if (changes.moving) {
        renewed |= moving_ranges_.set(gpu::bytes_of(lists.moving().ranges));
        renewed |= moving_ids_.set(gpu::bytes_of(lists.moving().ids));
        const uint32_t counts[2] = {static_cast<uint32_t>(lists.moving().ranges.size()),
                                    lists.moving_count() > 0 ? 1u : 0u};
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
