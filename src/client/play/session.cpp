// SPDX-License-Identifier: GPL-2.0-or-later
// Keeping the scene and rendering it.
#include "client/play/session.h"

#include "client/play/flashlight.h"
#include "common/log.h"
#include "common/stopwatch.h"

#include <algorithm>
#include <utility>

namespace vigil::client {

Session::Session(const FileSystem& files, refresh::Renderer& renderer,
                 const CvarRegistry& variables)
    : files_(files), renderer_(&renderer), variables_(variables) {}

void Session::load_map(std::string_view name) {
    const Stopwatch watch;
    std::shared_ptr<const Level> level = vigil::load_level(files_, name);
    renderer_->load_level(level, variables_.values());
    level_ = std::move(level);

    const Bsp& bsp = level_->bsp;
    drawn_entities_ = LevelEntities(bsp, register_model());
    entities_ = drawn_entities_;
    styles_ = LightStyles(bsp.entities);
    dynamic_lights_.clear();
    test_lights_.reset();
    played_.reset();
    const StartPlace start = find_start(bsp);
    camera_.set(start.origin, start.angles);
    time_s_ = 0.0;
    take_frame_times(true); // those of the level before
    forget_times();
    log_info("{}: {} faces, {} clusters, {} models placed, loaded in {:.2f} s", level_->name,
             bsp.faces.size(), bsp.cluster_count, entities_.entities().size(), watch.seconds());
}

RegisterModel Session::register_model() {
    return [this](std::string_view model) { return renderer_->register_model(model); };
}

void Session::forget_times() {
    statistics_.clear();
    counts_.clear();
    ++scene_changes_;
}

void Session::use_renderer(refresh::Renderer& renderer) {
    renderer_ = &renderer;
    shown_.reset();
    played_.reset();
    forget_times();
    if (level_ == nullptr) return;
    renderer_->load_level(level_, variables_.values());
    drawn_entities_.register_again(register_model());
    entities_.register_again(register_model());
}

void Session::place_entity(int number, const glm::vec3& origin, const glm::vec3& angles,
                           bool shown) {
    if (entities_.place(number, origin, angles, shown)) ++scene_changes_;
}

void Session::restore_level() {
    entities_ = drawn_entities_;
    styles_ = LightStyles(level_->bsp.entities);
    ++scene_changes_;
}

void Session::turn_entities(std::string_view target, const glm::vec3& angles) {
    entities_.turn(target, angles);
    ++scene_changes_;
}

void Session::set_light_styles(LightStyles styles) {
    styles_ = std::move(styles);
    ++scene_changes_;
}

void Session::set_dynamic_light(const refresh::DynamicLight& light) {
    const auto found = std::ranges::find(dynamic_lights_, light.id, &refresh::DynamicLight::id);
    if (found == dynamic_lights_.end()) {
        dynamic_lights_.push_back(light);
    } else {
        *found = light;
    }
    ++scene_changes_;
}

void Session::clear_dynamic_lights() {
    dynamic_lights_.clear();
    ++scene_changes_;
}

void Session::remove_dynamic_lights(uint32_t first, uint32_t last) {
    const auto removed = std::erase_if(dynamic_lights_, [&](const refresh::DynamicLight& light) {
        return light.id >= first && light.id <= last;
    });
    if (removed > 0) ++scene_changes_;
}

void Session::set_flashlight(bool on) {
    flashlight_ = on;
    ++scene_changes_;
}

void Session::reset_guiding() {
    renderer_->reset_guiding();
    counts_.clear();
    ++scene_changes_;
}

void Session::play(PlayedScene scene, double time_s) {
    played_ = std::move(scene);
    time_s_ = time_s;
    ++scene_changes_;
}

void Session::advance(double seconds) {
    if (variables_->pt_accumulate == 0) time_s_ += seconds;
}

refresh::Frame Session::frame() const {
    return frame_at(time_s_);
}

refresh::Frame Session::frame_at(double time_s) const {
    refresh::Frame frame;
    frame.settings = variables_.values();
    frame.view = {camera_.origin(), camera_.angles(), variables_->fov};
    frame.time_s = time_s;
    if (played_) {
        frame.view.fov = played_->fov;
        frame.entities = played_->entities;
        frame.dynamic_lights = played_->dynamic_lights;
        frame.beams = played_->beams;
        frame.particles = played_->particles;
    } else {
        frame.entities = entities_.entities();
        frame.dynamic_lights = dynamic_lights_;
    }
    if (variables_->testlights > 0 && level_ != nullptr) {
        if (!test_lights_) test_lights_.emplace(level_);
        const double moved_s = static_cast<double>(variables_->testlights_speed) * time_s;
        frame_lights_ = test_lights_->at(variables_->testlights, moved_s);
        frame_lights_.insert(frame_lights_.begin(), frame.dynamic_lights.begin(),
                             frame.dynamic_lights.end());
        frame.dynamic_lights = frame_lights_;
    }
    if (flashlight_) {
        frame_spot_ = client::flashlight(camera_.origin(), camera_.angles());
        frame.spots = std::span(&frame_spot_, 1);
    }
    if (variables_->pt_light_styles != 0) {
        frame.light_styles = styles_.values_at(time_s);
    } else {
        frame.light_styles.fill(1.0f);
    }
    return frame;
}

Session::Shown Session::present() const {
    Shown now{camera_.origin(), camera_.angles(), scene_changes_, 0};
    for (const CvarInfo& info : cvar_infos) {
        if (info.affects != Affects::Nothing) now.variable_changes += variables_.changes(info.name);
    }
    return now;
}

void Session::render(ImDrawData* overlay, bool uncapped) {
    refresh::Frame now = frame();
    now.overlay = overlay;
    now.uncapped = uncapped;
    last_frame_ = renderer_->render(now);
    shown_ = present();
}

void Session::calm_first_picture() {
    const refresh::Settings settings = frame().settings;
    if (!shown_ && settings.flt_enable != 0 && settings.pt_accumulate == 0 &&
        settings.flt_first > 0)
        render(nullptr);
}

std::vector<refresh::FrameTimes> Session::take_frame_times(bool wait) {
    std::vector<refresh::FrameTimes> times = renderer_->take_frame_times(wait);
    for (const refresh::FrameTimes& frame : times) {
        statistics_.add_frame(frame.passes);
        if (frame.counts.empty()) counts_.clear(); // guiding went off: what was is of no use
        counts_.add_frame(frame.counts);
    }
    return times;
}

void Session::render_if_stale() {
    if (!shown_ || *shown_ != present()) render(nullptr);
}

} // namespace vigil::client
