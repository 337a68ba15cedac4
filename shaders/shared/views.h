// SPDX-License-Identifier: GPL-2.0-or-later
// The list of views that `pt_view` can show instead of the picture: constants for the shader (debug/view.glsl), names and
// help for the variable. The colours and scales are in view_colors.h.
#ifndef VIGIL_SHARED_VIEWS_H
#define VIGIL_SHARED_VIEWS_H

// Columns: constant, number (in order from 0: it is the variable's value), name, help.
// clang-format off
#define VIGIL_VIEW_TABLE(ROW) \
    ROW(VIEW_NONE,        0,  none,        "The picture.") \
    ROW(VIEW_OCTREE,      1,  octree,      "Leaves of the octree, a colour each, with the borders of their cells.") \
    ROW(VIEW_SAMPLES,     2,  samples,     "Surface samples that the leaf received in this frame.") \
    ROW(VIEW_VLC_LIGHTS,  3,  vlc_lights,  "Lights in the leaf's Visibility Light Cache.") \
    ROW(VIEW_VLC_BUCKETS, 4,  vlc_buckets, "Buckets of the leaf's Visibility Light Cache.") \
    ROW(VIEW_CDQ,         5,  cdq,         "Directions at the crosshair: those that the quadtree there draws, and those that light comes from.") \
    ROW(VIEW_TECHNIQUE,   6,  technique,   "Whether cache or exploration chose the light sample, and whether it contributed.") \
    ROW(VIEW_ZERO,        7,  zero,        "Light samples that contributed nothing.") \
    ROW(VIEW_NONFINITE,   8,  nonfinite,   "Values that were not finite.") \
    ROW(VIEW_ALBEDO,      9,  albedo,      "Reflectance.") \
    ROW(VIEW_NORMAL,      10, normal,      "Geometric normals.") \
    ROW(VIEW_DEPTH,       11, depth,       "Distance from the eye.") \
    ROW(VIEW_CLUSTER,     12, cluster,     "PVS clusters, a colour each.") \
    ROW(VIEW_TRIANGLE,    13, triangle,    "Triangles, a colour each.") \
    ROW(VIEW_LIGHT,       14, light,       "Lights, a colour each.")
// clang-format on

#ifdef __cplusplus

#include <string_view>

namespace vigil {

namespace shader {
#define VIGIL_VIEW_CONSTANT(constant, number, name, help) inline constexpr int constant = number;
VIGIL_VIEW_TABLE(VIGIL_VIEW_CONSTANT)
#undef VIGIL_VIEW_CONSTANT
} // namespace shader

#define VIGIL_VIEW_CHOICE(constant, number, name, help) "|" #name
/// The names with bars between them: "none|octree|...".
inline constexpr std::string_view view_choices = std::string_view(VIGIL_VIEW_TABLE(VIGIL_VIEW_CHOICE)).substr(1);
#undef VIGIL_VIEW_CHOICE

struct ViewInfo {
    int number;
    std::string_view name;
    std::string_view help;
};

/// By number.
inline constexpr ViewInfo view_infos[] = {
#define VIGIL_VIEW_INFO(constant, number, name, help) {number, #name, help},
    VIGIL_VIEW_TABLE(VIGIL_VIEW_INFO)
#undef VIGIL_VIEW_INFO
};

} // namespace vigil

#else

#define VIGIL_VIEW_CONSTANT(constant, number, name, help) const int constant = number;
VIGIL_VIEW_TABLE(VIGIL_VIEW_CONSTANT)

#endif
#endif
