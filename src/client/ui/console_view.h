// SPDX-License-Identifier: GPL-2.0-or-later
// How the console looks: the sheet with its lines, the input line with its cursor, the list of
// candidates, and the notices over the picture. Only draws; console.h holds what there is to draw.
#pragma once

#include "client/ui/console.h"

struct ImFont;

namespace vigil::client {

/// Draws the console hanging down to `drop` (0..1) of the screen, into the current ImGui frame.
void draw_console(const Console& console, ImFont& font, float drop, double time_s);

/// True when a line arrived in the last `notify_s` seconds.
bool has_notices(const Console& console, double time_s, double notify_s);
/// Draws those lines at the top of the screen.
void draw_notices(const Console& console, ImFont& font, double time_s, double notify_s);

} // namespace vigil::client
