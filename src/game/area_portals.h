// SPDX-License-Identifier: GPL-2.0-or-later
// Which areas of a level are open to each other. Doors open and close the portals between them.
#pragma once

#include "formats/bsp.h"

#include <map>
#include <vector>

namespace vigil {

class AreaPortals {
public:
    /// All portals closed, as in the original until what stands in them opens. `bsp` must outlive
    /// it.
    explicit AreaPortals(const Bsp& bsp);

    /// `portal` as in BspAreaPortal::portal (the key `style` of a func_areaportal); numbers that no
    /// area has are ignored.
    void set_open(uint32_t portal, bool open);
    bool is_open(uint32_t portal) const;
    /// True where a way leads from one area to the other through open portals.
    bool connected(uint32_t area, uint32_t other) const { return group_[area] == group_[other]; }

private:
    void flood();

    const Bsp& bsp_;
    std::map<uint32_t, bool> open_;
    std::vector<uint32_t> group_; ///< for each area
};

} // namespace vigil
