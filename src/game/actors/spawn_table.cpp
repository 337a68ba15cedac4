// SPDX-License-Identifier: GPL-2.0-or-later
#include "game/actors/spawn_table.h"

#include "common/ascii_case.h"
#include "game/actors/door.h"
#include "game/actors/gliders.h"
#include "game/actors/solids.h"
#include "game/actors/targets.h"
#include "game/actors/triggers.h"

#include <algorithm>

namespace vigil {

namespace {

/// `more`: what the constructor of T takes after the usual three.
template <typename T, auto... more>
std::unique_ptr<Actor> spawn(Game& game, const Entity& keys, int number) {
    return std::make_unique<T>(game, keys, number, more...);
}

constexpr SpawnRow rows[] = {
    {"func_areaportal", spawn<actors::AreaPortal>},
    {"func_button", spawn<actors::Button>},
    {"func_conveyor", spawn<actors::Conveyor>},
    {"func_door", spawn<Door, Door::Opens::Slides>},
    {"func_door_rotating", spawn<Door, Door::Opens::Turns>},
    {"func_door_secret", spawn<actors::SecretDoor>},
    {"func_explosive", spawn<actors::Explosive>},
    {"func_object", spawn<actors::Object>},
    {"func_plat", spawn<actors::Plat>},
    {"func_rotating", spawn<actors::Rotating>},
    {"func_timer", spawn<actors::Timer>},
    {"func_train", spawn<actors::Train>},
    {"func_wall", spawn<actors::Wall>},
    {"func_water", spawn<Door, Door::Opens::Slides>},
    {"light", spawn<actors::Light>},
    {"misc_teleporter", spawn<actors::Pad>},
    {"target_explosion", spawn<actors::TargetExplosion>},
    {"target_lightramp", spawn<actors::LightRamp>},
    {"trigger_always", spawn<actors::Always>},
    {"trigger_counter", spawn<actors::Counter>},
    {"trigger_hurt", spawn<actors::Hurt>},
    {"trigger_multiple", spawn<actors::Trigger, actors::Times::Many>},
    {"trigger_once", spawn<actors::Trigger, actors::Times::Once>},
    {"trigger_push", spawn<actors::Push>},
    {"trigger_relay", spawn<actors::Relay>},
    {"trigger_secret", spawn<actors::Trigger, actors::Times::Once>}, // of Quake's levels
    {"trigger_teleport", spawn<actors::TeleportTrigger>},
    // Places that others name, lights that only the compiler and the renderer know, and silence.
    {"func_group", nullptr},
    {"info_intermission", nullptr},
    {"info_notnull", nullptr},
    {"info_null", nullptr},
    {"info_player_coop", nullptr},
    {"info_player_deathmatch", nullptr},
    {"info_player_intermission", nullptr},
    {"info_player_start", nullptr},
    {"info_teleport_destination", nullptr},
    {"misc_model", nullptr},
    {"misc_teleporter_dest", nullptr},
    {"path_corner", nullptr},
    {"target_position", nullptr},
    {"target_speaker", nullptr},
};

} // namespace

const SpawnRow* find_spawn_row(std::string_view classname) {
    // light_spot, light_mine1 and so on, as for the renderer's light styles.
    if (starts_nocase(classname, "light")) classname = "light";
    const auto row = std::ranges::find_if(
        rows, [classname](const SpawnRow& r) { return equal_nocase(r.classname, classname); });
    return row == std::end(rows) ? nullptr : row;
}

} // namespace vigil
