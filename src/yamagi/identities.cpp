// SPDX-License-Identifier: GPL-2.0-or-later
#include "yamagi/identities.h"

#include <algorithm>

namespace vigil::yamagi {

namespace {

// What counts as much as this distance from where a thing was expected, map units. All are small
// beside what moves: they decide between things that are about equally near.
constexpr float cut_in_animation = 12.0f;
constexpr float place_in_order = 0.01f; // for each place that it moved in the engine's list

/// An animation goes on: from the frame that was shown, or from the same one still.
bool goes_on(const Sighting& before, const Sighting& now) {
    return now.frame == before.frame || now.old_frame == before.frame ||
           now.old_frame == before.old_frame;
}

struct Pair {
    float cost;
    size_t track, thing;
};

} // namespace

std::vector<uint32_t> Identities::assign(std::span<const Sighting> things, double time_s) {
    if (time_s < time_s_) clear();
    time_s_ = time_s;
    std::erase_if(tracks_,
                  [&](const Track& track) { return time_s - track.seen_s > remembered_s; });

    // All pairs that may be the same thing, the likeliest first.
    std::vector<Pair> pairs;
    for (size_t t = 0; t < tracks_.size(); ++t) {
        const Track& track = tracks_[t];
        const auto seconds = static_cast<float>(time_s - track.seen_s);
        const float reach = farthest + fastest * seconds;
        const glm::vec3 moved = track.velocity * seconds;
        for (size_t i = 0; i < things.size(); ++i) {
            const Sighting& thing = things[i];
            if (thing.kind != track.last.kind) continue;
            float distance = glm::distance(track.last.place + moved, thing.place);
            if (track.last.end && thing.end)
                distance = std::max(distance, glm::distance(*track.last.end + moved, *thing.end));
            if (!(distance <= reach)) continue;
            const auto places =
                static_cast<float>(track.order > i ? track.order - i : i - track.order);
            pairs.push_back({distance + (goes_on(track.last, thing) ? 0.0f : cut_in_animation) +
                                 place_in_order * places,
                             t, i});
        }
    }
    std::ranges::sort(pairs, [](const Pair& a, const Pair& b) {
        return a.cost != b.cost ? a.cost < b.cost
                                : std::pair(a.track, a.thing) < std::pair(b.track, b.thing);
    });

    std::vector<uint32_t> ids(things.size(), 0);
    std::vector<bool> taken(tracks_.size(), false);
    for (const Pair& pair : pairs) {
        if (taken[pair.track] || ids[pair.thing] != 0) continue;
        taken[pair.track] = true;
        Track& track = tracks_[pair.track];
        const Sighting& thing = things[pair.thing];
        ids[pair.thing] = track.id;
        const auto seconds = static_cast<float>(time_s - track.seen_s);
        if (seconds > 0.0f) track.velocity = (thing.place - track.last.place) / seconds;
        track.last = thing;
        track.seen_s = time_s;
        track.order = pair.thing;
    }
    for (size_t i = 0; i < things.size(); ++i) {
        if (ids[i] != 0) continue;
        ids[i] = next_id_++;
        tracks_.push_back({things[i], glm::vec3(0.0f), time_s, ids[i], i});
    }
    return ids;
}

} // namespace vigil::yamagi
