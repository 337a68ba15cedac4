// SPDX-License-Identifier: GPL-2.0-or-later
// The one list of GPU passes, in frame order. Their names are those of their shaders, label
// debugger captures, and are rows of timing tables; those of a group are also summed. Each states
// what it waits for.
#pragma once

#include "refresh/refresh.h"
#include "refresh/vkpt/gpu/commands.h"

#include <array>
#include <string_view>

namespace vigil::vkpt {

/// What a pass reads, or overwrites, that was done before it in the same frame.
enum class Waits {
    None,    ///< nothing, or it says so itself
    Shaders, ///< what passes before it wrote
    Copies,  ///< that, and what was copied
};

// ROW(enumerator, name, group in reports, what it waits for)
// clang-format off
#define VIGIL_PASS_TABLE(ROW) \
    ROW(Upload, "upload", Other, None) /* copies of what changed since the last frame */ \
    ROW(ShadowStatistics, "shadow_statistics", Preparation, Copies) /* how often lights were hidden, for sll */ \
    ROW(OctreeMark, "octree_mark", Preparation, Copies) /* leaves to split and nodes to collapse */ \
    ROW(VlcDeduplicate, "vlc_deduplicate", Preparation, Shaders) /* different visible lights of each leaf */ \
    ROW(VlcMerge, "vlc_merge", Preparation, Shaders) /* lights of neighbours joined, buckets made */ \
    ROW(GuideAdapt, "guide_adapt", Preparation, Shaders) /* guiders learn from what rays brought */ \
    ROW(OctreeAdapt, "octree_adapt", Preparation, Shaders) /* the new tree's nodes in their places */ \
    ROW(OctreeAugment, "octree_augment", Preparation, Shaders) /* its leaves: neighbours, and room for samples */ \
    ROW(Primary, "primary", PathTracing, Copies) /* camera rays */ \
    ROW(Direct, "direct", PathTracing, Shaders) /* next event estimation at the primary hit */ \
    ROW(Indirect, "indirect", PathTracing, Shaders) /* BRDF rays and next event estimation where they land */ \
    ROW(DirectionMap, "direction_map", Other, Shaders) /* radiance that arrives at the crosshair, for pt_view cdq */ \
    ROW(FilterTiles, "filter_tiles", Filter, Copies) /* how bright light is around, and where lamps have changed */ \
    ROW(FilterTemporal, "filter_temporal", Filter, Shaders) /* light of this frame and of those before */ \
    ROW(FilterAtrous, "filter_atrous", Filter, Shaders) /* light of neighbouring pixels, several times */ \
    ROW(FilterCompose, "filter_compose", Filter, Shaders) /* light on the surfaces' colours */ \
    ROW(FilterTaa, "filter_taa", Filter, Shaders) /* anti-aliasing over frames */ \
    ROW(Accumulate, "accumulate", Other, Shaders) /* running mean and tile luminances */ \
    ROW(Exposure, "exposure", Other, Shaders) /* automatic exposure */ \
    ROW(Tonemap, "tonemap", Other, Shaders) /* radiance to 8-bit sRGB, or a debug view */ \
    ROW(Upscale, "upscale", Other, Shaders) /* more pixels than were traced */ \
    ROW(Draws, "draws", Other, Copies) /* pictures and fills over it */ \
    ROW(Overlay, "overlay", Other, None) /* console and menus */ \
    ROW(Present, "present", Other, None) /* copy to the window */
// clang-format on

enum class Pass : uint32_t {
#define VIGIL_PASS_ENUMERATOR(name, label, group, waits) name,
    VIGIL_PASS_TABLE(VIGIL_PASS_ENUMERATOR)
#undef VIGIL_PASS_ENUMERATOR
};

inline constexpr std::string_view pass_names[] = {
#define VIGIL_PASS_NAME(name, label, group, waits) label,
    VIGIL_PASS_TABLE(VIGIL_PASS_NAME)
#undef VIGIL_PASS_NAME
};

inline constexpr refresh::PassGroup pass_groups[] = {
#define VIGIL_PASS_GROUP(name, label, group, waits) refresh::PassGroup::group,
    VIGIL_PASS_TABLE(VIGIL_PASS_GROUP)
#undef VIGIL_PASS_GROUP
};

inline constexpr Waits pass_waits[] = {
#define VIGIL_PASS_WAITS(name, label, group, waits) Waits::waits,
    VIGIL_PASS_TABLE(VIGIL_PASS_WAITS)
#undef VIGIL_PASS_WAITS
};

/// Lets what is recorded while it lives wait as the pass states, labels it and times it.
class PassScope {
public:
    PassScope(gpu::FrameCommands& frame, Pass pass) : frame_(frame) {
        const auto row = static_cast<size_t>(pass);
        const gpu::Access written = pass_waits[row] == Waits::Copies
                                        ? gpu::access_of_shaders | gpu::access_of_copies
                                        : gpu::access_of_shaders;
        if (pass_waits[row] != Waits::None)
            gpu::barrier(frame_.commands(), written,
                         gpu::access_of_shaders | gpu::access_of_copies |
                             gpu::access_of_indirect_dispatches);
        frame_.device().begin_label(frame_.commands(), pass_names[row].data());
        frame_.timer().start(frame_.commands(), static_cast<uint32_t>(pass));
    }
    ~PassScope() {
        frame_.timer().stop(frame_.commands());
        frame_.device().end_label(frame_.commands());
    }
    PassScope(const PassScope&) = delete;
    PassScope& operator=(const PassScope&) = delete;

private:
    gpu::FrameCommands& frame_;
};

} // namespace vigil::vkpt
