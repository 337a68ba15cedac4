// SPDX-License-Identifier: GPL-2.0-or-later
// The ImGui context and one frame of it.
#include "client/overlay.h"

#include "client/console_view.h"

#include <imgui.h>

#include <algorithm>

namespace vigil::client {

namespace {

constexpr float open_height = 0.5f; // of the screen
constexpr float screens_per_second = 3.0f;
constexpr int font_scales = 3;
constexpr float font_pixels = 13.0f; // ImGui's own font is drawn for this size
constexpr float pixels_per_scale = 720.0f;

/// The fonts are the same pixels doubled and tripled, so pick by the height of the picture.
ImFont* font_for(int height) {
    const float scale = static_cast<float>(height) / pixels_per_scale;
    const int index = std::clamp(static_cast<int>(scale + 0.5f), 1, font_scales) - 1;
    return ImGui::GetIO().Fonts->Fonts[index];
}

} // namespace

Overlay::Overlay() {
    IMGUI_CHECKVERSION();
    context_ = ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr; // nothing is placed by hand, so nothing is remembered
    io.LogFilename = nullptr;
    for (int i = 1; i <= font_scales; ++i) {
        ImFontConfig config;
        config.SizePixels = font_pixels * static_cast<float>(i);
        config.OversampleH = 1;
        config.PixelSnapH = true;
        io.Fonts->AddFontDefault(&config);
    }
    io.Fonts->Build();
}

Overlay::~Overlay() {
    ImGui::DestroyContext(context_);
}

ImDrawData* Overlay::draw(const Console& console, glm::ivec2 size, double time_s, double seconds,
                          double notify_s, bool full) {
    const float wanted = !console.is_open() ? 0.0f : full ? 1.0f : open_height;
    const float step = screens_per_second * static_cast<float>(seconds);
    drop_ += std::clamp(wanted - drop_, -step, step);

    const bool notices = drop_ == 0.0f && has_notices(console, time_s, notify_s);
    if (size.x <= 0 || size.y <= 0 || (drop_ == 0.0f && !notices)) return nullptr;

    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(size.x), static_cast<float>(size.y)};
    io.DeltaTime = std::max(static_cast<float>(seconds), 1e-4f);
    ImGui::NewFrame();
    ImFont* font = font_for(size.y);
    if (drop_ > 0.0f) {
        draw_console(console, *font, drop_, time_s);
    } else {
        draw_notices(console, *font, time_s, notify_s);
    }
    ImGui::Render();
    return ImGui::GetDrawData();
}

} // namespace vigil::client
