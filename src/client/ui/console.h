// SPDX-License-Identifier: GPL-2.0-or-later
// The console: scroll-back fed by the log, the line being typed with its completion and history.
// Dear ImGui edits the line and shows all of it (console_view.cpp); what is typed here runs through
// the CommandRegistry alone.
#pragma once

#include "client/ui/command_history.h"
#include "common/log.h"
#include "console/command.h"
#include "platform/key.h"

#include <array>
#include <deque>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

struct ImGuiInputTextCallbackData;

namespace vigil::client {

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
    explicit Console(CommandRegistry& commands);
    ~Console();
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;

    /// Takes over the lines that arrived since the last call. `time_s` runs steadily.
    void update(double time_s);

    bool is_open() const { return open_; }
    void set_open(bool open);

    /// A key went down (also by auto-repeat) while the console is open. It counts in the next
    /// frame, so there is to be one for each.
    void key(platform::Key key, bool ctrl, bool shift);
    /// Scrolls by `lines` towards older (positive) or newer ones.
    void scroll(int lines) { scroll_lines_ += lines; }
    void clear_lines();
    /// All lines, each with its end.
    std::string text();

    /// Draws it hanging down to `drop` (0..1) of the screen, at its end `height` of it, into the
    /// current ImGui frame.
    void draw(float drop, float height);
    /// Draws the candidates below it, or above its input line where there is more room.
    void draw_suggestions(float drop) const;
    /// Draws the lines of the last `notify_s` seconds at the top of the screen.
    void draw_notices(double notify_s) const;
    bool has_notices(double notify_s) const;
    /// It gets what is typed: false for the first frames after it was opened.
    bool has_keyboard() const { return has_keyboard_; }
    /// Runs the line that was entered in the last frame, if any.
    void run_entered();

    const std::deque<Line>& lines() const { return lines_; }
    /// The newest line is in sight.
    bool shows_newest() const { return follows_; }
    /// The line that is typed, and the byte of it before which the cursor stands.
    std::string_view input() const { return input_.data(); }
    size_t cursor() const { return cursor_; }
    /// Candidates for the word at the cursor, and which of them Tab has put on the line (-1: none).
    const std::vector<Suggestion>& suggestions() const { return suggestions_; }
    int chosen_suggestion() const { return chosen_; }
    CommandHistory& history() { return history_; }

private:
    void draw_lines();
    void draw_input();
    void on_frame(ImGuiInputTextCallbackData& data);
    bool edit(ImGuiInputTextCallbackData& data);
    void complete(ImGuiInputTextCallbackData& data, int step);
    void refresh_suggestions(std::string_view typed);
    void drop_suggestions();
    Suggestion describe(std::string word, bool first_word) const;
    void append(Severity severity, std::string_view text, double time_s);

    CommandRegistry& commands_;
    CommandHistory history_;
    std::deque<Line> lines_;
    bool open_ = false;
    double time_s_ = 0.0;

    std::array<char, 4096> input_{};
    size_t cursor_ = 0;
    bool has_keyboard_ = false;
    platform::Key edit_key_ = platform::Key::None; // of ours, for the next frame
    bool shift_ = false;
    std::vector<std::string> entered_;

    int scroll_lines_ = 0;      // in the next frame
    bool follows_ = true;       // new lines are scrolled to
    float lines_height_ = 0.0f; // in pixels

    std::vector<Suggestion> suggestions_;
    int chosen_ = -1;
    size_t word_begin_ = 0;

    std::mutex arrived_mutex_; // the log may be written from any thread
    std::vector<Line> arrived_;
    int sink_ = 0;
};

} // namespace vigil::client
