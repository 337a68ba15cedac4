// SPDX-License-Identifier: GPL-2.0-or-later
// The commands about variables, commands and scripts themselves.
#include "console/builtin_commands.h"

#include "common/ascii_case.h"
#include "common/error.h"
#include "common/log.h"
#include "console/arguments.h"
#include "console/preset.h"

#include <climits>
#include <fmt/ranges.h>
#include <utility>

namespace vigil {

namespace {

std::string_view optional_word(CommandArguments arguments) {
    return arguments.empty() ? std::string_view() : std::string_view(arguments[0]);
}

const CvarInfo& known_cvar(std::string_view name) {
    const CvarInfo* info = find_cvar(ascii_lower(name));
    const ForeignName* foreign = find_foreign_name(ascii_lower(name));
    if (!info && foreign) info = find_cvar(foreign->target);
    if (!info && foreign) fail("{}", describe_foreign_name(*foreign));
    if (!info) fail("{}: unknown variable", name);
    return *info;
}

std::string join(CommandArguments words) {
    return fmt::format("{}", fmt::join(words, " "));
}

std::vector<std::string> variable_names(CommandArguments finished) {
    std::vector<std::string> names;
    if (!finished.empty()) return names;
    for (const CvarInfo& info : cvar_infos)
        names.emplace_back(info.name);
    for (const ForeignName& foreign : foreign_names())
        if (find_cvar(foreign.target)) names.emplace_back(foreign.name);
    return names;
}

// For `set`: names first, then the choices of the named variable.
std::vector<std::string> names_then_choices(CommandArguments finished) {
    if (finished.empty()) return variable_names(finished);
    const CvarInfo* info = find_cvar(ascii_lower(finished[0]));
    return finished.size() == 1 && info ? choice_names(*info) : std::vector<std::string>();
}

// `toggle NAME` flips a number between 0 and 1 and moves a choice on; `toggle NAME A B ...` goes
// from the value that matches to the one after it, and to A from any other value.
std::string next_value(const CvarInfo& info, const CvarRegistry& variables,
                       CommandArguments values) {
    const std::string now = variables.get_text(info.name);
    if (!values.empty()) {
        for (std::size_t i = 0; i < values.size(); ++i)
            if (equal_nocase(values[i], now)) return values[(i + 1) % values.size()];
        return values[0];
    }
    if (info.name == "pt_preset") return std::string(next_preset(variables, 1)); // never custom
    switch (info.type) {
    case CvarType::String:
        fail("{} is text. Name the values to go through.", info.name);
    case CvarType::Choice: {
        const int index = choice_index(info.choices, now) + 1;
        return fmt::to_string(index % choice_count(info.choices));
    }
    case CvarType::Integer:
    case CvarType::Real:
        break;
    }
    if (info.minimum > 0 || info.maximum < 1)
        fail("{} cannot be 0 and 1. Name the values to go through.", info.name);
    return now == "0" ? "1" : "0";
}

void add_variable_commands(CommandRegistry& commands) {
    CvarRegistry& variables = commands.variables();

    commands.add(
        "set", "NAME VALUE: Sets a variable.",
        [&](CommandArguments arguments) {
            if (const ForeignName* foreign = find_foreign_name(ascii_lower(arguments[0])))
                commands.set_foreign(*foreign, arguments[1]);
            else
                commands.set_variable(known_cvar(arguments[0]).name, arguments[1]);
        },
        names_then_choices);
    commands.add(
        "seta", "NAME VALUE: Sets a variable, as configuration files of other engines do.",
        [&](CommandArguments arguments) {
            if (const ForeignName* foreign = find_foreign_name(ascii_lower(arguments[0])))
                return commands.set_foreign(*foreign, arguments[1]);
            const CvarInfo& info = known_cvar(arguments[0]);
            commands.set_variable(info.name, arguments[1]);
            if (info.life == CvarLife::Session)
                log_info("{} is not kept. It lasts until the program ends.", info.name);
        },
        names_then_choices);
    commands.add(
        "reset", "NAME: Sets a variable to its default.",
        [&](CommandArguments arguments) { commands.reset_variable(known_cvar(arguments[0]).name); },
        variable_names);
    commands.add(
        "toggle",
        "NAME [VALUES...]: Sets a variable to the next of VALUES. Without VALUES, it goes from 0 "
        "to 1 and back, or to the next choice.",
        [&](CommandArguments arguments) {
            const CvarInfo& info = known_cvar(arguments[0]);
            commands.set_variable(info.name, next_value(info, variables, arguments.subspan(1)));
            log_info("{} \"{}\"", info.name, variables.get_text(info.name));
        },
        variable_names);
    commands.add(
        "cvarlist",
        "[PREFIX]: Lists the variables. A * marks those that differ from their default.",
        [&](CommandArguments arguments) {
            const auto rows = list_cvars(optional_word(arguments));
            for (const CvarInfo* info : rows) {
                const std::string value = variables.get_text(info->name);
                const char mark = value == cvar_default_text(*info) ? ' ' : '*';
                const std::string quoted = '"' + value + '"';
                log_info("{} {:<20} {:<12} {}", mark, info->name, quoted, info->help);
            }
            log_info("{} variables", rows.size());
        },
        variable_names);
}

void add_help_commands(CommandRegistry& commands) {
    CvarRegistry& variables = commands.variables();

    commands.add("cmdlist", "[PREFIX]: Lists the commands.", [&](CommandArguments arguments) {
        int count = 0;
        for (const auto& [name, command] : commands.commands()) {
            if (!starts_nocase(name, optional_word(arguments))) continue;
            log_info("  {} {}", name, command.help);
            ++count;
        }
        log_info("{} commands", count);
    });

    commands.add("q2rtxlist", "[PREFIX]: Lists names of Quake II RTX, and what they are here.",
                 [](CommandArguments arguments) {
                     for (const ForeignName& foreign : foreign_names())
                         if (starts_nocase(foreign.name, optional_word(arguments)))
                             log_info("  {}", describe_foreign_name(foreign));
                 });

    const auto help = [&](CommandArguments arguments) {
        if (arguments.empty()) {
            log_info("cmdlist [PREFIX] lists commands, cvarlist [PREFIX] variables. help NAME "
                     "tells about "
                     "one. A variable's name alone prints its value, and NAME VALUE sets it.");
            return;
        }
        const std::string name = ascii_lower(arguments[0]);
        const auto command = commands.commands().find(name);
        const auto alias = commands.aliases().find(name);
        if (command != commands.commands().end())
            log_info("{} {}", name, command->second.help);
        else if (alias != commands.aliases().end())
            log_info("{} is an alias. It runs: {}", name, alias->second.text);
        else if (const CvarInfo* info = find_cvar(name))
            log_info("{}", describe_cvar(*info, variables.values()));
        else if (const ForeignName* foreign = find_foreign_name(name))
            log_info("{}", describe_foreign_name(*foreign));
        else
            fail("{}: no command or variable has this name", arguments[0]);
    };
    commands.add("help", "[NAME]: Tells what a command or variable does.", help,
                 [&](CommandArguments finished) {
                     std::vector<std::string> names = variable_names(finished);
                     if (finished.empty())
                         for (const auto& [name, command] : commands.commands())
                             names.push_back(name);
                     return names;
                 });
}

void add_script_commands(CommandRegistry& commands, ScriptReader read_script) {
    commands.add("echo", "[WORDS...]: Prints the words.",
                 [](CommandArguments arguments) { log_info("{}", join(arguments)); });
    commands.add("wait", "[FRAMES]: The rest of the script waits for so many frames, or one.",
                 [&](CommandArguments arguments) {
                     commands.pause_script(
                         arguments.empty() ? 1 : integer_at(arguments, 0, "FRAMES", 0, INT_MAX));
                 });
    commands.add("exec", "FILE: Runs the commands of a cfg file.",
                 [&commands, read = std::move(read_script)](CommandArguments arguments) {
                     const ScriptText script = read(arguments[0]);
                     commands.insert_text(script.text, arguments[0], script.trust);
                 });

    commands.add("alias",
                 "[NAME [COMMANDS...]]: Gives a name to a list of commands. With less, it prints "
                 "one alias or all.",
                 [&](CommandArguments arguments) {
                     if (arguments.empty()) {
                         for (const auto& [name, script] : commands.aliases())
                             log_info("  {} : {}", name, script.text);
                         log_info("{} aliases", commands.aliases().size());
                     } else if (arguments.size() == 1) {
                         const auto alias = commands.aliases().find(ascii_lower(arguments[0]));
                         if (alias == commands.aliases().end())
                             fail("{}: no such alias", arguments[0]);
                         log_info("{} : {}", alias->first, alias->second.text);
                     } else {
                         commands.set_alias(arguments[0], join(arguments.subspan(1)));
                     }
                 });
    commands.add("unalias", "NAME: Forgets an alias.",
                 [&](CommandArguments arguments) { commands.remove_alias(arguments[0]); });
}

} // namespace

void add_builtin_commands(CommandRegistry& commands, ScriptReader read_script) {
    add_variable_commands(commands);
    add_help_commands(commands);
    add_script_commands(commands, std::move(read_script));
}

} // namespace vigil
