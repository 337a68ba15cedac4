// SPDX-License-Identifier: GPL-2.0-or-later
// The light lists of all PVS clusters on the GPU, as shaders/light/light_list.glsl reads them.
// Lists of the static world's lights are made once, unless the sun moves; lists of lights that move
// are made anew whenever one of them appears, vanishes or moves.
#pragma once

#include "refresh/vkpt/gpu/growing_buffer.h"
#include "refresh/vkpt/light/light_lists.h"
#include "refresh/vkpt/light/technique.h"

namespace vigil::vkpt {

class ClusterLists {
public:
    explicit ClusterLists(const TechniqueContext& context)
        : lister_(context.lister), limits_(limits_of(context.device)),
          static_(context.device, "static light"), moving_(context.device, "moving light"),
          counts_(context.device, "light list counts") {}

    /// Brings the lists to this frame's lights. Returns true if a buffer was made anew.
    bool prepare(const LightSet& lights);
    void upload(gpu::FrameCommands& commands);
    /// Puts the buffers at the bindings of light_list.glsl.
    void bind(LightTechnique::Bindings& bindings) const;
    /// Of the static world's lights.
    const LightLists& static_lists() const { return static_lists_; }
    /// Of the level.
    const Bsp& bsp() const { return lister_.bsp(); }
    /// Triangles of lights that can move, and shine.
    size_t moving_count() const { return moving_count_; }
    /// Lengths of all lists, added up.
    uint64_t pair_count() const { return static_lists_.pair_count + moving_pairs_; }

private:
    struct ListBuffers {
        ListBuffers(const gpu::Device& device, const char* name)
            : ranges(device, name), ids(device, name) {}
        bool set(const LightLists& lists) {
            const bool new_ranges = ranges.set(gpu::bytes_of(lists.ranges));
            return ids.set(gpu::bytes_of(lists.ids)) || new_ranges;
        }
        gpu::GrowingBuffer ranges, ids;
    };

    /// What fits into the device's buffers, which grow by half.
    static LightListLimits limits_of(const gpu::Device& device);
    LightLists build(std::span<const LightTriangle> lights, const char* which, bool& warned) const;

    const LightLister& lister_;
    LightListLimits limits_;
    ListBuffers static_, moving_;
    gpu::GrowingBuffer counts_;
    uint64_t revision_ = 0, sun_revision_ = 0;
    LightLists static_lists_;
    uint64_t moving_pairs_ = 0;
    size_t moving_count_ = 0;
    bool static_warned_ = false, moving_warned_ = false; // that lists were refused
};

} // namespace vigil::vkpt
