// SPDX-License-Identifier: GPL-2.0-or-later
// The light lists of all PVS clusters. Lists of the static world's lights are made once, unless the
// sun moves; lists of lights that move are made anew whenever one of them appears, vanishes or
// moves.
#pragma once

#include "refresh/vkpt/light/light_lists.h"
#include "refresh/vkpt/light/technique.h"

namespace vigil::vkpt {

class ClusterLists {
public:
    explicit ClusterLists(const TechniqueContext& context);

    struct Changes {
        bool still = false, moving = false;
    };
    /// Brings the lists to this frame's lights, and tells which are new.
    Changes prepare(const LightSet& lights);
    /// Of the static world's lights.
    const LightLists& still() const { return still_; }
    /// Of the others that shine.
    const LightLists& moving() const { return moving_; }
    /// Triangles of those.
    size_t moving_count() const { return moving_count_; }
    /// Lengths of all lists, added up.
    uint64_t pair_count() const { return still_.pair_count + moving_.pair_count; }
    /// Where lists may be, and what is in the way.
    const Bsp& bsp() const { return lister_.bsp(); }

private:
    LightLists build(std::span<const LightTriangle> lights, const char* which, bool& warned) const;

    const LightLister& lister_;
    LightListLimits limits_;
    LightLists still_, moving_;
    uint64_t revision_ = 0, sun_revision_ = 0;
    size_t moving_count_ = 0;
    bool still_warned_ = false, moving_warned_ = false; // that lists were refused
};

} // namespace vigil::vkpt
