// SPDX-License-Identifier: GPL-2.0-or-later
#include "platform/gamepad.h"

namespace vigil::platform {

bool trigger_is_down(bool was_down, float way) {
    return way >= (was_down ? 0.4f : 0.5f);
}

void add_gamepad_events(const GamepadState& before, const GamepadState& now,
                        std::vector<Event>& events) {
    for (int i = 0; i < gamepad_button_count; ++i) {
        const auto index = static_cast<size_t>(i);
        if (before.buttons.at(index) != now.buttons.at(index))
            events.emplace_back(KeyEvent{static_cast<Key>(static_cast<int>(Key::PadA) + i),
                                         now.buttons.at(index), false});
    }
    if (before.left != now.left) events.emplace_back(StickEvent{StickEvent::Stick::Left, now.left});
    if (before.right != now.right)
        events.emplace_back(StickEvent{StickEvent::Stick::Right, now.right});
}

} // namespace vigil::platform
