// SPDX-License-Identifier: GPL-2.0-or-later
#include "yamagi/identities.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace vigil::yamagi {

namespace {

// What counts as much as this distance from where a thing was expected, map units.
constexpr float cut_in_animation = 12.0f;
constexpr float break_of_order = 32.0f; // two things that changed places in the engine's list

/// An animation goes on: from the frame that was shown, or from the same one still.
bool goes_on(const Sighting& before, const Sighting& now) {
    return now.frame == before.frame || now.old_frame == before.frame ||
           now.old_frame == before.old_frame;
}

} // namespace

std::optional<float> Identities::cost(const Track& track, const Sighting& thing) const {
    if (thing.kind != track.last.kind) return std::nullopt;
    const auto seconds = static_cast<float>(time_s_ - track.seen_s);
    const glm::vec3 moved = track.velocity.value_or(glm::vec3(0.0f)) * seconds;
    float distance = glm::distance(track.last.place + moved, thing.place);
    if (track.last.end && thing.end)
        distance = std::max(distance, glm::distance(*track.last.end + moved, *thing.end));
    if (!(distance <= farthest + fastest * seconds)) return std::nullopt;
    if (!track.velocity) { // it is expected as far away as its kind goes
        const auto speed = speeds_.find(thing.kind);
        if (speed != speeds_.end()) distance = std::abs(distance - speed->second * seconds);
    }
    return distance + (goes_on(track.last, thing) ? 0.0f : cut_in_animation);
}

std::vector<Identities::Pair> Identities::likeliest(std::span<const Sighting> things) const {
    std::vector<Pair> pairs;
    for (size_t t = 0; t < tracks_.size(); ++t)
        for (size_t i = 0; i < things.size(); ++i)
            if (const auto c = cost(tracks_[t], things[i])) pairs.push_back({*c, t, i});
    std::ranges::sort(
        pairs, {}, [](const Pair& pair) { return std::tuple(pair.cost, pair.track, pair.thing); });
    std::vector<bool> known(tracks_.size(), false), seen(things.size(), false);
    std::vector<Pair> chosen;
    for (const Pair& pair : pairs) {
        if (known[pair.track] || seen[pair.thing]) continue;
        known[pair.track] = seen[pair.thing] = true;
        chosen.push_back(pair);
    }
    return chosen;
}

void Identities::put_in_order(std::vector<Pair>& pairs, std::span<const Sighting> things) const {
    std::ranges::sort(pairs, {}, [&](const Pair& pair) { return tracks_[pair.track].order; });
    // Each exchange takes at least one break of the order away, so this ends.
    for (bool changed = true; changed;) {
        changed = false;
        for (size_t a = 0; a < pairs.size(); ++a) {
            for (size_t b = a + 1; b < pairs.size(); ++b) {
                Pair &first = pairs[a], &second = pairs[b];
                if (first.thing < second.thing) continue;
                const auto first_cost = cost(tracks_[first.track], things[second.thing]);
                const auto second_cost = cost(tracks_[second.track], things[first.thing]);
                if (!first_cost || !second_cost) continue;
                if (*first_cost + *second_cost > first.cost + second.cost + break_of_order)
                    continue;
                std::swap(first.thing, second.thing);
                first.cost = *first_cost;
                second.cost = *second_cost;
                changed = true;
            }
        }
    }
}

std::vector<uint32_t> Identities::assign(std::span<const Sighting> things, double time_s) {
    if (time_s < time_s_) clear();
    time_s_ = time_s;
    std::erase_if(tracks_,
                  [&](const Track& track) { return time_s - track.seen_s > remembered_s; });

    std::vector<Pair> pairs = likeliest(things);
    put_in_order(pairs, things);
    std::vector<uint32_t> ids(things.size(), 0);
    for (const Pair& pair : pairs) {
        Track& track = tracks_[pair.track];
        const Sighting& thing = things[pair.thing];
        ids[pair.thing] = track.id;
        const auto seconds = static_cast<float>(time_s - track.seen_s);
        if (seconds > 0.0f) {
            track.velocity = (thing.place - track.last.place) / seconds;
            speeds_[thing.kind] = glm::length(*track.velocity);
        }
        track.last = thing;
        track.seen_s = time_s;
        track.order = pair.thing;
    }
    for (size_t i = 0; i < things.size(); ++i) {
        if (ids[i] != 0) continue;
        ids[i] = next_id_++;
        tracks_.push_back({things[i], std::nullopt, time_s, ids[i], i});
    }
    return ids;
}

} // namespace vigil::yamagi
