// SPDX-License-Identifier: GPL-2.0-or-later
// Drawing the console with ImGui's draw lists.
#include "client/ui/console_view.h"

#include "client/ui/pen.h"

#include <algorithm>
#include <cmath>

namespace vigil::client {

namespace {

constexpr int most_suggestions = 12;
constexpr float notice_height = 0.6f; // of the screen, at most

ImU32 color_of(const Console::Line& line) {
    switch (line.severity) {
    case Severity::Warning:
        return ink::warning;
    case Severity::Error:
        return ink::error;
    case Severity::Info:
        break;
    }
    return line.text.starts_with(']') ? ink::typed : ink::info;
}

/// The scroll-back, from `bottom` upwards.
void draw_lines(const Console& console, const Pen& pen, float left, float width, float bottom) {
    const auto& lines = console.lines();
    float y = bottom;
    if (console.scrolled() > 0) {
        y -= pen.line_height();
        pen.text({left, y}, ink::edge, "^   ^   ^   (newer lines below; PgDn)");
    }
    for (size_t i = lines.size() - std::min(console.scrolled(), lines.size());
         i-- > 0 && y > 0.0f;) {
        const Console::Line& line = lines[i];
        y -= pen.line_height() + static_cast<float>(pen.rows(line.text, width) - 1) * pen.size();
        pen.text({left, y}, color_of(line), line.text, width);
    }
}

/// The line being typed. Long lines slide to the left so that the cursor stays in view.
void draw_input(const Console& console, const Pen& pen, ImVec2 at, float width, double time_s) {
    const std::string& text = console.input().text();
    const std::string_view before = std::string_view(text).substr(0, console.input().cursor());
    const float prompt = pen.measure("] ").x;
    const float cursor = pen.measure(before).x;
    const float slide = std::max(0.0f, cursor + prompt + pen.size() - width);

    ImDrawList& list = pen.list();
    list.PushClipRect(at, {at.x + width, at.y + pen.line_height()}, true);
    pen.text(at, ink::edge, "]");
    list.PushClipRect({at.x + prompt, at.y}, {at.x + width, at.y + pen.line_height()}, true);
    const float x = at.x + prompt - slide;
    pen.text({x, at.y}, ink::info, text);
    if (std::fmod(time_s, 1.0) < 0.6) {
        const float thick = std::max(1.0f, std::floor(pen.size() / 10.0f));
        list.AddRectFilled({x + cursor, at.y}, {x + cursor + thick, at.y + pen.size()}, ink::info);
    }
    list.PopClipRect();
    list.PopClipRect();
}

/// A box with candidates under the console, or over its input line where there is no room below.
/// The range shown follows the chosen one.
void draw_suggestions(const Console& console, const Pen& pen, float left, float below,
                      float above) {
    const auto& all = console.suggestions();
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const auto rows_in = [&pen](float height) {
        return static_cast<int>(height / pen.line_height()) - 2;
    };
    const bool hangs = rows_in(screen.y - below) >= rows_in(above);
    const int room = rows_in(hangs ? screen.y - below : above);
    const int count = std::min({static_cast<int>(all.size()), most_suggestions, room});
    if (count <= 0) return;
    const int chosen = console.chosen_suggestion();
    const int first = std::clamp(chosen - count / 2, 0, static_cast<int>(all.size()) - count);

    const float pad = pen.size() * 0.5f;
    float word_width = 0.0f;
    for (int i = first; i < first + count; ++i) {
        word_width = std::max(word_width, pen.measure(all[static_cast<size_t>(i)].word).x);
    }
    float width = word_width;
    for (int i = first; i < first + count; ++i) {
        const float about = pen.measure(all[static_cast<size_t>(i)].about).x;
        if (about > 0.0f) width = std::max(width, word_width + 2.0f * pad + about);
    }
    const bool more = count < static_cast<int>(all.size());
    const int rows = count + (more ? 1 : 0);
    const float height = static_cast<float>(rows) * pen.line_height() + pad;
    const float top = hangs ? below : above - height;
    const ImVec2 low{left, top};
    const ImVec2 high{std::min(left + width + 3.0f * pad, screen.x - left), top + height};

    ImDrawList& list = pen.list();
    list.AddRectFilled(low, high, IM_COL32(12, 14, 18, 245));
    list.AddRect(low, high, IM_COL32(90, 80, 60, 255));
    list.PushClipRect(low, high, true);
    float y = top + pad * 0.5f;
    for (int i = first; i < first + count; ++i) {
        const Suggestion& suggestion = all[static_cast<size_t>(i)];
        if (i == chosen) {
            list.AddRectFilled({low.x, y}, {high.x, y + pen.line_height()}, ink::chosen);
        }
        pen.text({low.x + pad, y}, ink::info, suggestion.word);
        pen.text({low.x + word_width + 2.0f * pad, y}, ink::dim, suggestion.about);
        y += pen.line_height();
    }
    if (more) pen.text({low.x + pad, y}, ink::dim, fmt::format("{} in all", all.size()));
    list.PopClipRect();
}

} // namespace

void draw_console(const Console& console, ImFont& font, float drop, double time_s) {
    const Pen pen(font);
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float bottom = std::floor(screen.y * drop);
    const float pad = std::floor(pen.size() * 0.5f);
    const float width = screen.x - 2.0f * pad;

    ImDrawList& list = pen.list();
    list.AddRectFilledMultiColor({0.0f, 0.0f}, {screen.x, bottom}, ink::sheet_top, ink::sheet_top,
                                 ink::sheet_bottom, ink::sheet_bottom);
    list.AddRectFilled({0.0f, bottom - 2.0f}, {screen.x, bottom}, ink::edge);

    const float input_y = bottom - 2.0f - pad - pen.line_height();
    list.PushClipRect({0.0f, 0.0f}, {screen.x, std::max(0.0f, input_y)}, true);
    draw_lines(console, pen, pad, width, input_y - pad * 0.5f);
    list.PopClipRect();
    draw_input(console, pen, {pad, input_y}, width, time_s);
    if (console.is_open()) draw_suggestions(console, pen, pad, bottom + pad * 0.5f, input_y);
}

bool has_notices(const Console& console, double time_s, double notify_s) {
    const auto& lines = console.lines();
    return !lines.empty() && time_s - lines.back().time_s < notify_s;
}

void draw_notices(const Console& console, ImFont& font, double time_s, double notify_s) {
    const Pen pen(font);
    const auto& lines = console.lines();
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float pad = std::floor(pen.size() * 0.5f);
    const float width = screen.x - 2.0f * pad;
    const auto height_of = [&](const Console::Line& line) {
        return pen.line_height() + static_cast<float>(pen.rows(line.text, width) - 1) * pen.size();
    };

    // The newest lines that fit; a table that a key printed should not lose its head.
    size_t first = lines.size();
    float room = screen.y * notice_height;
    while (first > 0 && time_s - lines[first - 1].time_s < notify_s) {
        room -= height_of(lines[first - 1]);
        if (room < 0.0f) break;
        --first;
    }
    float y = pad;
    for (size_t i = first; i < lines.size(); ++i) {
        // Noise is hard to read on, so every line brings its own ground.
        const float height = height_of(lines[i]);
        const float ground = std::min(width, pen.measure(lines[i].text, width).x) + 2.0f * pad;
        pen.list().AddRectFilled({0.0f, y}, {ground, y + height}, ink::ground);
        pen.text({pad, y}, color_of(lines[i]), lines[i].text, width);
        y += height;
    }
}

} // namespace vigil::client
