// SPDX-License-Identifier: GPL-2.0-or-later
// An entity of a level that does something: the base of doors, triggers and the rest (actors/).
// Keys mean what the original game says; numbers out of range are brought into it.
#pragma once

#include "formats/entity.h"
#include "game/trace.h"

#include <cstdint>
#include <optional>
#include <string>

namespace vigil {

class Game;

class Actor {
public:
    /// `number` is the index in Bsp::entities; `keys` and `game` must outlive it.
    Actor(Game& game, const Entity& keys, int number);
    virtual ~Actor() = default;
    Actor(const Actor&) = delete;
    Actor& operator=(const Actor&) = delete;

    int number() const { return number_; }
    const Entity& keys() const { return keys_; }
    const std::string& targetname() const { return targetname_; }
    bool has_flag(uint32_t bit) const { return (flags_ & bit) != 0; }

    /// Once, when all actors are there.
    virtual void begin() {}
    /// At every tick of the level.
    virtual void tick() {}
    /// At the tick that think_in() chose.
    virtual void think() {}
    /// Something whose `target` this is has fired.
    virtual void use() {}
    /// The player's box is in volume().
    virtual void touch() {}
    virtual std::optional<Box> volume() const { return std::nullopt; }
    /// The player ran into its brushes.
    virtual void bump() {}
    /// Something hit it with this damage.
    virtual void hurt(float damage) { (void)damage; }

    /// It is there no longer.
    virtual void remove() { removed_ = true; }
    bool removed() const { return removed_; }
    bool thinks_at(int64_t tick) const { return think_at_ == tick; }

protected:
    Game& game() const { return game_; }
    /// Calls think() after a time; a later call replaces an earlier one.
    void think_in(float seconds);
    /// The same, at once without a time.
    void think_after(float seconds);
    void forget_thought() { think_at_ = -1; }
    bool is_thinking() const;
    /// Fires what the keys target, killtarget, delay and message say.
    void use_targets();
    /// A number in [low, high]; `fallback` where the key is missing or 0, as in the original.
    float number_key(std::string_view key, float fallback, float low, float high) const;

private:
    Game& game_;
    const Entity& keys_;
    int number_;
    uint32_t flags_;
    std::string targetname_;
    int64_t think_at_ = -1;
    bool removed_ = false;
};

} // namespace vigil
