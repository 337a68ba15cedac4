// SPDX-License-Identifier: GPL-2.0-or-later
// The console's reaction to keys: editing, history, completion, running the line.
#include "client/ui/console.h"

#include "common/ascii_case.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace vigil::client {

using platform::Key;

namespace {

constexpr int page_lines = 10;
constexpr std::string_view prompt = "]"; // Quake's, in front of lines that were typed

} // namespace

Console::Console(CommandRegistry& commands, Clipboard clipboard)
    : commands_(commands), clipboard_(std::move(clipboard)) {
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
    // What a person has scrolled to stays in place while new lines come in below.
    if (scrolled_ > 0) ++scrolled_;
    while (lines_.size() > line_capacity)
        lines_.pop_front();
    scroll(0);
}

void Console::set_open(bool open) {
    open_ = open;
    if (!open) scrolled_ = 0;
}

void Console::scroll(int lines) {
    const int most = std::max(0, static_cast<int>(lines_.size()) - 1);
    scrolled_ = static_cast<size_t>(std::clamp(static_cast<int>(scrolled_) + lines, 0, most));
}

void Console::clear_lines() {
    update(time_s_);
    lines_.clear();
    scrolled_ = 0;
}

void Console::text(std::string_view utf8) {
    input_.insert(utf8);
    refresh_suggestions();
}

void Console::key(Key key, bool ctrl, bool shift) {
    const EditUnit unit = ctrl ? EditUnit::Word : EditUnit::Character;
    switch (key) {
    case Key::Enter:
    case Key::KeypadEnter:
        submit();
        break;
    case Key::Tab:
        complete(shift ? -1 : 1);
        break;
    case Key::Up:
        input_.set(history_.older(input_.text()));
        break;
    case Key::Down:
        input_.set(history_.newer(input_.text()));
        break;
    case Key::PageUp:
        scroll(page_lines);
        break;
    case Key::PageDown:
        scroll(-page_lines);
        break;
    default:
        edit_key(key, ctrl, unit);
        break;
    }
    if (key == Key::Up || key == Key::Down) {
        suggestions_.clear();
        chosen_ = -1;
    }
}

void Console::edit_key(Key key, bool ctrl, EditUnit unit) {
    const std::string before = input_.text();
    const size_t cursor_before = input_.cursor();
    switch (key) {
    case Key::Left:
        input_.move_left(unit);
        break;
    case Key::Right:
        input_.move_right(unit);
        break;
    case Key::Home:
        ctrl ? scroll(static_cast<int>(lines_.size())) : input_.move_home();
        break;
    case Key::End:
        ctrl ? scroll(-static_cast<int>(lines_.size())) : input_.move_end();
        break;
    case Key::Backspace:
        input_.erase_back(unit);
        break;
    case Key::Delete:
        input_.erase_forward(unit);
        break;
    default:
        if (!ctrl) return;
        switch (key) {
        case Key::A:
            input_.move_home();
            break;
        case Key::E:
            input_.move_end();
            break;
        case Key::W:
            input_.erase_back(EditUnit::Word);
            break;
        case Key::U:
            input_.erase_to_start();
            break;
        case Key::K:
            input_.erase_to_end();
            break;
        case Key::C:
            clipboard_.write(input_.text());
            break;
        case Key::V:
            input_.insert(clipboard_.read());
            break;
        case Key::L:
            clear_lines();
            break;
        default:
            return;
        }
    }
    if (input_.text() != before || input_.cursor() != cursor_before) refresh_suggestions();
}

void Console::submit() {
    const std::string line = input_.text();
    input_.set("");
    suggestions_.clear();
    chosen_ = -1;
    scrolled_ = 0;
    history_.add(line);
    // Lines that wait in the queue belong above the echo.
    update(time_s_);
    append(Severity::Info, fmt::format("{}{}", prompt, line), time_s_);
    commands_.execute_text(line);
}

void Console::complete(int step) {
    // A second Tab walks through the candidates that the first one left.
    if (chosen_ < 0) {
        const Completion found =
            commands_.complete(std::string_view(input_.text()).substr(0, input_.cursor()));
        refresh_suggestions();
        if (found.candidates.empty()) return;
        if (found.candidates.size() == 1) {
            input_.replace_before_cursor(found.word_begin, found.candidates[0]);
            input_.insert(" ");
            refresh_suggestions();
            return;
        }
        const std::string typed =
            input_.text().substr(found.word_begin, input_.cursor() - found.word_begin);
        if (found.common.size() > typed.size()) {
            input_.replace_before_cursor(found.word_begin, found.common);
            refresh_suggestions();
            return;
        }
        chosen_ = step > 0 ? -1 : 0;
    }
    const int count = static_cast<int>(suggestions_.size());
    if (count == 0) return;
    chosen_ = (chosen_ + step + count) % count;
    input_.replace_before_cursor(word_begin_, suggestions_[static_cast<size_t>(chosen_)].word);
}

void Console::refresh_suggestions() {
    suggestions_.clear();
    chosen_ = -1;
    const std::string_view typed = std::string_view(input_.text()).substr(0, input_.cursor());
    if (typed.find_first_not_of(' ') == std::string_view::npos) return;
    Completion found = commands_.complete(typed);
    word_begin_ = found.word_begin;
    const std::string_view before = typed.substr(0, found.word_begin);
    const size_t last_end = before.find_last_not_of(' ');
    const bool first_word = last_end == std::string_view::npos || before[last_end] == ';';
    for (std::string& word : found.candidates) {
        suggestions_.push_back(describe(std::move(word), first_word));
    }
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
        }
    }
    return {std::move(word), std::move(about)};
}

} // namespace vigil::client
