// SPDX-License-Identifier: GPL-2.0-or-later
// The splitter of console text: one pass over the characters.
#include "console/command_text.h"

#include "common/printable.h"

namespace vigil {

namespace {

bool is_space(char c) {
    return c == ' ' || is_control(c);
}

} // namespace

std::vector<CommandText> split_commands(std::string_view text) {
    std::vector<CommandText> commands;
    CommandText command;
    CommandWord word;
    bool in_word = false;
    bool in_quotes = false;
    int line = 1;

    const auto end_word = [&] {
        if (in_word) command.words.push_back(std::move(word));
        word = {};
        in_word = false;
    };
    const auto end_command = [&] {
        end_word();
        if (!command.words.empty()) commands.push_back(std::move(command));
        command = {};
    };

    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '\n') {
            command.open_quote = in_quotes;
            in_quotes = false;
            end_command();
            ++line;
        } else if (c == '"') {
            if (!in_word && command.words.empty()) command.line = line;
            in_quotes = !in_quotes;
            in_word = word.quoted = true;
        } else if (in_quotes) {
            word.text += c;
        } else if (c == ';') {
            end_command();
        } else if (is_space(c)) {
            end_word();
        } else if (c == '/' && !in_word && text.substr(i, 2) == "//") {
            const auto newline = text.find('\n', i);
            if (newline == std::string_view::npos) break;
            i = newline - 1;
        } else {
            if (!in_word && command.words.empty()) command.line = line;
            in_word = true;
            word.text += c;
        }
    }
    command.open_quote = in_quotes;
    end_command();
    return commands;
}

std::string quote_word(std::string_view word) {
    const bool plain = !word.empty() && word.find_first_of(" \t;$/\"") == std::string_view::npos;
    return plain ? std::string(word) : '"' + std::string(word) + '"';
}

} // namespace vigil
