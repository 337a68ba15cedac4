// SPDX-License-Identifier: GPL-2.0-or-later
// The command line, after Quake: `vigil +set NAME VALUE +COMMAND ARGUMENTS ...`. It only sorts the
// words; what they do is up to the variables and commands.
#pragma once

#include "console/command.h"

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vigil {

struct CommandLine {
    bool help = false;    ///< --help
    bool version = false; ///< --version

    /// Variables to set before anything starts: every +set that comes before the first other
    /// command, and every +set of a variable that is read once at the start (life Start), in order.
    std::vector<std::pair<std::string, std::string>> early_sets;

    /// Everything else in the order given, each split into words; for
    /// CommandRegistry::execute_words.
    std::vector<std::vector<std::string>> commands;
};

/// Sorts the words after the program's name. A word that starts with + and is not a number begins a
/// command. Throws Error when a word belongs to no command, or a +set lacks its name or value.
CommandLine parse_command_line(std::span<const char* const> words);

/// Applies the early sets; they do not enter the configuration file. Throws Error as
/// CvarRegistry::set does.
void apply_early_sets(const CommandLine& line, CvarRegistry& variables = cvars());

/// What --help prints.
std::string command_line_help();

} // namespace vigil
