// SPDX-License-Identifier: GPL-2.0-or-later
// Reports of experiments as one table for anything that reads CSV (RFC 4180): a line per part, row,
// measure and frame. Numbers that do not exist are empty.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace vigil::bench {

/// The table of a report as run_plan() writes it.
std::string plan_csv(const nlohmann::ordered_json& report);

} // namespace vigil::bench
