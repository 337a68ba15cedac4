// SPDX-License-Identifier: GPL-2.0-or-later
// Sorting the command line into early sets and commands.
#include "console/command_line.h"

#include "common/ascii_case.h"
#include "common/error.h"
#include "console/foreign_names.h"

#include <fmt/ranges.h>
#include <string_view>

namespace vigil {

namespace {

// "+map" begins a command; "+5" and "+.5" are numbers.
bool begins_command(std::string_view word) {
    if (word.size() < 2 || word[0] != '+') return false;
    const char c = ascii_lower(word[1]);
    return (c >= 'a' && c <= 'z') || c == '_';
}

bool is_set(const std::vector<std::string>& words) {
    return equal_nocase(words[0], "set") || equal_nocase(words[0], "seta");
}

bool is_start_variable(std::string_view name) {
    const CvarInfo* info = find_cvar(ascii_lower(name));
    return info && info->life == CvarLife::Start;
}

} // namespace

CommandLine parse_command_line(std::span<const char* const> words) {
    // Gather the words of each command.
    CommandLine line;
    std::vector<std::vector<std::string>> commands;
    for (const std::string_view word : words) {
        if (word == "--help" || word == "-h")
            line.help = true;
        else if (word == "--version")
            line.version = true;
        else if (begins_command(word))
            commands.push_back({std::string(word.substr(1))});
        else if (!commands.empty())
            commands.back().emplace_back(word);
        else
            fail("command line: \"{}\" belongs to no command. Commands begin with +, as in +map "
                 "warehouse. --help tells more.",
                 word);
    }

    // Take out the sets that must come early.
    bool only_sets_so_far = true;
    for (std::vector<std::string>& command : commands) {
        const bool set = is_set(command);
        if (set && command.size() != 3)
            fail("command line: +{} needs a name and a value", fmt::join(command, " "));
        only_sets_so_far = only_sets_so_far && set;
        const ForeignName* foreign = set ? find_foreign_name(ascii_lower(command[1])) : nullptr;
        if (foreign != nullptr && find_cvar(foreign->target) != nullptr) {
            command[2] = converted_value(*foreign, command[2]);
            command[1] = foreign->target;
        }
        // What has no counterpart is said once, when commands run.
        const bool is_known = foreign == nullptr || !foreign->target.empty();
        if (set && is_known && (only_sets_so_far || is_start_variable(command[1])))
            line.early_sets.emplace_back(command[1], command[2]);
        else
            line.commands.push_back(std::move(command));
    }
    return line;
}

void apply_early_sets(const CommandLine& line, CvarRegistry& variables) {
    for (const auto& [name, value] : line.early_sets)
        variables.set_for_this_run(ascii_lower(name), value);
}

std::string command_line_help() {
    return "usage: vigil [+set NAME VALUE]... [+COMMAND [ARGUMENTS]]...\n"
           "\n"
           "Commands run in the order given, as if typed at the console. Two kinds of +set come\n"
           "before anything else: those before the first other command, and those of variables\n"
           "that are read once at the start (basedir, game, ...). Their values hold for this run.\n"
           "The configuration file does not keep them.\n"
           "\n"
           "  vigil +map warehouse\n"
           "  vigil +set vid_driver headless +map mine +wait 1 +screenshot mine +quit\n"
           "  vigil +cvarlist +cmdlist +quit\n"
           "\n"
           "  --help     this text\n"
           "  --version  the version\n";
}

} // namespace vigil
