// SPDX-License-Identifier: GPL-2.0-or-later
// func_areaportal: closed at first; each use opens or closes the portal of its `style`. Doors that
// target one open and close it themselves, and do not use it.
#include "game/actors/spawn_table.h"
#include "game/game.h"

namespace vigil {

namespace {

class AreaPortal : public Actor {
public:
    using Actor::Actor;
    void use() override {
        const auto portal = static_cast<uint32_t>(keys().get_int("style"));
        AreaPortals& portals = game().area_portals();
        portals.set_open(portal, !portals.is_open(portal));
    }
};

} // namespace

std::unique_ptr<Actor> spawn_area_portal(Game& game, const Entity& keys, int number) {
    return std::make_unique<AreaPortal>(game, keys, number);
}

} // namespace vigil
