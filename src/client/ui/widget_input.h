// SPDX-License-Identifier: GPL-2.0-or-later
// Keys, characters and the mouse for Dear ImGui's widgets, in whatever way its version takes them
// (1.86 is the oldest). All of it counts in the next frame of the current context.
#pragma once

#include "platform/key.h"

#include <glm/glm.hpp>
#include <string>

namespace vigil::client {

/// A key that edits text goes down, for one frame; other keys are none of the widgets'.
void press_widget_key(platform::Key key, bool ctrl, bool shift);
/// After a frame, what went down comes up; returns true when that takes another frame.
bool release_widget_keys();
/// Typed characters, UTF-8.
void type_into_widget(const std::string& text);

/// The mouse is at this place, in pixels, or nowhere.
void point_at_widgets(glm::vec2 place);
inline constexpr glm::vec2 nowhere{-3.4e38f}; // ImGui's -FLT_MAX, or less than it
/// Its left button.
void hold_widget(bool down);

} // namespace vigil::client
