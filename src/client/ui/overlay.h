// SPDX-License-Identifier: GPL-2.0-or-later
// The layer over the picture, drawn with Dear ImGui: console, notices, menu and statistics. It owns
// the ImGui context; the renderer's backend turns the draw data into pixels. ImGui gets no input
// here: the console edits its line itself (line_editor.h says why), and the menu is told where its
// rows are.
#pragma once

#include "client/ui/console.h"
#include "client/ui/menu.h"
#include "refresh/refresh.h"

#include <glm/glm.hpp>
#include <string>
#include <vector>

struct ImDrawData;
struct ImGuiContext;

namespace vigil::client {

/// What is to be seen over the picture.
struct OverlayContent {
    const Console& console;
    Menu& menu;                            ///< is told where its rows are
    const std::vector<std::string>& stats; ///< lines in the corner; may be none
    double notify_s = 0.0;                 ///< new lines stay so long while the console is closed
    bool full = false;      ///< the open console covers everything: there is no level
    bool crosshair = false; ///< marks the middle of the picture while the console is closed
    const refresh::Compilation* compilation =
        nullptr; ///< what the picture waits for; null: nothing
};

class Overlay {
public:
    /// Makes the context current and builds its fonts. Make it before the renderer and keep it
    /// longer.
    Overlay();
    ~Overlay();
    Overlay(const Overlay&) = delete;
    Overlay& operator=(const Overlay&) = delete;

    /// Lets the console slide for `seconds` towards open or closed and draws it for a framebuffer
    /// of `size` pixels, and all else that there is to see. Returns null when that is nothing; the
    /// data is valid until the next call.
    ImDrawData* draw(const OverlayContent& content, glm::ivec2 size, double time_s, double seconds);

private:
    ImGuiContext* context_ = nullptr;
    float drop_ = 0.0f; // height of the console in parts of the screen
};

} // namespace vigil::client
