// SPDX-License-Identifier: GPL-2.0-or-later
// Presets: a few choices of speed against accuracy, so that nobody must know a variable. Each is a
// row of `run bench trade`; docs/trade.md has what it measured.
#pragma once

#include "console/cvar.h"

#include <span>
#include <string_view>
#include <vector>

namespace vigil {

struct PresetSetting {
    std::string_view variable;
    std::string_view value;
};

struct Preset {
    std::string_view name;
    std::string_view purpose;
    /// All of them set the same variables.
    std::vector<PresetSetting> settings;
};

/// From the fastest on.
std::span<const Preset> presets();

/// The preset whose variables have just these values, or null.
const Preset* present_preset(const CvarRegistry& variables);

} // namespace vigil
