// SPDX-License-Identifier: GPL-2.0-or-later
// An actor whose brush model is a space that nobody sees: triggers.
#pragma once

#include "common/error.h"
#include "game/game.h"
#include "game/mover.h"

namespace vigil {

class Volume : public Actor {
public:
    /// Throws Error where the level has no such model.
    Volume(Game& game, const Entity& keys, int number) : Actor(game, keys, number) {
        const int model = brush_model_of(keys, game.bsp().models.size());
        if (model < 0) fail("it has no brush model of the level");
        const Box box = drawn_bounds(game.bsp().models[static_cast<size_t>(model)]);
        bounds_ = {box.mins + origin_of(keys), box.maxs + origin_of(keys)};
    }
    std::optional<Box> volume() const override { return bounds_; }

private:
    Box bounds_;
};

} // namespace vigil
