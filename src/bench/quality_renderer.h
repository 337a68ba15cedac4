// SPDX-License-Identifier: GPL-2.0-or-later
// The pictures of experiments: one level in the renderer, rows as settings, runs of
// frames that start with empty caches, and batches of references. It computes no statistics.
#pragma once

#include "bench/light_floor.h"
#include "bench/options.h"
#include "bench/quality_places.h"
#include "bench/reference.h"
#include "client/play/session.h"
#include "refresh/vkpt/frame_params.h"
#include "refresh/vkpt/renderer.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vigil::bench {

/// Paths per pixel of one batch of a reference.
inline constexpr int reference_batch_paths = 8;

/// What was seen of one run's measured frames.
struct Measurement {
    std::vector<std::vector<float>> pictures; // linear radiance, RGB, rows from the top
    // Median milliseconds by pass (the order of refresh/vkpt/gpu/passes.h) over the second half of
    // the warm-up and the measured frames; 0 where the pass did not run.
    std::vector<double> pass_ms;
    // Median milliseconds from one frame to the next over the second half of the warm-up: what the
    // host does for a frame counts where the device waits for it. NaN without a warm-up.
    double frame_ms = 0.0;
    // Of the last frame: shares of the primary hits that have something to light, NaN where no
    // light is sampled: whose light sample contributed nothing, and whose sample looked for new
    // lights.
    double unlit = 0.0;
    double explored = 0.0;
};

/// What one frame of a flight cost, milliseconds.
struct FrameCost {
    std::vector<double>
        pass_ms; // in the order of refresh/vkpt/gpu/passes.h; 0 for those that did not run
    double frame_ms = 0.0;          // by the clock of the host
    std::uint64_t upload_bytes = 0; // copied by the host for it
};

/// What the first frames of a row have made.
struct Preparation {
    vkpt::SceneFeatures features;                 // that its shaders are compiled for
    std::vector<gpu::CompiledPipeline> pipelines; // that no row before it has
};

/// What stands still costs.
struct StillCost {
    gpu::ByteCounts uploads; // of the last frame, by buffer
    gpu::ByteCounts memory;  // of the device, by buffer
};

/// How a scene differs from the level at rest.
struct SceneChange {
    std::optional<refresh::DynamicLight> lamp;
    int hidden = -1;         // number of an entity that is not there
    float brightness = 1.0f; // factor on all light styles

    /// For keys of references; empty: nothing differs.
    std::string text() const;
};

/// A door of the level.
struct Door {
    int number = 0;                  // of its entity
    glm::vec3 low{0.0f}, high{0.0f}; // its bounds
};

class QualityRenderer {
public:
    /// Loads a level from the first of the folders that has it. The variables now set are the base
    /// of all rows. Throws Error.
    QualityRenderer(const QualityOptions& options, const std::string& level);
    ~QualityRenderer();

    const std::vector<Place>& places() const { return places_; }
    /// Radiance values so far that were not finite and count as 0.
    std::uint32_t nonfinite_count() const { return renderer_->nonfinite_count(); }
    /// Of the level, as it is rendered. After a frame.
    std::size_t triangle_count() const { return renderer_->scene()->host_triangles().size(); }
    std::size_t light_count() const { return renderer_->scene()->lights().lights().size(); }

    /// Renders a few frames with every row, so that what is made at first use (pipelines, tables)
    /// is there before anything is measured.
    void prepare(const std::vector<QualityRow>& rows);
    /// What that did, by row.
    const std::vector<Preparation>& preparations() const { return preparations_; }
    /// Renders the warm-up and the measured frames from empty caches; frames after the first stand
    /// still.
    Measurement measure(const Place& place, const QualityRow& row, int seed, int frames);
    /// Renders all frames of the place from empty caches and waits for each.
    std::vector<FrameCost> fly(const Place& place, const QualityRow& row, int seed);
    /// Stands still at the end of the place for `frames` frames, with the caches as they are.
    StillCost stand(const Place& place, const QualityRow& row, int seed, int frames);
    /// The least error that any choice of lights can have at the place; changes pt_nee.
    LightFloor floor(const Place& place);
    /// Sets a row's variables and empties all caches, for stand_still().
    void begin_run(const QualityRow& row, int seed);
    /// The pictures of `frames` >= 1 more frames that stand still at the pose.
    std::vector<std::vector<float>> stand_still(const Pose& pose, int frames);
    /// Renders one frame and reads it.
    std::vector<float> show(const Pose& pose);
    /// What the camera rays of the last frame met, a pixel each.
    std::vector<shader::PrimaryHit> surfaces();
    /// The camera's part of a frame's parameters.
    shader::FrameParams camera(const Pose& pose) const;
    /// From the next frame on the scene is the level's with this change. References know it.
    void change(const SceneChange& change) { change_ = change; }
    std::vector<Door> doors() const;
    /// Whether a point is in the open.
    bool is_open(const glm::vec3& point) const;
    /// Turns brush models as the console's `turn` does; degrees. References know it.
    void turn(const std::string& target, float yaw);

    /// Who renders a reference, and how.
    struct ReferenceJob {
        const QualityRow& row;
        int warmup; // frames before the first batch
        bool fresh; // does not go on with the one in the cache
        /// How many batches, by a pilot; empty: `batches`, without a pilot.
        std::function<int(const Reference& pilot)> batches_wanted;
        int batches = 0;
        std::function<void(int batches)> noted; // called after every batch, with how many there are
    };
    /// Brings the reference of a pose, and its pilot, from the cache and completes them
    /// (complete_reference); what is new goes into the cache.
    void complete(Reference& reference, const Pose& pose, const ReferenceJob& job);

private:
    /// Goes to the pose for reference_batch(), and renders `frames` frames from empty caches.
    void begin_reference(const Pose& pose, const QualityRow& row, int frames);
    /// Mean picture of reference_batch_paths paths; the number chooses the seed, which no measured
    /// frame has.
    std::vector<float> reference_batch(const Pose& pose, int number);
    /// Everything that a reference depends on, as one line of text: level, view, size, variables
    /// and shaders.
    std::string reference_key(const Pose& pose, const QualityRow& row) const;
    std::uint64_t render(const Pose& pose);

    std::string level_name_;
    std::vector<Setting> base_; // values of the variables that rows change
    FileSystem files_;
    std::unique_ptr<refresh::CompilationWatcher> watcher_; // so that every first dispatch is timed
    std::unique_ptr<vkpt::VkptRenderer> renderer_;
    std::unique_ptr<client::Session> session_;
    std::vector<Place> places_;
    std::string turned_; // what turn() did, as text
    SceneChange change_;
    std::vector<refresh::Entity> entities_; // of the frame, where some are hidden
    std::vector<Preparation> preparations_;
    std::uint64_t content_hash_ = 0; // of the level's file and its materials
};

/// Sum over the passes of a group; `pass_ms` in the order of refresh/vkpt/gpu/passes.h.
double group_ms(std::span<const double> pass_ms, refresh::PassGroup group);

} // namespace vigil::bench
