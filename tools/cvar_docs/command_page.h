// SPDX-License-Identifier: GPL-2.0-or-later
// docs/play/commands.md: every command with its usage and what it does, and the names of Quake II
// RTX.
#pragma once

#include <string>
#include <string_view>

namespace vigil::docs {

/// The page as it is committed.
std::string command_page();

/// Text for a cell of a Markdown table, where a bar would end the cell.
std::string cell(std::string_view text);

} // namespace vigil::docs
