// SPDX-License-Identifier: GPL-2.0-or-later
// The light lists of all PVS clusters on the GPU, as shaders/light/light_list.glsl reads them.
// Lists of the static world's lights are made once, unless the sun moves; lists of lights that move
// are made anew whenever one of them appears, vanishes or moves.
#pragma once

#include "refresh/vkpt/gpu/growing_buffer.h"
#include "refresh/vkpt/light/light_lists.h"
#include "refresh/vkpt/light/technique.h"

#include <optional>

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
    /// What there is to see of the lights of the static world.
    struct Sight {
        uint32_t longest = 0; ///< lights in the longest list of a cluster
        /// part_in_sight(), where no list is longer than the largest bucket, and none has sky or
        /// sun.
        std::optional<double> seen{};
    };
    const Sight& sight() const { return sight_; }
    /// Triangles of lights that can move, and shine.
    size_t moving_count() const { return moving_count_; }
    /// Lengths of all lists, added up.
    uint64_t pair_count() const { return static_pairs_ + moving_pairs_; }

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
    Sight sight_of(const LightLists& lists, const LightSet& lights) const;
    LightLists build(std::span<const LightTriangle> lights, const char* which, bool& warned) const;

    const LightLister& lister_;
    LightListLimits limits_;
    ListBuffers static_, moving_;
    gpu::GrowingBuffer counts_;
    uint64_t revision_ = 0, sun_revision_ = 0;
    uint64_t static_pairs_ = 0, moving_pairs_ = 0;
    Sight sight_;
    size_t moving_count_ = 0;
    bool static_warned_ = false, moving_warned_ = false; // that lists were refused
};

} // namespace vigil::vkpt
