// SPDX-License-Identifier: GPL-2.0-or-later
// What all that lies over the picture looks like: its colours, letters and measures, and the two
// kinds of windows.
#pragma once

#include <imgui.h>

namespace vigil::client::theme {

inline const ImVec4 edge{0.902f, 0.588f, 0.196f, 1.0f};
inline const ImVec4 text{0.84f, 0.84f, 0.81f, 1.0f};
inline const ImVec4 value{0.55f, 0.78f, 1.0f, 1.0f}; // what a person typed or chose
inline const ImVec4 warning{1.0f, 0.8f, 0.35f, 1.0f};
inline const ImVec4 error{1.0f, 0.43f, 0.37f, 1.0f};

/// A window with an edge, in the place that it is given.
inline constexpr ImGuiWindowFlags sheet =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav;
/// Begins a window of text on a dark ground, behind all sheets.
void begin_note(const char* name);

/// A context with the letters of all scales, which is current then. It keeps no file.
ImGuiContext* make_context();
/// 1, 2 or 3, by the height of the picture in pixels: letters are the same pixels doubled and
/// tripled.
float scale_for(float height);
/// Letters of the current context at such a scale.
ImFont* letters(float scale);
/// Measures for letters of 13 pixels, times `scale`.
ImGuiStyle style(float scale);

} // namespace vigil::client::theme
