// SPDX-License-Identifier: GPL-2.0-or-later
#include "walks/walk_maker.h"

#include "client/play/level_entities.h"
#include "common/ascii_case.h"
#include "game/actors/door.h"
#include "game/view_axes.h"
#include "walks/walk_report.h"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vigil::walks {

namespace {

constexpr float astray = 10.0f;    // map units from the plan
constexpr int look_ahead = 30;     // ticks
constexpr int look_every = 5;      // ticks
constexpr int longest_leg = 2500;  // ticks
constexpr float near_goal = 16.0f; // map units

bool is_class(const Actor& actor, std::initializer_list<std::string_view> names) {
    return std::ranges::any_of(names, [&actor](std::string_view name) {
        return equal_nocase(actor.keys().classname(), name);
    });
}

bool is_shot_open(const Actor& actor) {
    if (is_class(actor, {"func_door_secret"}))
        return actor.targetname().empty() || actor.has_flag(1);
    return is_class(actor, {"func_button", "func_door", "func_door_rotating"}) &&
           actor.keys().get_float("health") > 0.0f;
}

/// One with a name works only for a moment after something has used it.
bool is_closed_teleport(const Actor& actor) {
    return is_class(actor, {"trigger_teleport"}) && !actor.targetname().empty();
}

/// Yaw and pitch from one point to another.
glm::vec3 angles_to(const glm::vec3& from, const glm::vec3& to) {
    const glm::vec3 way = to - from;
    return {-glm::degrees(std::atan2(way.z, glm::length(glm::vec2(way)))),
            glm::degrees(std::atan2(way.y, way.x)), 0.0f};
}

glm::vec3 eye_of(const PlayerState& state) {
    return state.origin + glm::vec3(0.0f, 0.0f, state.eye_height());
}

float heading_to(const glm::vec3& from, const glm::vec3& to) {
    const float degrees = glm::degrees(std::atan2(to.y - from.y, to.x - from.x));
    return 0.5f * std::round(2.0f * degrees);
}

float turn_between(float from, float to) {
    return std::remainder(to - from, 360.0f);
}

float rounded(float value, float steps) {
    return std::round(value * steps) / steps;
}

Box player_bounds(const PlayerState& state) {
    const Box& box = state.box();
    return {state.origin + box.mins - 1.0f, state.origin + box.maxs + 1.0f};
}

float distance_to(const Box& box, const glm::vec3& point) {
    return glm::distance(point, glm::clamp(point, box.mins, box.maxs));
}

} // namespace

WalkMaker::WalkMaker(std::shared_ptr<const Level> level, const MakerOptions& options)
    : level_(std::move(level)), options_(options), game_(level_, start_origin(level_->bsp)),
      view_(client::find_start(level_->bsp).angles.y) {}

bool WalkMaker::over() const {
    return static_cast<float>(walk_.ticks()) >= options_.seconds * player::ticks_per_second;
}

void WalkMaker::tick(const PlayerCommand& command) {
    game_.tick(command);
    walk_.add(command);
    constexpr float apart = 96.0f;
    const glm::vec3& place = game_.player().origin;
    if (seen_.empty() || glm::distance(seen_.back(), place) > apart) seen_.push_back(place);
    for (const auto& actor : game_.actors()) {
        const std::optional<Box> volume = actor->volume();
        if (volume && !is_class(*actor, {"func_door", "func_plat"}) &&
            boxes_touch(*volume, player_bounds(game_.player())))
            done_.insert(actor->number());
    }
    if (game_.player().ground > owner_world) {
        const Actor* ground = game_.actor(game_.player().ground);
        if (ground != nullptr && is_class(*ground, {"func_plat"})) done_.insert(ground->number());
    }
}

void WalkMaker::rest(int ticks) {
    PlayerCommand command;
    command.angles.y = view_;
    for (int i = 0; i < ticks; ++i)
        tick(command);
}

/// The world as it is now, with doors open that open by themselves or are about to.
CollisionWorld WalkMaker::open_world() const {
    CollisionWorld world = game_.collision();
    for (const auto& actor : game_.actors()) {
        const auto* door = dynamic_cast<const Door*>(actor.get());
        if (door == nullptr) continue;
        const bool moves =
            door->state() == Door::State::Opening || door->state() == Door::State::Closing;
        if (moves || (door->opens_by_itself() && door->state() == Door::State::Closed))
            world.obstacle(door->obstacle()).solid = false;
    }
    return world;
}

Reach::Verdict WalkMaker::judge(const PlayerState& state) const {
    const Box bounds = player_bounds(state);
    for (const auto& actor : game_.actors()) {
        if (actor->removed()) continue;
        const std::optional<Box> volume = actor->volume();
        if (!volume || !boxes_touch(*volume, bounds)) continue;
        if (is_class(*actor, {"trigger_hurt"})) return Reach::Verdict::Forbidden;
        if (is_closed_teleport(*actor)) continue;
        if (is_class(*actor, {"trigger_teleport", "misc_teleporter", "trigger_push"}))
            return Reach::Verdict::Ends;
    }
    return Reach::Verdict::Fine;
}

std::vector<WalkMaker::Goal> WalkMaker::goals(const Reach& reach) const {
    std::vector<Goal> found;
    for (const auto& actor : game_.actors()) {
        if (actor->removed() || done_.contains(actor->number())) continue;
        const auto* mover = dynamic_cast<const Mover*>(actor.get());
        const bool button = is_class(*actor, {"func_button"}) && mover != nullptr &&
                            actor->keys().get_float("health") <= 0.0f &&
                            actor->targetname().empty();
        const bool lift =
            is_class(*actor, {"func_plat"}) && mover != nullptr && actor->targetname().empty();
        const bool volume =
            actor->volume() && is_class(*actor, {"trigger_teleport", "misc_teleporter",
                                                 "trigger_once", "trigger_multiple"});
        // Doors lead on only while they are closed.
        const bool target = mover != nullptr && mover->shown() && is_shot_open(*actor);
        if (!button && !lift && !volume && !target) continue;
        if (is_closed_teleport(*actor)) continue;
        if (volume && is_class(*actor, {"trigger_once", "trigger_multiple"}) &&
            !actor->keys().has("target") && !actor->keys().has("killtarget"))
            continue;
        for (size_t i = 1; i < reach.places().size(); ++i) {
            const PlayerState& state = reach.places()[i].state;
            bool there = false;
            if (target) {
                there = can_shoot(state, *mover);
            } else if (button) {
                constexpr float arm = 44.0f;
                const Box box = game_.collision().bounds(mover->obstacle());
                there = distance_to(box, state.origin) < arm &&
                        state.origin.z + 24.0f > box.mins.z && state.origin.z - 20.0f < box.maxs.z;
            } else if (lift) {
                const Box box = game_.collision().bounds(mover->obstacle());
                const glm::vec3 middle = 0.5f * (box.mins + box.maxs);
                there = state.ground == actor->number() &&
                        glm::distance(glm::vec2(middle), glm::vec2(state.origin)) < 40.0f;
            } else {
                there = boxes_touch(*actor->volume(), player_bounds(state));
            }
            if (!there) continue;
            found.push_back({static_cast<int>(i), actor->number(), button, target, lift,
                             std::string(actor->keys().classname())});
            break; // places come in the order of their distance
        }
    }
    std::ranges::sort(found, {}, &Goal::place);
    return found;
}

WalkMaker::Goal WalkMaker::farthest(const Reach& reach) const {
    Goal best;
    float most = 150.0f; // nearer is nothing new
    for (size_t i = 1; i < reach.places().size(); ++i) {
        const Place& place = reach.places()[i];
        if (place.ends) continue;
        float nearest = std::numeric_limits<float>::max();
        for (const glm::vec3& seen : seen_)
            nearest = std::min(nearest, glm::distance(seen, place.state.origin));
        constexpr float under_water = 0.5f; // less to see there
        if (place.state.water_level > 1) nearest *= under_water;
        if (nearest <= most) continue;
        most = nearest;
        best.place = static_cast<int>(i);
        best.name = fmt::format("a place {:.0f} away", most);
    }
    return best;
}

/// Straight on to a place; on success the plan is longer by the way there.
bool WalkMaker::steer(Plan& plan, const PlayerState& goal, const CollisionWorld& world) const {
    PlayerState state = plan.end;
    std::vector<PlayerCommand> commands;
    std::vector<glm::vec3> places;
    const float way = glm::distance(glm::vec2(state.origin), glm::vec2(goal.origin));
    const int most = 30 + static_cast<int>(way / 300.0f * 120.0f);
    Step step;
    for (int tick = 0; tick < most; ++tick) {
        constexpr int turn_every = 8;
        if (tick % turn_every == 0) step.heading = heading_to(state.origin, goal.origin);
        const PlayerCommand command = command_of(step, tick);
        state = move_player(state, command, world);
        if (state.water_level > 0) return false;
        commands.push_back(command);
        places.push_back(state.origin);
        const float left = glm::distance(glm::vec2(state.origin), glm::vec2(goal.origin));
        if (left > near_goal) {
            if (tick % turn_every == 0 && judge(state) != Reach::Verdict::Fine) return false;
            continue;
        }
        constexpr float level_with = 24.0f;
        if (std::abs(state.origin.z - goal.origin.z) > level_with) return false;
        if (state.ground == owner_none) return false;
        plan.commands.insert(plan.commands.end(), commands.begin(), commands.end());
        plan.places.insert(plan.places.end(), places.begin(), places.end());
        plan.end = state;
        return true;
    }
    return false;
}

WalkMaker::Plan WalkMaker::plan(const Reach& reach, int place, const CollisionWorld& world) const {
    Plan plan;
    plan.end = game_.player();
    const std::vector<int> way = reach.way_to(place);
    const auto at = [&](size_t i) -> const Place& {
        return reach.places()[static_cast<size_t>(way[i])];
    };
    plan.complete = true;
    for (size_t i = 0; i < way.size();) {
        // As far ahead as a straight way leads, but not over a jump.
        constexpr size_t farthest_ahead = 24;
        size_t last = i;
        while (last < way.size() && last < i + farthest_ahead && !at(last).step.jump &&
               !at(last).ends && at(last).state.water_level < 2)
            ++last;
        size_t reached = i;
        for (size_t j = last; j > i && reached == i; --j)
            if (steer(plan, at(j - 1).state, world)) reached = j;
        if (reached > i) {
            i = reached;
            continue;
        }
        // Else the step as it was found.
        if (!take_step(plan.end, at(i).step, world, &plan.commands, &plan.places) ||
            glm::distance(plan.end.origin, at(i).state.origin) > Reach::cell) {
            plan.complete = false;
            break;
        }
        ++i;
    }
    smooth(plan, world);
    return plan;
}

void WalkMaker::smooth(Plan& plan, const CollisionWorld& world) const {
    constexpr int ahead = 24;                      // ticks that the eye knows before the feet
    constexpr int every = 3;                       // ticks of one direction: keeps files small
    constexpr float share = 0.2f, fastest = 12.0f; // of the turn that is left; degrees
    std::vector<PlayerCommand> commands = plan.commands;
    std::vector<glm::vec3> places;
    PlayerState state = game_.player();
    float view = view_;
    const int count = static_cast<int>(commands.size());
    for (int i = 0; i < count; ++i) {
        const float heading = plan.commands[static_cast<size_t>(i)].angles.y;
        if (i % every == 0) {
            const size_t seen = static_cast<size_t>(std::min(i + ahead, count - 1));
            const float turn = turn_between(view, plan.commands[seen].angles.y);
            view = rounded(view + std::clamp(share * turn, -fastest, fastest), 2.0f);
            if (std::abs(turn) < 1.0f) view = plan.commands[seen].angles.y;
            view = turn_between(0.0f, view);
        }
        PlayerCommand& command = commands[static_cast<size_t>(i)];
        const float turn = glm::radians(turn_between(view, heading));
        command.angles.y = view;
        command.forward = rounded(run_speed * std::cos(turn), 1.0f);
        command.side = -rounded(run_speed * std::sin(turn), 1.0f);
        state = move_player(state, command, world);
        places.push_back(state.origin);
    }
    // Rounding may lead elsewhere at an edge; then the eye looks where the feet go.
    if (places.empty() || glm::distance(places.back(), plan.places.back()) > near_goal) return;
    plan.commands = std::move(commands);
    plan.places = std::move(places);
    plan.end = state;
}

WalkMaker::Outcome WalkMaker::follow(const Plan& plan) {
    const int count = static_cast<int>(plan.commands.size());
    for (int i = 0; i < count; ++i) {
        if (i % look_every == 0) {
            PlayerState state = game_.player();
            const int end = std::min(i + look_ahead, count);
            for (int j = i; j < end; ++j)
                state =
                    move_player(state, plan.commands[static_cast<size_t>(j)], game_.collision());
            if (glm::distance(state.origin, plan.places[static_cast<size_t>(end - 1)]) > astray)
                return Outcome::Blocked;
        }
        const PlayerCommand& command = plan.commands[static_cast<size_t>(i)];
        tick(command);
        view_ = command.angles.y;
        if (glm::distance(game_.player().origin, plan.places[static_cast<size_t>(i)]) > astray)
            return Outcome::Astray;
    }
    return Outcome::Arrived;
}

bool WalkMaker::go(const Reach& first, const Goal& goal) {
    const glm::vec3 there = first.places()[static_cast<size_t>(goal.place)].state.origin;
    int standstills = 0;
    for (int attempt = 0; attempt < 8; ++attempt) {
        const CollisionWorld world = open_world();
        std::optional<Reach> again;
        int place = goal.place;
        if (attempt > 0) {
            again.emplace(world, game_.player(), longest_leg,
                          [this](const PlayerState& state) { return judge(state); });
            float nearest = 2.0f * Reach::cell;
            place = -1;
            for (size_t i = 0; i < again->places().size(); ++i) {
                const float distance = glm::distance(again->places()[i].state.origin, there);
                if (distance >= nearest) continue;
                nearest = distance;
                place = static_cast<int>(i);
            }
            if (place < 0) return false;
            if (place == 0) return true;
        }
        const Plan plan = this->plan(again ? *again : first, place, world);
        const glm::vec3 from = game_.player().origin;
        const Outcome outcome = follow(plan);
        if (outcome == Outcome::Arrived && plan.complete) return true;
        if (goal.actor >= 0 && done_.contains(goal.actor)) return true;
        if (outcome == Outcome::Blocked) {
            // A door opens meanwhile, or something passes by.
            rest(50);
            for (int i = 0; i < 6 && game_.player().velocity != glm::vec3(0.0f); ++i)
                rest(10);
        } else if (plan.commands.empty() ||
                   glm::distance(from, game_.player().origin) < near_goal) {
            // The plan led nowhere: once more, and then something else.
            if (++standstills == 2) return false;
            rest(10);
        }
        if (over()) return false;
    }
    return false;
}

void WalkMaker::press(int number) {
    const auto& mover = dynamic_cast<const Mover&>(*game_.actor(number));
    const glm::vec3 before = mover.place().origin;
    const Box box = game_.collision().bounds(mover.obstacle());
    const glm::vec3 middle = 0.5f * (box.mins + box.maxs);
    for (int i = 0; i < 60 && mover.place().origin == before; ++i) {
        Step step;
        step.heading = heading_to(game_.player().origin, middle);
        const PlayerCommand command = command_of(step, i);
        view_ = command.angles.y;
        tick(command);
    }
    done_.insert(number);
}

bool WalkMaker::can_shoot(const PlayerState& state, const Mover& target) const {
    constexpr float far = 700.0f, near = 48.0f;
    const Box box = game_.collision().bounds(target.obstacle());
    const glm::vec3 middle = 0.5f * (box.mins + box.maxs), eye = eye_of(state);
    const float distance = glm::distance(middle, eye);
    if (distance > far || distance < near || state.water_level > 0) return false;
    return game_.collision().trace(eye, middle, {}, mask_shot).owner == target.number();
}

void WalkMaker::shoot(int number) {
    const auto& mover = dynamic_cast<const Mover&>(*game_.actor(number));
    const Box box = game_.collision().bounds(mover.obstacle());
    const glm::vec3 middle = 0.5f * (box.mins + box.maxs);
    PlayerCommand command;
    // Bolts start beside the eye: aim from there.
    command.angles = angles_to(eye_of(game_.player()), middle);
    const ViewAxes axes = view_axes(command.angles);
    const glm::vec3 hand = 24.0f * axes.forward + 8.0f * axes.right - 8.0f * axes.up;
    command.angles = angles_to(eye_of(game_.player()) + hand, middle);
    command.angles.x = rounded(command.angles.x, 2.0f);
    command.angles.y = view_ = rounded(command.angles.y, 2.0f);
    const glm::vec3 before = mover.place().origin;
    for (int i = 0; i < 100 && mover.place().origin == before; ++i) {
        command.attack = i >= 20 && i < 24;
        tick(command);
    }
    done_.insert(number);
}

void WalkMaker::ride() {
    // Until what one stands on has come to rest again.
    for (int i = 0; i < 8 * player::ticks_per_second / 10; ++i) {
        const float before = game_.player().origin.z;
        rest(10);
        if (i > 3 && game_.player().origin.z == before) return;
    }
}

client::Walk WalkMaker::make() {
    rest(30);
    int waits = 0;                                          // in a row
    int64_t end = 0;                                        // where they began
    size_t places = std::numeric_limits<size_t>::max() / 2; // that the last leg could reach
    for (int leg = 0; leg < options_.legs && !over(); ++leg) {
        if (game_.player().hold != PlayerState::Hold::None) rest(25); // just arrived
        const CollisionWorld world = open_world();
        const Reach reach(world, game_.player(), longest_leg,
                          [this](const PlayerState& state) { return judge(state); });
        const std::vector<Goal> found = goals(reach);
        // What has just opened may soon close.
        const bool opened = reach.places().size() > 2 * places;
        const bool see = found.empty() || leg % 3 == 2 || opened;
        places = reach.places().size();
        const Goal goal = see ? farthest(reach) : found.front();
        if (goal.place <= 0) {
            // Between closed doors, or on its way with a lift: it will change.
            if (++waits == 4) break;
            if (waits == 1) end = walk_.ticks();
            rest(100);
            continue;
        }
        waits = 0;
        const bool there = go(reach, goal);
        if (options_.verbose)
            fmt::print("leg {}: {} of {} places: {}{}, now {:.1f} s\n", leg, goal.place,
                       reach.places().size(), goal.name, there ? "" : " (not reached)",
                       static_cast<double>(walk_.ticks()) / player::ticks_per_second);
        if (goal.actor >= 0 && !there) done_.insert(goal.actor); // not again
        if (there && goal.press) press(goal.actor);
        if (there && goal.shoot) shoot(goal.actor);
        if (there && goal.ride) ride();
        if (!there && goal.actor < 0)
            seen_.push_back(reach.places()[static_cast<size_t>(goal.place)].state.origin);
    }
    // Without the wait for what did not change.
    client::Walk walk;
    for (int64_t tick = 0; tick < (waits == 4 ? end : walk_.ticks()); ++tick)
        walk.add(walk_.command_at(tick));
    constexpr int last_look = 20;
    PlayerCommand command;
    command.angles.y = view_;
    for (int i = 0; i < last_look; ++i)
        walk.add(command);
    return walk;
}

} // namespace vigil::walks
