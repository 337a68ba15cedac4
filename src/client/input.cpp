// SPDX-License-Identifier: GPL-2.0-or-later
// Routing of events.
#include "client/input.h"

#include <cmath>
#include <variant>

namespace vigil::client {

using platform::Key;
using platform::KeyEvent;

namespace {

constexpr float degrees_per_count = 0.022f; // Quake's, times `sensitivity`
constexpr float lines_per_wheel_step = 3.0f;

/// Keys whose bindings work while the console is open: they type nothing.
bool works_under_console(Key key) {
    return key >= Key::F1 && key <= Key::F12;
}

bool is_wheel(Key key) {
    return key == Key::WheelUp || key == Key::WheelDown;
}

} // namespace

Input::Input(CommandRegistry& commands, KeyBindings& bindings, Console& console, Camera& camera)
    : commands_(commands), bindings_(bindings), console_(console), camera_(camera) {}

void Input::handle(const platform::Event& event, bool mouse_look) {
    mouse_look_ = mouse_look;
    std::visit([this](const auto& what) { on(what); }, event);
}

void Input::run(const ScriptText& script) {
    commands_.execute_text(script.text, {}, script.trust);
}

void Input::on(const KeyEvent& event) {
    if (event.key == Key::Ctrl) ctrl_ = event.down;
    if (event.key == Key::Shift) shift_ = event.down;
    if (event.key == Key::Alt) alt_ = event.down;
    if (event.down) {
        press(event);
        return;
    }
    if (event.key == Key::Grave) skip_text_ = false;
    // Releases always arrive, or a key held while the console opened would be stuck.
    run(bindings_.release(event.key));
}

void Input::press(const KeyEvent& event) {
    const bool toggles = event.key == Key::Grave || event.key == Key::Escape;
    if (toggles) {
        skip_text_ = event.key == Key::Grave;
        if (!event.repeat) console_.set_open(!console_.is_open());
        return;
    }
    if (event.key == Key::Enter && alt_) {
        if (!event.repeat) commands_.execute_text("toggle vid_fullscreen");
        return;
    }
    if (console_.is_open() && !works_under_console(event.key)) {
        if (!is_wheel(event.key)) console_.key(event.key, ctrl_, shift_);
        return;
    }
    if (!event.repeat) run(bindings_.press(event.key));
}

void Input::on(const platform::TextEvent& event) {
    if (console_.is_open() && !skip_text_ && !ctrl_) console_.text(event.text);
}

void Input::on(const platform::MouseMoveEvent& event) {
    if (!mouse_look_) return;
    const CvarValues& values = commands_.variables().values();
    camera_.turn(event.delta, values.sensitivity * degrees_per_count, values.m_invert != 0);
}

void Input::on(const platform::WheelEvent& event) {
    if (!console_.is_open()) return;
    // Fine wheels report parts of a step.
    wheel_remainder_ += event.steps * lines_per_wheel_step;
    const float lines = std::trunc(wheel_remainder_);
    wheel_remainder_ -= lines;
    console_.scroll(static_cast<int>(lines));
}

void Input::on(const platform::FocusEvent& event) {
    focused_ = event.focused;
    if (focused_) return;
    // Keys that come up now are reported to another window.
    ctrl_ = shift_ = alt_ = skip_text_ = false;
    run(bindings_.release_all());
}

} // namespace vigil::client
