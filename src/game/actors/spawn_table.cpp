// SPDX-License-Identifier: GPL-2.0-or-later
#include "game/actors/spawn_table.h"

#include "common/ascii_case.h"

#include <algorithm>

namespace vigil {

namespace {

constexpr SpawnRow rows[] = {
    {"func_areaportal", spawn_area_portal},
    {"func_button", spawn_button},
    {"func_conveyor", spawn_conveyor},
    {"func_door", spawn_door},
    {"func_door_rotating", spawn_rotating_door},
    {"func_door_secret", spawn_secret_door},
    {"func_explosive", spawn_explosive},
    {"func_object", spawn_object},
    {"func_plat", spawn_plat},
    {"func_rotating", spawn_rotating},
    {"func_timer", spawn_timer},
    {"func_train", spawn_train},
    {"func_wall", spawn_wall},
    {"func_water", spawn_door},
    {"light", spawn_light},
    {"misc_teleporter", spawn_teleporter},
    {"target_explosion", spawn_target_explosion},
    {"target_lightramp", spawn_light_ramp},
    {"trigger_always", spawn_trigger_always},
    {"trigger_counter", spawn_counter},
    {"trigger_hurt", spawn_hurt},
    {"trigger_multiple", spawn_trigger_multiple},
    {"trigger_once", spawn_trigger_once},
    {"trigger_push", spawn_push},
    {"trigger_relay", spawn_relay},
    {"trigger_secret", spawn_trigger_once}, // of Quake's levels
    {"trigger_teleport", spawn_trigger_teleport},
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
