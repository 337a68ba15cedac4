// SPDX-License-Identifier: GPL-2.0-or-later
// What all passes from camera rays to the finished picture share: the frame's parameters, the
// buffers whose size follows the resolution, the descriptor sets 0 and 1, and the layout of sets 0,
// 1 and 2 (shaders/shared/bindings.h).
#pragma once

#include "refresh/vkpt/pathtrace/frame_description.h"
#include "refresh/vkpt/pathtrace/picture_side.h"
#include "shared/indirect_turn.h"

#include <array>
#include <optional>

namespace vigil::vkpt {

class FrameBuffers {
public:
    /// `guiding` is a set like set 2.
    FrameBuffers(const gpu::Device& device, const gpu::DescriptorSet& guiding);

    /// Makes the per-pixel buffers: of the picture, and of what is traced of it at most. `scales`:
    /// the picture is scaled up from what is traced. The GPU must be idle. Throws Error if the
    /// device's buffers are too small.
    void resize(glm::uvec2 picture, glm::uvec2 most_traced, bool scales);
    /// How much the next frame traces: no more than there is room for.
    void trace(glm::uvec2 size) { size_ = size; }
    /// Makes or gives back what the path tracer writes for the filter. The GPU must be idle, and
    /// the sets are to be bound anew. Throws Error if the device's buffers are too small.
    void keep_filter_input(bool keep);
    /// Points the sets at the scene's and the techniques' buffers; `right` is that of the second
    /// side. The GPU must be idle.
    void bind(const Scene& scene, const LightTechnique& technique, const LightTechnique& right);
    /// Describes the next frame. Records the copy of its parameters, if they have changed.
    void describe(gpu::FrameCommands& commands, const FrameDescription& frame);
    /// A frame that was described never ran: what the buffers have is not known.
    void forget_copies();

    /// What a dispatch for one side reads: the sets, and whose path it traces (PassConstants).
    struct SideInputs {
        std::array<VkDescriptorSet, 3> sets;
        shader::PassConstants push;
        gpu::Inputs inputs() const { return {sets, gpu::bytes_of_value(push)}; }
    };
    SideInputs side(std::span<const PictureSide> sides, size_t side, uint32_t path,
                    uint32_t paths) const;
    /// Work groups of 8 x 8 pixels that cover the picture, or the columns of a side.
    gpu::WorkGroups groups() const { return {{tiles(), 1}}; }
    gpu::WorkGroups groups(const PictureSide& side) const {
        return {{(side.end_column + 7) / 8 - side.first_column / 8, tiles().y, 1}};
    }
    /// The same for the pixels of a side whose turn it is to trace indirect light.
    gpu::WorkGroups indirect_groups(const PictureSide& side) const {
        gpu::WorkGroups all = groups(side);
        if (side.indirect_turn != shader::INDIRECT_ALL) all.count.y = (all.count.y + 1) / 2;
        return all;
    }

    const gpu::PipelineLayout& layout() const { return layout_; }
    const gpu::DescriptorSet& scene_set() const { return scene_set_; }
    /// Of the first side.
    const gpu::DescriptorSet& technique_set() const { return technique_sets_[0]; }

    /// Pixels that are traced.
    glm::uvec2 size() const { return size_; }
    glm::uvec2 most_traced() const { return most_traced_; }
    glm::uvec2 picture_size() const { return picture_size_; }
    bool scales() const { return scales_; }
    /// The toned picture before it is scaled up; only where it is.
    const gpu::Buffer& toned() const { return toned_; }
    glm::uvec2 tiles() const { return (size_ + 7u) / 8u; }
    const gpu::Buffer& display() const { return display_; }
    const gpu::Buffer& mean_radiance() const { return accumulation_; }
    const gpu::Buffer& counters() const { return counters_; }
    const gpu::Buffer& filter_input() const { return filter_input_; }
    const gpu::Buffer& primary_hits() const { return surfaces_; }
    /// What became of the paths of each pixel: shader::PIXEL_*.
    const gpu::Buffer& pixel_flags() const { return pixel_flags_; }
    /// Light that arrives at the crosshair, for pt_view cdq: shaders/debug/direction_map.glsl.
    const gpu::Buffer& direction_map() const { return direction_map_; }

private:
    const gpu::Device& device_;
    glm::uvec2 size_{0, 0}, most_traced_{0, 0}, picture_size_{0, 0};
    bool scales_ = false;
    std::optional<shader::FrameParams> copied_; // what frame_ has
    shader::FrameTurn turn_{};
    gpu::Buffer unused_, frame_, surfaces_, pixel_flags_, radiance_, accumulation_, exposure_,
        counters_, display_, toned_, ltc_, direction_map_, filter_input_;
    gpu::DescriptorSet scene_set_;
    std::array<gpu::DescriptorSet, most_sides> technique_sets_;
    gpu::PipelineLayout layout_;
};

} // namespace vigil::vkpt
