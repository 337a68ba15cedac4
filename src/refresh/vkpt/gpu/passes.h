// SPDX-License-Identifier: GPL-2.0-or-later
// The one list of GPU passes, in frame order: their names label debugger captures and rows of
// timing tables, and those of a group are also summed.
#pragma once

#include "refresh/refresh.h"
#include "refresh/vkpt/gpu/commands.h"

#include <array>
#include <string_view>

namespace vigil::vkpt {

// clang-format off
#define VIGIL_PASS_TABLE(ROW) \
    ROW(Upload, "upload", Other) /* copies of what changed since the last frame */ \
    ROW(OctreeMark, "octree_mark", Preparation) /* leaves to split and nodes to collapse */ \
    ROW(VlcDeduplicate, "vlc_deduplicate", Preparation) /* different visible lights of each leaf */ \
    ROW(VlcMerge, "vlc_merge", Preparation) /* lights of neighbours joined, buckets made */ \
    ROW(GuideAdapt, "guide_adapt", Preparation) /* guiders learn from what rays brought */ \
    ROW(OctreeAdapt, "octree_adapt", Preparation) /* the new tree's nodes in their places */ \
    ROW(OctreeAugment, "octree_augment", Preparation) /* its leaves: neighbours, and room for samples */ \
    ROW(ShadowStatistics, "shadow_statistics", Preparation) /* how often lights were hidden, for sll */ \
    ROW(Primary, "primary", PathTracing) /* camera rays */ \
    ROW(Direct, "direct", PathTracing) /* next event estimation at the primary hit */ \
    ROW(Indirect, "indirect", PathTracing) /* BRDF rays and next event estimation where they land */ \
    ROW(Directions, "directions", Other) /* radiance that arrives at the crosshair, for pt_view cdq */ \
    ROW(Accumulate, "accumulate", Other) /* running mean and tile luminances */ \
    ROW(Exposure, "exposure", Other) /* automatic exposure */ \
    ROW(Tonemap, "tonemap", Other) /* radiance to 8-bit sRGB, or a debug view */ \
    ROW(Draws, "draws", Other) /* pictures and fills over it */ \
    ROW(Overlay, "overlay", Other) /* console and menus */ \
    ROW(Present, "present", Other) /* copy to the window */
// clang-format on

enum class Pass : uint32_t {
#define VIGIL_PASS_ENUMERATOR(name, label, group) name,
    VIGIL_PASS_TABLE(VIGIL_PASS_ENUMERATOR)
#undef VIGIL_PASS_ENUMERATOR
};

inline constexpr std::string_view pass_names[] = {
#define VIGIL_PASS_NAME(name, label, group) label,
    VIGIL_PASS_TABLE(VIGIL_PASS_NAME)
#undef VIGIL_PASS_NAME
};

inline constexpr refresh::PassGroup pass_groups[] = {
#define VIGIL_PASS_GROUP(name, label, group) refresh::PassGroup::group,
    VIGIL_PASS_TABLE(VIGIL_PASS_GROUP)
#undef VIGIL_PASS_GROUP
};

/// Labels and times everything recorded while it lives, and ends with a barrier, so that the next
/// pass sees this one's writes.
class PassScope {
public:
    PassScope(const gpu::Device& device, gpu::FrameCommands& frame, Pass pass)
        : device_(device), frame_(frame) {
        device_.begin_label(frame_.commands(), pass_names[static_cast<size_t>(pass)].data());
        frame_.timer().start(frame_.commands(), static_cast<uint32_t>(pass));
    }
    ~PassScope() {
        gpu::full_barrier(frame_.commands());
        frame_.timer().stop(frame_.commands());
        device_.end_label(frame_.commands());
    }
    PassScope(const PassScope&) = delete;
    PassScope& operator=(const PassScope&) = delete;

private:
    const gpu::Device& device_;
    gpu::FrameCommands& frame_;
};

} // namespace vigil::vkpt
