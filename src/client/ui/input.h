// SPDX-License-Identifier: GPL-2.0-or-later
// Where a window's events go: to the console or the menu while one is open, else to key bindings
// and the camera. Whatever is bound, the key left of 1 (`) opens and closes the console, and Escape
// closes what is open, else opens the menu.
#pragma once

#include "client/play/camera.h"
#include "client/ui/console.h"
#include "client/ui/key_bindings.h"
#include "client/ui/menu.h"
#include "console/command.h"
#include "platform/event.h"

#include <utility>

namespace vigil::client {

class Input {
public:
    /// All must outlive the input.
    Input(CommandRegistry& commands, KeyBindings& bindings, Console& console, Menu& menu,
          Camera& camera);

    /// Mouse motion turns the camera only while `mouse_look` is on. Returns true when the console
    /// or menu has a key or characters that count in their next frame.
    bool handle(const platform::Event& event, bool mouse_look);

    /// The person asked to close the window.
    bool close_requested() const { return close_requested_; }
    /// The window has the keyboard.
    bool focused() const { return focused_; }

    /// Where a controller's sticks stand, as StickEvent has it.
    glm::vec2 stick_move() const { return stick_move_; }
    glm::vec2 stick_look() const { return stick_look_; }

    /// While it is on, and techniques are compared, the mouse moves the line between them instead
    /// of the view.
    void set_dragging(bool dragging) { dragging_ = dragging; }
    /// Counts that the line was moved by since the last call; to the right is positive.
    float take_drag() { return std::exchange(dragged_, 0.0f); }

private:
    void on(const platform::KeyEvent& event);
    void on(const platform::TextEvent& event);
    void on(const platform::MouseMoveEvent& event);
    void on(const platform::WheelEvent& event);
    void on(const platform::StickEvent& event);
    void on(const platform::ResizeEvent&) {}
    void on(const platform::FocusEvent& event);
    void on(const platform::CloseEvent&) { close_requested_ = true; }

    void press(const platform::KeyEvent& event);
    void press_escape();
    void run(const ScriptText& script);

    CommandRegistry& commands_;
    KeyBindings& bindings_;
    Console& console_;
    Menu& menu_;
    Camera& camera_;

    bool mouse_look_ = false;
    bool close_requested_ = false;
    bool focused_ = true;
    bool ctrl_ = false;
    bool shift_ = false;
    bool alt_ = false;
    bool skip_text_ = false; // the character of the key that opened the console is on its way
    float wheel_remainder_ = 0.0f;
    glm::vec2 stick_move_{0.0f}; // as the controller tells
    glm::vec2 stick_look_{0.0f};
    int menu_stick_ = 0; // -1, 1: it holds the menu's choice down, up
    bool dragging_ = false;
    float dragged_ = 0.0f;
};

} // namespace vigil::client
