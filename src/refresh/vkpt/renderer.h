// SPDX-License-Identifier: GPL-2.0-or-later
// The Vulkan path tracer behind refresh::Renderer: one frame's data flow from scene update to
// presentation.
#pragma once

#include "refresh/refresh.h"
#include "refresh/vkpt/debug/direction_map.h"
#include "refresh/vkpt/debug/legend.h"
#include "refresh/vkpt/debug/side_labels.h"
#include "refresh/vkpt/filter/filter.h"
#include "refresh/vkpt/gpu/swapchain.h"
#include "refresh/vkpt/light/light_lists.h"
#include "refresh/vkpt/pathtrace/pathtracer.h"
#include "refresh/vkpt/post/draws.h"
#include "refresh/vkpt/post/overlay.h"
#include "refresh/vkpt/post/post.h"
#include "refresh/vkpt/post/resolution.h"
#include "refresh/vkpt/side.h"

#include <array>
#include <deque>
#include <functional>
#include <optional>

namespace vigil::vkpt {

class VkptRenderer : public refresh::Renderer {
public:
    VkptRenderer(FileSystem& files, refresh::SurfaceProvider* surface,
                 const refresh::Settings& settings);
    ~VkptRenderer() override;

    void watch_compilation(refresh::CompilationWatcher* watcher) override { watcher_ = watcher; }
    bool compiling() const override { return !compiler_.idle(); }
    void load_level(std::shared_ptr<const Level> level, const refresh::Settings& settings) override;
    refresh::ModelHandle register_model(std::string_view name) override;
    refresh::SkinHandle register_skin(std::string_view name) override;
    void set_sky(std::string_view name, float degrees_per_second, glm::vec3 axis) override;
    refresh::PictureHandle register_picture(std::string_view name) override {
        return draws_.register_picture(files_, name);
    }
    refresh::PictureHandle make_picture(glm::ivec2 size) override {
        return draws_.make_picture(size);
    }
    void change_picture(refresh::PictureHandle picture, std::span<const uint8_t> rgba) override {
        draws_.change_picture(picture, rgba);
    }
    glm::ivec2 picture_size(refresh::PictureHandle picture) const override {
        return draws_.size_of(picture);
    }
    uint64_t render(const refresh::Frame& frame) override;
    refresh::Picture read_picture(bool with_overlay) override;
    refresh::RadiancePicture read_radiance() override;
    std::vector<refresh::FrameTimes> take_frame_times(bool wait) override;
    refresh::Health health() const override;
    std::string device_name() const override { return device_.description(); }
    refresh::SceneReport report_scene(const refresh::Settings& settings) const override;
    refresh::GuidingReport report_guiding() const override;
    void reset_guiding() override;
    void export_scene(const refresh::Frame& frame, const std::string& path) override;

    // For tests and benchmarks.
    const gpu::Device& device() const { return device_; }
    FrameBuffers& buffers() { return buffers_; }
    /// Records all from camera rays to the finished picture; bound and sized as the last frame was.
    void record_picture(gpu::FrameCommands& commands, std::span<const PictureSide> sides,
                        const FrameDescription& params, uint32_t paths);
    Scene* scene() { return scene_.get(); }
    /// Those that shaders of the last frame were compiled for.
    SceneFeatures compiled_features() const { return compiled_features(left_); }
    // Of the picture, or, while pt_compare splits it, of its left side.
    LightTechnique* technique() { return left_.technique(); }
    Guiding& guiding() { return left_.guiding(); }
    /// Pipelines that can be used since the last call; with a watcher, after their first dispatch.
    std::vector<gpu::CompiledPipeline> take_compiled() { return compiler_.take_compiled(); }
    /// What pt_guide asks for, as far as the device can.
    GuideChoice guide() const;
    /// Whether the octree is kept: for the technique, or for the guider.
    bool guided() const { return left_.technique()->uses_guiding() || guide().guides(); }
    const Legend& legend() const { return legends_[0]; }
    /// The right side while pt_compare splits the picture, else null.
    const SideLabels& side_labels() const { return side_labels_; }
    /// Where the right side begins; the picture's width while there is none.
    uint32_t split_column() const;
    /// Frames in the running mean of pt_view's map of directions.
    uint32_t view_accumulated() const { return view_accumulated_; }
    /// Radiance values so far that were not finite.
    uint32_t nonfinite_count() const;

private:
    SceneFeatures compiled_features(const Side& side) const;
    static constexpr size_t frames_in_flight = 2;

    glm::uvec2 screen_size() const;
    /// Follows the screen's size and what is traced of it.
    void resize(glm::uvec2 size);
    void make_buffers(glm::uvec2 size);
    /// Whether the right side is the left's, unfiltered.
    bool compares_raw() const;
    void select_sides();
    void reset_side(Side& side);
    void prepare_sides(const refresh::Frame& frame);
    void for_each_side(const std::function<void(Side&)>& what);
    void prepare_pipelines();
    void update_sides(gpu::FrameCommands& commands, size_t slot, const FrameDescription& camera);
    std::vector<PictureSide> picture_sides() const;
    void record_texts(gpu::FrameCommands& commands, std::span<const PictureSide> sides);
    void record_black(gpu::FrameCommands& commands);
    void remember_shown(const refresh::Frame& frame, std::span<const PictureSide> sides);
    bool use_ray_query(const refresh::Settings& settings) const;
    void follow_trace_setting();
    void follow_environment_setting();
    bool prepare_ray_query();
    FrameDescription frame_params(const refresh::Frame& frame);
    void update_accumulation(const FrameDescription& params);
    /// A frame, and whether it is presented.
    uint64_t draw(const refresh::Frame& frame, bool shown);
    void finish_slot(size_t slot);
    /// The side that reports are about.
    const Side& shown_side() const { return shown_.right && right_ ? *right_ : left_; }
    std::optional<shader::PrimaryHit> hit_under_crosshair() const;
    ImDrawData* await_pipelines(ImDrawData* overlay);
    void show_wait(ImDrawData* overlay);
    void present(gpu::FrameCommands& commands, ImDrawData* overlay, bool vsync);

    FileSystem& files_;
    refresh::SurfaceProvider* surface_;
    refresh::Settings settings_; // of the last frame
    gpu::Device device_;
    gpu::PipelineCompiler compiler_;
    std::array<gpu::FrameCommands, frames_in_flight> frames_;
    gpu::FrameCommands waiting_frame_; // what is shown while pipelines are made
    Side left_;                        // the only one while there is no right one
    std::optional<Side> right_;
    FrameBuffers buffers_;
    PathTracer path_tracer_;
    DirectionMap direction_map_;
    Filter filter_;
    Post post_;
    Resolution resolution_;
    Draws draws_;
    std::optional<gpu::Swapchain> swapchain_;
    std::optional<Overlay> overlay_;
    gpu::Image picture_;
    std::array<Legend, most_sides> legends_;
    SideLabels side_labels_;

    std::shared_ptr<const Level> level_;
    std::unique_ptr<LightLister> lister_;
    std::unique_ptr<Scene> scene_;
    refresh::CompilationWatcher* watcher_ = nullptr;
    bool traced_ = false; // there is a picture of this level and size, or what was drawn over black
    bool shown_a_frame_ = false; // of this level
    bool rebind_ = true;
    int trace_setting_ = -1;        // pt_trace as it was followed last
    bool ray_query_failed_ = false; // with this level and setting
    bool frame_unfinished_ = false; // recorded, and not submitted

    uint64_t frame_number_ = 0;
    uint64_t first_frame_ = 0;                // of the level: random numbers count from it
    uint32_t accumulated_ = 0;                // frames in the running mean after the last render
    uint32_t view_accumulated_ = 0;           // the same of the view's
    std::vector<std::byte> accumulation_key_; // what both depend on, with
    refresh::Settings accumulation_settings_;
    float accumulation_time_ = 0.0f;    // of moving textures; 0 where there are none
    Change change_ = Change::Something; // but for time
    uint64_t light_places_ = 0, new_lights_ = 0;
    /// What the last frame showed, for reports.
    struct Shown {
        bool right = false; // the crosshair looked at the right side
        bool guided = false;
        uint32_t bucket_size = 0;
        GuideChoice guide;
        size_t dynamic_lights = 0; // the last instances of the scene
    };
    Shown shown_;
    /// Which frame a slot of frames_ rendered last, whether the octree of the side under the
    /// crosshair was kept in it, and which side that was.
    struct SlotFrame {
        uint64_t number = 0;
        bool guided = false;
        bool right = false;
        float scale = 1.0f; // of its resolution
        gpu::ByteCounts uploads;
    };
    std::array<SlotFrame, frames_in_flight> slot_frames_{};
    shader::GuidingWork guiding_work_{}; // of the last frame that was finished with guiding
    std::deque<refresh::FrameTimes> finished_times_;
};

} // namespace vigil::vkpt
