// SPDX-License-Identifier: GPL-2.0-or-later
// The +commands that move the player or fly the camera: which are held, by which keys. A press
// shorter than a frame still counts as half a frame, because frames are long where there is no GPU.
#pragma once

#include "client/play/camera.h"
#include "console/command.h"

#include <array>
#include <set>
#include <string>
#include <string_view>

namespace vigil::client {

class HeldButtons {
public:
    /// Adds +forward, -forward, ... to `commands`, which must not outlive this object.
    void add_commands(CommandRegistry& commands);

    /// What the held keys ask for in this frame; presses that ended are forgotten with it.
    FlightInput take_frame();

private:
    enum Button {
        Forward,
        Back,
        MoveLeft,
        MoveRight,
        MoveUp,
        MoveDown,
        TurnLeft,
        TurnRight,
        LookUp,
        LookDown,
        Fast,
        Attack,
        ButtonCount
    };
    struct State {
        std::set<std::string, std::less<>> keys; // names of the keys that hold it
        bool pressed = false;                    // went down since the last frame
    };

    float take(Button button);

    std::array<State, ButtonCount> states_;
};

} // namespace vigil::client
