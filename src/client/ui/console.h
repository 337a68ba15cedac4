// SPDX-License-Identifier: GPL-2.0-or-later
// The console as data: scroll-back fed by the log, the line being typed, its completion and
// history. It draws nothing (console_view does) and runs commands through the CommandRegistry
// alone.
#pragma once

#include "client/ui/command_history.h"
#include "client/ui/line_editor.h"
#include "common/log.h"
#include "console/command.h"
#include "platform/key.h"

#include <deque>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace vigil::client {

/// Reads and writes the system's clipboard; a null window has none.
struct Clipboard {
    std::function<std::string()> read = [] { return std::string(); };
    std::function<void(const std::string&)> write = [](const std::string&) {};
};

/// One candidate shown under the input line.
struct Suggestion {
    std::string word;
    std::string about; ///< help of a command, value and help of a variable; may be empty
};

class Console {
public:
    static constexpr size_t line_capacity = 4096;

    struct Line {
        Severity severity = Severity::Info;
        std::string text;
        double time_s = 0.0; ///< on the clock of update(), when it arrived
    };

    /// Listens to the log as long as it lives.
    explicit Console(CommandRegistry& commands, Clipboard clipboard = {});
    ~Console();
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;

    /// Takes over the lines that arrived since the last call. `time_s` runs steadily.
    void update(double time_s);

    bool is_open() const { return open_; }
    void set_open(bool open);

    /// A key went down (also by auto-repeat) while the console is open.
    void key(platform::Key key, bool ctrl, bool shift);
    /// Typed characters.
    void text(std::string_view utf8);
    /// Scrolls by `lines` towards older (positive) or newer ones.
    void scroll(int lines);
    void clear_lines();

    const std::deque<Line>& lines() const { return lines_; }
    /// Lines hidden below the bottom edge because of scrolling.
    size_t scrolled() const { return scrolled_; }
    const LineEditor& input() const { return input_; }
    /// Candidates for the word at the cursor, and which of them Tab has put on the line (-1: none).
    const std::vector<Suggestion>& suggestions() const { return suggestions_; }
    int chosen_suggestion() const { return chosen_; }
    CommandHistory& history() { return history_; }

private:
    void edit_key(platform::Key key, bool ctrl, EditUnit unit);
    void submit();
    void complete(int step);
    void refresh_suggestions();
    Suggestion describe(std::string word, bool first_word) const;
    void append(Severity severity, std::string_view text, double time_s);

    CommandRegistry& commands_;
    Clipboard clipboard_;
    CommandHistory history_;
    LineEditor input_;
    std::deque<Line> lines_;
    size_t scrolled_ = 0;
    bool open_ = false;
    double time_s_ = 0.0;

    std::vector<Suggestion> suggestions_;
    int chosen_ = -1;
    size_t word_begin_ = 0;

    std::mutex arrived_mutex_; // the log may be written from any thread
    std::vector<Line> arrived_;
    int sink_ = 0;
};

} // namespace vigil::client
