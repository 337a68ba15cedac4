// SPDX-License-Identifier: GPL-2.0-or-later
// Presets: the paper as it stands, and a few choices of speed against accuracy, so that nobody must
// know a variable. Each is a row of `run bench trade`; docs/research/trade.md has what it measured.
#pragma once

#include "console/cvar.h"

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vigil {

struct PresetSetting {
    std::string_view variable;
    std::string value;
};

struct Preset {
    std::string_view name;
    std::string_view purpose;
    /// All of them set the same variables.
    std::vector<PresetSetting> settings;
};

/// The paper's, then from the fastest on.
std::span<const Preset> presets();

/// What pt_preset says where the settings are none of them.
inline constexpr std::string_view custom_preset = "custom";

/// The preset of this name, or null.
const Preset* find_preset(std::string_view name);

/// Whether presets set this variable.
bool is_preset_setting(std::string_view variable);

/// The preset whose variables have the values that `value_of` gives as text, or null.
const Preset* preset_with(const std::function<std::string(std::string_view variable)>& value_of);

/// The preset whose variables have just these values, or null.
const Preset* present_preset(const CvarRegistry& variables);
/// Its name, or `custom`.
std::string_view preset_name_of(const CvarValues& values);

/// The name `direction` (1 or -1) further, round and round: from `custom`, the first or the last.
std::string_view next_preset(const CvarRegistry& variables, int direction);

} // namespace vigil
