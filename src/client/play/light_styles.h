// SPDX-License-Identifier: GPL-2.0-or-later
// Light styles: how brightly each of Quake's 256 numbered groups of lights shines at a time. The
// built-in patterns 0..11 are facts of Quake's game code: one letter per tenth of a second, a =
// dark, m = normal, z = twice as bright.
#pragma once

#include "formats/entity.h"
#include "refresh/refresh.h"

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace vigil::client {

class LightStyles {
public:
    /// Patterns of a fresh level: 0..11 as in Quake, 63 dark, all others steady.
    LightStyles();

    /// The same, with the switched lights (styles 32 and up) of a level off that start off:
    /// entities of class light* with bit 0 of `spawnflags`.
    explicit LightStyles(std::span<const Entity> entities);

    /// Letters a to z, ten per second, repeated; "" is steady at 1. Throws Error otherwise, and
    /// when the style is not in 0..255.
    void set_pattern(int style, std::string_view letters);
    /// Steady at `value` >= 0. Throws Error otherwise.
    void set_value(int style, float value);

    /// The multipliers at a time in seconds.
    std::array<float, refresh::light_style_count> values_at(double time_s) const;

    /// "0.5" or "mmamm", for messages.
    std::string text(int style) const;

private:
    struct Style {
        std::string pattern; // empty: steady
        float value = 1.0f;
    };
    Style& at(int style);

    std::array<Style, refresh::light_style_count> styles_;
};

} // namespace vigil::client
