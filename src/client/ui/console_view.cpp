// SPDX-License-Identifier: GPL-2.0-or-later
// How the console looks: its lines, the line being typed, the candidates, and notices over the
// picture.
#include "client/ui/console.h"
#include "client/ui/theme.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <utility>

namespace vigil::client {

namespace {

constexpr float most_suggestions = 12.5f; // the half one tells that there are more
constexpr float notice_height = 0.6f;     // of the screen, at most

ImVec4 color_of(const Console::Line& line) {
    switch (line.severity) {
    case Severity::Warning:
        return theme::warning;
    case Severity::Error:
        return theme::error;
    case Severity::Info:
        break;
    }
    return line.text.starts_with(']') ? theme::value : theme::text;
}

void show_line(const Console::Line& line) {
    ImGui::PushStyleColor(ImGuiCol_Text, color_of(line));
    ImGui::TextUnformatted(line.text.data(), line.text.data() + line.text.size());
    ImGui::PopStyleColor();
}

} // namespace

void Console::draw_lines() {
    // A few lines stand at the bottom.
    const float room = ImGui::GetWindowHeight() - lines_height_;
    if (room > 0.0f && !lines_.empty()) ImGui::SetCursorPosY(room);
    const float top = ImGui::GetCursorPosY();
    ImGui::PushTextWrapPos(0.0f);
    for (const Line& line : lines_)
        show_line(line);
    ImGui::PopTextWrapPos();
    lines_height_ = ImGui::GetCursorPosY() - top;

    const float newest = ImGui::GetScrollMaxY();
    float wanted = ImGui::GetScrollY();
    if (scroll_lines_ != 0) {
        wanted -= static_cast<float>(std::exchange(scroll_lines_, 0)) *
                  ImGui::GetTextLineHeightWithSpacing();
        wanted = std::clamp(wanted, 0.0f, newest);
        ImGui::SetScrollY(wanted);
        follows_ = wanted == newest;
    } else if (follows_) {
        ImGui::SetScrollHereY(1.0f);
    }
}

void Console::draw_input() {
    ImGui::TextColored(theme::edge, "]");
    ImGui::SameLine(0.0f, ImGui::CalcTextSize(" ").x);
    ImGui::SetNextItemWidth(-FLT_MIN);
    if (!has_keyboard_) ImGui::SetKeyboardFocusHere();
    const auto on_edit = [](ImGuiInputTextCallbackData* data) {
        static_cast<Console*>(data->UserData)->on_frame(*data);
        return 0;
    };
    ImGui::InputText("##input", input_.data(), input_.size(), ImGuiInputTextFlags_CallbackAlways,
                     on_edit, this);
}

void Console::draw(float drop, float height) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    // Of its edge only the lower part is on the screen.
    ImGui::SetNextWindowPos({-1.0f, screen.y * (drop - height) - 1.0f});
    ImGui::SetNextWindowSize({screen.x + 2.0f, screen.y * height + 1.0f});
    ImGui::Begin("console", nullptr, theme::sheet);
    ImGui::BeginChild("lines", {0.0f, -ImGui::GetFrameHeightWithSpacing()});
    draw_lines();
    ImGui::EndChild();
    draw_input();
    ImGui::End();
}

void Console::draw_suggestions(float drop) const {
    if (suggestions_.empty()) return;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const ImVec2 pad = ImGui::GetStyle().WindowPadding;
    const float below = screen.y * drop + pad.y;
    const float above = screen.y * drop - ImGui::GetFrameHeight() - 2.0f * pad.y;
    const bool hangs = screen.y - below >= above;
    ImGui::SetNextWindowPos({pad.x, hangs ? below : above}, ImGuiCond_Always,
                            {0.0f, hangs ? 0.0f : 1.0f});
    const float most = most_suggestions * ImGui::GetTextLineHeightWithSpacing();
    ImGui::SetNextWindowSizeConstraints(
        {0.0f, 0.0f}, {screen.x - 2.0f * pad.x, std::min(hangs ? screen.y - below : above, most)});
    ImGui::BeginTooltip();
    if (ImGui::BeginTable("words", 2, ImGuiTableFlags_SizingFixedFit)) {
        for (int i = 0; i < static_cast<int>(suggestions_.size()); ++i) {
            const Suggestion& suggestion = suggestions_[static_cast<size_t>(i)];
            ImGui::TableNextColumn();
            ImGui::Selectable(suggestion.word.c_str(), i == chosen_,
                              ImGuiSelectableFlags_SpanAllColumns);
            if (i == chosen_) ImGui::SetScrollHereY();
            ImGui::TableNextColumn();
            ImGui::TextDisabled("%s", suggestion.about.c_str());
        }
        ImGui::EndTable();
    }
    ImGui::EndTooltip();
}

bool Console::has_notices(double notify_s) const {
    return !lines_.empty() && time_s_ - lines_.back().time_s < notify_s;
}

void Console::draw_notices(double notify_s) const {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.0f, 0.0f});
    ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {screen.x, screen.y * notice_height});
    theme::begin_note("notices");
    ImGui::PushTextWrapPos(screen.x - ImGui::GetStyle().WindowPadding.x);
    for (const Line& line : lines_)
        if (time_s_ - line.time_s < notify_s) show_line(line);
    ImGui::PopTextWrapPos();
    ImGui::SetScrollHereY(1.0f); // the newest, where not all have room
    ImGui::End();
}

} // namespace vigil::client
