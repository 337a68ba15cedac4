// SPDX-License-Identifier: GPL-2.0-or-later
// Game controllers as events: buttons and triggers are keys, sticks are places. They are SDL 2's,
// which knows the layout of most, whichever system has the window; they may come and go at any
// time.
#pragma once

#include "platform/event.h"

#include <array>
#include <map>
#include <memory>
#include <vector>

union SDL_Event;
struct _SDL_GameController;

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

/// Opens every controller that there is or that is plugged in while it lives. Without a window too,
/// for tests.
class Gamepads {
public:
    /// A system without controllers is no error: a warning says why there are none.
    Gamepads();
    ~Gamepads();
    Gamepads(const Gamepads&) = delete;
    Gamepads& operator=(const Gamepads&) = delete;

    /// Appends what one of SDL's events means, if it is one of a controller's.
    void handle(const SDL_Event& event, std::vector<Event>& events);
    /// Appends that all of them are let go: another window has the keyboard.
    void let_go(std::vector<Event>& events);

private:
    struct Close {
        void operator()(_SDL_GameController* controller) const;
    };
    struct Gamepad {
        std::unique_ptr<_SDL_GameController, Close> controller;
        GamepadState state;
    };

    void connect(int device);
    void disconnect(int id, std::vector<Event>& events);

    bool started_ = false;
    std::map<int, Gamepad> gamepads_; // by SDL's id of the instance
};

} // namespace vigil::platform
