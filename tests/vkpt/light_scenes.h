// SPDX-License-Identifier: GPL-2.0-or-later
// The scenes on which every light-sampling technique is tested: one lamp, none, only lamps that
// cannot shine on what is seen, ten thousand, half of them switched off, lamps in the plane of what
// they would shine on, lamps that moved, a court under sky and sun. Made in memory: triangles of
// light are hung into small levels of tests/data.
#pragma once

#include "render_test.h"

#include <optional>
#include <string>
#include <vector>

namespace vigil::test {

struct LightScene {
    std::string name;
    std::string level; // of tests/data
    std::function<void(Level&)> edit;
    Shot shot;         // models of entities by name are for the caller to register: see door
    bool door = false; // entity 1 is the level's model *1
    glm::ivec2 size{24, 16};
    /// So many times the usual draws.
    uint32_t effort = 1;
    /// Biases of the mean picture that any technique's test must be able to find.
    Bounds bounds{.everywhere = 0.05, .quadrant = 0.14, .five_blocks = 0.4};
    /// Sky: degrees per second about an axis.
    std::optional<glm::vec4> sky_turns{};
    /// No light reaches what is seen.
    bool dark = false;
    /// Draws spread over many lights, so that an error in probabilities can be found among them.
    bool spread = true;
    /// What a row of docs/internals/numerics.md calls the scene; none: it is not one of those.
    std::string extreme{};
};

std::vector<LightScene> light_scenes();

/// Lights at the extremes: brightnesses from 1e-12 to 1e12 in one room, needles and lamps of a
/// ten-thousandth of a unit, lamps that stand on the floor and reach through it, lamps behind walls
/// alone, all switched off, a room at the far end of the coordinates that levels may have, and
/// skies and suns of every kind.
std::vector<LightScene> extreme_light_scenes();

/// Hangs triangles of light of this size under the roof of the level `lamp`, turned anyhow.
void hang_scattered(Level& level, int count, float size, int value);

} // namespace vigil::test
