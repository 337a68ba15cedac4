// SPDX-License-Identifier: GPL-2.0-or-later
#include "command_page.h"

#include "client/client.h"
#include "client/play/held_buttons.h"
#include "console/builtin_commands.h"
#include "console/foreign_names.h"

#include <fmt/format.h>

namespace vigil::docs {

namespace {

constexpr std::string_view introduction = R"(# Console commands

`vigil_cvar_docs --commands` generates this page from the program's tables. Edit those, not this page.

A command takes as many words as its usage says. `[ ]` may be left out, and `...` stands for any number. `help NAME` prints
the same line at the console, and `cmdlist` lists the commands. [console.md](console.md) tells about scripts and files,
[cvars.md](cvars.md) about variables.
)";

constexpr std::string_view table_head = "| usage | meaning |\n|---|---|\n";

std::string row(std::string_view name, std::string_view help) {
    const size_t colon = help.find(':');
    std::string usage(name);
    if (colon > 0) usage += fmt::format(" {}", help.substr(0, colon));
    return fmt::format("| `{}` | {} |\n", cell(usage), cell(help.substr(colon + 2)));
}

std::string section(std::string_view title, const CommandRegistry& commands) {
    std::string text = fmt::format("\n## {}\n\n{}", title, table_head);
    for (const auto& [name, command] : commands.commands())
        if (!name.starts_with('-')) text += row(name, command.help);
    return text;
}

std::string foreign_section() {
    std::string text =
        "\n## Names of Quake II RTX\n\n"
        "These names work here too, at the console, in cfg files and on the command line. "
        "`q2rtxlist` lists them.\n"
        "A name without a counterpart says so in one line, and a script goes on.\n\n"
        "| name there | name here | values | note |\n|---|---|---|---|\n";
    for (const ForeignName& foreign : foreign_names()) {
        const std::string_view how = foreign.convert;
        std::string values(how);
        if (const size_t bar = how.find('|'); bar != std::string_view::npos)
            values =
                fmt::format("0 is `{}`, more is `{}`", how.substr(0, bar), how.substr(bar + 1));
        else if (how == "exp2")
            values = "2 to the power of it";
        else if (how == "up")
            values = "rounded up";
        else if (how.starts_with('*'))
            values = fmt::format("times {}", how.substr(1));
        text +=
            fmt::format("| `{}` | {} | {} | {} |\n", foreign.name,
                        foreign.target.empty() ? "*(none)*" : fmt::format("`{}`", foreign.target),
                        values, cell(foreign.about));
    }
    return text;
}

} // namespace

std::string cell(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '|') escaped += '\\';
        escaped += c;
    }
    return escaped;
}

std::string command_page() {
    std::string text(introduction);
    for (const client::CommandGroup& group : client::command_groups()) {
        text += fmt::format("\n## {}\n\n{}", group.title, table_head);
        for (const client::ClientCommand& command : group.commands)
            if (!std::string_view(command.name).starts_with('-'))
                text += row(command.name, command.help);
    }
    CvarRegistry variables;
    CommandRegistry held(variables), keys(variables), scripts(variables);
    client::HeldButtons buttons;
    buttons.add_commands(held);
    text += section("Moving", held);
    text += "\nEach command with `+`, these and `+comparedrag`, has one with `-` that ends it.\n";
    client::KeyBindings bindings;
    client::add_binding_commands(keys, bindings);
    text += section("Keys", keys);
    add_builtin_commands(scripts, {});
    text += section("Variables and scripts", scripts);
    return text + foreign_section();
}

} // namespace vigil::docs
