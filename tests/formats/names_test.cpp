// SPDX-License-Identifier: GPL-2.0-or-later
// Sky sides and texture file names. The sky must be seamless: neighbouring sides agree about the
// direction of their common edge.
#include "formats/sky.h"
#include "formats/texture_name.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <set>

namespace vigil {
namespace {

glm::vec3 sky_direction(const SkySide& side, float u, float v) {
    return side.forward + (2 * u - 1) * side.right - (2 * v - 1) * side.up;
}

TEST(Sky, SidesArePicturesSeenFromInside) {
    for (const SkySide& side : sky_sides)
        EXPECT_EQ(glm::cross(side.right, side.up), -side.forward) << side.suffix;
}

TEST(Sky, SidesCoverAllSixDirections) {
    glm::vec3 sum(0);
    for (const SkySide& a : sky_sides) {
        sum += a.forward;
        for (const SkySide& b : sky_sides)
            EXPECT_LE(glm::dot(a.forward, b.forward), &a == &b ? 1.0f : 0.0f);
    }
    EXPECT_EQ(sum, glm::vec3(0));
}

TEST(Sky, TheHorizonRunsThroughFourUprightSides) {
    // Turning left from rt (+x): bk, lf, ft, and rt again. Each picture's left edge is the next
    // picture's right edge.
    for (size_t i = 0; i < 4; ++i) {
        const SkySide& side = sky_sides[i];
        const SkySide& left = sky_sides[(i + 1) % 4];
        EXPECT_EQ(side.up, glm::vec3(0, 0, 1));
        for (const float v : {0.0f, 0.3f, 1.0f})
            EXPECT_EQ(sky_direction(side, 0, v), sky_direction(left, 1, v));
    }
}

TEST(Sky, UpAndDownMeetTheFrontOfYawZero) {
    // The view along yaw 0 sees rt upright; tilting up, "up" follows without turning.
    for (const float u : {0.0f, 0.25f, 1.0f}) {
        EXPECT_EQ(sky_direction(sky_sides[0], u, 0), sky_direction(sky_sides[4], u, 1));
        EXPECT_EQ(sky_direction(sky_sides[0], u, 1), sky_direction(sky_sides[5], u, 0));
    }
}

TEST(Sky, FilesAreTriedInOrder) {
    EXPECT_EQ(sky_candidates("unit1_", 1),
              (std::vector<std::string>{"env/unit1_bk.png", "env/unit1_bk.jpg", "env/unit1_bk.tga",
                                        "env/unit1_bk.pcx"}));
}

TEST(TextureName, ReplacementsComeFirst) {
    EXPECT_EQ(texture_candidates("e1u1\\*Water"),
              (std::vector<std::string>{"textures/e1u1/*Water.png", "textures/e1u1/*Water.jpg",
                                        "textures/e1u1/*Water.tga", "textures/e1u1/*Water.wal"}));
}

TEST(TextureName, AnimatedNamesAreRecognised) {
    const auto frames = [](const char* name) {
        return animation_names(name, [](const std::string&) { return true; }).size();
    };
    for (const char* name : {"+0light", "+9light", "+alight", "+JLIGHT", "e1u1/+0light"})
        EXPECT_EQ(frames(name), 10u) << name;
    for (const char* name : {"light", "+light", "+klight", "+0", "+", "", "+0/light", "e1u1/light"})
        EXPECT_EQ(frames(name), 1u) << name;
}

TEST(TextureName, SequencesEndAtTheFirstMissingFrame) {
    const std::set<std::string> files = {"x/+0fan", "x/+1fan", "x/+2fan", "x/+4fan", "x/+afan"};
    const auto exists = [&](const std::string& name) { return files.count(name) > 0; };
    const std::vector<std::string> expected = {"x/+0fan", "x/+1fan", "x/+2fan"};
    EXPECT_EQ(animation_names("x/+0fan", exists), expected);
    EXPECT_EQ(animation_names("x/+2fan", exists), expected);
    EXPECT_EQ(animation_names("x/+afan", exists), (std::vector<std::string>{"x/+afan"}));
    EXPECT_EQ(animation_names("+3butnn", exists), (std::vector<std::string>{"+3butnn"}));
    EXPECT_EQ(animation_names("wall", exists), (std::vector<std::string>{"wall"}));
    const auto always = [](const std::string&) { return true; };
    EXPECT_EQ(animation_names("+0fan", always).size(), 10u);
}

} // namespace
} // namespace vigil
