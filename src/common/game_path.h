// SPDX-License-Identifier: GPL-2.0-or-later
// What counts as a safe relative path, for names that come from levels, archives and the console.
// It looks at the text only, never at the disk.
#pragma once

#include <string_view>

namespace vigil {

/// Why `path` is not a safe relative path with forward slashes ("goes up with ..", "is absolute",
/// ...), or an empty text when it is one.
std::string_view game_path_fault(std::string_view path);

} // namespace vigil
