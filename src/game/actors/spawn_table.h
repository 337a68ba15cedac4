// SPDX-License-Identifier: GPL-2.0-or-later
// The one table of class names: what an entity of a class becomes.
#pragma once

#include "game/actor.h"

#include <memory>
#include <string_view>

namespace vigil {

/// Throws Error where the keys do not make one.
using SpawnFunction = std::unique_ptr<Actor> (*)(Game&, const Entity&, int number);

struct SpawnRow {
    std::string_view classname;
    SpawnFunction
        spawn; ///< null: known, and needs nothing (places, lights of the compiler, sounds)
};

/// Null for a class that is not known. Without regard to ASCII case, as class names elsewhere.
const SpawnRow* find_spawn_row(std::string_view classname);

// Each is in the file of its name.
std::unique_ptr<Actor> spawn_area_portal(Game&, const Entity&, int);
std::unique_ptr<Actor> spawn_button(Game&, const Entity&, int);
std::unique_ptr<Actor> spawn_conveyor(Game&, const Entity&, int);
std::unique_ptr<Actor> spawn_counter(Game&, const Entity&, int);
std::unique_ptr<Actor> spawn_door(Game&, const Entity&, int);
std::unique_ptr<Actor> spawn_explosive(Game&, const Entity&, int);
std::unique_ptr<Actor> spawn_hurt(Game&, const Entity&, int);
std::unique_ptr<Actor> spawn_light(Game&, const Entity&, int);
std::unique_ptr<Actor> spawn_light_ramp(Game&, const Entity&, int);
std::unique_ptr<Actor> spawn_object(Game&, const Entity&, int);
std::unique_ptr<Actor> spawn_plat(Game&, const Entity&, int);
std::unique_ptr<Actor> spawn_push(Game&, const Entity&, int);
std::unique_ptr<Actor> spawn_relay(Game&, const Entity&, int);
std::unique_ptr<Actor> spawn_rotating(Game&, const Entity&, int);
std::unique_ptr<Actor> spawn_rotating_door(Game&, const Entity&, int);
std::unique_ptr<Actor> spawn_secret_door(Game&, const Entity&, int);
std::unique_ptr<Actor> spawn_target_explosion(Game&, const Entity&, int);
std::unique_ptr<Actor> spawn_teleporter(Game&, const Entity&, int);
std::unique_ptr<Actor> spawn_timer(Game&, const Entity&, int);
std::unique_ptr<Actor> spawn_train(Game&, const Entity&, int);
std::unique_ptr<Actor> spawn_trigger_always(Game&, const Entity&, int);
std::unique_ptr<Actor> spawn_trigger_multiple(Game&, const Entity&, int);
std::unique_ptr<Actor> spawn_trigger_once(Game&, const Entity&, int);
std::unique_ptr<Actor> spawn_trigger_teleport(Game&, const Entity&, int);
std::unique_ptr<Actor> spawn_wall(Game&, const Entity&, int);

} // namespace vigil
