// SPDX-License-Identifier: GPL-2.0-or-later
// The ImGui context and one frame of it.
#include "client/ui/overlay.h"

#include "client/ui/compile_view.h"
#include "client/ui/console_view.h"
#include "client/ui/menu_view.h"
#include "client/ui/pen.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

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

/// Four strokes around the middle pixel, dark under bright: visible on any ground.
void draw_crosshair(float scale) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const ImVec2 middle{std::floor(screen.x / 2.0f) + 0.5f, std::floor(screen.y / 2.0f) + 0.5f};
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    const auto stroke = [&](float x, float y) {
        const ImVec2 from{middle.x + 3.0f * scale * x, middle.y + 3.0f * scale * y};
        const ImVec2 to{middle.x + 8.0f * scale * x, middle.y + 8.0f * scale * y};
        list.AddLine(from, to, IM_COL32(0, 0, 0, 255), 3.0f * scale);
        list.AddLine(from, to, IM_COL32(255, 255, 255, 255), scale);
    };
    stroke(1.0f, 0.0f);
    stroke(-1.0f, 0.0f);
    stroke(0.0f, 1.0f);
    stroke(0.0f, -1.0f);
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
#if IMGUI_VERSION_NUM >= 19200
    // Whoever draws the lists makes the textures that they ask for.
    io.BackendFlags |= ImGuiBackendFlags_RendererHasTextures;
#else
    io.Fonts->Build();
#endif
}

Overlay::~Overlay() {
    ImGui::DestroyContext(context_);
}

ImDrawData* Overlay::draw(const OverlayContent& content, glm::ivec2 size, double time_s,
                          double seconds) {
    const Console& console = content.console;
    const float wanted = !console.is_open() ? 0.0f : content.full ? 1.0f : open_height;
    const float step = screens_per_second * static_cast<float>(seconds);
    drop_ += std::clamp(wanted - drop_, -step, step);

    const bool notices = drop_ == 0.0f && has_notices(console, time_s, content.notify_s);
    const bool anything = drop_ > 0.0f || notices || content.crosshair || content.menu.is_open() ||
                          !content.stats.empty() || content.compilation != nullptr;
    if (size.x <= 0 || size.y <= 0 || !anything) return nullptr;

    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(size.x), static_cast<float>(size.y)};
    io.DeltaTime = std::max(static_cast<float>(seconds), 1e-4f);
    ImGui::NewFrame();
    ImFont* font = font_for(size.y);
    // From the back to the front.
    if (!content.stats.empty()) draw_stats(content.stats, *font, 0.0f);
    if (drop_ > 0.0f) {
        draw_console(console, *font, drop_, time_s);
    } else {
        if (content.crosshair) draw_crosshair(size_of(*font) / font_pixels);
        draw_notices(console, *font, time_s, content.notify_s);
    }
    if (content.menu.is_open()) content.menu.set_places(draw_menu(content.menu, *font));
    if (content.compilation != nullptr) draw_compilation(*content.compilation, *font);
    ImGui::Render();
    return ImGui::GetDrawData();
}

} // namespace vigil::client
