// SPDX-License-Identifier: GPL-2.0-or-later
// Records what a session shows as a .dm2 demo that other Quake II engines play: view, brush models
// and other models, light styles, dynamic lights as far as the protocol knows such, ten frames a
// second of the level's time.
#pragma once

#include "client/play/light_styles.h"
#include "formats/dm2_writer.h"
#include "level/level.h"
#include "refresh/refresh.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace vigil::client {

/// What the entities of a refresh::Frame show: "*3", "models/x.glb", one for each entity.
using ModelNames = std::span<const std::string>;

class DemoRecorder {
public:
    /// Begins with what is said once: level, sky, models, light styles, first states.
    DemoRecorder(std::shared_ptr<const Level> level, std::string_view game,
                 const LightStyles& styles, const refresh::Frame& frame, ModelNames models);

    /// Whether a tenth of a second has begun for which there is no frame yet.
    bool wants(double time_s) const;
    /// Writes a frame: the moment `frame` is; its time must be wanted.
    void add(const refresh::Frame& frame, const LightStyles& styles);

    const Level& level() const { return *level_; }
    int frames() const { return frames_; }
    /// Entities or models that had no room.
    size_t left_out() const { return left_out_; }
    /// The largest block of the demo.
    size_t largest_block() const { return writer_.largest_block(); }
    /// The demo so far.
    std::vector<uint8_t> finish() { return writer_.finish(); }

private:
    int32_t tick(double time_s) const;
    void add_string(uint32_t index, std::string text);
    void add_styles(const LightStyles& styles);
    void number_models(const refresh::Frame& frame, ModelNames models);
    void add_light_model(const refresh::Frame& frame);
    std::vector<dm2::EntityState> states_of(const refresh::Frame& frame) const;

    std::shared_ptr<const Level> level_;
    dm2::Writer writer_;
    std::vector<std::string> style_texts_;
    /// Of the session's entities, by place in the frame: number and model in the demo; 0: left out.
    struct Known {
        int session_number = 0;
        uint32_t number = 0;
        uint8_t model = 0;
    };
    std::vector<Known> entities_;
    uint8_t light_model_ = 0;
    bool light_model_sent_ = false;
    size_t left_out_ = 0;
    int32_t last_tick_ = 0;
    int frames_ = 0;
    std::vector<dm2::EntityState> last_states_;
};

} // namespace vigil::client
