// SPDX-License-Identifier: GPL-2.0-or-later
#include "game/area_portals.h"

namespace vigil {

AreaPortals::AreaPortals(const Bsp& bsp) : bsp_(bsp) {
    flood();
}

bool AreaPortals::is_open(uint32_t portal) const {
    const auto found = open_.find(portal);
    return found != open_.end() && found->second;
}

void AreaPortals::set_open(uint32_t portal, bool open) {
    if (is_open(portal) == open) return;
    open_[portal] = open;
    flood();
}

void AreaPortals::flood() {
    constexpr uint32_t none = ~0u;
    group_.assign(bsp_.areas.size(), none);
    std::vector<uint32_t> stack;
    for (uint32_t first = 0; first < group_.size(); ++first) {
        if (group_[first] != none) continue;
        group_[first] = first;
        stack.push_back(first);
        while (!stack.empty()) {
            const BspArea& area = bsp_.areas[stack.back()];
            stack.pop_back();
            for (uint32_t i = 0; i < area.portal_count; ++i) {
                const BspAreaPortal& portal = bsp_.area_portals[area.first_portal + i];
                if (!is_open(portal.portal) || group_[portal.other_area] != none) continue;
                group_[portal.other_area] = first;
                stack.push_back(portal.other_area);
            }
        }
    }
}

} // namespace vigil
