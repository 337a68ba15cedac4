// SPDX-License-Identifier: GPL-2.0-or-later
// What the renderer can be told: a structure made from shaders/shared/settings_table.h. A front end
// passes it with each frame. Names, ranges and help texts are for whoever shows or parses them
// (console/cvar.h).
#pragma once

#include "shared/settings_table.h"

#include <string>
#include <string_view>

namespace vigil {

/// What a variable may change; each value with all that come before it. The table says more.
enum class Affects { Nothing, Display, Picture, Reference };

/// Number of choices in "a|b|c".
constexpr int choice_count(std::string_view choices) {
    int count = 1;
    for (char c : choices)
        count += c == '|' ? 1 : 0;
    return count;
}

/// Index of `name` in "a|b|c", or -1. Letter by letter: to GCC's sanitizers the string's own
/// functions are not constant on a part of a text.
constexpr int choice_index(std::string_view choices, std::string_view name) {
    int index = 0;
    size_t letter = 0;
    bool same = true;
    for (const char c : choices) {
        if (c != '|') {
            same = same && letter < name.size() && name[letter] == c;
            ++letter;
            continue;
        }
        if (same && letter == name.size()) return index;
        ++index;
        letter = 0;
        same = true;
    }
    return same && letter == name.size() ? index : -1;
}

/// Name number `index` of "a|b|c"; index must be in range.
constexpr std::string_view choice_name(std::string_view choices, int index) {
    for (; index > 0; --index)
        choices.remove_prefix(choices.find('|') + 1);
    return choices.substr(0, choices.find('|'));
}

// Members of a structure with the table's defaults. A choice is the index of its name.
#define VIGIL_STRING_MEMBER(name, life, affects, value, help) std::string name = value;
#define VIGIL_INTEGER_MEMBER(name, life, affects, value, low, high, help) int name = value;
#define VIGIL_REAL_MEMBER(name, life, affects, value, low, high, help)                             \
    float name = static_cast<float>(value);
#define VIGIL_CHOICE_MEMBER(name, life, affects, value, choices, help)                             \
    int name = choice_index(choices, value);

namespace refresh {

/// Values in the table's ranges, as members: settings.pt_spp. Compare a choice with
/// setting_choice().
struct Settings {
    VIGIL_RENDERER_TABLE(VIGIL_STRING_MEMBER, VIGIL_INTEGER_MEMBER, VIGIL_REAL_MEMBER,
                         VIGIL_CHOICE_MEMBER, VIGIL_INTEGER_MEMBER, VIGIL_REAL_MEMBER,
                         VIGIL_CHOICE_MEMBER)
};

} // namespace refresh

#define VIGIL_SKIP(...)
#define VIGIL_FIND_CHOICE(name, life, affects, value, choices, help)                               \
    if (variable == #name) index = choice_index(choices, choice);
#define VIGIL_COPY(name, ...) gpu.name = settings.name;
#define VIGIL_COMPARE(name, life, affects, ...)                                                    \
    if (Affects::affects >= Affects::Picture) same = same && a.name == b.name;

/// The value of a named choice, checked when compiling:
/// `if (settings.pt_trace == setting_choice("pt_trace", "query"))`.
consteval int setting_choice(std::string_view variable, std::string_view choice) {
    int index = -1;
    VIGIL_RENDERER_TABLE(VIGIL_SKIP, VIGIL_SKIP, VIGIL_SKIP, VIGIL_FIND_CHOICE, VIGIL_SKIP,
                         VIGIL_SKIP, VIGIL_FIND_CHOICE)
    if (index < 0) throw "no such setting or choice";
    return index;
}

/// What shaders read of the settings.
inline GpuSettings gpu_settings(const refresh::Settings& settings) {
    GpuSettings gpu;
    VIGIL_RENDERER_TABLE(VIGIL_SKIP, VIGIL_SKIP, VIGIL_SKIP, VIGIL_SKIP, VIGIL_COPY, VIGIL_COPY,
                         VIGIL_COPY)
    return gpu;
}

/// Whether radiance with settings `a` is that with `b`: all that affect a picture are the same.
inline bool same_radiance(const refresh::Settings& a, const refresh::Settings& b) {
    bool same = true;
    VIGIL_RENDERER_TABLE(VIGIL_COMPARE, VIGIL_COMPARE, VIGIL_COMPARE, VIGIL_COMPARE, VIGIL_COMPARE,
                         VIGIL_COMPARE, VIGIL_COMPARE)
    return same;
}

#undef VIGIL_SKIP
#undef VIGIL_FIND_CHOICE
#undef VIGIL_COPY
#undef VIGIL_COMPARE

} // namespace vigil
