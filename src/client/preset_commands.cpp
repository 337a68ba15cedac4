// SPDX-License-Identifier: GPL-2.0-or-later
// The console command presets; the variable pt_preset chooses one.
#include "client/client.h"
#include "common/log.h"
#include "console/preset.h"

namespace vigil::client {

namespace {

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

void add_preset_commands(Client& client) {
    add_commands(client,
                 {{"presets", ": lists the presets that pt_preset chooses from, and what each sets",
                   list_presets}});
}

} // namespace vigil::client
