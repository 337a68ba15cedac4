// SPDX-License-Identifier: GPL-2.0-or-later
// The light style table and its evaluation. Quake II shows each letter for a tenth of a second
// without blending, and so does this.
#include "client/play/light_styles.h"

#include "common/ascii_case.h"
#include "common/error.h"
#include "common/printable.h"

#include <algorithm>
#include <cmath>

namespace vigil::client {

namespace {

constexpr std::string_view built_in[] = {
    "m",                                                   // 0 normal
    "mmnmmommommnonmmonqnmmo",                             // 1 flicker
    "abcdefghijklmnopqrstuvwxyzyxwvutsrqponmlkjihgfedcba", // 2 slow strong pulse
    "mmmmmaaaaammmmmaaaaaabcdefgabcdefg",                  // 3 candle
    "mamamamamama",                                        // 4 fast strobe
    "jklmnopqrstuvwxyzyxwvutsrqponmlkj",                   // 5 gentle pulse
    "nmonqnmomnmomomno",                                   // 6 flicker
    "mmmaaaabcdefgmmmmaaaammmaamm",                        // 7 candle
    "mmmaaammmaaammmabcdefaaaammmmabcdefmmmaaaa",          // 8 candle
    "aaaaaaaazzzzzzzz",                                    // 9 slow strobe
    "mmamammmmammamamaaamammma",                           // 10 fluorescent flicker
    "abcdefghijklmnopqrrqponmlkjihgfedcba",                // 11 slow pulse that does not go black
};

constexpr int first_switched = 32;
constexpr uint32_t start_off = 1;
constexpr double letters_per_second = 10.0;

float letter_value(char letter) {
    return static_cast<float>(letter - 'a') / static_cast<float>('m' - 'a');
}

} // namespace

LightStyles::LightStyles() {
    for (size_t i = 0; i < std::size(built_in); ++i)
        styles_[i].pattern = built_in[i];
    styles_[63].pattern = "a"; // Quake's "testing" style
}

LightStyles::LightStyles(std::span<const Entity> entities) : LightStyles() {
    for (const Entity& entity : entities) {
        if (!starts_nocase(entity.classname(), "light")) continue;
        const int style = entity.get_int("style");
        if (style < first_switched || style >= refresh::light_style_count) continue;
        const bool off = (static_cast<uint32_t>(entity.get_int("spawnflags")) & start_off) != 0;
        styles_[static_cast<size_t>(style)].pattern = off ? "a" : "m";
    }
}

LightStyles::Style& LightStyles::at(int style) {
    if (style < 0 || style >= refresh::light_style_count) {
        fail("a light style has a number from 0 to {}, not {}", refresh::light_style_count - 1,
             style);
    }
    return styles_[static_cast<size_t>(style)];
}

void LightStyles::set_pattern(int style, std::string_view letters) {
    const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
    if (!std::ranges::all_of(letters, is_letter)) {
        fail("a light style has letters a to z, or a number, not \"{}\"", printable(letters, 80));
    }
    at(style) = {std::string(letters), 1.0f};
}

void LightStyles::set_value(int style, float value) {
    if (!(value >= 0.0f) || !std::isfinite(value)) {
        fail("a light style must be at least 0, not {}", value);
    }
    at(style) = {"", value};
}

std::array<float, refresh::light_style_count> LightStyles::values_at(double time_s) const {
    // A hair is added so that the steps of a clock that counts 1/60 s fall on the right side.
    const auto tick = static_cast<uint64_t>(std::max(0.0, time_s * letters_per_second + 1e-6));
    std::array<float, refresh::light_style_count> values{};
    for (size_t i = 0; i < values.size(); ++i) {
        const Style& style = styles_[i];
        values[i] = style.pattern.empty()
                        ? style.value
                        : letter_value(style.pattern[tick % style.pattern.size()]);
    }
    return values;
}

std::string LightStyles::text(int style) const {
    const Style& found = styles_.at(static_cast<size_t>(style));
    return found.pattern.empty() ? fmt::format("{}", found.value) : found.pattern;
}

} // namespace vigil::client
