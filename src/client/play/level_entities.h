// SPDX-License-Identifier: GPL-2.0-or-later
// What a level's entity text puts into the picture: brush models (doors, platforms) where the
// level's author drew them, models placed by misc_model, and the place where a player starts.
// Nothing moves by itself here: client/play/play.h moves them, and `turn` turns one by hand.
#pragma once

#include "level/level.h"
#include "refresh/refresh.h"

#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vigil::client {

/// Gives the handle of "*3" or "models/x.glb"; throws Error when it cannot be loaded.
using RegisterModel = std::function<refresh::ModelHandle(std::string_view name)>;

class LevelEntities {
public:
    LevelEntities() = default;

    /// Registers and places everything visible. A model that cannot be loaded is reported as a
    /// warning and left out; classes that name a model but are not known are reported once each.
    LevelEntities(const Bsp& bsp, const RegisterModel& register_model);

    /// Gives the same models to another renderer.
    void register_again(const RegisterModel& register_model);

    /// In file order; `number` is the index of the entity in the level's entity text. What waits
    /// for a trigger to appear has model -1.
    std::span<const refresh::Entity> entities() const { return entities_; }

    /// What each of them shows: "*3", "models/x.glb".
    std::span<const std::string> models() const { return models_; }

    /// Moves, shows or hides a brush model; a number that has none is ignored. Returns true where
    /// that changed anything.
    bool place(int number, const glm::vec3& origin, const glm::vec3& angles, bool shown);

    /// Sets the angles (pitch, yaw, roll in degrees) of every brush model with this `targetname`.
    /// Throws Error when there is none.
    void turn(std::string_view target, const glm::vec3& angles);
    /// The names `turn` accepts, sorted.
    std::vector<std::string> targets() const;

private:
    void add_brush_model(const Entity& source, int number, const RegisterModel& register_model);
    void add_misc_model(const Entity& source, int number, const RegisterModel& register_model);
    bool add(const Entity& source, int number, std::string_view model,
             const RegisterModel& register_model);

    std::vector<refresh::Entity> entities_;
    std::vector<std::string> models_;                         // one for each
    std::vector<refresh::ModelHandle> handles_;               // one for each, hidden or not
    std::multimap<std::string, size_t, std::less<>> targets_; // into entities_
};

/// The eye where a single player starts (22 units over info_player_start), else in a deathmatch,
/// else in the middle of the level: in the leaf with a cluster that is nearest to it.
struct StartPlace {
    glm::vec3 origin{0.0f};
    glm::vec3 angles{0.0f};
};
StartPlace find_start(const Bsp& bsp);

} // namespace vigil::client
