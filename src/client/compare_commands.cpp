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

} // namespace

void add_compare_commands(Client& client) {
    const auto compared = [](const Client&) { return choice_names(*find_cvar("pt_compare")); };
    add_commands(
        client,
        {{"compare",
          "[NAME]: splits the picture: technique NAME (or NAME+cdq) on the right; alone, on and "
          "off",
          [last = std::make_shared<std::string>(compared_first)](
              Client& c, CommandArguments arguments) { compare(c, arguments, *last); },
          compared},
         {"comparemove", "PART: moves the line of `compare` by this part of the width",
          [](Client& c, CommandArguments arguments) {
              c.move_compare_line(number_at(arguments, 0, "PART"));
          }},
         {"+comparedrag", "[KEY]: the mouse moves the line of `compare` while the key is held",
          [](Client& c, CommandArguments) { c.input().set_dragging(true); }},
         {"-comparedrag", "[KEY]: ends +comparedrag",
          [](Client& c, CommandArguments) { c.input().set_dragging(false); }}});
}

} // namespace vigil::client
