// SPDX-License-Identifier: GPL-2.0-or-later
// Presets: the paper as it stands, and a few choices of speed against accuracy, so that nobody must
// know a variable. Each is a row of `run bench trade`; docs/research/trade.md has what it measured.
#pragma once

#include "console/cvar.h"

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

/// The preset of this name, or null.
const Preset* find_preset(std::string_view name);

/// The preset whose variables have just these values, or null.
const Preset* present_preset(const CvarRegistry& variables);

} // namespace vigil
