// SPDX-License-Identifier: GPL-2.0-or-later
// The list of what a scene may have or lack. Each is a specialisation constant, so that a pass has no code for what no
// surface of the level needs: the members of SceneFeatures, and the names that `pt_features` takes.
#ifndef VIGIL_SHARED_FEATURES_H
#define VIGIL_SHARED_FEATURES_H

#include "shared/bindings.h"

// Columns: name, specialisation constant.
// clang-format off
#define VIGIL_FEATURE_TABLE(ROW) \
    ROW(instances,   CONSTANT_INSTANCES)   /* models are placed */ \
    ROW(translucent, CONSTANT_TRANSLUCENT) /* some faces or models are */ \
    ROW(sky,         CONSTANT_SKY) \
    ROW(gloss,       CONSTANT_GLOSS) \
    ROW(lights,      CONSTANT_LIGHTS) \
    ROW(effects,     CONSTANT_EFFECTS)     /* some model fades, glows, is a sprite or hidden from some rays */ \
    ROW(environment, CONSTANT_ENVIRONMENT) /* sky and sun are sampled as lights */ \
    ROW(caches,      CONSTANT_CACHES)      /* `vlc`: much light is out of sight */
// clang-format on

#ifdef __cplusplus

#include <array>
#include <string_view>

namespace vigil {

#define VIGIL_FEATURE_CHOICE(name, constant) "|" #name
/// The choices of `pt_features`: then a feature's index is that of its choice less two.
inline constexpr char feature_choices[] = "auto|all" VIGIL_FEATURE_TABLE(VIGIL_FEATURE_CHOICE);
#undef VIGIL_FEATURE_CHOICE

namespace vkpt {

/// What a level uses.
struct SceneFeatures {
#define VIGIL_FEATURE_MEMBER(name, constant) bool name = false;
    VIGIL_FEATURE_TABLE(VIGIL_FEATURE_MEMBER)
#undef VIGIL_FEATURE_MEMBER
    bool operator==(const SceneFeatures&) const = default;
};

/// A feature by its name in `pt_features`.
struct SceneFeatureRow {
    std::string_view name;
    bool SceneFeatures::*member;
    unsigned constant; ///< its specialisation constant
};

inline constexpr auto scene_feature_rows = std::to_array<SceneFeatureRow>({
#define VIGIL_FEATURE_ROW(name, constant) {#name, &SceneFeatures::name, constant},
    VIGIL_FEATURE_TABLE(VIGIL_FEATURE_ROW)
#undef VIGIL_FEATURE_ROW
});

/// Whether a value of `pt_features` asks for this one.
constexpr bool forces_feature(int choice, bool SceneFeatures::*member) {
    return choice == 1 || (choice > 1 && scene_feature_rows.at(choice - 2).member == member);
}

} // namespace vkpt
} // namespace vigil

#endif

#endif
