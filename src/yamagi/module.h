// SPDX-License-Identifier: GPL-2.0-or-later
// The renderer's module between its loading and its unloading: in which order the engine's calls
// come, and what is told at its console. What a call means is in screen, level_view, models and
// variables; how C functions become these members, in entry.cpp.
#pragma once

#include "client/measure/count_statistics.h"
#include "client/measure/pass_statistics.h"
#include "common/log.h"
#include "refresh/preview/preview.h"
#include "yamagi/compile_wait.h"
#include "yamagi/level_view.h"
#include "yamagi/sdl_window.h"
#include "yamagi/variables.h"

#include <mutex>
#include <thread>

namespace vigil::yamagi {

class Module {
public:
    explicit Module(const EngineFunctions& functions);
    ~Module();

    const Engine& engine() const { return engine_; }

    /// Opens the window, which calls prepare_for_window and init_context. False: the engine goes on
    /// with another renderer; why was told.
    bool init();
    /// Flags of the window, or -1 where it cannot show Vulkan's pictures, which was told.
    int prepare_for_window();
    /// Makes the renderer for SDL's window. Throws Error.
    void init_context(void* window);
    void shutdown_context();
    glm::ivec2 drawable_size() const;
    bool vsync() const { return settings().vid_vsync != 0; }

    /// Loads the level. Throws Error; then views of it are black.
    void begin_registration(std::string_view level);
    ModelObject* register_model(std::string_view name) { return models_.find(name); }
    void set_sky(std::string_view name, float degrees_per_second, const glm::vec3& axis);

    Screen& screen() { return screen_; }
    void begin_frame();
    void render_view(const EngineView& view);
    /// Renders. Throws Error once; then nothing is rendered until a level is loaded.
    void end_frame();

    // Commands of the engine's console. They throw Error.
    void take_screenshot();
    void say_scene();
    void say_guiding();
    void reset_guiding();
    void say_light_cache();
    void say_quadtree();
    void say_passes();

    /// Tells what the log had from other threads.
    void tell_pending();

private:
    refresh::Settings settings() const;
    refresh::Renderer& renderer_in_level();
    /// Takes over what was set at the engine's console.
    bool open_window();
    MaterialTable materials() const;
    void take_times(bool wait);
    /// Linear radiance of every so manieth frame of a timed demo, where one is wanted.
    void keep_timed_picture();
    /// After a demo was timed (`timedemo` of the engine).
    void say_timed_passes();
    std::string times_json() const;
    void hear(Severity severity, std::string_view line);

    Engine engine_;
    int log_ = 0; // token of its sink
    std::thread::id thread_;
    std::mutex pending_mutex_;
    std::vector<std::string> pending_; // of other threads

    FileSystem files_;
    Variables variables_;
    Screen screen_;
    Models models_;
    LevelView view_;
    refresh::PreviewPainter painter_;

    glm::ivec2 size_{640, 480}; // that the engine draws for
    bool without_vulkan_ = false;
    std::optional<SdlWindow> window_;
    CompileWait compile_wait_;
    std::unique_ptr<refresh::Renderer> renderer_;
    bool level_loaded_ = false;
    std::string level_name_;
    bool level_seen_ = false; // in this frame
    bool failed_ = false;     // the last frame
    bool timed_ = false;      // a demo
    int timed_frames_ = 0;    // of it
    int previews_ = 0;        // in this frame
    client::PassStatistics passes_;
    client::CountStatistics counts_{100};
};

} // namespace vigil::yamagi
