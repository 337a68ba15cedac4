// SPDX-License-Identifier: GPL-2.0-or-later
// The list of light sampling techniques that `pt_nee` can choose between. C++ makes the choices of
// the variable from it and CMake compiles one path tracer per row (it reads this file line by line,
// so a row stays on one line); the techniques themselves are in shaders/light.
#ifndef VIGIL_SHARED_TECHNIQUES_H
#define VIGIL_SHARED_TECHNIQUES_H

// clang-format off
#define VIGIL_TECHNIQUE_TABLE(ROW) \
    ROW(sll, "Static Light Lists of Quake II RTX. They weight the lights of the surface's PVS cluster.") \
    ROW(lh, "Light Hierarchy: a tree over all lights. It is walked by what each part may add, and sees no walls.") \
    ROW(vlc, "Visibility Light Cache. It weights the lights that samples of the last frames have seen nearby.") \
    ROW(cut, "Light cuts: each PVS cluster weights single lights nearby and groups of lights farther off.") \
    ROW(uniform, "Every light of the level with equal probability. A baseline.") \
    ROW(power, "Every light of the level in proportion to its emitted power. A baseline.") \
    ROW(ris, "Resampled importance sampling: some lights of the level, weighted. A baseline that knows no clusters.") \
    ROW(brute, "No light sampling: rays by the BRDF meet the lamps. The reference for tests.")
// clang-format on

#ifdef __cplusplus

#include "shared/guiders.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace vigil {

/// One value per row, in order: what `pt_nee` holds.
enum class Technique {
#define VIGIL_TECHNIQUE_ENUMERATOR(name, help) name,
    VIGIL_TECHNIQUE_TABLE(VIGIL_TECHNIQUE_ENUMERATOR)
#undef VIGIL_TECHNIQUE_ENUMERATOR
};

#define VIGIL_TECHNIQUE_CHOICE(name, help) "|" #name
/// The names with bars between them: "sll|uniform|...".
inline constexpr std::string_view technique_choices = std::string_view(VIGIL_TECHNIQUE_TABLE(VIGIL_TECHNIQUE_CHOICE)).substr(1);
#undef VIGIL_TECHNIQUE_CHOICE

struct TechniqueInfo {
    std::string_view name;
    std::string_view help;
};

inline constexpr TechniqueInfo technique_infos[] = {
#define VIGIL_TECHNIQUE_INFO(name, help) {#name, help},
    VIGIL_TECHNIQUE_TABLE(VIGIL_TECHNIQUE_INFO)
#undef VIGIL_TECHNIQUE_INFO
};

/// A technique, and what guides its indirect rays.
struct TechniqueRow {
    Technique technique = Technique::sll;
    Guide guide = Guide::brdf;
    bool operator==(const TechniqueRow&) const = default;
};

/// The row that tables of measurements and `pt_compare` call "NAME", or "NAME+GUIDER" with guided
/// rays; nothing if no technique or guider is called so.
constexpr std::optional<TechniqueRow> find_technique_row(std::string_view name) {
    TechniqueRow row;
    if (const auto plus = name.find('+'); plus != std::string_view::npos) {
        for (const GuiderInfo& info : guider_infos)
            if (info.name == name.substr(plus + 1)) row.guide = static_cast<Guide>(&info - guider_infos);
        if (row.guide == Guide::brdf) return std::nullopt;
        name = name.substr(0, plus);
    }
    for (const TechniqueInfo& info : technique_infos) {
        if (info.name == name) {
            row.technique = static_cast<Technique>(&info - technique_infos);
            return row;
        }
    }
    return std::nullopt;
}

/// The name that find_technique_row() finds.
inline std::string technique_row_name(const TechniqueRow& row) {
    std::string name(technique_infos[static_cast<int>(row.technique)].name);
    if (row.guide == Guide::brdf) return name;
    name += '+';
    return name += guider_infos[static_cast<int>(row.guide)].name;
}

/// What `pt_compare` holds: "none|raw|sll|sll+cdq|...".
inline constexpr auto compare_choice_text = [] {
    constexpr auto write = [](char* to) {
        std::size_t length = 0;
        const auto add = [&](std::string_view text) {
            for (const char c : text) {
                if (to != nullptr) to[length] = c;
                ++length;
            }
        };
        add("none|raw");
        for (const TechniqueInfo& technique : technique_infos)
            for (const GuiderInfo& guider : guider_infos) {
                add("|");
                add(technique.name);
                if (&guider == guider_infos) continue; // the BRDF alone
                add("+");
                add(guider.name);
            }
        return length;
    };
    std::array<char, write(nullptr)> text{};
    write(text.data());
    return text;
}();
inline constexpr std::string_view compare_choices{compare_choice_text.data(), compare_choice_text.size()};

} // namespace vigil

#endif
#endif
