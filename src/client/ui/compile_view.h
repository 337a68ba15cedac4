// SPDX-License-Identifier: GPL-2.0-or-later
// How the wait for a compiler looks: a box with a bar in the lower part of the window, and the same
// words for a terminal.
#pragma once

#include "refresh/refresh.h"

struct ImFont;

namespace vigil::client {

/// "compiling indirect.vlc, direct.vlc: 3 of 12 shaders done, 8 s".
std::string compilation_text(const refresh::Compilation& state);

/// Draws the box into the current ImGui frame.
void draw_compilation(const refresh::Compilation& state, ImFont& font);

} // namespace vigil::client
