// SPDX-License-Identifier: GPL-2.0-or-later
// func_door, func_door_rotating and func_water: between a closed and an open placement. Doors of a
// team move as one, led by the first of them in the file.
#pragma once

#include "game/mover.h"

#include <vector>

namespace vigil {

class Door : public Mover {
public:
    enum class State { Closed, Opening, Open, Closing };
    enum class Opens { Slides, Turns };

    Door(Game& game, const Entity& keys, int number, Opens opens);

    void begin() override;
    void think() override;
    void use() override;
    void touch() override;
    std::optional<Box> volume() const override { return trigger_; }
    void hurt(float damage) override;

    State state() const { return state_; }
    /// Nothing has to be pressed, shot or passed: it opens before who comes near.
    bool opens_by_itself() const { return leader_->trigger_.has_value(); }

protected:
    void arrived() override;
    void blocked() override;

private:
    void gather_team();
    void open_up();
    void close();
    bool leads() const { return leader_ == this; }

    Placement closed_, open_;
    GlideSpeed speed_;
    float wait_s_;
    State state_ = State::Closed;
    Door* leader_ = this;
    std::vector<Door*> team_; ///< of the leader: all, itself first
    std::optional<Box> trigger_;
    int64_t touched_at_ = -1;
};

} // namespace vigil
