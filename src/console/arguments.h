// SPDX-License-Identifier: GPL-2.0-or-later
// Reading the words after a command's name: numbers, with errors a person can act on.
#pragma once

#include "console/command.h"

#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <string_view>

namespace vigil {

/// Word `index` as a finite number; throws Error naming `what` and the word.
float number_at(CommandArguments arguments, size_t index, std::string_view what);
/// The same as a whole number in [low, high].
int integer_at(CommandArguments arguments, size_t index, std::string_view what, int low, int high);
/// Three numbers from word `index` on.
glm::vec3 vector_at(CommandArguments arguments, size_t index, std::string_view what);

/// The lines of a text that have words in front of `#`, each as numbers. Throws Error "NAME, line
/// N: expected EXPECTED" where a line has not `columns` numbers, or not such as are `allowed`.
void for_each_number_line(std::string_view name, std::string_view text, size_t columns,
                          std::string_view expected,
                          const std::function<bool(std::span<const float>)>& allowed,
                          const std::function<void(std::span<const float>, int line)>& visit);

/// The number that all of `text` spells, or false.
bool parse_number(std::string_view text, float& value);

} // namespace vigil
