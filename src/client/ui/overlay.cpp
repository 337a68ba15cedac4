// SPDX-License-Identifier: GPL-2.0-or-later
// The ImGui context and one frame of it.
#include "client/ui/overlay.h"

#include "client/ui/compile_box.h"
#include "client/ui/theme.h"
#include "client/ui/widget_input.h"

#include <algorithm>
#include <cmath>

namespace vigil::client {

namespace {

constexpr float open_height = 0.5f; // of the screen
constexpr float least_drop = 0.2f;  // of an open console: its input line can be seen
constexpr float screens_per_second = 3.0f;
constexpr int most_frames = 4; // that ImGui takes to give an open console the keyboard

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

} // namespace

Overlay::Overlay(Clipboard clipboard) : clipboard_(std::move(clipboard)) {
    context_ = theme::make_context();
    ImGuiIO& io = ImGui::GetIO();
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
    if (scale_ != theme::scale_for(io.DisplaySize.y)) {
        scale_ = theme::scale_for(io.DisplaySize.y);
        ImGui::GetStyle() = theme::style(scale_);
    }
    io.DeltaTime = std::max(static_cast<float>(seconds), 1e-4f);
    ImGui::NewFrame();
    ImGui::PushFont(theme::letters(scale_));
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
