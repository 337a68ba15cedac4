// SPDX-License-Identifier: GPL-2.0-or-later
// Game controllers by SDL 2, which knows the layout of most. They may come and go at any time.
#pragma once

#include "platform/gamepad.h"

#include <map>
#include <memory>
#include <vector>

union SDL_Event;
struct _SDL_GameController;

namespace vigil::platform {

/// Opens every controller that there is or that is plugged in while it lives. Without a window too,
/// for tests.
class SdlGamepads {
public:
    /// A system without controllers is no error: a warning says why there are none.
    SdlGamepads();
    ~SdlGamepads();
    SdlGamepads(const SdlGamepads&) = delete;
    SdlGamepads& operator=(const SdlGamepads&) = delete;

    /// Appends what one of SDL's events means, if it is one of a controller's.
    void handle(const SDL_Event& event, std::vector<Event>& events);

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
