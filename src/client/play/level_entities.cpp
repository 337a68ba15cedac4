// SPDX-License-Identifier: GPL-2.0-or-later
// Entities of a level and the start place. Class names and spawn flags are those of Quake II's
// game.
#include "client/play/level_entities.h"

#include "common/ascii_case.h"
#include "common/error.h"
#include "common/log.h"
#include "game/player_movement.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace vigil::client {

namespace {

/// Volumes that only game logic knows.
bool is_invisible_class(std::string_view name) {
    static constexpr std::string_view classes[] = {
        "func_areaportal", "func_clip",    "func_group", "func_killbox",
        "func_ladder",     "func_monitor", "func_push",  "func_clock",
    };
    return starts_nocase(name, "trigger_") ||
           std::ranges::any_of(classes, [name](auto other) { return equal_nocase(name, other); });
}

/// Brush models that the game hides until a trigger shows them.
bool starts_hidden(const Entity& entity) {
    const std::string name = entity.classname();
    const auto flags = static_cast<uint32_t>(entity.get_int("spawnflags"));
    constexpr uint32_t trigger_spawn = 1;
    if (equal_nocase(name, "func_wall")) {
        constexpr uint32_t any_trigger = 7;
        constexpr uint32_t start_on = 4;
        return (flags & any_trigger) != 0 && (flags & start_on) == 0;
    }
    if (equal_nocase(name, "func_explosive") || equal_nocase(name, "func_object")) {
        return (flags & trigger_spawn) != 0;
    }
    return false;
}

/// Classes whose `angle` is the direction of their travel: the game clears it when they start.
bool travels(std::string_view name) {
    static constexpr std::string_view classes[] = {"func_door",  "func_button", "func_plat",
                                                   "func_train", "func_water",  "func_secret"};
    return std::ranges::any_of(classes,
                               [name](auto prefix) { return starts_nocase(name, prefix); });
}

/// N of "*N", or -1.
int brush_model_number(std::string_view model) {
    if (!model.starts_with('*')) return -1;
    int number = -1;
    const auto [end, error] =
        std::from_chars(model.data() + 1, model.data() + model.size(), number);
    return error == std::errc() && end == model.data() + model.size() ? number : -1;
}

StartPlace middle_of(const Bsp& bsp) {
    const glm::vec3 middle = 0.5f * (bsp.models[0].mins + bsp.models[0].maxs);
    StartPlace start{middle, glm::vec3(0.0f)};
    float nearest = std::numeric_limits<float>::max();
    for (const BspLeaf& leaf : bsp.leafs) {
        if (leaf.cluster < 0 || (leaf.contents & CONTENTS_SOLID) != 0) continue;
        const glm::vec3 center = 0.5f * (leaf.mins + leaf.maxs);
        const float distance = glm::distance(center, middle);
        if (distance >= nearest) continue;
        nearest = distance;
        start.origin = center;
    }
    return start;
}

} // namespace

LevelEntities::LevelEntities(const Bsp& bsp, const RegisterModel& register_model) {
    std::map<std::string, int> unknown;
    for (size_t i = 1; i < bsp.entities.size(); ++i) {
        const Entity& source = bsp.entities[i];
        const std::string* model = source.find("model");
        if (model == nullptr || model->empty()) continue;
        const int number = static_cast<int>(i);
        if (brush_model_number(*model) >= 0) {
            add_brush_model(source, number, register_model);
        } else if (equal_nocase(source.classname(), "misc_model")) {
            add_misc_model(source, number, register_model);
        } else {
            ++unknown[source.classname()];
        }
    }
    for (const auto& [name, count] : unknown) {
        log_info("entities of class {} are not shown, {} in this level", name, count);
    }
}

bool LevelEntities::add(const Entity& source, int number, std::string_view model,
                        const RegisterModel& register_model) {
    refresh::Entity entity;
    try {
        entity.model = register_model(model);
    } catch (const Error& error) {
        log_warning("entity {} ({}) is left out: {}", number, source.classname(), error.what());
        return false;
    }
    entity.number = number;
    entity.origin = source.get_vec3("origin");
    entities_.push_back(entity);
    models_.emplace_back(model);
    handles_.push_back(entity.model);
    return true;
}

void LevelEntities::add_brush_model(const Entity& source, int number,
                                    const RegisterModel& register_model) {
    if (is_invisible_class(source.classname())) return;
    if (!add(source, number, *source.find("model"), register_model)) return;
    if (starts_hidden(source)) entities_.back().model = -1;
    if (!travels(source.classname())) entities_.back().angles = source.get_model_angles();
    if (const std::string* target = source.find("targetname")) {
        targets_.emplace(*target, entities_.size() - 1);
    }
}

void LevelEntities::add_misc_model(const Entity& source, int number,
                                   const RegisterModel& register_model) {
    if (!add(source, number, *source.find("model"), register_model)) return;
    refresh::Entity& entity = entities_.back();
    entity.angles = source.get_model_angles();
    entity.skin = std::max(0, source.get_int("skin"));
    entity.frame = entity.old_frame = std::max(0, source.get_int("frame"));
}

void LevelEntities::register_again(const RegisterModel& register_model) {
    for (size_t i = 0; i < entities_.size(); ++i) {
        handles_[i] = register_model(models_[i]);
        if (entities_[i].model >= 0) entities_[i].model = handles_[i];
    }
}

bool LevelEntities::place(int number, const glm::vec3& origin, const glm::vec3& angles,
                          bool shown) {
    const auto found = std::ranges::lower_bound(entities_, number, {}, &refresh::Entity::number);
    if (found == entities_.end() || found->number != number) return false;
    const refresh::ModelHandle model =
        shown ? handles_[static_cast<size_t>(found - entities_.begin())] : -1;
    if (found->origin == origin && found->angles == angles && found->model == model) return false;
    found->origin = origin;
    found->angles = angles;
    found->model = model;
    return true;
}

void LevelEntities::turn(std::string_view target, const glm::vec3& angles) {
    const auto [begin, end] = targets_.equal_range(target);
    if (begin == end) fail("no brush model of this level has the targetname \"{}\"", target);
    for (auto it = begin; it != end; ++it)
        entities_[it->second].angles = angles;
}

std::vector<std::string> LevelEntities::targets() const {
    std::vector<std::string> names;
    for (const auto& [name, index] : targets_) {
        if (names.empty() || names.back() != name) names.push_back(name);
    }
    return names;
}

StartPlace find_start(const Bsp& bsp) {
    for (const std::string_view wanted : {"info_player_start", "info_player_deathmatch"}) {
        for (const Entity& entity : bsp.entities) {
            if (!equal_nocase(entity.classname(), wanted)) continue;
            const glm::vec3 eye =
                entity.get_vec3("origin") + glm::vec3(0.0f, 0.0f, player::standing_eye);
            return {eye, entity.get_model_angles()};
        }
    }
    return middle_of(bsp);
}

} // namespace vigil::client
