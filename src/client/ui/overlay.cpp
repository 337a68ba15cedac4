// SPDX-License-Identifier: GPL-2.0-or-later
// The ImGui context and one frame of it.
#include "client/ui/overlay.h"

#include "client/ui/theme.h"
#include "client/ui/widget_input.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace vigil::client {

namespace {

constexpr float open_height = 0.5f; // of the screen
constexpr float least_drop = 0.2f;  // of an open console: its input line can be seen
constexpr float screens_per_second = 3.0f;
constexpr int most_frames = 4; // that ImGui takes to give an open console the keyboard
constexpr int font_scales = 3;
constexpr float font_pixels = 13.0f; // ImGui's own font is drawn for this size
constexpr float pixels_per_scale = 720.0f;

/// The fonts are the same pixels doubled and tripled, so pick by the height of the picture.
float scale_for(float height) {
    return std::clamp(std::floor(height / pixels_per_scale + 0.5f), 1.0f,
                      static_cast<float>(font_scales));
}

/// Four strokes around the middle pixel, dark under bright: visible on any ground.
void draw_crosshair(float scale) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const ImVec2 middle{std::floor(screen.x / 2.0f) + 0.5f, std::floor(screen.y / 2.0f) + 0.5f};
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
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

void draw_stats(const std::vector<std::string>& lines) {
    ImGui::SetNextWindowPos({ImGui::GetIO().DisplaySize.x, 0.0f}, ImGuiCond_Always, {1.0f, 0.0f});
    theme::begin_note("statistics");
    for (const std::string& line : lines)
        ImGui::TextUnformatted(line.c_str());
    ImGui::End();
}

void draw_compilation(const refresh::Compilation& state) {
    constexpr const char* comfort = "The driver keeps them: the next start is quick.";
    constexpr float height_in_window = 0.7f;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float width = ImGui::CalcTextSize(comfort).x + 2.0f * ImGui::GetStyle().WindowPadding.x;
    ImGui::SetNextWindowPos({screen.x / 2.0f, height_in_window * screen.y}, ImGuiCond_Always,
                            {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(width, screen.x), 0.0f});
    ImGui::BeginTooltip(); // over all else
    ImGui::TextColored(
        theme::edge, "Compiling shaders: %s",
        fmt::format("{} of {}, {:.0f} s", state.done, state.total, state.seconds).c_str());
    ImGui::ProgressBar(std::clamp(state.share, 0.0f, 1.0f), {-FLT_MIN, 0.0f}, "");
    ImGui::TextUnformatted(fmt::format("{}", fmt::join(state.passes, ", ")).c_str());
    ImGui::TextDisabled("%s", comfort);
    ImGui::EndTooltip();
}

} // namespace

std::string compilation_text(const refresh::Compilation& state) {
    return fmt::format("compiling {}: {} of {} shaders done, {:.0f} s",
                       fmt::join(state.passes, ", "), state.done, state.total, state.seconds);
}

Overlay::Overlay(Clipboard clipboard) : clipboard_(std::move(clipboard)) {
    IMGUI_CHECKVERSION();
    context_ = ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr; // nothing is placed by hand, so nothing is remembered
    io.LogFilename = nullptr;
    io.ClipboardUserData = this;
    io.GetClipboardTextFn = [](void* self) {
        auto& overlay = *static_cast<Overlay*>(self);
        overlay.pasted_ = overlay.clipboard_.read();
        for (char& c : overlay.pasted_) // lines become one line
            if (c == '\n' || c == '\t') c = ' ';
        return overlay.pasted_.c_str();
    };
    io.SetClipboardTextFn = [](void* self, const char* text) {
        static_cast<Overlay*>(self)->clipboard_.write(text);
    };
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

ImDrawData* Overlay::draw(const OverlayContent& content, glm::ivec2 size, double seconds) {
    Console& console = content.console;
    const float wanted = !console.is_open() ? 0.0f : content.full ? 1.0f : open_height;
    const float step = screens_per_second * static_cast<float>(seconds);
    drop_ += std::clamp(wanted - drop_, -step, step);
    if (console.is_open()) drop_ = std::max(drop_, least_drop);

    const bool notices = drop_ == 0.0f && console.has_notices(content.notify_s);
    const bool anything = drop_ > 0.0f || notices || content.crosshair || content.menu.is_open() ||
                          !content.stats.empty() || content.compilation != nullptr;
    if (size.x <= 0 || size.y <= 0 || !anything) return nullptr;

    ImGui::SetCurrentContext(context_);
    ImGui::GetIO().DisplaySize = {static_cast<float>(size.x), static_cast<float>(size.y)};
    bool more = draw_frame(content, seconds);
    for (int i = 0; i < most_frames && more; ++i)
        more = draw_frame(content, 0.0);
    return ImGui::GetDrawData();
}

/// Returns true when what was typed or opened takes another.
bool Overlay::draw_frame(const OverlayContent& content, double seconds) {
    ImGuiIO& io = ImGui::GetIO();
    if (scale_ != scale_for(io.DisplaySize.y)) {
        scale_ = scale_for(io.DisplaySize.y);
        ImGui::GetStyle() = theme::style(scale_);
    }
    io.DeltaTime = std::max(static_cast<float>(seconds), 1e-4f);
    ImGui::NewFrame();
    ImGui::PushFont(io.Fonts->Fonts[static_cast<int>(scale_) - 1]);
    if (!content.stats.empty()) draw_stats(content.stats);
    if (drop_ > 0.0f) {
        content.console.draw(drop_, content.full ? 1.0f : open_height);
    } else {
        if (content.crosshair) draw_crosshair(scale_);
        if (content.console.has_notices(content.notify_s))
            content.console.draw_notices(content.notify_s);
    }
    if (content.menu.is_open()) content.menu.draw();
    if (content.compilation != nullptr)
        draw_compilation(*content.compilation);
    else if (content.console.is_open())
        content.console.draw_suggestions(drop_);
    ImGui::PopFont();
    ImGui::Render();
    const bool released = release_widget_keys();
    return released || (content.console.is_open() && !content.console.has_keyboard());
}

} // namespace vigil::client
