// SPDX-License-Identifier: GPL-2.0-or-later
// The one list of GPU passes, in frame order: their names label debugger captures and rows of
// timing tables.
#pragma once

#include "refresh/vkpt/gpu/commands.h"

#include <array>
#include <string_view>

namespace vigil::vkpt {

// clang-format off
#define VIGIL_PASS_TABLE(ROW) \
    ROW(Upload,     "upload")     /* copies of what changed since the last frame */ \
    ROW(OctreeMark, "octree_mark") /* leaves to split and nodes to collapse */ \
    ROW(VlcDeduplicate, "vlc_deduplicate") /* different visible lights of each leaf */ \
    ROW(VlcMerge,   "vlc_merge")  /* lights of neighbours joined, buckets made */ \
    ROW(CdqAdapt,   "cdq_adapt")  /* what rays brought is added up, quadtrees follow it */ \
    ROW(OctreeAdapt, "octree_adapt") /* the new tree's nodes in their places */ \
    ROW(OctreeAugment, "octree_augment") /* its leaves: neighbours, and room for samples */ \
    ROW(ShadowStatistics, "shadow_statistics") /* how often lights were hidden, for sll */ \
    ROW(Primary,    "primary")    /* camera rays */ \
    ROW(Direct,     "direct")     /* next event estimation at the primary hit */ \
    ROW(Indirect,   "indirect")   /* BRDF rays and next event estimation where they land */ \
    ROW(Directions, "directions") /* radiance that arrives at the crosshair, for pt_view cdq */ \
    ROW(Accumulate, "accumulate") /* running mean and tile luminances */ \
    ROW(Exposure,   "exposure")   /* automatic exposure */ \
    ROW(Tonemap,    "tonemap")    /* radiance to 8-bit sRGB, or a debug view */ \
    ROW(Overlay,    "overlay")    /* console and menus */ \
    ROW(Present,    "present")    /* copy to the window */
// clang-format on

enum class Pass : uint32_t {
#define VIGIL_PASS_ENUMERATOR(name, label) name,
    VIGIL_PASS_TABLE(VIGIL_PASS_ENUMERATOR)
#undef VIGIL_PASS_ENUMERATOR
};

inline constexpr std::string_view pass_names[] = {
#define VIGIL_PASS_NAME(name, label) label,
    VIGIL_PASS_TABLE(VIGIL_PASS_NAME)
#undef VIGIL_PASS_NAME
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
