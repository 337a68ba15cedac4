// SPDX-License-Identifier: GPL-2.0-or-later
// A tick in the order of the original: crouch, where am I, ladder and the edge of water, jump,
// friction, acceleration by medium, and the way along whatever is in it.
#include "game/player_movement.h"

#include "game/view_axes.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace vigil {

using namespace player;

namespace {

using Hold = PlayerState::Hold;

/// Rising faster than this leaves the ground.
constexpr float takeoff_speed = 180.0f;
constexpr float ground_probe = 0.25f;
constexpr float hard_landing = 200.0f, harder_landing = 400.0f;
constexpr int hard_landing_ticks = ticks_per_second * 144 / 1000;
constexpr int harder_landing_ticks = ticks_per_second * 200 / 1000;
constexpr int water_jump_ticks = ticks_per_second * 2040 / 1000;
constexpr float water_jump_forward = 50.0f, water_jump_up = 350.0f;
constexpr float sink_speed = 60.0f;
constexpr float ladder_sideways = 25.0f;
constexpr float view_step_speed = 180.0f; // a whole step in a tenth of a second
constexpr float still = 0.1f;             // slower than this along an axis after a bump is rest

/// Against the wall, but a hair faster, so that rounding does not keep the box in the plane.
glm::vec3 slide_along(const glm::vec3& velocity, const glm::vec3& normal) {
    constexpr float overbounce = 1.01f;
    float into = glm::dot(velocity, normal);
    into = into < 0.0f ? into * overbounce : into / overbounce;
    glm::vec3 slid = velocity - normal * into;
    for (size_t axis = 0; axis < 3; ++axis)
        if (std::abs(slid[axis]) < still) slid[axis] = 0.0f;
    return slid;
}

/// True where two surfaces together hold up what lies on both.
bool holds(const glm::vec3& a, const glm::vec3& b) {
    constexpr float wall = -0.01f;
    const glm::vec3 sum = a + b;
    return a.z > wall && b.z > wall && sum.z >= steepest_floor * glm::length(sum) && sum.z > 0.0f;
}

class Move {
public:
    Move(const PlayerState& state, const PlayerCommand& command, const CollisionWorld& world,
         std::vector<int>* touched)
        : state_(state), command_(command), world_(world), touched_(touched) {}

    PlayerState tick();

private:
    Trace trace(const glm::vec3& from, const glm::vec3& to) const {
        return world_.trace(from, to, state_.box(), mask_player_solid);
    }
    void touch(int owner) {
        if (touched_ == nullptr || owner <= owner_world) return;
        if (std::ranges::find(*touched_, owner) == touched_->end()) touched_->push_back(owner);
    }

    void free_from_solid();
    void duck();
    void find_ground();
    void land(const Trace& below);
    void find_wedge(const glm::vec3& begin);
    void find_water();
    void find_ladder();
    void try_water_jump(const glm::vec3& ahead);
    void jump();
    void slow_down();
    void add_currents(glm::vec3& wish) const;
    void accelerate(const glm::vec3& wish, float limit, float rate);
    void walk();
    void swim();
    /// Half of a tick's gravity; once before and once after the way makes the way exact.
    void fall_half() { state_.velocity.z -= 0.5f * gravity * tick_s; }
    void slide();
    void step_and_slide();

    PlayerState state_;
    const PlayerCommand& command_;
    const CollisionWorld& world_;
    std::vector<int>* touched_;
    uint32_t ground_contents_ = 0;
    uint32_t ground_surface_ = 0;
};

/// A box that rounding left inside a solid by a hair may step out of it.
void Move::free_from_solid() {
    if (world_.is_free(state_.origin, state_.box(), mask_player_solid)) return;
    for (const float distance : {0.125f, 0.5f, 1.0f})
        for (const float z : {0.0f, 1.0f, -1.0f})
            for (const float x : {0.0f, 1.0f, -1.0f})
                for (const float y : {0.0f, 1.0f, -1.0f}) {
                    const glm::vec3 place = state_.origin + distance * glm::vec3(x, y, z);
                    if (!world_.is_free(place, state_.box(), mask_player_solid)) continue;
                    state_.origin = place;
                    return;
                }
}

void Move::duck() {
    if (command_.up < 0.0f && state_.ground != owner_none) {
        state_.ducked = true;
    } else if (state_.ducked && !(command_.up < 0.0f && state_.ground != owner_none)) {
        if (world_.is_free(state_.origin, standing_box, mask_player_solid)) state_.ducked = false;
    }
}

void Move::land(const Trace& below) {
    if (state_.ground == owner_none) {
        if (state_.hold == Hold::WaterJump) state_.hold = Hold::None;
        if (state_.velocity.z < -hard_landing) {
            state_.hold = Hold::Landed;
            state_.hold_ticks =
                state_.velocity.z < -harder_landing ? harder_landing_ticks : hard_landing_ticks;
        }
    }
    state_.ground = below.owner;
}

void Move::find_ground() {
    ground_contents_ = ground_surface_ = 0;
    if (state_.velocity.z > takeoff_speed) {
        state_.ground = owner_none;
    } else {
        const Trace below =
            trace(state_.origin, state_.origin - glm::vec3(0.0f, 0.0f, ground_probe));
        ground_contents_ = below.contents;
        ground_surface_ = below.surface_flags;
        const bool steep = below.normal.z < steepest_floor && !below.start_solid && !state_.wedged;
        if (!below.hit() || steep)
            state_.ground = owner_none;
        else
            land(below);
        touch(below.owner);
    }
}

/// At the top of a jump one is this slow for half of these ticks.
void Move::find_wedge(const glm::vec3& begin) {
    constexpr float slow = 20.0f;
    constexpr int long_ticks = ticks_per_second / 10;
    const bool rests = state_.ground == owner_none && state_.water_level < 2 && !state_.on_ladder &&
                       state_.hold == Hold::None &&
                       glm::distance(begin, state_.origin) < slow * tick_s;
    state_.still_ticks = rests ? state_.still_ticks + 1 : 0;
    if (state_.still_ticks >= long_ticks) state_.wedged = true;
}

void Move::find_water() {
    state_.water_level = 0;
    state_.water_type = 0;
    const float feet = state_.box().mins.z;
    const float to_eyes = state_.eye_height() - feet;
    const auto contents = [&](float over_feet) {
        return world_.contents_at(state_.origin + glm::vec3(0.0f, 0.0f, feet + over_feet));
    };
    const uint32_t at_feet = contents(1.0f);
    if ((at_feet & mask_water) == 0) return;
    state_.water_type = at_feet;
    state_.water_level = 1;
    if ((contents(1.0f + 0.5f * to_eyes) & mask_water) == 0) return;
    state_.water_level = 2;
    if ((contents(1.0f + to_eyes) & mask_water) != 0) state_.water_level = 3;
}

void Move::find_ladder() {
    state_.on_ladder = false;
    if (state_.hold != Hold::None) return;
    const glm::vec3 ahead = view_axes({0.0f, command_.angles.y, 0.0f}).forward;
    const Trace wall = trace(state_.origin, state_.origin + ahead);
    state_.on_ladder = wall.fraction < 1.0f && (wall.contents & CONTENTS_LADDER) != 0;
    try_water_jump(ahead);
}

/// Out of the water over its edge: a wall ahead at the waist, and nothing above it.
void Move::try_water_jump(const glm::vec3& ahead) {
    if (state_.water_level != 2) return;
    glm::vec3 spot = state_.origin + 30.0f * ahead;
    spot.z += 4.0f;
    if (world_.is_free(spot, {}, CONTENTS_SOLID)) return;
    spot.z += 16.0f;
    if (world_.contents_at(spot) != 0 || !world_.is_free(spot, {}, CONTENTS_SOLID)) return;
    state_.velocity = water_jump_forward * ahead;
    state_.velocity.z = water_jump_up;
    state_.hold = Hold::WaterJump;
    state_.hold_ticks = water_jump_ticks;
}

void Move::jump() {
    if (state_.hold == Hold::Landed) return;
    if (command_.up < 10.0f) {
        state_.jump_held = false;
        return;
    }
    if (state_.jump_held) return;
    if (state_.water_level >= 2) { // swims up instead
        state_.ground = owner_none;
        if (state_.velocity.z <= -300.0f) return;
        const uint32_t type = state_.water_type;
        state_.velocity.z = (type & CONTENTS_WATER) != 0   ? 100.0f
                            : (type & CONTENTS_SLIME) != 0 ? 80.0f
                                                           : 50.0f;
        return;
    }
    if (state_.ground == owner_none) return;
    state_.jump_held = true;
    state_.ground = owner_none;
    state_.velocity.z = std::max(state_.velocity.z + jump_speed, jump_speed);
}

void Move::slow_down() {
    const float speed = glm::length(state_.velocity);
    if (speed < 1.0f) {
        state_.velocity.x = state_.velocity.y = 0.0f;
        return;
    }
    float drop = 0.0f;
    const bool grips = state_.ground != owner_none && (ground_surface_ & SURF_SLICK) == 0;
    if (grips || state_.on_ladder) drop += std::max(speed, stop_speed) * friction * tick_s;
    if (state_.water_level > 0 && !state_.on_ladder)
        drop += speed * water_friction * static_cast<float>(state_.water_level) * tick_s;
    state_.velocity *= std::max(0.0f, speed - drop) / speed;
}

glm::vec3 current_of(uint32_t contents) {
    glm::vec3 current(0.0f);
    if ((contents & CONTENTS_CURRENT_0) != 0) current.x += 1.0f;
    if ((contents & CONTENTS_CURRENT_90) != 0) current.y += 1.0f;
    if ((contents & CONTENTS_CURRENT_180) != 0) current.x -= 1.0f;
    if ((contents & CONTENTS_CURRENT_270) != 0) current.y -= 1.0f;
    if ((contents & CONTENTS_CURRENT_UP) != 0) current.z += 1.0f;
    if ((contents & CONTENTS_CURRENT_DOWN) != 0) current.z -= 1.0f;
    return current;
}

void Move::add_currents(glm::vec3& wish) const {
    if (state_.on_ladder && std::abs(state_.velocity.z) <= ladder_speed) {
        constexpr float looks_up = -15.0f, looks_down = 15.0f;
        if (command_.angles.x <= looks_up && command_.forward > 0.0f)
            wish.z = ladder_speed;
        else if (command_.angles.x >= looks_down && command_.forward > 0.0f)
            wish.z = -ladder_speed;
        else if (command_.up != 0.0f)
            wish.z = command_.up > 0.0f ? ladder_speed : -ladder_speed;
        else
            wish.z = 0.0f;
        wish.x = std::clamp(wish.x, -ladder_sideways, ladder_sideways);
        wish.y = std::clamp(wish.y, -ladder_sideways, ladder_sideways);
    }
    if ((state_.water_type & mask_current) != 0) {
        const bool wading = state_.water_level == 1 && state_.ground != owner_none;
        wish += current_of(state_.water_type) * (water_current_speed * (wading ? 0.5f : 1.0f));
    }
    if (state_.ground != owner_none) wish += current_of(ground_contents_) * conveyor_speed;
}

/// Brings the speed along `wish` nearer to its length, at most `limit`.
void Move::accelerate(const glm::vec3& wish, float limit, float rate) {
    const float length = glm::length(wish);
    if (length == 0.0f) return;
    const glm::vec3 direction = wish / length;
    const float wanted = std::min(length, limit);
    const float missing = wanted - glm::dot(state_.velocity, direction);
    if (missing <= 0.0f) return;
    state_.velocity += std::min(rate * tick_s * wanted, missing) * direction;
}

void Move::walk() {
    // On foot, looking up or down does not slow one down much.
    const ViewAxes axes =
        view_axes({command_.angles.x / 3.0f, command_.angles.y, command_.angles.z});
    glm::vec3 wish = axes.forward * command_.forward + axes.right * command_.side;
    wish.z = 0.0f;
    add_currents(wish);
    const float limit = state_.ducked ? ducked_speed : max_speed;

    if (state_.on_ladder) {
        accelerate(wish, limit, acceleration);
        if (wish.z == 0.0f) {
            // Holds on to it.
            const float brake = gravity * tick_s;
            float& z = state_.velocity.z;
            z = z > 0.0f ? std::max(0.0f, z - brake) : std::min(0.0f, z + brake);
        }
        step_and_slide();
    } else if (state_.ground != owner_none) {
        state_.velocity.z = 0.0f;
        accelerate(wish, limit, acceleration);
        state_.velocity.z = 0.0f;
        if (state_.velocity.x == 0.0f && state_.velocity.y == 0.0f) return;
        step_and_slide();
    } else {
        accelerate(wish, limit, air_acceleration);
        fall_half();
        step_and_slide();
        fall_half();
    }
}

void Move::swim() {
    const ViewAxes axes = view_axes(command_.angles);
    glm::vec3 wish = axes.forward * command_.forward + axes.right * command_.side;
    if (command_.forward == 0.0f && command_.side == 0.0f && command_.up == 0.0f)
        wish.z -= sink_speed;
    else
        wish.z += command_.up;
    add_currents(wish);
    const float limit = state_.ducked ? ducked_speed : max_speed;
    const float length = glm::length(wish);
    if (length > limit) wish *= limit / length;
    accelerate(0.5f * wish, limit, water_acceleration);
    step_and_slide();
}

/// The way of one tick along up to five planes.
void Move::slide() {
    constexpr int most_bumps = 4;
    constexpr size_t most_planes = 5;
    const glm::vec3 wanted = state_.velocity;
    std::array<glm::vec3, most_planes> planes;
    size_t plane_count = 0;
    state_.wedged = false;
    float left_s = tick_s;
    for (int bump = 0; bump < most_bumps; ++bump) {
        const Trace way = trace(state_.origin, state_.origin + left_s * state_.velocity);
        if (way.all_solid) { // nothing to be done here; do not gather speed
            state_.velocity.z = 0.0f;
            return;
        }
        if (way.fraction > 0.0f) {
            state_.origin = way.end;
            plane_count = 0;
        }
        if (way.fraction == 1.0f) break;
        touch(way.owner);
        left_s -= left_s * way.fraction;
        if (plane_count == most_planes) {
            state_.velocity = glm::vec3(0.0f);
            break;
        }
        planes[plane_count++] = way.normal;
        for (size_t i = 0; i + 1 < plane_count; ++i)
            state_.wedged |= holds(planes[i], way.normal);

        // Along the first plane from which no other is run into; else along the crease of two.
        bool found = false;
        glm::vec3 along(0.0f);
        for (size_t i = 0; i < plane_count && !found; ++i) {
            along = slide_along(state_.velocity, planes[i]);
            found = true;
            for (size_t j = 0; j < plane_count; ++j)
                if (j != i && glm::dot(along, planes[j]) < 0.0f) found = false;
        }
        if (!found) {
            if (plane_count != 2) {
                state_.velocity = glm::vec3(0.0f);
                break;
            }
            const glm::vec3 crease = glm::cross(planes[0], planes[1]);
            const float length = glm::length(crease);
            if (length < 1e-6f) {
                state_.velocity = glm::vec3(0.0f);
                break;
            }
            along = crease / length * glm::dot(crease / length, state_.velocity);
        }
        state_.velocity = along;
        // Turning back would tremble in corners.
        if (glm::dot(state_.velocity, wanted) <= 0.0f) {
            state_.velocity = glm::vec3(0.0f);
            break;
        }
    }
    // Teleported or jumping out of water: walls do not slow one down meanwhile.
    if (state_.hold != Hold::None && state_.hold != Hold::Landed) state_.velocity = wanted;
}

/// The way at this height or a step higher, whichever leads further.
void Move::step_and_slide() {
    const PlayerState before = state_;
    slide();
    const PlayerState low = state_;

    const glm::vec3 step(0.0f, 0.0f, step_height);
    if (!world_.is_free(before.origin + step, before.box(), mask_player_solid)) return;
    state_.origin = before.origin + step;
    state_.velocity = before.velocity;
    slide();
    const Trace down = trace(state_.origin, state_.origin - step);
    if (!down.all_solid) state_.origin = down.end;

    const auto squared_way = [&](const glm::vec3& to) {
        const glm::vec2 way = glm::vec2(to) - glm::vec2(before.origin);
        return glm::dot(way, way);
    };
    if (squared_way(low.origin) > squared_way(state_.origin) || down.normal.z < steepest_floor) {
        state_ = low;
        return;
    }
    state_.wedged = low.wedged && state_.origin.z <= low.origin.z;
    state_.velocity.z = low.velocity.z;
    const float rise = state_.origin.z - low.origin.z;
    if (before.ground != owner_none && rise > 1.0f)
        state_.step_left = std::min(state_.step_left + rise, 2.0f * step_height);
}

PlayerState Move::tick() {
    const glm::vec3 begin = state_.origin;
    state_.step_left = std::max(0.0f, state_.step_left - view_step_speed * tick_s);
    free_from_solid();
    duck();
    find_ground();
    find_water();
    find_ladder();
    if (state_.hold != Hold::None && --state_.hold_ticks <= 0) state_.hold = Hold::None;

    if (state_.hold == Hold::Teleported) {
        // Stands where it arrived.
    } else if (state_.hold == Hold::WaterJump) {
        fall_half();
        step_and_slide();
        fall_half();
        if (state_.velocity.z < 0.0f) state_.hold = Hold::None;
    } else {
        jump();
        slow_down();
        if (state_.water_level >= 2)
            swim();
        else
            walk();
    }
    state_.velocity = glm::clamp(state_.velocity, glm::vec3(-fastest), glm::vec3(fastest));
    find_wedge(begin);
    find_ground();
    find_water();
    return state_;
}

} // namespace

PlayerState move_player(const PlayerState& state, const PlayerCommand& command,
                        const CollisionWorld& world, std::vector<int>* touched) {
    return Move(state, command, world, touched).tick();
}

PlayerState move_player_for(PlayerState state, const PlayerCommand& command,
                            const CollisionWorld& world, int ticks) {
    for (int i = 0; i < ticks; ++i)
        state = move_player(state, command, world);
    return state;
}

PlayerState place_player(const glm::vec3& origin, const CollisionWorld& world) {
    PlayerState state;
    state.origin = origin;
    for (int distance = 0; distance <= 9; ++distance)
        for (const glm::vec3& direction :
             {glm::vec3(0, 0, 1), glm::vec3(1, 0, 0), glm::vec3(-1, 0, 0), glm::vec3(0, 1, 0),
              glm::vec3(0, -1, 0), glm::vec3(0, 0, -1)}) {
            const glm::vec3 place = origin + static_cast<float>(distance) * direction;
            if (!world.is_free(place, standing_box, mask_player_solid)) continue;
            state.origin = place;
            return state;
        }
    return state;
}

} // namespace vigil
