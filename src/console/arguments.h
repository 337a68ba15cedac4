// SPDX-License-Identifier: GPL-2.0-or-later
// Reading the words after a command's name: counts and numbers, with errors a person can act on.
#pragma once

#include "console/command.h"

#include <glm/glm.hpp>
#include <string_view>

namespace vigil {

/// Throws Error "usage: USAGE" unless between `least` and `most` words are there.
void check_count(CommandArguments arguments, size_t least, size_t most, std::string_view usage);

/// Word `index` as a finite number; throws Error naming `what` and the word.
float number_at(CommandArguments arguments, size_t index, std::string_view what);
/// The same as a whole number in [low, high].
int integer_at(CommandArguments arguments, size_t index, std::string_view what, int low, int high);
/// Three numbers from word `index` on.
glm::vec3 vector_at(CommandArguments arguments, size_t index, std::string_view what);

/// The number that all of `text` spells, or false.
bool parse_number(std::string_view text, float& value);

} // namespace vigil
