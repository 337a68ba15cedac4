// SPDX-License-Identifier: GPL-2.0-or-later
// Counts and numbers of command words.
#include "console/arguments.h"

#include "common/error.h"

#include <charconv>
#include <cmath>

namespace vigil {

bool parse_number(std::string_view text, float& value) {
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
}

void check_count(CommandArguments arguments, size_t least, size_t most, std::string_view usage) {
    if (arguments.size() < least || arguments.size() > most) fail("usage: {}", usage);
}

float number_at(CommandArguments arguments, size_t index, std::string_view what) {
    float value = 0.0f;
    if (!parse_number(arguments[index], value)) {
        fail("{} must be a number, not \"{}\"", what, arguments[index]);
    }
    return value;
}

int integer_at(CommandArguments arguments, size_t index, std::string_view what, int low, int high) {
    const std::string& word = arguments[index];
    int value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || value < low || value > high) {
        fail("{} must be a whole number from {} to {}, not \"{}\"", what, low, high, word);
    }
    return value;
}

glm::vec3 vector_at(CommandArguments arguments, size_t index, std::string_view what) {
    return {number_at(arguments, index, what), number_at(arguments, index + 1, what),
            number_at(arguments, index + 2, what)};
}

} // namespace vigil
