// SPDX-License-Identifier: GPL-2.0-or-later
#include "platform/gamepad_sdl.h"

#include "common/log.h"

#include <SDL.h>

#include <algorithm>

namespace vigil::platform {

namespace {

Key key_of(int button) {
    switch (button) {
    case SDL_CONTROLLER_BUTTON_A:
        return Key::PadA;
    case SDL_CONTROLLER_BUTTON_B:
        return Key::PadB;
    case SDL_CONTROLLER_BUTTON_X:
        return Key::PadX;
    case SDL_CONTROLLER_BUTTON_Y:
        return Key::PadY;
    case SDL_CONTROLLER_BUTTON_BACK:
        return Key::PadBack;
    case SDL_CONTROLLER_BUTTON_GUIDE:
        return Key::PadGuide;
    case SDL_CONTROLLER_BUTTON_START:
        return Key::PadStart;
    case SDL_CONTROLLER_BUTTON_LEFTSTICK:
        return Key::PadLeftStick;
    case SDL_CONTROLLER_BUTTON_RIGHTSTICK:
        return Key::PadRightStick;
    case SDL_CONTROLLER_BUTTON_LEFTSHOULDER:
        return Key::PadLeftShoulder;
    case SDL_CONTROLLER_BUTTON_RIGHTSHOULDER:
        return Key::PadRightShoulder;
    case SDL_CONTROLLER_BUTTON_DPAD_UP:
        return Key::PadUp;
    case SDL_CONTROLLER_BUTTON_DPAD_DOWN:
        return Key::PadDown;
    case SDL_CONTROLLER_BUTTON_DPAD_LEFT:
        return Key::PadLeft;
    case SDL_CONTROLLER_BUTTON_DPAD_RIGHT:
        return Key::PadRight;
    default:
        return Key::None;
    }
}

/// SDL's -32768 to 32767 as -1 to 1.
float part_of(int value) {
    return std::max(static_cast<float>(value) / 32767.0f, -1.0f);
}

void set_trigger(bool& down, float way) {
    down = trigger_is_down(down, way);
}

void set_axis(GamepadState& state, int axis, float part) {
    switch (axis) {
    case SDL_CONTROLLER_AXIS_LEFTX:
        state.left.x = part;
        break;
    case SDL_CONTROLLER_AXIS_LEFTY: // SDL: down positive
        state.left.y = -part;
        break;
    case SDL_CONTROLLER_AXIS_RIGHTX:
        state.right.x = part;
        break;
    case SDL_CONTROLLER_AXIS_RIGHTY:
        state.right.y = -part;
        break;
    case SDL_CONTROLLER_AXIS_TRIGGERLEFT:
        set_trigger(state.button(Key::PadLeftTrigger), part);
        break;
    case SDL_CONTROLLER_AXIS_TRIGGERRIGHT:
        set_trigger(state.button(Key::PadRightTrigger), part);
        break;
    default:
        break;
    }
}

} // namespace

void SdlGamepads::Close::operator()(SDL_GameController* controller) const {
    SDL_GameControllerClose(controller);
}

SdlGamepads::SdlGamepads() : started_(SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0) {
    // Those that are there already are announced by events as well.
    if (!started_) log_warning("no game controllers: {}", SDL_GetError());
}

SdlGamepads::~SdlGamepads() {
    gamepads_.clear();
    if (started_) SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
}

void SdlGamepads::connect(int device) {
    std::unique_ptr<SDL_GameController, Close> controller(SDL_GameControllerOpen(device));
    if (!controller) {
        log_warning("a game controller cannot be used: {}", SDL_GetError());
        return;
    }
    const int id = SDL_JoystickInstanceID(SDL_GameControllerGetJoystick(controller.get()));
    if (gamepads_.contains(id)) return; // announced twice
    const char* name = SDL_GameControllerName(controller.get());
    log_info("game controller: {}", name != nullptr ? name : "without a name");
    gamepads_[id].controller = std::move(controller);
}

void SdlGamepads::disconnect(int id, std::vector<Event>& events) {
    const auto found = gamepads_.find(id);
    if (found == gamepads_.end()) return;
    log_info("a game controller was removed");
    // What it held is let go.
    add_gamepad_events(found->second.state, GamepadState(), events);
    gamepads_.erase(found);
}

void SdlGamepads::handle(const SDL_Event& event, std::vector<Event>& events) {
    const auto change = [&](int id, const auto& edit) {
        const auto found = gamepads_.find(id);
        if (found == gamepads_.end()) return;
        const GamepadState before = found->second.state;
        edit(found->second.state);
        add_gamepad_events(before, found->second.state, events);
    };
    switch (event.type) {
    case SDL_CONTROLLERDEVICEADDED:
        connect(event.cdevice.which);
        break;
    case SDL_CONTROLLERDEVICEREMOVED:
        disconnect(event.cdevice.which, events);
        break;
    case SDL_CONTROLLERBUTTONDOWN:
    case SDL_CONTROLLERBUTTONUP:
        change(event.cbutton.which, [&](GamepadState& state) {
            const Key key = key_of(event.cbutton.button);
            if (key != Key::None) state.button(key) = event.type == SDL_CONTROLLERBUTTONDOWN;
        });
        break;
    case SDL_CONTROLLERAXISMOTION:
        change(event.caxis.which, [&](GamepadState& state) {
            set_axis(state, event.caxis.axis, part_of(event.caxis.value));
        });
        break;
    default:
        break;
    }
}

} // namespace vigil::platform
