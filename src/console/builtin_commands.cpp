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
    if (!info) fail("{}: unknown variable", name);
    return *info;
}

std::string join(CommandArguments words) {
    return fmt::format("{}", fmt::join(words, " "));
}

std::vector<std::string> variable_names(CommandArguments finished) {
    std::vector<std::string> names;
    if (finished.empty())
        for (const CvarInfo& info : cvar_infos)
            names.emplace_back(info.name);
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
        fail("{} is text: name the values to go through", info.name);
    case CvarType::Choice: {
        const int index = choice_index(info.choices, now) + 1;
        return fmt::to_string(index % choice_count(info.choices));
    }
    case CvarType::Integer:
    case CvarType::Real:
        break;
    }
    if (info.minimum > 0 || info.maximum < 1)
        fail("{} cannot be 0 and 1: name the values to go through", info.name);
    return now == "0" ? "1" : "0";
}

void add_variable_commands(CommandRegistry& commands) {
    CvarRegistry& variables = commands.variables();

    commands.add(
        "set", "NAME VALUE: sets a variable",
        [&](CommandArguments arguments) {
            commands.set_variable(known_cvar(arguments[0]).name, arguments[1]);
        },
        names_then_choices);
    commands.add(
        "seta", "NAME VALUE: sets a variable; for configuration files of other engines",
        [&](CommandArguments arguments) {
            const CvarInfo& info = known_cvar(arguments[0]);
            commands.set_variable(info.name, arguments[1]);
            if (info.life == CvarLife::Session)
                log_info("{} is not kept: it lasts until the program ends", info.name);
        },
        names_then_choices);
    commands.add(
        "reset", "NAME: sets a variable to its default",
        [&](CommandArguments arguments) { commands.reset_variable(known_cvar(arguments[0]).name); },
        variable_names);
    commands.add(
        "toggle", "NAME [VALUES...]: 0 to 1 and back, the next choice, or the next of VALUES",
        [&](CommandArguments arguments) {
            const CvarInfo& info = known_cvar(arguments[0]);
            commands.set_variable(info.name, next_value(info, variables, arguments.subspan(1)));
            log_info("{} \"{}\"", info.name, variables.get_text(info.name));
        },
        variable_names);
    commands.add(
        "cvarlist", "[PREFIX]: all variables; * marks those that differ from their default",
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

    commands.add("cmdlist", "[PREFIX]: all commands", [&](CommandArguments arguments) {
        int count = 0;
        for (const auto& [name, command] : commands.commands()) {
            if (!starts_nocase(name, optional_word(arguments))) continue;
            log_info("  {} {}", name, command.help);
            ++count;
        }
        log_info("{} commands", count);
    });

    const auto help = [&](CommandArguments arguments) {
        if (arguments.empty()) {
            log_info(
                "cmdlist [PREFIX] shows commands, cvarlist [PREFIX] variables; help NAME tells "
                "about one. A variable's name alone shows its value, NAME VALUE sets it.");
            return;
        }
        const std::string name = ascii_lower(arguments[0]);
        const auto command = commands.commands().find(name);
        const auto alias = commands.aliases().find(name);
        if (command != commands.commands().end())
            log_info("{} {}", name, command->second.help);
        else if (alias != commands.aliases().end())
            log_info("{} is an alias for: {}", name, alias->second.text);
        else if (const CvarInfo* info = find_cvar(name))
            log_info("{}", describe_cvar(*info, variables.values()));
        else
            fail("{}: no command or variable has this name", arguments[0]);
    };
    commands.add("help", "[NAME]: what a command or variable does", help,
                 [&](CommandArguments finished) {
                     std::vector<std::string> names = variable_names(finished);
                     if (finished.empty())
                         for (const auto& [name, command] : commands.commands())
                             names.push_back(name);
                     return names;
                 });
}

void add_script_commands(CommandRegistry& commands, ScriptReader read_script) {
    commands.add("echo", "[WORDS...]: prints them",
                 [](CommandArguments arguments) { log_info("{}", join(arguments)); });
    commands.add("wait", "[FRAMES]: what follows in the same script waits for 1 or more frames",
                 [&](CommandArguments arguments) {
                     commands.pause_script(
                         arguments.empty() ? 1 : integer_at(arguments, 0, "FRAMES", 0, INT_MAX));
                 });
    commands.add("exec", "FILE: runs the commands of a cfg file",
                 [&commands, read = std::move(read_script)](CommandArguments arguments) {
                     const ScriptText script = read(arguments[0]);
                     commands.insert_text(script.text, arguments[0], script.trust);
                 });

    commands.add("alias", "[NAME [COMMANDS...]]: names a list of commands; shows one or all",
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
    commands.add("unalias", "NAME: forgets an alias",
                 [&](CommandArguments arguments) { commands.remove_alias(arguments[0]); });
}

} // namespace

void add_builtin_commands(CommandRegistry& commands, ScriptReader read_script) {
    add_variable_commands(commands);
    add_help_commands(commands);
    add_script_commands(commands, std::move(read_script));
}

} // namespace vigil
