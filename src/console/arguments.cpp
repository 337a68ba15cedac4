// SPDX-License-Identifier: GPL-2.0-or-later
// Counts and numbers of command words.
#include "console/arguments.h"

#include "common/error.h"

#include <charconv>
#include <cmath>
#include <sstream>

namespace vigil {

bool parse_number(std::string_view text, float& value) {
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
}

void for_each_number_line(std::string_view name, std::string_view text, size_t columns,
                          std::string_view expected,
                          const std::function<bool(std::span<const float>)>& allowed,
                          const std::function<void(std::span<const float>, int line)>& visit) {
    std::istringstream lines{std::string(text)};
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        std::istringstream words(line.substr(0, line.find('#')));
        std::vector<float> values;
        bool good = true;
        for (std::string word; words >> word;)
            good &= parse_number(word, values.emplace_back());
        if (values.empty()) continue;
        if (!good || values.size() != columns || !allowed(values))
            fail("{}, line {}: expected {}", name, number, expected);
        visit(values, number);
    }
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
