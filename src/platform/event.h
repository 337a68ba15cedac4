// SPDX-License-Identifier: GPL-2.0-or-later
// What a window reports: keys, typed text, the mouse, game controllers, and changes of the window
// itself. Both window systems deliver the same events, so nothing above this header knows which one
// runs.
#pragma once

#include "platform/key.h"

#include <glm/glm.hpp>
#include <string>
#include <variant>

namespace vigil::platform {

/// A key or mouse button went down or up. `repeat` marks the system's auto-repeat of a held key.
/// A wheel step is WheelUp/WheelDown going down and up at once.
struct KeyEvent {
    Key key = Key::None;
    bool down = false;
    bool repeat = false;
};

/// Typed characters, UTF-8.
struct TextEvent {
    std::string text;
};

/// The mouse moved. `position` in framebuffer pixels from the top left (unspecified while the mouse
/// is captured), `delta` in counts since the last event.
struct MouseMoveEvent {
    glm::vec2 position{0.0f};
    glm::vec2 delta{0.0f};
};

/// The wheel turned: steps, up is positive. Fine wheels report fractions.
struct WheelEvent {
    float steps = 0.0f;
};

/// A stick of a game controller went to `place`: right and up are positive, 1 is all the way, (0,
/// 0) the middle. As the device tells it, so that a stick at rest may be a little off. Its buttons
/// and triggers are keys.
struct StickEvent {
    enum class Stick { Left, Right };
    Stick stick = Stick::Left;
    glm::vec2 place{0.0f};
};

/// The framebuffer has a new size in pixels; (0, 0) while minimised.
struct ResizeEvent {
    glm::ivec2 size{0};
};

struct FocusEvent {
    bool focused = true;
};

/// The person asked to close the window.
struct CloseEvent {};

using Event = std::variant<KeyEvent, TextEvent, MouseMoveEvent, WheelEvent, StickEvent, ResizeEvent,
                           FocusEvent, CloseEvent>;

} // namespace vigil::platform
