// SPDX-License-Identifier: GPL-2.0-or-later
// The console command pt_preset.
#include "client/client.h"
#include "common/error.h"
#include "common/log.h"
#include "console/arguments.h"
#include "console/preset.h"

#include <fmt/ranges.h>

namespace vigil::client {

namespace {

std::vector<std::string> preset_names() {
    std::vector<std::string> names;
    for (const Preset& preset : presets())
        names.emplace_back(preset.name);
    return names;
}

void list_presets(const CvarRegistry& variables) {
    const Preset* present = present_preset(variables);
    for (const Preset& preset : presets()) {
        std::string settings;
        for (const PresetSetting& setting : preset.settings)
            settings += fmt::format(" {} {}", setting.variable, setting.value);
        log_info("{} {:<9} {}:{}", &preset == present ? '*' : ' ', preset.name, preset.purpose,
                 settings);
    }
}

void set_preset(Client& client, CommandArguments arguments) {
    if (arguments.empty()) return list_presets(client.commands().variables());
    const Preset* preset = find_preset(arguments[0]);
    if (preset == nullptr)
        fail("there is no preset \"{}\"; there are {}", arguments[0],
             fmt::join(preset_names(), ", "));
    for (const PresetSetting& setting : preset->settings)
        client.commands().set_variable(setting.variable, std::string(setting.value));
}

} // namespace

void add_preset_commands(Client& client) {
    add_commands(
        client,
        {{"pt_preset",
          "[NAME]: the paper as it stands, or speed against accuracy: paper, fast, balanced or "
          "accurate; alone, a list",
          set_preset, [](const Client&) { return preset_names(); }}});
}

} // namespace vigil::client
