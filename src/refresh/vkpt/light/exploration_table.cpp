// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/light/exploration_table.h"

#include "refresh/vkpt/light/alias_table.h"
#include "refresh/vkpt/scene/light_set.h"

namespace vigil::vkpt {

bool ExplorationTable::prepare(const LightFrame& frame) {
    const ExplorationMix mix{frame.settings.pt_explore_energy, frame.settings.pt_explore_change,
                             frame.settings.pt_explore_distance};
    if (revision_ == frame.lights.revision() && eye_ == frame.eye && mix_ == mix &&
        !exploration_.fading())
        return false;
    revision_ = frame.lights.revision();
    eye_ = frame.eye;
    mix_ = mix;
    return table_.set(
        alias_table_bytes(exploration_.weights(frame.lights.lights(), frame.eye, mix)));
}

} // namespace vigil::vkpt
