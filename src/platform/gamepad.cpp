// SPDX-License-Identifier: GPL-2.0-or-later
#include "platform/gamepad.h"

#include "common/log.h"

#include <SDL.h>

#include <algorithm>
#include <utility>

namespace vigil::platform {

namespace {

/// SDL numbers the buttons in the order of their keys.
constexpr CodeRun button_runs[] = {
    {SDL_CONTROLLER_BUTTON_A, SDL_CONTROLLER_BUTTON_DPAD_RIGHT, Key::PadA}};

/// SDL's -32768 to 32767 as -1 to 1.
float part_of(int value) {
    return std::max(static_cast<float>(value) / 32767.0f, -1.0f);
}

void set_axis(GamepadState& state, int axis, float part) {
    const auto pull = [&](bool& down) { down = trigger_is_down(down, part); };
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
        pull(state.button(Key::PadLeftTrigger));
        break;
    case SDL_CONTROLLER_AXIS_TRIGGERRIGHT:
        pull(state.button(Key::PadRightTrigger));
        break;
    default:
        break;
    }
}

} // namespace

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

void Gamepads::Close::operator()(SDL_GameController* controller) const {
    SDL_GameControllerClose(controller);
}

Gamepads::Gamepads() : started_(SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0) {
    // Those that are there already are announced by events as well.
    if (!started_) log_warning("no game controllers: {}", SDL_GetError());
}

Gamepads::~Gamepads() {
    gamepads_.clear();
    if (started_) SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
}

void Gamepads::connect(int device) {
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

void Gamepads::disconnect(int id, std::vector<Event>& events) {
    const auto found = gamepads_.find(id);
    if (found == gamepads_.end()) return;
    log_info("a game controller was removed");
    // What it held is let go.
    add_gamepad_events(found->second.state, GamepadState(), events);
    gamepads_.erase(found);
}

void Gamepads::let_go(std::vector<Event>& events) {
    for (auto& [id, gamepad] : gamepads_)
        add_gamepad_events(std::exchange(gamepad.state, {}), GamepadState(), events);
}

void Gamepads::handle(const SDL_Event& event, std::vector<Event>& events) {
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
            const Key key = key_of_code(event.cbutton.button, button_runs);
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
