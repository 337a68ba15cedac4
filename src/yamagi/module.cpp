// SPDX-License-Identifier: GPL-2.0-or-later
#include "yamagi/module.h"

#include "client/measure/picture_file.h"
#include "client/measure/report_text.h"
#include "common/error.h"
#include "common/log.h"
#include "common/output.h"
#include "formats/sky.h"
#include "level/level.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace vigil::yamagi {

namespace {

// Modes that the engine numbers below 0.
constexpr int mode_of_desktop = -2, mode_of_person = -1;
constexpr const char* first_mode = "4"; // 640 x 480

// The game's lights are as bright as light maps can be: a shot would outshine a level of lamps a
// hundred times. With this it is about as bright as the brightest of their walls.
constexpr const char* dlight_scale = "0.03";
/// Of the weapon, vertical degrees: as the engine's other renderers have it.
constexpr const char* gun_fov = "80";

const client::PassSum sums[] = {{refresh::PassGroup::Preparation, "= preparation"},
                                {refresh::PassGroup::PathTracing, "= path tracing"},
                                {refresh::PassGroup::Filter, "= filter"}};

} // namespace

Module::Module(const EngineFunctions& functions)
    : engine_(functions),
      log_(
          add_log_sink([this](Severity severity, std::string_view line) { hear(severity, line); })),
      thread_(std::this_thread::get_id()), files_([this] {
          FileSystem files;
          files.mount(std::make_unique<EngineFiles>(engine_));
          return files;
      }()),
      variables_(engine_), screen_(files_), models_(files_), painter_(files_) {}

Module::~Module() {
    shutdown_context();
    remove_log_sink(log_);
}

void Module::hear(Severity severity, std::string_view line) {
    std::string text;
    if (severity != Severity::Info) text = severity == Severity::Warning ? "warning: " : "error: ";
    text += line;
    if (std::this_thread::get_id() == thread_) {
        engine_.print(text);
        return;
    }
    const std::scoped_lock lock(pending_mutex_);
    pending_.push_back(std::move(text));
}

void Module::tell_pending() {
    std::vector<std::string> lines;
    {
        const std::scoped_lock lock(pending_mutex_);
        lines.swap(pending_);
    }
    for (const std::string& line : lines)
        engine_.print(line);
}

// ---- window ----

bool Module::init() {
    variables_.update();
    if (!open_window()) return false;
    engine_.functions().init_menu();
    return true;
}

bool Module::open_window() {
    const EngineFunctions& functions = engine_.functions();
    const auto number = [&](const char* name, const char* value) {
        return static_cast<int>(std::lround(engine_.value(name, value, variable_archived)));
    };
    const int mode = number("r_mode", first_mode), fullscreen = number("vid_fullscreen", "0");
    glm::ivec2 size(number("r_customwidth", "1024"), number("r_customheight", "768"));
    bool known = mode == mode_of_person;
    if (mode == mode_of_desktop) known = functions.desktop_size(&size.x, &size.y) != 0;
    if (mode >= 0) known = (functions.mode_size(&size.x, &size.y, mode) & 0xff) != 0;
    if (!known) {
        log_warning("r_mode {}: there is no such mode; a window of 640 x 480 it is", mode);
        size = {640, 480};
    }
    for (const int way : {fullscreen, 0}) {
        size_ = size;
        if ((functions.open_window(way, &size_.x, &size_.y) & 0xff) != 0) return true;
        if (without_vulkan_ || fullscreen == 0) break;
    }
    return false;
}

int Module::prepare_for_window() {
    const bool headless = engine_.value("vigil_headless", "0") != 0.0f;
    if (headless || sdl_version() == 0) return 0; // pictures are read back
    if (const auto fault = load_sdl_vulkan()) {
        log_error("no Vulkan: {}", *fault);
        without_vulkan_ = true;
        return -1;
    }
    return sdl_window_vulkan;
}

void Module::init_context(void* window) {
    shutdown_context();
    const bool headless = engine_.value("vigil_headless", "0") != 0.0f;
    if (!headless && window != nullptr && sdl_version() != 0) window_.emplace(window);
    try {
        renderer_ = refresh::make_vkpt_renderer(files_, window_ ? &*window_ : nullptr, settings());
    } catch (...) {
        without_vulkan_ = true;
        window_.reset();
        throw;
    }
    renderer_->watch_compilation(&compile_wait_);
    screen_.use(renderer_.get());
    models_.use(renderer_.get());
}

void Module::shutdown_context() {
    if (timed_) say_timed_passes();
    screen_.use(nullptr);
    models_.use(nullptr);
    level_loaded_ = false;
    renderer_.reset();
    window_.reset();
}

glm::ivec2 Module::drawable_size() const {
    const glm::ivec2 size = window_ ? window_->framebuffer_size() : glm::ivec2(0);
    return size.x > 0 && size.y > 0 ? size : size_;
}

refresh::Settings Module::settings() const {
    refresh::Settings settings = variables_.values();
    settings.vid_width = std::clamp(size_.x, 16, 16384);
    settings.vid_height = std::clamp(size_.y, 16, 16384);
    settings.vid_vsync = engine_.value("r_vsync", "1", variable_archived) != 0.0f ? 1 : 0;
    return settings;
}

// ---- level ----

MaterialTable Module::materials() const {
    constexpr std::string_view name = "materials.json";
    try {
        if (files_.exists(name)) return parse_material_table(name, files_.read_text(name));
    } catch (const Error&) {
        // The renderer tells of it.
    }
    return {};
}

void Module::begin_registration(std::string_view level) {
    if (timed_) say_timed_passes();
    if (!renderer_) return;
    level_loaded_ = false;
    failed_ = false;
    models_.begin_level(false);
    view_.begin_level({});
    passes_.clear();
    counts_.clear();
    variables_.update();
    const std::shared_ptr<const Level> loaded = load_level(files_, level);
    renderer_->load_level(loaded, settings());
    level_loaded_ = true;
    level_name_ = loaded->name;
    const int wanted =
        static_cast<int>(engine_.value("vigil_entity_lights", "2", variable_archived));
    std::vector<LevelLight> lights =
        entity_lights(*loaded, materials(),
                      wanted == 0   ? EntityLights::None
                      : wanted == 1 ? EntityLights::All
                                    : EntityLights::WhereNothingShines);
    if (!lights.empty())
        log_info("{}: {} of the level's entities are lights", loaded->name, lights.size());
    view_.begin_level(std::move(lights));
    models_.begin_level(true);
    painter_.clear();
}

void Module::set_sky(std::string_view name, float degrees_per_second, const glm::vec3& axis) {
    if (!level_loaded_) return;
    // The game names a sky of its own data where a level names none: without it the level's own
    // light stays.
    const std::vector<std::string> candidates = sky_candidates(name, 0);
    const bool there =
        std::ranges::any_of(candidates, [&](const auto& file) { return files_.exists(file); });
    if (there) renderer_->set_sky(name, degrees_per_second, axis);
}

refresh::Renderer& Module::renderer_in_level() {
    if (!renderer_ || !level_loaded_) fail("no level is loaded");
    return *renderer_;
}

// ---- frames ----

void Module::begin_frame() {
    variables_.update();
    screen_.set_size(size_, drawable_size());
    screen_.begin_frame();
    level_seen_ = false;
    previews_ = 0;
}

void Module::render_view(const EngineView& view) {
    if (!renderer_) return;
    const glm::ivec2 corner(view.x, view.y), size(view.width, view.height);
    if ((view.flags & view_without_level) != 0) {
        refresh::Preview preview;
        preview.view.origin = glm::vec3(view.origin[0], view.origin[1], view.origin[2]);
        preview.view.angles = glm::vec3(view.angles[0], view.angles[1], view.angles[2]);
        preview.view.fov = std::clamp(view.fov_x, 1.0f, 170.0f);
        preview.view.fov_y = std::clamp(view.fov_y, 1.0f, 170.0f);
        preview.size = screen_.shown_size(size);
        const std::vector<refresh::PreviewModel> models = preview_models(view);
        preview.models = models;
        screen_.made(corner, size, painter_.draw(preview), previews_++);
        return;
    }
    const float lights = engine_.value("vigil_dlight_scale", dlight_scale, variable_archived);
    constexpr float left_hand = 1.0f, no_hand = 2.0f; // where the game shows no weapon
    const float hand = engine_.value("hand", "0");
    view_.show_weapon({hand != no_hand, hand == left_hand,
                       engine_.value("r_gunfov", gun_fov, variable_archived)});
    view_.read(view, size_, models_, screen_, std::max(lights, 0.0f));
    level_seen_ = true;
    const float(&blend)[4] = view.blend;
    if (blend[3] > 0.0f)
        screen_.tint(corner, size, {blend[0], blend[1], blend[2], std::min(blend[3], 1.0f)});
}

void Module::end_frame() {
    if (!renderer_ || failed_) return;
    refresh::Frame frame = level_seen_ && level_loaded_ ? view_.frame() : refresh::Frame();
    frame.show_level = level_seen_ && level_loaded_;
    frame.settings = settings();
    frame.draws = screen_.draws();
    if (variables_.values().pt_light_styles == 0) frame.light_styles.fill(1.0f);
    timed_ = timed_ || (frame.show_level && engine_.value("timedemo", "0") != 0.0f);
    frame.uncapped = timed_;
    compile_wait_.set_size(window_ ? drawable_size() : glm::ivec2(0));
    try {
        renderer_->render(frame);
    } catch (...) {
        failed_ = true;
        throw;
    }
    if (frame.show_level && timed_) {
        keep_timed_picture();
        ++timed_frames_;
    }
    take_times(false);
}

void Module::keep_timed_picture() {
    const std::string name = engine_.text("vigil_timedemo_exr", "");
    const int every = static_cast<int>(engine_.value("vigil_timedemo_every", "1"));
    if (name.empty() || every < 1 || timed_frames_ % every != 0) return;
    try {
        const auto path = output_path(engine_.functions().game_folder(),
                                      fmt::format("{}_{:03}.exr", name, timed_frames_ / every));
        client::write_exr(path, renderer_->read_radiance());
    } catch (const Error& error) {
        log_warning("{}", error.what());
        engine_.set("vigil_timedemo_exr", "");
    }
}

void Module::take_times(bool wait) {
    for (const refresh::FrameTimes& frame : renderer_->take_frame_times(wait)) {
        // Frames of menus and films would be fast ones.
        if (std::ranges::none_of(frame.passes, [](const refresh::PassTime& pass) {
                return pass.group == refresh::PassGroup::PathTracing;
            }))
            continue;
        passes_.add_frame(frame.passes);
        counts_.add_frame(frame.counts);
    }
}

// ---- commands ----

void Module::take_screenshot() {
    if (!renderer_) fail("there is no picture");
    const refresh::Picture picture = renderer_->read_picture(false);
    std::vector<uint8_t> rgb;
    rgb.reserve(picture.rgba.size() / 4 * 3);
    for (size_t i = 0; i < picture.rgba.size(); i += 4)
        rgb.insert(rgb.end(), &picture.rgba[i], &picture.rgba[i] + 3);
    engine_.functions().write_screenshot(picture.width, picture.height, 3, rgb.data());
}

void Module::say_scene() {
    const refresh::Renderer& renderer = renderer_in_level();
    log_info("{}", client::scene_text(renderer.report_scene(settings()), renderer.report_guiding(),
                                      renderer.health(), settings()));
}

void Module::say_guiding() {
    log_info("{}", client::guiding_text(renderer_in_level().report_guiding()));
    take_times(true);
    if (counts_.frame_count() > 0) log_info("{}", counts_.table());
}

void Module::reset_guiding() {
    renderer_in_level().reset_guiding();
    counts_.clear();
}

void Module::say_light_cache() {
    log_info("{}", client::light_cache_text(renderer_in_level().report_guiding()));
}

void Module::say_quadtree() {
    log_info("{}", client::quadtree_text(renderer_in_level().report_guiding()));
}

void Module::say_passes() {
    renderer_in_level();
    take_times(true);
    if (passes_.frame_count() == 0) fail("no frame of this level was timed");
    log_info("{}", passes_.table(sums));
}

void Module::say_timed_passes() {
    timed_ = false;
    timed_frames_ = 0;
    if (!renderer_) return;
    take_times(true);
    if (passes_.frame_count() == 0) return;
    log_info("{}", passes_.table(sums));
    const std::string name = engine_.text("vigil_timedemo_json", "");
    if (name.empty()) return;
    try {
        if (!name.ends_with(".json")) fail("vigil_timedemo_json {}: a name ends in .json", name);
        const auto path = output_path(engine_.functions().game_folder(), name);
        write_file(path, times_json());
        log_info("wrote {}", path.string());
    } catch (const Error& error) {
        log_warning("{}", error.what());
    }
}

std::string Module::times_json() const {
    nlohmann::ordered_json json;
    json["level"] = level_name_;
    json["device"] = renderer_->device_name();
    json["size"] = {size_.x, size_.y};
    json["frames"] = passes_.frame_count();
    for (const CvarInfo& info : cvar_infos)
        if (info.affects != Affects::Nothing &&
            (info.name.starts_with("pt_") || info.name.starts_with("flt_")))
            json["variables"][std::string(info.name)] = variables_.registry().get_text(info.name);
    const auto add = [&](const client::PassSummary& pass) {
        json["passes"].push_back({{"name", pass.name},
                                  {"frames", pass.frames},
                                  {"min_ms", pass.minimum},
                                  {"median_ms", pass.median},
                                  {"mean_ms", pass.mean},
                                  {"p99_ms", pass.p99},
                                  {"share", pass.share}});
    };
    for (const client::PassSummary& pass : passes_.summarize())
        add(pass);
    for (const client::PassSum& sum : sums)
        if (const client::PassSummary pass = passes_.summarize(sum); pass.frames > 0) add(pass);
    return json.dump(2) + "\n";
}

} // namespace vigil::yamagi
