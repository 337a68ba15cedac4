// SPDX-License-Identifier: GPL-2.0-or-later
// The layer over the picture, drawn with Dear ImGui: the console and its notices. It owns the ImGui
// context; the renderer's backend turns the draw data into pixels. ImGui gets no input here: the
// console edits its line itself (line_editor.h says why).
#pragma once

#include "client/console.h"

#include <glm/glm.hpp>

struct ImDrawData;
struct ImGuiContext;

namespace vigil::client {

class Overlay {
public:
    /// Makes the context current and builds its fonts. Make it before the renderer and keep it
    /// longer.
    Overlay();
    ~Overlay();
    Overlay(const Overlay&) = delete;
    Overlay& operator=(const Overlay&) = delete;

    /// Lets the console slide for `seconds` towards open or closed and draws it for a framebuffer
    /// of `size` pixels. New lines stay on the screen for `notify_s` seconds while it is closed.
    /// Without a level (`full`), the open console covers everything. `crosshair` marks the middle
    /// of the picture while the console is closed. Returns null when there is nothing to see; the
    /// data is valid until the next call.
    ImDrawData* draw(const Console& console, glm::ivec2 size, double time_s, double seconds,
                     double notify_s, bool full, bool crosshair);

private:
    ImGuiContext* context_ = nullptr;
    float drop_ = 0.0f; // height of the console in parts of the screen
};

} // namespace vigil::client
