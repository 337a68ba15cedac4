// SPDX-License-Identifier: GPL-2.0-or-later
// misc_teleporter, a pad, and trigger_teleport, a volume: who touches one stands at the entity that
// its `target` names, looks where that looks, and cannot move for a moment. A trigger with a name
// works for two tenths of a second after each use.
#include "common/log.h"
#include "game/actors/spawn_table.h"
#include "game/actors/volume.h"

#include <glm/glm.hpp>

namespace vigil {

namespace {

constexpr float over_pad = 10.0f;
constexpr float hold_s = 0.16f;
constexpr float open_s = 0.2f;

void send_player(Game& game, const Entity& keys, int number) {
    const Entity* goal = game.find_entity(keys.get_string("target"));
    if (goal == nullptr) return;
    const PlayerState arrived =
        place_player(origin_of(*goal) + glm::vec3(0.0f, 0.0f, over_pad), game.collision());
    if (!game.collision().is_free(arrived.origin, player::standing_box, mask_player_solid)) {
        log_warning("entity {} ({}) has no room where it leads", number, keys.classname());
        return;
    }
    PlayerState& player = game.player();
    player.velocity = glm::vec3(0.0f);
    player.hold = PlayerState::Hold::Teleported;
    player.hold_ticks = static_cast<int>(ticks_of(hold_s));
    game.place_player_at(arrived.origin);
    const glm::vec3 angles =
        goal->has("angles") ? goal->get_vec3("angles") : glm::vec3(0, goal->get_float("angle"), 0);
    game.turn_view(angles);
}

class Pad : public Actor {
public:
    Pad(Game& game, const Entity& keys, int number)
        : Actor(game, keys, number), bounds_{origin_of(keys) + glm::vec3(-8, -8, 8),
                                             origin_of(keys) + glm::vec3(8, 8, 24)} {}
    std::optional<Box> volume() const override { return bounds_; }
    void touch() override { send_player(game(), keys(), number()); }

private:
    Box bounds_;
};

class TeleportTrigger : public Volume {
public:
    using Volume::Volume;
    void use() override { think_in(open_s); }
    void touch() override {
        if (targetname().empty() || is_thinking()) send_player(game(), keys(), number());
    }
};

} // namespace

std::unique_ptr<Actor> spawn_teleporter(Game& game, const Entity& keys, int number) {
    return std::make_unique<Pad>(game, keys, number);
}

std::unique_ptr<Actor> spawn_trigger_teleport(Game& game, const Entity& keys, int number) {
    return std::make_unique<TeleportTrigger>(game, keys, number);
}

} // namespace vigil
