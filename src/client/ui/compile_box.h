// SPDX-License-Identifier: GPL-2.0-or-later
// The wait for a compiler as a person sees it: a box over the picture, and a line of text.
#pragma once

#include "refresh/refresh.h"

#include <string>

namespace vigil::client {

/// Draws the box in the current frame of Dear ImGui, over all else.
void draw_compilation(const refresh::Compilation& state);

/// "compiling indirect.vlc, direct.vlc: 3 of 12 shaders done, 8 s".
std::string compilation_text(const refresh::Compilation& state);

} // namespace vigil::client
