// SPDX-License-Identifier: GPL-2.0-or-later
// From a texinfo's texture name to file names: replacement formats and the "+0name" animations that
// Quake's own textures use (Quake II's chains through texinfo are in bsp_query.h). It opens no
// files and folds no case; the file system does both.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace vigil {

/// Files to try for a texinfo's texture, best first: textures/<name>.png, .jpg, .tga, .wal.
/// Replacement pictures come before the original. Backslashes become slashes, `*` and `+` are kept.
std::vector<std::string> texture_candidates(std::string_view name);

/// All frames of the sequence `name` belongs to ("+0name" .. "+9name", or "+aname" .. "+jname",
/// also below a folder: "e1u1/+0name"), in order, asking `exists` for each name (without folder
/// textures/ and extension) until the first that is missing. {name} where it is not animated or
/// none exists. Quake shows ten frames per second.
std::vector<std::string> animation_names(std::string_view name,
                                         const std::function<bool(const std::string&)>& exists);

} // namespace vigil
