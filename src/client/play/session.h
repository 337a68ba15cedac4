// SPDX-License-Identifier: GPL-2.0-or-later
// What is on the screen: the level, its entities, lights and time, and the camera in it. It fills
// the renderer's Frame and keeps the times of its passes. It knows no window, console or keys.
#pragma once

#include "client/measure/count_statistics.h"
#include "client/measure/pass_statistics.h"
#include "client/play/camera.h"
#include "client/play/level_entities.h"
#include "client/play/light_styles.h"
#include "client/play/played_scene.h"
#include "client/play/test_lights.h"
#include "common/file_system.h"
#include "console/cvar.h"
#include "level/level.h"
#include "refresh/refresh.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vigil::client {

class Session {
public:
    /// All three must outlive the session.
    Session(const FileSystem& files, refresh::Renderer& renderer, const CvarRegistry& variables);

    /// Loads a level and puts the camera at its start. Throws Error and then keeps the level
    /// before.
    void load_map(std::string_view name);
    /// Null before the first level.
    const Level* level() const { return level_.get(); }
    const std::shared_ptr<const Level>& shared_level() const { return level_; }
    const FileSystem& files() const { return files_; }
    refresh::Renderer& renderer() { return *renderer_; }
    /// Shows everything in another renderer from now on; that of before may be gone already. The
    /// level goes on as it is, a demo's picture does not.
    void use_renderer(refresh::Renderer& renderer);

    Camera& camera() { return camera_; }
    const LevelEntities& entities() const { return entities_; }
    /// Moves, shows or hides a brush model of the level (LevelEntities::place).
    void place_entity(int number, const glm::vec3& origin, const glm::vec3& angles, bool shown);
    /// Entities and light styles as the level has them.
    void restore_level();
    void turn_entities(std::string_view target, const glm::vec3& angles);
    const LightStyles& light_styles() const { return styles_; }
    void set_light_styles(LightStyles styles);
    /// Adds a dynamic light, or changes the one with the same id.
    void set_dynamic_light(const refresh::DynamicLight& light);
    void clear_dynamic_lights();
    /// Removes those whose ids are in [first, last].
    void remove_dynamic_lights(uint32_t first, uint32_t last);
    /// The flashlight in the hand of the camera.
    void set_flashlight(bool on);
    bool flashlight() const { return flashlight_; }
    /// Empties the renderer's octree and light caches.
    void reset_guiding();

    /// Shows a moment of a demo, at a time of the level, in place of the level's own entities and
    /// dynamic lights, until a level is loaded.
    void play(PlayedScene scene, double time_s);
    /// What play() shows; null: nothing is played in this level.
    const PlayedScene* played() const { return played_ ? &*played_ : nullptr; }

    /// Lets time pass. It stands still while pt_accumulate averages frames.
    void advance(double seconds);
    double time_s() const { return time_s_; }

    /// The frame as it would be rendered now; its spans are valid until the session changes.
    refresh::Frame frame() const;
    /// The same at another time of the level: light styles and test lights are of then.
    refresh::Frame frame_at(double time_s) const;
    /// Renders it, with `uncapped` without waiting for the display. Throws Error when the device is
    /// lost.
    void render(ImDrawData* overlay, bool uncapped = false);
    /// If nothing of the level has been shown and frames are filtered: renders one, with the
    /// unseen ones before it (flt_first).
    void calm_first_picture();
    /// Number of the frame that was rendered last.
    uint64_t last_frame() const { return last_frame_; }
    /// GPU times and counts of the frames that were finished since the last call, which also enter
    /// pass_statistics() and count_statistics(); with `wait`, of all frames rendered so far.
    std::vector<refresh::FrameTimes> take_frame_times(bool wait);
    /// Renders once more if the picture does not show the present view, level or settings.
    void render_if_stale();

    PassStatistics& pass_statistics() { return statistics_; }
    /// Of recent frames.
    const CountStatistics& count_statistics() const { return counts_; }

private:
    /// A second of play.
    static constexpr size_t recent_frames = 60;

    /// What a picture depends on, apart from the passing of time.
    struct Shown {
        glm::vec3 origin{0.0f};
        glm::vec3 angles{0.0f};
        uint64_t scene_changes = 0;
        uint64_t variable_changes = 0;
        bool operator==(const Shown&) const = default;
    };
    Shown present() const;
    RegisterModel register_model();
    void forget_times();

    const FileSystem& files_;
    refresh::Renderer* renderer_;
    const CvarRegistry& variables_;

    std::shared_ptr<const Level> level_;
    LevelEntities drawn_entities_; // as loaded
    LevelEntities entities_;
    LightStyles styles_;
    std::vector<refresh::DynamicLight> dynamic_lights_;
    std::optional<PlayedScene> played_;
    bool flashlight_ = false;
    // What frame() points to beyond what is above.
    mutable std::optional<TestLights> test_lights_;
    mutable std::vector<refresh::DynamicLight> frame_lights_;
    mutable refresh::Spot frame_spot_;
    Camera camera_;
    double time_s_ = 0.0;

    uint64_t scene_changes_ = 0;
    std::optional<Shown> shown_;
    PassStatistics statistics_;
    CountStatistics counts_{recent_frames};
    uint64_t last_frame_ = 0;
};

} // namespace vigil::client
