// SPDX-License-Identifier: GPL-2.0-or-later
// The Vulkan path tracer behind refresh::Renderer: one frame's data flow from scene update to
// presentation.
#pragma once

#include "refresh/refresh.h"
#include "refresh/vkpt/debug/legend.h"
#include "refresh/vkpt/gpu/swapchain.h"
#include "refresh/vkpt/guiding/guiding.h"
#include "refresh/vkpt/light/light_lists.h"
#include "refresh/vkpt/overlay.h"
#include "refresh/vkpt/pathtracer.h"

#include <array>
#include <deque>
#include <optional>

namespace vigil::vkpt {

class VkptRenderer : public refresh::Renderer {
public:
    VkptRenderer(FileSystem& files, refresh::SurfaceProvider* surface);
    ~VkptRenderer() override;

    void load_level(std::shared_ptr<const Level> level) override;
    refresh::ModelHandle register_model(std::string_view name) override;
    uint64_t render(const refresh::Frame& frame) override;
    refresh::Picture read_picture(bool with_overlay) override;
    refresh::RadiancePicture read_radiance() override;
    std::vector<refresh::FrameTimes> take_frame_times(bool wait) override;
    refresh::Health health() const override;
    std::string describe_scene() const override;
    std::string describe_device() const override;
    std::string describe_guiding() const override;
    std::string describe_leaf() const override;
    std::string describe_directions() const override;
    void reset_guiding() override;
    void export_scene(const refresh::Frame& frame, const std::string& path) override;

    // For tests and benchmarks.
    const gpu::Device& device() const { return device_; }
    PathTracer& path_tracer() { return path_tracer_; }
    Scene* scene() { return scene_.get(); }
    LightTechnique* technique() { return technique_.get(); }
    Guiding& guiding() { return guiding_; }
    /// Size of the quadtrees that guide indirect rays; 0: none do.
    uint32_t cdq_bits() const;
    /// Whether the octree is kept: for the technique, or for the quadtrees.
    bool guided() const;
    const Legend& legend() const { return legend_; }
    /// Frames in the running mean of pt_view's map of directions.
    uint32_t view_accumulated() const { return view_accumulated_; }
    /// Radiance values so far that were not finite.
    uint32_t nonfinite_count() const;

private:
    static constexpr size_t frames_in_flight = 2;

    glm::uvec2 picture_size() const;
    void resize(glm::uvec2 size);
    void select_technique(Technique technique);
    void update_guiding(gpu::FrameCommands& commands, size_t slot);
    bool use_ray_query() const;
    void follow_trace_setting();
    void follow_guide_setting();
    bool prepare_ray_query();
    shader::FrameParams frame_params(const refresh::Frame& frame);
    void update_accumulation(const shader::FrameParams& params);
    void finish_slot(size_t slot);
    std::optional<shader::PrimaryHit> hit_under_crosshair() const;
    std::string guiding_off_text() const; // empty if it was on in the last frame
    std::string guiding_line() const;     // of `scene`
    void present(gpu::FrameCommands& commands, const refresh::Frame& frame);

    FileSystem& files_;
    refresh::SurfaceProvider* surface_;
    gpu::Device device_;
    gpu::PipelineCache pipeline_cache_;
    std::array<gpu::FrameCommands, frames_in_flight> frames_;
    Guiding guiding_;
    PathTracer path_tracer_;
    std::optional<gpu::Swapchain> swapchain_;
    std::optional<Overlay> overlay_;
    gpu::Image picture_;
    Legend legend_;

    std::shared_ptr<const Level> level_;
    std::unique_ptr<LightLister> lister_;
    std::unique_ptr<Scene> scene_;
    std::unique_ptr<LightTechnique> technique_;
    Technique technique_id_ = Technique::sll;
    bool rebind_ = true;
    int trace_setting_ = -1;        // pt_trace as it was followed last
    int guide_setting_ = -1;        // pt_guide, the same
    bool ray_query_failed_ = false; // with this level and setting

    uint64_t frame_number_ = 0;
    uint64_t first_frame_ = 0;                // of the level: random numbers count from it
    uint32_t accumulated_ = 0;                // frames in the running mean after the last render
    uint32_t view_accumulated_ = 0;           // the same of the view's
    std::vector<std::byte> accumulation_key_; // what both depend on
    /// What the last frame showed, for texts about it.
    struct Shown {
        bool guided = false;
        uint32_t bucket_size = 0;
        uint32_t cdq_bits = 0;     // 0: no quadtrees
        size_t dynamic_lights = 0; // the last instances of the scene
    };
    Shown shown_;
    /// Which frame a slot of frames_ rendered last, and whether guiding passes ran in it.
    struct SlotFrame {
        uint64_t number = 0;
        bool guided = false;
    };
    std::array<SlotFrame, frames_in_flight> slot_frames_{};
    shader::GuidingWork guiding_work_{}; // of the last frame that was finished with guiding
    std::deque<refresh::FrameTimes> finished_times_;
};

} // namespace vigil::vkpt
