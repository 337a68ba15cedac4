// SPDX-License-Identifier: GPL-2.0-or-later
// The one table of class names: what an entity of a class becomes.
#pragma once

#include "game/actor.h"

#include <memory>
#include <string_view>

namespace vigil {

struct SpawnRow {
    std::string_view classname;
    /// Throws Error where the keys do not make one. Null: known, and needs nothing (places, lights
    /// of the compiler, sounds).
    std::unique_ptr<Actor> (*spawn)(Game&, const Entity&, int number);
};

/// Null for a class that is not known. Without regard to ASCII case, as class names elsewhere.
const SpawnRow* find_spawn_row(std::string_view classname);

} // namespace vigil
