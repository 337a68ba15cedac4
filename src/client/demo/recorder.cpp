// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/demo/recorder.h"

#include "client/play/effect_lights.h"
#include "formats/dm2_protocol.h"
#include "game/player_movement.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vigil::client {

namespace {

constexpr uint32_t first_entity = 2; // 1 is the player's
/// Where lights are numbered from, downwards.
constexpr uint32_t last_light = dm2::most_entities - 1;
/// A model that the game has, for entities that are there for their light: where it is missing, a
/// light without a body is what remains.
constexpr std::string_view light_model = "models/objects/laser/tris.md2";

/// The protocol's lights are effects: the one nearest in colour.
uint32_t effect_of(const glm::vec3& radiance) {
    struct Row {
        uint32_t effect;
        glm::vec3 color;
    };
    static const Row rows[] = {
        {dm2::EF_ROCKET, {1, 1, 0}},          {dm2::EF_FLAG1, {1, 0.1f, 0.1f}},
        {dm2::EF_FLAG2, {0.1f, 0.1f, 1}},     {dm2::EF_BFG | dm2::EF_ANIM_ALLFAST, {0, 1, 0}},
        {dm2::EF_IONRIPPER, {1, 0.5f, 0.5f}},
    };
    const float brightest = std::max({radiance.x, radiance.y, radiance.z, 1e-6f});
    const auto nearest = std::ranges::min_element(
        rows, {}, [&](const Row& row) { return glm::distance(row.color, radiance / brightest); });
    return nearest->effect;
}

/// A pattern as it is sent: letters. A style that is a number becomes the nearest letter.
std::string style_letters(const LightStyles& styles, int style) {
    std::string text = styles.text(style);
    const bool letters = std::ranges::all_of(text, [](char c) { return c >= 'a' && c <= 'z'; });
    if (letters) return text;
    const float value = std::strtof(text.c_str(), nullptr);
    return std::string(1, static_cast<char>('a' + std::clamp(std::lround(12.0f * value), 0l, 25l)));
}

} // namespace

DemoRecorder::DemoRecorder(std::shared_ptr<const Level> level, std::string_view game,
                           const LightStyles& styles, const refresh::Frame& frame,
                           ModelNames models)
    : level_(std::move(level)), style_texts_(refresh::light_style_count) {
    const vigil::Entity& world = level_->bsp.worldspawn();
    const std::string title =
        world.get_string("message").empty() ? level_->name : world.get_string("message");
    dm2::ServerData data;
    data.server_count = 1;
    // The folder of the game as other engines know it; baseq2 is theirs without being said.
    data.game_folder = game == "baseq2" ? "" : game;
    data.level_title = title;
    writer_.add(data);
    add_string(dm2::CS_NAME, title);
    add_string(dm2::CS_SKY, world.get_string("sky"));
    add_string(dm2::CS_SKYAXIS, "0 0 0");
    add_string(dm2::CS_SKYROTATE, "0");
    add_string(dm2::CS_AIRACCEL, "0");
    add_string(dm2::CS_MAXCLIENTS, "1");
    add_string(dm2::CS_MAPCHECKSUM, "0");
    add_string(dm2::CS_MODELS + 1, fmt::format("maps/{}.bsp", level_->name));
    number_models(frame, models);
    add_light_model(frame);
    add_string(dm2::CS_PLAYERSKINS, "camera\\male/grunt");
    add_styles(styles);
    for (dm2::EntityState state : states_of(frame)) {
        state.old_origin = glm::vec3(0.0f);
        writer_.add(dm2::Baseline{state});
        if (writer_.block_bytes() > dm2::portable_block_bytes / 2) writer_.end_block();
    }
    writer_.add(dm2::StuffText{"precache\n"});
    writer_.end_block();
    last_tick_ = tick(frame.time_s) - 1;
}

void DemoRecorder::add_string(uint32_t index, std::string text) {
    if (text.empty()) return;
    writer_.add(dm2::ConfigString{index, std::move(text)});
    // Blocks stay far below what the first Quake II reads.
    if (writer_.block_bytes() > dm2::portable_block_bytes / 2) writer_.end_block();
}

void DemoRecorder::add_styles(const LightStyles& styles) {
    for (int style = 0; style < refresh::light_style_count; ++style) {
        std::string letters = style_letters(styles, style);
        if (letters.empty()) letters = "m"; // steady
        std::string& known = style_texts_[static_cast<size_t>(style)];
        if (letters == known || (known.empty() && letters == "m" && frames_ == 0)) continue;
        known = letters;
        add_string(dm2::CS_LIGHTS + static_cast<uint32_t>(style), std::move(letters));
    }
}

void DemoRecorder::number_models(const refresh::Frame& frame, ModelNames models) {
    uint32_t next_model = 2, next_number = first_entity;
    std::vector<std::string> names; // from index 2 on
    for (size_t i = 0; i < frame.entities.size(); ++i) {
        Known known;
        known.session_number = frame.entities[i].number;
        const auto found = std::ranges::find(names, models[i]);
        // 255 stands for a player's model.
        if (found == names.end() && next_model < 254) {
            add_string(dm2::CS_MODELS + next_model++, models[i]);
            names.push_back(models[i]);
            known.model = static_cast<uint8_t>(next_model - 1);
        } else if (found != names.end()) {
            known.model = static_cast<uint8_t>(2 + (found - names.begin()));
        }
        if (known.model != 0 && entities_.size() < dm2::portable_frame_entities) {
            known.number = next_number++;
            entities_.push_back(known);
        } else {
            ++left_out_;
        }
    }
    light_model_ = static_cast<uint8_t>(next_model);
}

void DemoRecorder::add_light_model(const refresh::Frame& frame) {
    if (frame.dynamic_lights.empty() || std::exchange(light_model_sent_, true)) return;
    add_string(dm2::CS_MODELS + uint32_t{light_model_}, std::string(light_model));
}

int32_t DemoRecorder::tick(double time_s) const {
    // A hair is added so that times that were summed up fall on the right side.
    return 1 + static_cast<int32_t>(std::min(time_s * dm2::frames_per_second + 1e-6, 1e9));
}

bool DemoRecorder::wants(double time_s) const {
    return tick(time_s) > last_tick_;
}

std::vector<dm2::EntityState> DemoRecorder::states_of(const refresh::Frame& frame) const {
    std::vector<dm2::EntityState> states;
    for (const Known& known : entities_) {
        const auto entity =
            std::ranges::find(frame.entities, known.session_number, &refresh::Entity::number);
        if (entity == frame.entities.end() || entity->model < 0) continue;
        dm2::EntityState state;
        state.number = known.number;
        state.models[0] = known.model;
        state.origin = entity->origin;
        state.angles = entity->angles;
        state.frame = static_cast<uint16_t>(std::clamp(entity->frame, 0, 0x7fff));
        state.skin = static_cast<uint32_t>(std::max(entity->skin, 0));
        states.push_back(dm2::entity_as_sent(state));
    }
    // Lights, as many as still fit.
    uint32_t number = last_light;
    std::vector<dm2::EntityState> lights;
    for (const refresh::DynamicLight& light : frame.dynamic_lights) {
        if (states.size() + lights.size() >= dm2::portable_frame_entities) break;
        dm2::EntityState state;
        state.number = number--;
        state.models[0] = light_model_;
        state.origin = light.origin;
        state.effects = effect_of(light.radiance);
        lights.push_back(dm2::entity_as_sent(state));
    }
    states.insert(states.end(), lights.rbegin(), lights.rend());
    return states;
}

void DemoRecorder::add(const refresh::Frame& frame, const LightStyles& styles) {
    last_tick_ = tick(frame.time_s);
    add_styles(styles);
    add_light_model(frame);

    dm2::Frame recorded;
    recorded.number = last_tick_;
    // All areas are open: doors of the level do not close anything here.
    recorded.area_bits.assign(std::min<size_t>((level_->bsp.areas.size() + 7) / 8, 32), 0xff);
    dm2::PlayerState& player = recorded.player;
    player.movement_type = dm2::PM_FREEZE;
    player.movement_flags = dm2::PMF_NO_PREDICTION;
    player.view_offset = {0.0f, 0.0f, player::standing_eye};
    player.origin = frame.view.origin - player.view_offset;
    player.view_angles = frame.view.angles;
    player.fov = static_cast<uint8_t>(std::clamp(std::lround(frame.view.fov), 1l, 170l));
    recorded.entities = states_of(frame);
    for (dm2::EntityState& state : recorded.entities) {
        const dm2::EntityState* old = dm2::find_entity(last_states_, state.number);
        state.old_origin = old != nullptr ? old->origin : state.origin;
    }
    last_states_ = recorded.entities;
    writer_.add(recorded);
    writer_.end_block();
    ++frames_;
}

} // namespace vigil::client
