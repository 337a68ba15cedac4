// SPDX-License-Identifier: GPL-2.0-or-later
// Where a window's events go: to the console while it is open, else to key bindings and the camera.
// The key left of 1 (`) and Escape open and close the console whatever is bound.
#pragma once

#include "client/camera.h"
#include "client/console.h"
#include "client/key_bindings.h"
#include "common/command.h"
#include "platform/event.h"

namespace vigil::client {

class Input {
public:
    /// All must outlive the input.
    Input(CommandRegistry& commands, KeyBindings& bindings, Console& console, Camera& camera);

    /// Mouse motion turns the camera only while `mouse_look` is on.
    void handle(const platform::Event& event, bool mouse_look);

    /// The person asked to close the window.
    bool close_requested() const { return close_requested_; }
    /// The window has the keyboard.
    bool focused() const { return focused_; }

private:
    void on(const platform::KeyEvent& event);
    void on(const platform::TextEvent& event);
    void on(const platform::MouseMoveEvent& event);
    void on(const platform::WheelEvent& event);
    void on(const platform::ResizeEvent&) {}
    void on(const platform::FocusEvent& event);
    void on(const platform::CloseEvent&) { close_requested_ = true; }

    void press(const platform::KeyEvent& event);
    void run(const ScriptText& script);

    CommandRegistry& commands_;
    KeyBindings& bindings_;
    Console& console_;
    Camera& camera_;

    bool mouse_look_ = false;
    bool close_requested_ = false;
    bool focused_ = true;
    bool ctrl_ = false;
    bool shift_ = false;
    bool alt_ = false;
    bool skip_text_ = false; // the character of the key that opened the console is on its way
    float wheel_remainder_ = 0.0f;
};

} // namespace vigil::client
