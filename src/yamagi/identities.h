// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers that stay with things, for an engine that sends none: what is seen in a frame is matched
// with what was seen before, by kind, place, motion and order. What is wrong costs noise and
// nothing else (docs/internals/front-end.md). tests/yamagi/identities_test.cpp measures how often
// it is.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace vigil::yamagi {

/// A thing as one frame shows it.
struct Sighting {
    uint64_t kind = 0;              ///< only things of one kind are matched: a model, a colour
    glm::vec3 place{0.0f};          ///< map units
    std::optional<glm::vec3> end{}; ///< of a beam: matched as its place is
    int frame = 0;     ///< of its animation, and the one that it comes from; equal for all
    int old_frame = 0; ///< where there is none
};

class Identities {
public:
    /// Things that moved farther than this plus `fastest` times the time are others, map units.
    static constexpr float farthest = 64.0f;
    /// Map units per second: somewhat more than the game's fastest missiles.
    static constexpr float fastest = 1500.0f;
    /// A thing that is not seen for longer is forgotten, seconds.
    static constexpr double remembered_s = 0.25;

    /// The numbers of a frame's things, in their order; from 1, each once. `time_s` is the engine's
    /// time; where it goes back, all is forgotten.
    std::vector<uint32_t> assign(std::span<const Sighting> things, double time_s);

    void clear() {
        tracks_.clear();
        speeds_.clear();
    }
    size_t track_count() const { return tracks_.size(); }

private:
    struct Track {
        Sighting last;
        std::optional<glm::vec3> velocity{}; // map units per second; none when seen once
        double seen_s = 0.0;
        uint32_t id = 0;
        size_t order = 0; // in its frame
    };
    /// What was seen before, and what it is now.
    struct Pair {
        float cost;
        size_t track, thing;
    };

    /// How far `thing` is from what is expected of `track`, map units; nothing if it is another.
    std::optional<float> cost(const Track& track, const Sighting& thing) const;
    /// Each track and each thing at most once, the cheapest pairs first.
    std::vector<Pair> likeliest(std::span<const Sighting> things) const;
    /// The engine lists things of a kind by its own numbers, where the C library's sort is stable.
    /// Pairs that break this order exchange their things where that costs little.
    void put_in_order(std::vector<Pair>& pairs, std::span<const Sighting> things) const;

    std::vector<Track> tracks_;
    std::map<uint64_t, float> speeds_; // the latest of each kind, map units per second
    double time_s_ = 0.0;
    uint32_t next_id_ = 1;
};

} // namespace vigil::yamagi
