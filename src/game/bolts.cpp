// SPDX-License-Identifier: GPL-2.0-or-later
#include "game/bolts.h"

#include "game/game.h"
#include "game/view_axes.h"

namespace vigil {

namespace {

constexpr float speed = 1000.0f, damage = 10.0f;
constexpr int life_ticks = 2 * player::ticks_per_second;
constexpr int pause = player::ticks_per_second / 2;
constexpr int hit_ticks = player::ticks_per_second * 4 / 10;
/// Lights keep this far from the wall that they hit, or it would swallow them.
constexpr float light_gap = 8.0f;
/// From the eye to the muzzle: forward, right and up.
constexpr glm::vec3 muzzle(24.0f, 8.0f, -8.0f);

} // namespace

void Bolts::tick(Game& game, const glm::vec3& eye, const glm::vec3& angles, bool attack) {
    hits_.tick();
    std::erase_if(bolts_, [&](Bolt& bolt) {
        bolt.before = bolt.now;
        bolt.now += player::tick_s * bolt.velocity;
        const Trace way = game.shoot(bolt.before, bolt.now, damage);
        if (way.hit() && (way.surface_flags & SURF_SKY) == 0)
            hits_.add(bolt.id, way.end + light_gap * way.normal, hit_ticks);
        return way.hit() || --bolt.ticks_left <= 0;
    });

    if (pause_ticks_ > 0) --pause_ticks_;
    if (!attack || pause_ticks_ > 0) return;
    pause_ticks_ = pause;
    const ViewAxes axes = view_axes(angles);
    Bolt bolt;
    bolt.id = next_id_++;
    bolt.velocity = speed * axes.forward;
    bolt.ticks_left = life_ticks;
    // The arm does not reach through walls.
    const glm::vec3 hand =
        eye + axes.forward * muzzle.x + axes.right * muzzle.y + axes.up * muzzle.z;
    bolt.before = bolt.now = game.collision().trace(eye, hand, {}, mask_shot).end;
    bolts_.push_back(bolt);
}

} // namespace vigil
