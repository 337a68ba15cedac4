// SPDX-License-Identifier: GPL-2.0-or-later
#include "console/preset.h"

#include <algorithm>

namespace vigil {

std::span<const Preset> presets() {
    static const std::vector<Preset> table = {
        {"fast",
         "less time for a frame; noisy where only guided rays find the light",
         {{"pt_nee", "vlc"}, {"pt_guide", "brdf"}, {"pt_spp", "1"}, {"pt_light_points", "4"}}},
        {"balanced",
         "the defaults: little noise everywhere, for one path a pixel",
         {{"pt_nee", "vlc"}, {"pt_guide", "cdq"}, {"pt_spp", "1"}, {"pt_light_points", "8"}}},
        {"accurate",
         "the least noise; frames take several times as long",
         {{"pt_nee", "vlc"}, {"pt_guide", "cdq"}, {"pt_spp", "4"}, {"pt_light_points", "16"}}},
    };
    return table;
}

const Preset* present_preset(const CvarRegistry& variables) {
    for (const Preset& preset : presets())
        if (std::ranges::all_of(preset.settings, [&](const PresetSetting& setting) {
                return variables.get_text(setting.variable) == setting.value;
            }))
            return &preset;
    return nullptr;
}

} // namespace vigil
