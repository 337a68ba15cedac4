// SPDX-License-Identifier: GPL-2.0-or-later
// Splits console text into commands and words, after Quake II's rules: commands end at newlines and
// semicolons, words at white space; double quotes protect both; `//` at the start of a word begins
// a comment. It does not expand `$name` nor run anything; CommandRegistry does.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace vigil {

struct CommandWord {
    std::string text;
    bool quoted = false; ///< some part stood in quotes: `$name` in it stays as it is
};

struct CommandText {
    std::vector<CommandWord> words; ///< never empty
    int line = 1;                   ///< of the text, where the command starts
    bool open_quote = false;        ///< a quote was still open when the line ended
};

/// Commands of `text` in order; empty ones are left out.
std::vector<CommandText> split_commands(std::string_view text);

/// The words of a command as text that split_commands() reads back. Words must hold no double
/// quotes.
std::string quote_word(std::string_view word);

} // namespace vigil
