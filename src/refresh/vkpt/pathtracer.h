// SPDX-License-Identifier: GPL-2.0-or-later
// The passes from camera rays to the finished 8-bit picture: descriptor sets, pipelines per
// technique and scene features, and the buffers whose size follows the resolution.
#pragma once

#include "refresh/vkpt/gpu/passes.h"
#include "refresh/vkpt/gpu/pipeline_compiler.h"
#include "refresh/vkpt/guiding/guider.h"
#include "refresh/vkpt/light/technique.h"
#include "refresh/vkpt/scene/scene.h"
#include "shared/frame_params.h"

#include <array>
#include <map>
#include <span>

namespace vigil::vkpt {

/// What a set of path-tracing pipelines was compiled for.
struct PathTracerVariant {
    Technique technique = Technique::sll;
    SceneFeatures features;
    bool ray_query = false;
    GuideChoice guide{}; // of indirect rays
    bool operator==(const PathTracerVariant&) const = default;
};

/// A part of the picture's columns, and how it is traced. While techniques are compared there are
/// two.
struct PictureSide {
    PathTracerVariant variant;
    bool samples_lights = false;       ///< the technique's promise
    bool guided = false;               ///< set 2 is this frame's: views may look into it
    VkDescriptorSet guiding = nullptr; ///< set 2
    uint32_t first_column = 0;
    uint32_t end_column = 0; ///< the one after its last; a side may have none
};

/// Index of the side that the crosshair looks at.
size_t crosshair_side(std::span<const PictureSide> sides, glm::uvec2 picture_size);

/// The features, and what guides rays, as constants of shaders: the ids of trace/trace.glsl and
/// scene/frame.glsl.
std::vector<gpu::Specialization> specialization(const SceneFeatures& features,
                                                const GuideChoice& guide);

class PathTracer {
public:
    /// `guiding` is a set like set 2.
    PathTracer(const gpu::Device& device, gpu::PipelineCompiler& compiler,
               const gpu::DescriptorSet& guiding);

    /// Makes the per-pixel buffers. The GPU must be idle. Throws Error if the device's buffers are
    /// too small.
    void resize(glm::uvec2 size);
    /// Points the sets at the scene's and the technique's buffers; `right` is that of the second
    /// side, null if there is none. The GPU must be idle.
    void bind(const Scene& scene, const LightTechnique& technique,
              const LightTechnique* right = nullptr);

    /// Sides of a picture, at most.
    static constexpr size_t most_sides = 2;

    /// Has the pipelines made that record() will need for these sides; after bind(). `view` is
    /// pt_view.
    void prepare(std::span<const PictureSide> sides, int view);

    /// Records the frame's passes from `primary` to `tonemap`, `paths` paths per pixel. Camera
    /// rays, means and exposure are the whole picture's; the features of all sides are the same.
    void record(gpu::FrameCommands& commands, std::span<const PictureSide> sides,
                const shader::FrameParams& params, uint32_t paths);

    glm::uvec2 size() const { return size_; }
    const gpu::Buffer& display() const { return display_; }
    const gpu::Buffer& mean_radiance() const { return accumulation_; }
    const gpu::Buffer& counters() const { return counters_; }
    const gpu::Buffer& primary_hits() const { return surfaces_; }
    /// Light that arrives at the crosshair, for pt_view cdq: shaders/debug/direction_map.glsl.
    const gpu::Buffer& direction_map() const { return direction_map_; }
    VkPipelineLayout layout() const { return layout_.get(); }
    /// Layouts of sets 0, 1 and 2.
    std::array<VkDescriptorSetLayout, 3> set_layouts() const {
        return {scene_set_.layout(), technique_sets_[0].layout(), guiding_layout_};
    }
    VkDescriptorSet scene_set() const { return scene_set_.handle(); }
    /// Of the first side.
    VkDescriptorSet technique_set() const { return technique_sets_[0].handle(); }

private:
    struct Pipelines {
        PathTracerVariant variant;
        gpu::ComputePipeline primary, indirect;
        // Made when a frame asks for them: samples of lights, no view, any view, pt_view cdq.
        gpu::ComputePipeline direct, tonemap, tonemap_view, direction_map;
    };
    gpu::ComputePipeline make_pipeline(const PathTracerVariant& variant, const std::string& name,
                                       bool views = false);
    Pipelines& pipelines(const PictureSide& side, int view);
    void select_side(VkCommandBuffer commands, std::span<const PictureSide> sides, size_t side,
                     uint32_t path, uint32_t paths);
    void record_direction_map(gpu::FrameCommands& commands, std::span<const PictureSide> sides,
                              int view, uint32_t paths);

    const gpu::Device& device_;
    gpu::PipelineCompiler& compiler_;
    VkDescriptorSetLayout guiding_layout_;
    std::vector<std::vector<VkDescriptorType>> set_types_; // of sets 0, 1 and 2
    glm::uvec2 size_{0, 0};
    gpu::Buffer unused_, frame_, surfaces_, radiance_, accumulation_, exposure_, counters_,
        display_, ltc_, direction_map_;
    gpu::DescriptorSet scene_set_;
    std::array<gpu::DescriptorSet, most_sides> technique_sets_;
    gpu::Handle<VkPipelineLayout> layout_;
    gpu::ComputePipeline accumulate_, exposure_pipeline_;
    std::vector<std::unique_ptr<Pipelines>> variants_;
};

} // namespace vigil::vkpt
