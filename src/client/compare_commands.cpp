// SPDX-License-Identifier: GPL-2.0-or-later
// Console commands about techniques: two of them in one picture (compare, comparemove,
// +comparedrag; the variables behind them are pt_compare and pt_compare_at), and presets.
#include "client/client.h"
#include "client/ui/screen_stats.h"
#include "common/log.h"
#include "console/arguments.h"
#include "console/preset.h"

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
        log_info("{}. The keys [ and ] and the right mouse button move the line.",
                 technique_text(client.variables()));
}

void list_presets(Client& client, CommandArguments) {
    const Preset* present = present_preset(client.variables());
    for (const Preset& preset : presets()) {
        std::string settings;
        for (const PresetSetting& setting : preset.settings)
            settings += fmt::format(" {} {}", setting.variable, setting.value);
        log_info("{} {:<9} {} It sets{}.", &preset == present ? '*' : ' ', preset.name,
                 preset.purpose, settings);
    }
}

} // namespace

ClientCommands compare_commands() {
    const auto compared = [](const Client&) { return choice_names(*find_cvar("pt_compare")); };
    return {
        {"compare",
         "[NAME]: Splits the picture, with technique NAME on the right. Alone, it switches that "
         "on and off.",
         [last = std::make_shared<std::string>(compared_first)](
             Client& c, CommandArguments arguments) { compare(c, arguments, *last); },
         compared},
        {"comparemove", "PART: Moves the line of `compare` by this part of the width.",
         [](Client& c, CommandArguments arguments) {
             c.move_compare_line(number_at(arguments, 0, "PART"));
         }},
        {"+comparedrag", "[KEY]: The mouse moves the line of `compare` while the key is held.",
         [](Client& c, CommandArguments) { c.input().set_dragging(true); }},
        {"-comparedrag", "[KEY]: Ends +comparedrag.",
         [](Client& c, CommandArguments) { c.input().set_dragging(false); }},
        {"presets", ": Lists the presets of pt_preset, and what each of them sets.", list_presets}};
}

} // namespace vigil::client
