// SPDX-License-Identifier: GPL-2.0-or-later
// The main loop: events, commands, time, one rendered frame after the other. Without a window
// (headless) it goes on as long as commands wait to run, and every frame lasts exactly 1/60 s of
// the level's time, so that the same commands give the same pictures.
#pragma once

#include "client/demo/fly_through.h"
#include "client/demo/playback.h"
#include "client/demo/recorder.h"
#include "client/play/held_buttons.h"
#include "client/play/play.h"
#include "client/play/session.h"
#include "client/ui/console.h"
#include "client/ui/input.h"
#include "client/ui/key_bindings.h"
#include "client/ui/menu.h"
#include "client/ui/overlay.h"
#include "client/ui/screen_stats.h"
#include "common/error.h"
#include "common/progress.h"
#include "common/stopwatch.h"
#include "console/command.h"
#include "platform/window.h"

#include <functional>
#include <memory>
#include <optional>

namespace vigil::client {

/// Time that a headless frame lasts, in seconds.
inline constexpr double headless_frame_s = 1.0 / 60.0;

/// A renderer, and the window that it draws into; null: headless.
struct Video {
    refresh::Renderer& renderer;
    platform::Window* window = nullptr;
};

/// What a client works with; all must outlive it.
struct ClientParts {
    const FileSystem& files;
    CommandRegistry& commands;
    KeyBindings& bindings;
    Console& console;
    Overlay& overlay;
    refresh::Renderer& renderer;
    platform::Window* window = nullptr; ///< null: headless
    /// Ends window and renderer, and gives new ones by the present variables. Throws Error when
    /// there are none any more. May be empty.
    std::function<Video()> restart_video = {};
};

/// The window was closed while the renderer waited for a compiler.
class CompilationEnded : public Error {
public:
    CompilationEnded() : Error("the window was closed while shaders were compiled") {}
};

class Client : private refresh::CompilationWatcher {
public:
    /// Adds its commands to the registry (add_*_commands below).
    explicit Client(const ClientParts& parts);
    ~Client() override;
    Client(const Client&) = delete;
    Client& operator=(const Client&) = delete;

    /// Runs until `quit`, until the window is closed, or, headless, until no command waits any
    /// more. Throws Error when rendering fails for good (device lost).
    void run();

    /// Ends run() after the present command; commands that wait are dropped.
    void quit();
    bool quitting() const { return quitting_; }

    /// Makes window and renderer anew before the next frame; the present script waits for it.
    /// Throws Error when it cannot.
    void restart_video();

    bool headless() const { return window_ == nullptr; }
    Session& session() { return session_; }
    const Session& session() const { return session_; }
    /// The session; throws Error when no level is loaded.
    Session& session_in_level();
    const CvarRegistry& variables() const { return variables_; }
    CommandRegistry& commands() { return commands_; }
    Console& console() { return console_; }
    Menu& menu() { return menu_; }
    Input& input() { return input_; }
    /// Size of the picture in pixels.
    glm::ivec2 picture_size() const;
    /// Moves the line of pt_compare by this part of the picture's width; it stays inside.
    void move_compare_line(float part);
    /// Size of the window, if there is one and it does not fill the screen.
    void set_window_size(glm::ivec2 size);

    /// Loads a level; while it loads, the window says so. Throws Error and keeps the level before.
    void load_map(std::string_view name);
    /// Plays the level from its start. A window does so as soon as a level is loaded; without one
    /// the level stands as it is drawn until `noclip` or `walk`, and the camera flies.
    void start_play();
    /// The level as it is drawn, and free flight. Keeps a walk that is being recorded.
    void end_play();
    Play* play() { return play_.get(); }
    /// Writes the walk that is being recorded, and says so. Throws Error when that fails.
    void write_walk();

    /// Starts a flight, or ends the one under way.
    void start_flight(Route route, RunPlan plan);
    /// Ends the flight under way, if any, before its time; that counts as a failure.
    void end_flight();
    bool flying() const { return flight_ != nullptr; }

    /// Loads a demo's level and plays the demo. Throws Error.
    void start_demo(DemoPlayback demo);
    /// Ends the demo that plays, if any. A measurement is reported as far as it is finished; that
    /// counts as a failure.
    void end_demo();
    bool playing() const { return demo_ != nullptr; }

    /// A recorder of what the session shows from now on.
    DemoRecorder make_recorder() const;
    /// Records as `path` below outdir until stop_recording() or another level.
    void start_recording(std::string path);
    /// Writes what was recorded. Throws Error when that fails.
    void stop_recording();
    bool recording() const { return recorder_ != nullptr; }
    /// Writes a demo as `path` below outdir, and says so. Throws Error.
    void write_recording(const std::string& path, DemoRecorder& recorder);

    /// Runs a part of a frame; an Error of it is logged after `what`, and counted. Returns false
    /// then.
    bool attempt(std::string_view what, const std::function<void()>& part);
    /// Flights, demos, recordings and the like that ended with an error so far.
    int failures() const { return failures_; }
    /// run() ended in the midst of a measurement.
    bool cut_short() const { return cut_short_; }

private:
    void frame();
    void handle_events();
    void handle(const platform::Event& event);
    void follow_settings();
    void make_video_anew();
    void move_camera(double seconds);
    void drag_compare_line();
    FlightInput take_input(double seconds);
    void render(double seconds);
    ImDrawData* draw_overlay(const refresh::Compilation* compilation, double seconds);
    ImDrawData* compiling(const refresh::Compilation& state) override;
    void tell_compilation(const refresh::Compilation& state, bool over);
    void finish_flight_frame(double seconds);
    void finish_demo_frame(double seconds);
    void record_frame();
    /// Ends a recording under way; what was recorded is kept.
    void keep_recording();
    bool measuring() const { return flight_ || (demo_ && demo_->timed()); }
    /// Ends what goes on in the level and loads another, or the same one anew. That takes a while:
    /// a last frame before it says what is going on.
    void replace_level(const std::function<void()>& load);
    void close_screens();
    void show_title(double seconds);
    void limit_rate(double frame_start_s) const;
    bool mouse_look() const;

    CommandRegistry& commands_;
    Console& console_;
    Overlay& overlay_;
    platform::Window* window_;
    const CvarRegistry& variables_;
    const std::function<Video()> make_video_;
    Session session_;
    HeldButtons buttons_;
    Menu menu_;
    Input input_;
    ScreenStats stats_;
    const std::vector<std::string> no_stats_;

    std::unique_ptr<Play> play_;
    std::unique_ptr<FlyThrough> flight_;
    std::unique_ptr<DemoPlayback> demo_;
    std::unique_ptr<DemoRecorder> recorder_;
    std::string recorded_path_;
    std::vector<platform::Event> waiting_events_; // that arrived while shaders were compiled
    std::unique_ptr<ProgressLine> compile_line_;
    double compile_s_ = 0.0; // of the present frame
    int failures_ = 0;
    bool cut_short_ = false;
    Stopwatch clock_;
    double last_frame_s_ = 0.0;
    bool quitting_ = false;
    bool restart_wanted_ = false;
    bool captured_ = false;
    bool fullscreen_ = false;
    int title_frames_ = 0;
    double title_s_ = 0.0;
};

/// A row of the client's commands.
struct ClientCommand {
    const char* name;
    const char* help; ///< as of CommandRegistry::Command
    std::function<void(Client& client, CommandArguments arguments)> run;
    /// What the first word may be.
    std::function<std::vector<std::string>(const Client& client)> names = {};
};
using ClientCommands = std::vector<ClientCommand>;
void add_commands(Client& client, const ClientCommands& rows);

/// The client's commands by what they are about; each file has its own.
ClientCommands level_commands();
ClientCommands view_commands();
ClientCommands picture_commands();
ClientCommands play_commands();
ClientCommands guiding_commands();
ClientCommands demo_commands();
/// compare, comparemove, +comparedrag, presets.
ClientCommands compare_commands();
/// togglemenu, the menu's pages, resolution, vid_restart.
ClientCommands window_commands();

/// All of them, in the order in which a page lists them.
struct CommandGroup {
    std::string_view title;
    ClientCommands commands;
};
std::vector<CommandGroup> command_groups();

/// Says what names there are of something, and how many.
void log_names(const std::vector<std::string>& names, std::string_view of_what);

/// Names for `demomap`.
std::vector<std::string> list_demos(const Client& client);

/// bind, unbind, unbindall, bindlist.
void add_binding_commands(CommandRegistry& commands, KeyBindings& bindings);

} // namespace vigil::client
