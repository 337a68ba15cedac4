// SPDX-License-Identifier: GPL-2.0-or-later
// Game controllers as events: buttons and triggers are keys, sticks are places. Both window systems
// fill the same state and report its changes from here.
#pragma once

#include "platform/event.h"

#include <array>
#include <vector>

namespace vigil::platform {

/// Buttons of a controller and its triggers: keys in a row from PadA on.
inline constexpr int gamepad_button_count =
    static_cast<int>(Key::PadRightTrigger) - static_cast<int>(Key::PadA) + 1;

/// What a controller's owner holds. The default is a controller at rest.
struct GamepadState {
    std::array<bool, gamepad_button_count> buttons{}; ///< by key, from PadA on
    glm::vec2 left{0.0f};                             ///< sticks: right and up positive, to 1
    glm::vec2 right{0.0f};

    /// `key` is one from PadA to PadRightTrigger.
    bool& button(Key key) {
        return buttons.at(static_cast<size_t>(static_cast<int>(key) - static_cast<int>(Key::PadA)));
    }
};

/// Whether a trigger that is pulled this far (0 to 1) counts as down: from half the way on, and
/// then until it is back at 0.4, so that a trembling finger presses it once.
bool trigger_is_down(bool was_down, float way);

/// Appends what changed.
void add_gamepad_events(const GamepadState& before, const GamepadState& now,
                        std::vector<Event>& events);

} // namespace vigil::platform
