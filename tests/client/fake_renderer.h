// SPDX-License-Identifier: GPL-2.0-or-later
// A renderer that draws nothing: it records what it was asked to do, gives pictures of one colour
// that count the frames, and fails where a test tells it to.
#pragma once

#include "common/error.h"
#include "level/level.h"
#include "refresh/refresh.h"

#include <algorithm>
#include <chrono>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace vigil::client {

/// What happened, kept outside so that it outlives the renderer.
struct RenderLog {
    refresh::Health health; // of the next or present renderer: it goes with it
    std::string device = "a fake device";
    std::vector<std::string> calls; // "map tiny", "render", "picture", "radiance", "export PATH"
    std::vector<refresh::View> views;
    std::vector<double> times;
    std::vector<float> style_0;
    std::vector<float> style_1;
    std::vector<refresh::Entity> entities;     // of the last frame
    size_t dynamic_lights = 0;                 // in the last frame
    std::vector<refresh::DynamicLight> lights; // of the last frame
    std::vector<refresh::Spot> spots;          // of the last frame
    std::vector<std::string> models;           // registered, in order

    std::set<std::string, std::less<>> broken_models;
    int fail_at_frame = -1;  // render throws in this frame
    int reports = 0;         // of a compiler that the next frame waits for, the last one included
    double compile_s = 0.0;  // that it waits
    std::vector<bool> drawn; // whether each report was answered with something to draw

    size_t count(std::string_view call) const {
        return static_cast<size_t>(std::count(calls.begin(), calls.end(), call));
    }
};

class FakeRenderer final : public refresh::Renderer {
public:
    explicit FakeRenderer(RenderLog& log) : log_(log) {}
    ~FakeRenderer() override { log_.health = {}; }
    FakeRenderer(const FakeRenderer&) = delete;
    FakeRenderer& operator=(const FakeRenderer&) = delete;

    void load_level(std::shared_ptr<const Level> level, const refresh::Settings&) override {
        log_.calls.push_back("map " + level->name);
        level_ = std::move(level);
    }
    refresh::Health health() const override { return log_.health; }
    refresh::ModelHandle register_model(std::string_view name) override {
        if (log_.broken_models.contains(name)) fail("{}: broken", name);
        log_.models.emplace_back(name);
        return static_cast<refresh::ModelHandle>(log_.models.size()) - 1;
    }
    refresh::SkinHandle register_skin(std::string_view) override { return 0; }
    void set_sky(std::string_view, float, glm::vec3) override {}
    refresh::PictureHandle register_picture(std::string_view) override { return 0; }
    refresh::PictureHandle make_picture(glm::ivec2) override { return 0; }
    void change_picture(refresh::PictureHandle, std::span<const uint8_t>) override {}
    glm::ivec2 picture_size(refresh::PictureHandle) const override { return {1, 1}; }
    void watch_compilation(refresh::CompilationWatcher* watcher) override { watcher_ = watcher; }
    uint64_t render(const refresh::Frame& frame) override {
        const int count = std::exchange(log_.reports, 0), last = count - 1;
        for (int i = 0; i < count; ++i) {
            std::this_thread::sleep_for(std::chrono::duration<double>(log_.compile_s / count));
            const std::vector<std::string> passes =
                i < last ? std::vector<std::string>{"shade"} : std::vector<std::string>();
            log_.drawn.push_back(watcher_->compiling({passes, i, last, 0.5f, log_.compile_s}) !=
                                 nullptr);
        }
        if (log_.fail_at_frame == frames_) fail("the device was lost");
        ++frames_;
        log_.calls.emplace_back("render");
        log_.views.push_back(frame.view);
        log_.times.push_back(frame.time_s);
        log_.style_0.push_back(frame.light_styles[0]);
        log_.style_1.push_back(frame.light_styles[1]);
        log_.entities.assign(frame.entities.begin(), frame.entities.end());
        log_.dynamic_lights = frame.dynamic_lights.size();
        log_.lights.assign(frame.dynamic_lights.begin(), frame.dynamic_lights.end());
        log_.spots.assign(frame.spots.begin(), frame.spots.end());
        return rendered_++;
    }
    refresh::Picture read_picture(bool) override {
        log_.calls.emplace_back("picture");
        return {4, 2, std::vector<uint8_t>(32, static_cast<uint8_t>(frames_))};
    }
    refresh::RadiancePicture read_radiance() override {
        log_.calls.emplace_back("radiance");
        return {2, 1, frames_, {0.5f, 1.0f, 2.0f, 4.0f, 8.0f, 16.0f}};
    }
    std::vector<refresh::FrameTimes> take_frame_times(bool) override {
        std::vector<refresh::FrameTimes> times;
        for (; timed_ < rendered_; ++timed_)
            times.push_back({timed_,
                             {{"primary", 1.0, refresh::PassGroup::PathTracing}, {"shade", 3.0}},
                             {{"leaves", static_cast<double>(timed_)}},
                             {}});
        return times;
    }
    std::string device_name() const override { return log_.device; }
    refresh::SceneReport report_scene(const refresh::Settings&) const override {
        refresh::SceneReport report;
        report.level = "a fake scene";
        return report;
    }
    refresh::GuidingReport report_guiding() const override {
        refresh::GuidingReport report;
        report.on = report.quadtrees = true;
        report.position = {1, 2, 3};
        report.buckets = {{{}}};
        report.quadtree.bits = 32;
        report.quadtree.cells.resize(25);
        return report;
    }
    void reset_guiding() override { log_.calls.emplace_back("reset guiding"); }
    void export_scene(const refresh::Frame&, const std::string& path) override {
        log_.calls.push_back("export " + path);
    }

private:
    RenderLog& log_;
    refresh::CompilationWatcher* watcher_ = nullptr;
    std::shared_ptr<const Level> level_;
    int frames_ = 0;
    uint64_t rendered_ = 0; // frames, and how many of them had their times taken
    uint64_t timed_ = 0;
};

} // namespace vigil::client
