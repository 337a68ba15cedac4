// SPDX-License-Identifier: GPL-2.0-or-later
#include "console/preset.h"

#include <algorithm>
#include <utility>

namespace vigil {

namespace {

/// A variable by which the defaults, or a preset, differ from the paper, and the paper's value.
struct Departure {
    std::string_view variable;
    std::string_view paper;
};
constexpr Departure departures[] = {
    {"pt_env_nee", "0"},          // section 7.1: next event estimation knows no environment maps
    {"pt_light_points", "1"},     // section 7: plain area sampling
    {"pt_light_density", "area"}, // the same
    {"pt_oct_start", "0"},        // section 6: the octree follows the frames before
    {"pt_rest_after", "0"},       // section 6: the octree is made anew in every frame
    {"pt_learn_every", "1"},      // the same
    {"pt_vlc_enough", "0"},       // section 4: caches everywhere
    {"pt_vlc_explore", "0.1"},    // section 7
    {"pt_vlc_beside", "0"},       // algorithm 1: exploring samples take the place of others
    {"pt_vlc_adapt", "0"},        // section 8: a fixed fraction
    {"pt_vlc_weigh", "0"},        // algorithm 1: buckets are drawn evenly
    {"pt_vlc_persist", "0"},      // section 4.1: caches of one frame
    {"pt_explore_local", "0"},    // section 4.3: one distribution for all places
    {"pt_cdq_margin", "0.1"},     // section 5.1
    {"pt_cdq_rays", "0"},         // section 5.1: the samples of the frame before
    {"pt_cdq_migrations", "1"},   // section 5.1
    {"pt_cdq_adapt", "0"},        // section 7: half of the rays
    {"pt_guide_gain", "0"},       // all frames have guided rays
    {"pt_guide_directions", "1"}, // section 5.2: a ray is a draw from the mixture
    {"pt_tail", "0"},        // section 7: paths end where light is sampled last; as the default
    {"pt_vlc_bucket", "32"}, // section 7; as the default
    {"pt_indirect_rate", "full"}, // section 7: one path per pixel; as the default
};

/// `settings`, and the departures from the paper that they leave open: off, or at their defaults.
Preset make_preset(std::string_view name, std::string_view purpose,
                   std::vector<PresetSetting> settings, bool paper = false) {
    for (const auto& [variable, value] : departures)
        if (std::ranges::find(settings, variable, &PresetSetting::variable) == settings.end())
            settings.push_back(
                {variable, paper ? std::string(value) : cvar_default_text(*find_cvar(variable))});
    return {name, purpose, std::move(settings)};
}

} // namespace

std::span<const Preset> presets() {
    static const std::vector<Preset> table = {
        make_preset("paper", "As in the paper: every departure from it is off.",
                    {{"pt_nee", "vlc"}, {"pt_guide", "cdq"}, {"pt_spp", "1"}}, true),
        make_preset("fast",
                    "Less time for a frame. It is noisy where only guided rays find the light.",
                    {{"pt_nee", "vlc"},
                     {"pt_guide", "brdf"},
                     {"pt_spp", "1"},
                     {"pt_light_points", "4"},
                     {"pt_vlc_bucket", "16"},
                     {"pt_vlc_adapt", "0"},
                     {"pt_vlc_explore", "0.03"},
                     {"pt_indirect_rate", "half"}}),
        make_preset("balanced",
                    "The defaults. There is little noise anywhere, for one path a pixel.",
                    {{"pt_nee", "vlc"}, {"pt_guide", "cdq"}, {"pt_spp", "1"}}),
        make_preset(
            "accurate", "The least noise. Frames take several times as long.",
            {{"pt_nee", "vlc"}, {"pt_guide", "cdq"}, {"pt_spp", "4"}, {"pt_light_points", "16"}}),
    };
    return table;
}

const Preset* find_preset(std::string_view name) {
    const auto preset = std::ranges::find(presets(), name, &Preset::name);
    return preset != presets().end() ? &*preset : nullptr;
}

bool is_preset_setting(std::string_view variable) {
    const std::vector<PresetSetting>& settings = presets().front().settings;
    return std::ranges::find(settings, variable, &PresetSetting::variable) != settings.end();
}

const Preset* preset_with(const std::function<std::string(std::string_view variable)>& value_of) {
    for (const Preset& preset : presets())
        if (std::ranges::all_of(preset.settings, [&](const PresetSetting& setting) {
                return value_of(setting.variable) == setting.value;
            }))
            return &preset;
    return nullptr;
}

const Preset* present_preset(const CvarRegistry& variables) {
    return preset_with([&](std::string_view name) { return variables.get_text(name); });
}

std::string_view preset_name_of(const CvarValues& values) {
    const Preset* preset =
        preset_with([&](std::string_view name) { return cvar_text(*find_cvar(name), values); });
    return preset != nullptr ? preset->name : custom_preset;
}

std::string_view next_preset(const CvarRegistry& variables, int direction) {
    const Preset* present = present_preset(variables);
    const int count = static_cast<int>(presets().size());
    const int now = present != nullptr ? static_cast<int>(present - presets().data())
                                       : (direction > 0 ? -1 : 0);
    return presets()[static_cast<std::size_t>((now + direction + count) % count)].name;
}

} // namespace vigil
