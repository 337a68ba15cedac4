// SPDX-License-Identifier: GPL-2.0-or-later
// The scenes on which every light-sampling technique is tested: one lamp, none, only lamps that
// cannot shine on what is seen, ten thousand, half of them switched off, lamps in the plane of what
// they would shine on, lamps that moved. Made in memory: triangles of light are hung into small
// levels of tests/data.
#pragma once

#include "render_test.h"

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
    /// Relative bias of the mean picture that any technique's test must be able to find.
    double detectable = 0.05;
    /// No light reaches what is seen.
    bool dark = false;
};

std::vector<LightScene> light_scenes();

} // namespace vigil::test
