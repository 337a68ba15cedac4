// SPDX-License-Identifier: GPL-2.0-or-later
// Builds the alias table that shaders/shared/alias_table.h looks up (Vose, "A Linear Algorithm for
// Generating Random Numbers with a Given Distribution", 1991). The densities it stores are those of
// the table as quantised, not of the weights it was asked for: sampling with them is unbiased,
// exactly.
#pragma once

#include "shared/alias_table.h"

#include <cstddef>
#include <span>
#include <vector>

namespace vigil {

/// A table over `weights` (any finite numbers >= 0, in any unit; at most 2^32 - 1 of them). One
/// entry per weight; empty if there are no weights or none is positive: then there is nothing to
/// draw. An entry of weight zero is never drawn; one of positive weight always can be, however
/// small. Throws Error on negative or non-finite weights.
std::vector<shader::AliasEntry> build_alias_table(std::span<const float> weights);

/// The same as shaders/light/alias.glsl reads it: the number of entries, then the entries.
std::vector<std::byte> alias_table_bytes(std::span<const float> weights);

} // namespace vigil
