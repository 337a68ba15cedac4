// SPDX-License-Identifier: GPL-2.0-or-later
// The layer over the picture: console, notices, menu, statistics and the wait for a compiler, all
// of them windows of Dear ImGui. It owns the ImGui context; widget_input.h brings what is typed and
// clicked, and the renderer's backend turns the draw data into pixels.
#pragma once

#include "client/ui/console.h"
#include "client/ui/menu.h"
#include "refresh/refresh.h"

#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

struct ImDrawData;
struct ImGuiContext;

namespace vigil::client {

/// Reads and writes the system's clipboard.
struct Clipboard {
    std::function<std::string()> read = [] { return std::string(); };
    std::function<void(const std::string&)> write = [](const std::string&) {};
};

/// What is to be seen over the picture.
struct OverlayContent {
    Console& console;
    Menu& menu;
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
    explicit Overlay(Clipboard clipboard = {});
    ~Overlay();
    Overlay(const Overlay&) = delete;
    Overlay& operator=(const Overlay&) = delete;

    /// Lets the console slide for `seconds` towards open or closed and draws it for a framebuffer
    /// of `size` pixels, and all else that there is to see. What was typed and clicked counts, so
    /// call it after each key with 0 seconds. Returns null when there is nothing to see; the data
    /// is valid until the next call.
    ImDrawData* draw(const OverlayContent& content, glm::ivec2 size, double seconds);

private:
    bool draw_frame(const OverlayContent& content, double seconds);

    Clipboard clipboard_;
    std::string pasted_;
    ImGuiContext* context_ = nullptr;
    float scale_ = 0.0f;
    float drop_ = 0.0f; // height of the console in parts of the screen
};

} // namespace vigil::client
