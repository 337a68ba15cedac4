// SPDX-License-Identifier: GPL-2.0-or-later
// What the menu looks like. Only draws; menu.h holds what there is to draw.
#pragma once

#include "client/ui/menu.h"

#include <string>
#include <vector>

struct ImFont;

namespace vigil::client {

/// Draws the menu in the middle of the screen, into the current ImGui frame. Long pages show a
/// part of their rows, with the chosen one. Returns where the rows are.
std::vector<MenuPlace> draw_menu(const Menu& menu, ImFont& font);

/// Lines in the upper right corner, from `top` pixels down.
void draw_stats(const std::vector<std::string>& lines, ImFont& font, float top);

} // namespace vigil::client
