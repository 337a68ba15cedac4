// SPDX-License-Identifier: GPL-2.0-or-later
// Completion of console lines: names of commands, aliases and variables for the first word; values
// and what the command itself offers for the others.
#include "common/ascii_case.h"
#include "console/command.h"

#include <algorithm>

namespace vigil {

namespace {

std::string common_prefix(const std::vector<std::string>& words) {
    if (words.empty()) return {};
    std::string_view common = words.front();
    for (const std::string& word : words) {
        std::size_t length = 0;
        while (length < std::min(common.size(), word.size()) &&
               ascii_lower(common[length]) == ascii_lower(word[length]))
            ++length;
        common = common.substr(0, length);
    }
    return std::string(common);
}

// Where the last word of the line starts: behind the last separator outside quotes.
std::size_t last_word_begin(std::string_view line) {
    std::size_t begin = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"') {
            quoted = !quoted;
            begin = i + 1;
        } else if (!quoted && (line[i] == ' ' || line[i] == '\t' || line[i] == ';')) {
            begin = i + 1;
        }
    }
    return begin;
}

} // namespace

// All that the last word may become, given the finished words before it (at least one).
std::vector<std::string>
CommandRegistry::argument_candidates(const std::vector<std::string>& words) const {
    const std::string name = ascii_lower(words.front());
    const ForeignName* foreign = find_foreign_name(name);
    if (foreign && commands_.contains(foreign->target)) {
        std::vector<std::string> meant = words;
        meant.front() = foreign->target;
        return argument_candidates(meant);
    }
    if (const CvarInfo* info = find_cvar(name))
        return words.size() == 1 ? choice_names(*info) : std::vector<std::string>();
    const auto command = commands_.find(name);
    if (command == commands_.end() || !command->second.complete) return {};
    return command->second.complete(std::span(words).subspan(1));
}

Completion CommandRegistry::complete(std::string_view line) const {
    Completion result;
    result.word_begin = last_word_begin(line);
    const std::string_view typed = line.substr(result.word_begin);

    // The finished words of the last command on the line. A word added behind them makes the
    // splitter return that command even where nothing of it is typed yet.
    const std::string finished = std::string(line.substr(0, result.word_begin)) +
                                 (line.substr(0, result.word_begin).ends_with('"') ? "x\"" : "x");
    std::vector<std::string> words;
    if (const auto commands = split_commands(finished); !commands.empty())
        for (const CommandWord& word : commands.back().words)
            words.push_back(word.text);
    if (!words.empty()) words.pop_back();

    std::vector<std::string> all;
    if (!words.empty()) {
        all = argument_candidates(words);
    } else {
        for (const auto& [name, command] : commands_)
            all.push_back(name);
        for (const auto& [name, script] : aliases_)
            all.push_back(name);
        for (const CvarInfo& info : cvar_infos)
            all.emplace_back(info.name);
        for (const ForeignName& foreign : foreign_names())
            if (!foreign.target.empty()) all.emplace_back(foreign.name);
    }

    for (std::string& candidate : all)
        if (starts_nocase(candidate, typed)) result.candidates.push_back(std::move(candidate));
    std::sort(result.candidates.begin(), result.candidates.end());
    result.candidates.erase(std::unique(result.candidates.begin(), result.candidates.end()),
                            result.candidates.end());
    result.common = common_prefix(result.candidates);
    return result;
}

} // namespace vigil
