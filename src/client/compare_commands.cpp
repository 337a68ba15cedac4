// SPDX-License-Identifier: GPL-2.0-or-later
// Console commands that compare two techniques in one picture: compare, comparemove, +comparedrag.
// The variables behind them are pt_compare and pt_compare_at.
#include "client/client.h"
#include "client/ui/screen_stats.h"
#include "common/log.h"
#include "console/arguments.h"

#include <memory>

namespace vigil::client {

namespace {

constexpr std::string_view compared_first = "sll";

/// `last` is what was compared last; the command alone switches between it and nothing.
void compare(Client& client, CommandArguments arguments, std::string& last) {
    check_count(arguments, 0, 1, "compare [NAME]");
    CommandRegistry& commands = client.commands();
    const std::string before = client.variables().get_text("pt_compare");
    if (before != "none") last = before;
    commands.set_variable("pt_compare", !arguments.empty() ? arguments[0]
                                        : before == "none" ? last
                                                           : "none");
    if (client.variables()->pt_compare != 0)
        log_info("{}: [ and ] or the right mouse button move the line",
                 technique_text(client.variables()));
}

std::vector<std::string> compared_names(CommandArguments arguments) {
    return arguments.empty() ? choice_names(*find_cvar("pt_compare")) : std::vector<std::string>();
}

void move_line(Client& client, CommandArguments arguments) {
    check_count(arguments, 1, 1, "comparemove PART");
    client.move_compare_line(number_at(arguments, 0, "PART"));
}

} // namespace

void add_compare_commands(Client& client) {
    CommandRegistry& commands = client.commands();
    const auto last = std::make_shared<std::string>(compared_first);
    commands.add(
        "compare",
        "[NAME]: splits the picture: technique NAME (or NAME+cdq) on the right; alone, on and off",
        [&client, last](CommandArguments arguments) { compare(client, arguments, *last); },
        compared_names);
    commands.add("comparemove", "PART: moves the line of `compare` by this part of the width",
                 [&client](CommandArguments arguments) { move_line(client, arguments); });
    commands.add("+comparedrag",
                 "[KEY]: the mouse moves the line of `compare` while the key is held",
                 [&client](CommandArguments) { client.input().set_dragging(true); });
    commands.add("-comparedrag", "[KEY]: ends +comparedrag",
                 [&client](CommandArguments) { client.input().set_dragging(false); });
}

} // namespace vigil::client
