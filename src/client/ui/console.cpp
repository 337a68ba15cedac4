// SPDX-License-Identifier: GPL-2.0-or-later
// The console's reaction to keys: what Dear ImGui's text field does not do itself, which is
// history, completion, running the line, and a few keys of shells.
#include "client/ui/console.h"

#include "client/ui/widget_input.h"
#include "common/ascii_case.h"

#include <imgui.h>

#include <utility>

namespace vigil::client {

using platform::Key;

namespace {

constexpr int page_lines = 10;
constexpr int all_lines = Console::line_capacity * 100; // wrapped ones too
constexpr std::string_view prompt = "]"; // Quake's, in front of lines that were typed

/// Puts `text` in the place of bytes [begin, end).
void replace(ImGuiInputTextCallbackData& data, size_t begin, size_t end, const std::string& text) {
    data.DeleteChars(static_cast<int>(begin), static_cast<int>(end - begin));
    data.InsertChars(static_cast<int>(begin), text.c_str());
}

std::string_view before_cursor(const ImGuiInputTextCallbackData& data) {
    return {data.Buf, static_cast<size_t>(data.CursorPos)};
}

} // namespace

Console::Console(CommandRegistry& commands) : commands_(commands) {
    sink_ = add_log_sink([this](Severity severity, std::string_view line) {
        const std::lock_guard lock(arrived_mutex_);
        arrived_.push_back({severity, std::string(line), 0.0});
    });
}

Console::~Console() {
    remove_log_sink(sink_);
}

void Console::update(double time_s) {
    time_s_ = time_s;
    std::vector<Line> arrived;
    {
        const std::lock_guard lock(arrived_mutex_);
        arrived = std::exchange(arrived_, {});
    }
    for (const Line& line : arrived)
        append(line.severity, line.text, time_s);
}

void Console::append(Severity severity, std::string_view text, double time_s) {
    lines_.push_back({severity, std::string(text), time_s});
    while (lines_.size() > line_capacity)
        lines_.pop_front();
}

void Console::set_open(bool open) {
    open_ = open;
    has_keyboard_ = false;
    if (!open) follows_ = true;
}

void Console::clear_lines() {
    update(time_s_);
    lines_.clear();
    follows_ = true;
}

std::string Console::text() {
    update(time_s_);
    std::string text;
    for (const Line& line : lines_)
        text += line.text + "\n";
    return text;
}

void Console::key(Key key, bool ctrl, bool shift) {
    shift_ = shift;
    switch (key) {
    case Key::PageUp:
        return scroll(page_lines);
    case Key::PageDown:
        return scroll(-page_lines);
    case Key::Home:
    case Key::End:
        if (ctrl) return scroll(key == Key::Home ? all_lines : -all_lines);
        break;
    case Key::Enter:
    case Key::KeypadEnter:
    case Key::Tab:
    case Key::Up:
    case Key::Down:
        edit_key_ = key;
        return;
    case Key::U:
    case Key::K:
        if (ctrl) edit_key_ = key;
        return;
    case Key::L:
        if (ctrl) clear_lines();
        return;
    case Key::A:
        return ctrl ? press_widget_key(Key::Home, false, false) : void();
    case Key::E:
        return ctrl ? press_widget_key(Key::End, false, false) : void();
    case Key::W:
        return ctrl ? press_widget_key(Key::Backspace, true, false) : void();
    default:
        break;
    }
    press_widget_key(key, ctrl, shift);
}

void Console::on_frame(ImGuiInputTextCallbackData& data) {
    if (!std::exchange(has_keyboard_, true)) { // all is selected then
        data.ClearSelection();
        data.CursorPos = data.BufTextLen;
    }
    const std::string before(input());
    const size_t cursor_before = std::exchange(cursor_, static_cast<size_t>(data.CursorPos));
    const bool chosen = edit(data);
    cursor_ = static_cast<size_t>(data.CursorPos);
    if (!chosen && (before != data.Buf || cursor_ != cursor_before))
        refresh_suggestions(before_cursor(data));
}

/// Returns true when the suggestions are to stay as they are.
bool Console::edit(ImGuiInputTextCallbackData& data) {
    const Key key = std::exchange(edit_key_, Key::None);
    const auto length = static_cast<size_t>(data.BufTextLen);
    switch (key) {
    case Key::Enter:
    case Key::KeypadEnter:
        entered_.emplace_back(data.Buf);
        replace(data, 0, length, "");
        break;
    case Key::Up:
        replace(data, 0, length, history_.older(data.Buf));
        break;
    case Key::Down:
        replace(data, 0, length, history_.newer(data.Buf));
        break;
    case Key::Tab:
        complete(data, shift_ ? -1 : 1);
        return true;
    case Key::U:
        replace(data, 0, cursor_, "");
        return false;
    case Key::K:
        replace(data, cursor_, length, "");
        return false;
    default:
        return false;
    }
    drop_suggestions();
    return true;
}

void Console::run_entered() {
    for (const std::string& line : std::exchange(entered_, {})) {
        follows_ = true;
        history_.add(line);
        // Lines that wait in the queue belong above the echo.
        update(time_s_);
        append(Severity::Info, fmt::format("{}{}", prompt, line), time_s_);
        commands_.execute_text(line);
    }
}

void Console::complete(ImGuiInputTextCallbackData& data, int step) {
    // A second Tab walks through the candidates that the first one left.
    if (chosen_ < 0) {
        const Completion found = commands_.complete(before_cursor(data));
        const std::string typed(before_cursor(data).substr(found.word_begin));
        const bool only = found.candidates.size() == 1;
        if (only || found.common.size() > typed.size()) {
            replace(data, found.word_begin, cursor_,
                    only ? found.candidates[0] + " " : found.common);
            refresh_suggestions(before_cursor(data));
            return;
        }
        refresh_suggestions(before_cursor(data));
        chosen_ = step > 0 ? -1 : 0;
    }
    const int count = static_cast<int>(suggestions_.size());
    if (count == 0) return;
    chosen_ = (chosen_ + step + count) % count;
    replace(data, word_begin_, cursor_, suggestions_[static_cast<size_t>(chosen_)].word);
}

void Console::drop_suggestions() {
    suggestions_.clear();
    chosen_ = -1;
}

void Console::refresh_suggestions(std::string_view typed) {
    drop_suggestions();
    if (typed.find_first_not_of(' ') == std::string_view::npos) return;
    Completion found = commands_.complete(typed);
    word_begin_ = found.word_begin;
    const std::string_view before = typed.substr(0, found.word_begin);
    const size_t last_end = before.find_last_not_of(' ');
    const bool first_word = last_end == std::string_view::npos || before[last_end] == ';';
    for (std::string& word : found.candidates)
        suggestions_.push_back(describe(std::move(word), first_word));
}

Suggestion Console::describe(std::string word, bool first_word) const {
    std::string about;
    if (first_word) {
        const auto command = commands_.commands().find(ascii_lower(word));
        if (command != commands_.commands().end()) {
            about = command->second.help;
            // Commands without arguments: nothing stands before the colon.
            if (about.starts_with(": ")) about.erase(0, 2);
        } else if (const CvarInfo* info = find_cvar(ascii_lower(word))) {
            about = fmt::format("= {}  {} ({})", commands_.variables().get_text(info->name),
                                info->help, cvar_range_text(*info));
        } else if (const ForeignName* foreign = find_foreign_name(ascii_lower(word))) {
            about = fmt::format("alias for {}. {}", foreign->target, foreign->about);
        }
    }
    return {std::move(word), std::move(about)};
}

} // namespace vigil::client
