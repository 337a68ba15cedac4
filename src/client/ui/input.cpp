// SPDX-License-Identifier: GPL-2.0-or-later
// Routing of events.
#include "client/ui/input.h"

#include "client/ui/widget_input.h"

#include <cmath>
#include <variant>

namespace vigil::client {

using platform::Key;
using platform::KeyEvent;

namespace {

constexpr float degrees_per_count = 0.022f; // Quake's, times `sensitivity`
constexpr float lines_per_wheel_step = 3.0f;
constexpr float menu_stick_way = 0.5f; // of a stick, from where it moves the menu's choice

/// Keys whose bindings work while the console is open: they type nothing.
bool works_under_console(Key key) {
    return key >= Key::F1 && key <= Key::F12;
}

bool is_wheel(Key key) {
    return key == Key::WheelUp || key == Key::WheelDown;
}

} // namespace

Input::Input(CommandRegistry& commands, KeyBindings& bindings, Console& console, Menu& menu,
             Camera& camera)
    : commands_(commands), bindings_(bindings), console_(console), menu_(menu), camera_(camera) {}

bool Input::handle(const platform::Event& event, bool mouse_look) {
    mouse_look_ = mouse_look;
    std::visit([this](const auto& what) { on(what); }, event);
    return (console_.is_open() || menu_.is_open()) &&
           (std::holds_alternative<KeyEvent>(event) ||
            std::holds_alternative<platform::TextEvent>(event));
}

void Input::run(const ScriptText& script) {
    commands_.execute_text(script.text, {}, script.trust);
}

void Input::on(const KeyEvent& event) {
    if (event.key == Key::Ctrl) ctrl_ = event.down;
    if (event.key == Key::Shift) shift_ = event.down;
    if (event.key == Key::Alt) alt_ = event.down;
    // The console has no use for clicks: they would take the keyboard from it.
    const bool clicks = menu_.is_open() && !menu_.wants_key() && !console_.is_open();
    if (event.key == Key::Mouse1 && (clicks || !event.down)) {
        hold_widget(event.down);
        if (event.down) return;
    }
    if (event.down) {
        press(event);
        return;
    }
    if (event.key == Key::Grave) skip_text_ = false;
    // Releases always arrive, or a key held while the console opened would be stuck.
    run(bindings_.release(event.key));
}

void Input::press(const KeyEvent& event) {
    if (event.key == Key::Grave) {
        skip_text_ = true;
        if (!event.repeat) {
            menu_.close();
            console_.set_open(!console_.is_open());
        }
        return;
    }
    if (event.key == Key::Escape) {
        if (!event.repeat) press_escape();
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
    if (menu_.is_open() && (menu_.wants_key() || !works_under_console(event.key))) {
        menu_.key(event.key, event.repeat);
        return;
    }
    if (!event.repeat) run(bindings_.press(event.key));
}

void Input::press_escape() {
    if (console_.is_open())
        console_.set_open(false);
    else if (menu_.is_open())
        menu_.key(Key::Escape, false);
    else
        menu_.open();
}

void Input::on(const platform::TextEvent& event) {
    if (console_.is_open() && !skip_text_ && !ctrl_) type_into_widget(event.text);
}

void Input::on(const platform::MouseMoveEvent& event) {
    if (menu_.is_open()) point_at_widgets(event.position);
    if (!mouse_look_) return;
    if (dragging_ && commands_.variables()->pt_compare != 0) {
        dragged_ += event.delta.x;
        return;
    }
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

void Input::on(const platform::StickEvent& event) {
    const bool left = event.stick == platform::StickEvent::Stick::Left;
    (left ? stick_move_ : stick_look_) = event.place;
    if (!left) return;
    // In the menu it is a key that goes down past the half, and comes up below it.
    const int direction = event.place.y > menu_stick_way    ? 1
                          : event.place.y < -menu_stick_way ? -1
                                                            : 0;
    if (direction == std::exchange(menu_stick_, direction) || direction == 0) return;
    if (menu_.is_open() && !menu_.wants_key() && !console_.is_open())
        menu_.key(direction > 0 ? Key::Up : Key::Down, false);
}

void Input::on(const platform::FocusEvent& event) {
    focused_ = event.focused;
    if (focused_) return;
    // Keys that come up now are reported to another window.
    ctrl_ = shift_ = alt_ = skip_text_ = false;
    stick_move_ = stick_look_ = glm::vec2(0.0f);
    run(bindings_.release_all());
}

} // namespace vigil::client
