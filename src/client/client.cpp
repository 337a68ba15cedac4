// SPDX-License-Identifier: GPL-2.0-or-later
// The main loop.
#include "client/client.h"

#include "client/play/stick.h"
#include "common/error.h"
#include "common/log.h"
#include "console/outdir.h"
#include "formats/dm2_protocol.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

namespace vigil::client {

namespace {

// The camera does not jump when a frame took longer (a level was loaded).
constexpr double longest_move_s = 0.5;
constexpr double minimised_sleep_s = 0.02;
constexpr double title_interval_s = 1.0;

void sleep_for(double seconds) {
    if (seconds > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

} // namespace

Client::Client(const ClientParts& parts)
    : commands_(parts.commands), console_(parts.console), overlay_(parts.overlay),
      window_(parts.window), variables_(parts.commands.variables()),
      make_video_(parts.restart_video), session_(parts.files, parts.renderer, variables_),
      menu_({commands_, parts.bindings, [this] { return list_levels(session_.files()); },
             [this] { return list_demos(*this); }, [this] { return picture_size(); }}),
      input_(commands_, parts.bindings, console_, menu_, session_.camera()),
      fullscreen_(variables_->vid_fullscreen != 0) {
    buttons_.add_commands(commands_);
    for (const CommandGroup& group : command_groups())
        add_commands(*this, group.commands);
    session_.renderer().watch_compilation(this);
}

Client::~Client() {
    end_flight(); // none is under way unless rendering failed
    end_demo();
    keep_recording();
    end_play();
    session_.renderer().watch_compilation(nullptr);
}

void Client::quit() {
    quitting_ = true;
    commands_.clear();
}

void Client::restart_video() {
    if (!make_video_) fail("window and renderer cannot be made anew here");
    restart_wanted_ = true;
    // What follows is about the new ones.
    commands_.pause_script_until([this] { return !restart_wanted_; });
}

void Client::make_video_anew() {
    end_flight();
    end_demo();
    keep_recording();
    // Keys that come up now are reported to nobody.
    input_.handle(platform::FocusEvent{false}, false);
    input_.handle(platform::FocusEvent{true}, false);
    waiting_events_.clear();
    session_.renderer().watch_compilation(nullptr);
    window_ = nullptr;
    const Video video = make_video_();
    window_ = video.window;
    captured_ = false;
    fullscreen_ = variables_->vid_fullscreen != 0;
    session_.use_renderer(video.renderer);
    session_.renderer().watch_compilation(this);
    last_frame_s_ = clock_.seconds();
    restart_wanted_ = false;
    log_info("window and renderer are new: {}", session_.renderer().device_name());
}

Session& Client::session_in_level() {
    if (session_.level() == nullptr) fail("no level is loaded. `map NAME` loads one.");
    return session_;
}

glm::ivec2 Client::picture_size() const {
    if (window_ != nullptr) return window_->framebuffer_size();
    return {variables_->vid_width, variables_->vid_height};
}

void Client::run() {
    if (!headless() && session_.level() == nullptr && commands_.idle()) {
        menu_.open();
        log_info("The menu (ESCAPE) has levels. The key ` opens the console. There `maps` lists "
                 "levels, `map NAME` loads one, and `help` tells more.");
    }
    last_frame_s_ = clock_.seconds();
    while (!quitting_) {
        if (headless() && commands_.idle() && !flying() && !playing()) break;
        frame();
    }
    cut_short_ = measuring();
    end_flight();
    end_demo();
    keep_recording();
}

void Client::frame() {
    const double start_s = clock_.seconds();
    double seconds = std::exchange(last_frame_s_, start_s);
    seconds = headless() ? headless_frame_s : start_s - seconds;

    if (restart_wanted_) make_video_anew();
    if (!headless()) {
        handle_events();
        if (quitting_) return;
        follow_settings();
        if (window_->framebuffer_size() == glm::ivec2(0)) {
            sleep_for(minimised_sleep_s); // minimised: nothing to draw into
            return;
        }
    }

    const Stopwatch watch;
    compile_s_ = 0.0;
    move_camera(seconds);
    render(seconds);
    if (quitting_) return;
    record_frame();
    // What a driver compiles is kept: it is none of this frame's time.
    if (flight_)
        finish_flight_frame(watch.seconds() - compile_s_);
    else if (demo_)
        finish_demo_frame(watch.seconds() - compile_s_);
    else
        session_.take_frame_times(false);
    commands_.run_frame();
    if (!headless()) {
        show_title(seconds);
        if (!measuring()) limit_rate(start_s);
    }
}

void Client::handle_events() {
    for (const platform::Event& event : std::exchange(waiting_events_, {}))
        handle(event);
    for (const platform::Event& event : window_->poll_events())
        handle(event);
    if (input_.close_requested()) quit();
}

void Client::handle(const platform::Event& event) {
    // However long a frame takes, each key counts in order.
    if (console_.is_open() && !console_.has_keyboard()) draw_overlay(nullptr, 0.0);
    if (!input_.handle(event, captured_)) return;
    draw_overlay(nullptr, 0.0);
    console_.run_entered();
    menu_.run_clicked();
}

bool Client::mouse_look() const {
    return input_.focused() && !console_.is_open() && !menu_.is_open() &&
           session_.level() != nullptr;
}

void Client::follow_settings() {
    if (mouse_look() != captured_) {
        captured_ = !captured_;
        window_->set_mouse_captured(captured_);
    }
    const bool fullscreen = variables_->vid_fullscreen != 0;
    if (fullscreen == fullscreen_) return;
    fullscreen_ = fullscreen;
    attempt("vid_fullscreen", [&] { window_->set_fullscreen(fullscreen); });
}

void Client::set_window_size(glm::ivec2 size) {
    if (window_ != nullptr && !fullscreen_) window_->set_size(size.x, size.y);
}

void Client::move_compare_line(float part) {
    // Round numbers stay round.
    constexpr float steps = 10000.0f;
    const float at = std::round((variables_->pt_compare_at + part) * steps) / steps;
    commands_.variables().set(&CvarValues::pt_compare_at, std::clamp(at, 0.0f, 1.0f));
}

void Client::drag_compare_line() {
    const float counts = input_.take_drag();
    // A count is a pixel where the system does not change the mouse's speed.
    if (counts != 0.0f)
        move_compare_line(counts / static_cast<float>(std::max(picture_size().x, 1)));
}

FlightInput Client::take_input(double seconds) {
    FlightInput held = buttons_.take_frame();
    if (!mouse_look()) return held; // sticks steer the menu, or nothing
    const auto answer = [&](glm::vec2 place) {
        return stick_response(place, variables_->joy_deadzone, variables_->joy_curve);
    };
    const glm::vec2 move = answer(input_.stick_move()), look = answer(input_.stick_look());
    held.forward = std::clamp(held.forward + move.y, -1.0f, 1.0f);
    held.right = std::clamp(held.right + move.x, -1.0f, 1.0f);
    session_.camera().turn(glm::vec2(look.x, -look.y) * static_cast<float>(seconds),
                           variables_->joy_look, variables_->joy_invert != 0);
    return held;
}

void Client::move_camera(double seconds) {
    const double moved_s = std::min(seconds, longest_move_s);
    const FlightInput held = take_input(moved_s);
    drag_compare_line();
    if (flight_) {
        flight_->begin_frame(session_);
        return;
    }
    if (demo_) {
        if (!attempt("demomap", [&] { demo_->begin_frame(seconds, session_); })) end_demo();
        return;
    }
    if (play_)
        play_->frame(held, moved_s, variables_->pt_accumulate != 0, session_);
    else
        session_.camera().fly(held, static_cast<float>(moved_s));
    session_.advance(seconds);
}

void Client::render(double seconds) {
    console_.update(clock_.seconds());
    ImDrawData* const drawn = headless() ? nullptr : draw_overlay(nullptr, seconds);
    try {
        session_.render(drawn, measuring());
    } catch (const CompilationEnded&) {
        // quit() was called.
    }
}

ImDrawData* Client::draw_overlay(const refresh::Compilation* compilation, double seconds) {
    const bool full = session_.level() == nullptr;
    // Views invite questions about a place (`vlcinfo`).
    const bool crosshair = !full && variables_->pt_view != 0;
    const bool stats = variables_->scr_stats != 0 && !full;
    if (stats && seconds > 0.0)
        stats_.add_frame(seconds, session_.pass_statistics(), variables_, picture_size());
    return overlay_.draw({console_, menu_, stats ? stats_.lines() : no_stats_,
                          variables_->con_notify, full, crosshair, compilation},
                         picture_size(), seconds);
}

void Client::load_map(std::string_view name) {
    log_info("loading {} ...", name);
    replace_level([&] {
        session_.load_map(name);
        if (!headless()) start_play();
    });
}

void Client::replace_level(const std::function<void()>& load) {
    if (!headless() && picture_size() != glm::ivec2(0)) render(0.0);
    end_flight();
    end_demo();
    keep_recording();
    end_play();
    load();
    close_screens();
    if (!headless()) window_->set_title(fmt::format("Vigil - {}", session_.level()->name));
    last_frame_s_ = clock_.seconds();
}

void Client::close_screens() {
    console_.set_open(false);
    menu_.close();
}

void Client::start_play() {
    end_play();
    play_ = std::make_unique<Play>(session_);
}

void Client::end_play() {
    if (!play_) return;
    if (play_->recording()) attempt("walkrecord", [this] { write_walk(); });
    Play::clear(session_);
    play_.reset();
}

void Client::write_walk() {
    const std::optional<Walk> walk = play_->take_recording();
    if (!walk || walk->ticks() == 0)
        fail("{}: not written, because no time has passed", play_->recorded_path());
    const std::filesystem::path file = output_path(play_->recorded_path());
    write_file(file, walk->text());
    log_info("wrote {} ({} ticks)", file.string(), walk->ticks());
}

void Client::start_flight(Route route, RunPlan plan) {
    end_play();
    flight_ = std::make_unique<FlyThrough>(std::move(route), std::move(plan));
    close_screens();
}

void Client::end_flight() {
    if (flight_) attempt("fly", [this] { flight_->cut_short(); });
    flight_.reset();
}

void Client::end_demo() {
    if (demo_ && demo_->timed())
        attempt("demomap", [this] { demo_->cut_short(session_, variables_); });
    demo_.reset();
}

bool Client::attempt(std::string_view what, const std::function<void()>& part) {
    try {
        part();
        return true;
    } catch (const Error& error) {
        log_error("{}: {}", what, error.what());
        ++failures_;
        return false;
    }
}

void Client::finish_flight_frame(double seconds) {
    // The command `fly` waits for the end of the flight, and reports what is thrown here as its
    // own.
    bool over = true;
    attempt("fly", [&] {
        flight_->end_frame(session_, seconds);
        over = flight_->finished();
        if (over) flight_->report(session_, variables_);
    });
    if (over) flight_.reset();
}

void Client::start_demo(DemoPlayback demo) {
    if (!headless()) log_info("loading ...");
    replace_level([&] {
        demo.start(session_);
        demo_ = std::make_unique<DemoPlayback>(std::move(demo));
    });
}

void Client::finish_demo_frame(double seconds) {
    bool over = false;
    const bool sound = attempt("demomap", [&] {
        over = demo_->end_frame(seconds, session_);
        if (over) demo_->finish(session_, variables_);
    });
    if (over)
        demo_.reset();
    else if (!sound)
        end_demo();
    if (!measuring()) session_.take_frame_times(false);
}

DemoRecorder Client::make_recorder() const {
    return {session_.shared_level(), variables_->game, session_.light_styles(), session_.frame(),
            session_.entities().models()};
}

void Client::start_recording(std::string path) {
    recorder_ = std::make_unique<DemoRecorder>(make_recorder());
    recorded_path_ = std::move(path);
}

void Client::record_frame() {
    if (recorder_ && recorder_->wants(session_.time_s()))
        recorder_->add(session_.frame(), session_.light_styles());
}

void Client::stop_recording() {
    const std::unique_ptr<DemoRecorder> recorder = std::move(recorder_);
    write_recording(recorded_path_, *recorder);
}

void Client::keep_recording() {
    if (recorder_) attempt("record", [this] { stop_recording(); });
}

void Client::write_recording(const std::string& path, DemoRecorder& recorder) {
    if (recorder.frames() == 0) fail("{}: not written, because no time has passed", path);
    const std::filesystem::path file = output_path(path);
    const std::vector<uint8_t> bytes = recorder.finish();
    write_file(file, std::as_bytes(std::span(bytes)));
    if (recorder.left_out() > 0)
        log_warning("{} models of {} have no room in the demo", recorder.left_out(),
                    recorder.level().name);
    if (recorder.largest_block() > dm2::portable_block_bytes)
        log_warning("{}: some engines refuse blocks of {} bytes. They read up to {}.",
                    file.string(), recorder.largest_block(), dm2::portable_block_bytes);
    log_info("wrote {} ({} frames, {} bytes)", file.string(), recorder.frames(), bytes.size());
}

void Client::show_title(double seconds) {
    ++title_frames_;
    title_s_ += seconds;
    if (title_s_ < title_interval_s) return;
    if (session_.level() != nullptr) {
        window_->set_title(fmt::format("Vigil - {} - {:.1f} fps", session_.level()->name,
                                       title_frames_ / title_s_));
    }
    title_frames_ = 0;
    title_s_ = 0.0;
}

void Client::limit_rate(double frame_start_s) const {
    sleep_for(1.0 / variables_->cl_maxfps - (clock_.seconds() - frame_start_s));
}

void add_commands(Client& client, const ClientCommands& rows) {
    for (const ClientCommand& row : rows) {
        CommandCompletion complete;
        if (row.names)
            complete = [&client, names = row.names](CommandArguments finished) {
                return finished.empty() ? names(client) : std::vector<std::string>();
            };
        client.commands().add(
            row.name, row.help,
            [&client, run = row.run](CommandArguments words) { run(client, words); },
            std::move(complete));
    }
}

std::vector<CommandGroup> command_groups() {
    return {{"Levels and the program", level_commands()},
            {"Play", play_commands()},
            {"View and console", view_commands()},
            {"Window and menu", window_commands()},
            {"Pictures and flights", picture_commands()},
            {"Demos", demo_commands()},
            {"Techniques", compare_commands()},
            {"What the renderer has learned", guiding_commands()}};
}

} // namespace vigil::client
