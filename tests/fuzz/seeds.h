// SPDX-License-Identifier: GPL-2.0-or-later
// Inputs that fuzzing starts from: right files, small ones that the tests build and real ones from
// game folders.
#pragma once

#include "target.h"

#include <filesystem>
#include <vector>

namespace vigil::fuzz {

using Bytes = std::vector<std::uint8_t>;

/// Right files that are made here; none for a target whose seeds are all found.
std::vector<Bytes> built_seeds(const Target& target);

/// Files of the target's format below `folder`, no larger than the target's largest input; for
/// `entities` and `pvs` those parts of its levels. Empty where the folder is missing.
std::vector<Bytes> found_seeds(const Target& target, const std::filesystem::path& folder);

} // namespace vigil::fuzz
