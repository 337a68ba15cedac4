// SPDX-License-Identifier: GPL-2.0-or-later
// The commit that the program was built from, for reports.
#pragma once

#include <string_view>

namespace vigil::client {

/// As `git describe --always --dirty` said when the program was linked; "unknown" outside of git.
std::string_view commit();

} // namespace vigil::client
