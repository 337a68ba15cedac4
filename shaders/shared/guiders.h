// SPDX-License-Identifier: GPL-2.0-or-later
// The list of guiders: what indirect rays are drawn by, besides the BRDF. C++ makes the choices of
// `pt_guide` from it and CMake compiles the passes that draw or learn directions once per row (it
// reads this file line by line, so a row stays on one line). The guiders themselves are in
// shaders/guiding and refresh/vkpt/guiding; docs/research/adding-a-guider.md adds one.
#ifndef VIGIL_SHARED_GUIDERS_H
#define VIGIL_SHARED_GUIDERS_H

// clang-format off
#define VIGIL_GUIDER_TABLE(ROW) \
    ROW(brdf, "No guiding: the surface's BRDF alone.") \
    ROW(cdq, "Quadtrees of directions that brought light, one per node of the octree.") \
    ROW(lobe, "One lobe per node of the octree, around the directions that brought light. A baseline.")
// clang-format on

#ifdef __cplusplus

#include <string_view>

namespace vigil {

/// One value per row, in order: what `pt_guide` holds.
enum class Guide {
#define VIGIL_GUIDER_ENUMERATOR(name, help) name,
    VIGIL_GUIDER_TABLE(VIGIL_GUIDER_ENUMERATOR)
#undef VIGIL_GUIDER_ENUMERATOR
};

#define VIGIL_GUIDER_CHOICE(name, help) "|" #name
/// The names with bars between them: "brdf|cdq|...".
inline constexpr std::string_view guider_choices = std::string_view(VIGIL_GUIDER_TABLE(VIGIL_GUIDER_CHOICE)).substr(1);
#undef VIGIL_GUIDER_CHOICE

struct GuiderInfo {
    std::string_view name;
    std::string_view help;
};

inline constexpr GuiderInfo guider_infos[] = {
#define VIGIL_GUIDER_INFO(name, help) {#name, help},
    VIGIL_GUIDER_TABLE(VIGIL_GUIDER_INFO)
#undef VIGIL_GUIDER_INFO
};

} // namespace vigil

#endif
#endif
