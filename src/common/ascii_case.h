// SPDX-License-Identifier: GPL-2.0-or-later
// Comparing names without regard to the case of ASCII letters, as Quake II does for files and
// commands. It knows no locale: bytes above 127 stay as they are.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace vigil {

constexpr char ascii_lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
}

inline std::string ascii_lower(std::string_view text) {
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return ascii_lower(c); });
    return lower;
}

constexpr bool equal_nocase(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return ascii_lower(x) == ascii_lower(y); });
}

constexpr bool starts_nocase(std::string_view text, std::string_view prefix) {
    return text.size() >= prefix.size() && equal_nocase(text.substr(0, prefix.size()), prefix);
}

constexpr bool ends_nocase(std::string_view text, std::string_view suffix) {
    return text.size() >= suffix.size() &&
           equal_nocase(text.substr(text.size() - suffix.size()), suffix);
}

} // namespace vigil
