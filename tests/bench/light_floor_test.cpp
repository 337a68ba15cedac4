// SPDX-License-Identifier: GPL-2.0-or-later
// The floor of `quality --floor`: where there is nothing to choose it is the noise that is
// measured, where lights are small it is nothing, and no technique is ever below it.
#include "bench/light_floor.h"

#include "vkpt/light_scenes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

namespace vigil::test {
namespace {

class LightFloorTest : public RenderTest {
protected:
    void show(const LightScene& scene) {
        load(scene.level, scene.edit);
        set_size(scene.size.x, scene.size.y);
        set("pt_bounces", "0");
        shot_ = scene.shot;
    }

    /// Variance of a frame, over pixels and channels, and of its mean square.
    struct Noise {
        double variance = 0.0;
        double square = 0.0;
    };
    Noise noise(std::string_view technique, int frames) const {
        set("pt_nee", technique);
        learn(shot_, frames_to_learn);
        std::vector<double> sums, squares;
        for (int frame = 0; frame < frames; ++frame) {
            const std::vector<float> seen = radiance(shot_).rgb;
            sums.resize(seen.size());
            squares.resize(seen.size());
            for (size_t i = 0; i < seen.size(); ++i) {
                sums[i] += static_cast<double>(seen[i]);
                squares[i] += static_cast<double>(seen[i]) * static_cast<double>(seen[i]);
            }
        }
        Noise result;
        for (size_t i = 0; i < sums.size(); ++i) {
            const double mean = sums[i] / frames;
            result.variance += (squares[i] - frames * mean * mean) / (frames - 1);
            result.square += mean * mean;
        }
        const auto values = static_cast<double>(sums.size());
        return {result.variance / values, result.square / values};
    }

    bench::LightFloor floor(int samples) const {
        set("pt_nee", "sll");
        radiance(shot_);
        return bench::measure_light_floor(renderer(), {samples, 1 << 20});
    }

private:
    Shot shot_;
};

LightScene scene_called(std::string_view name) {
    for (LightScene& scene : light_scenes())
        if (scene.name == name) return scene;
    ADD_FAILURE() << "no scene " << name;
    return {};
}

TEST_F(LightFloorTest, IsTheNoiseItselfWhereThereIsOneLight) {
    show(scene_called("OneLight"));
    set("pt_light_points", "1"); // more noise to compare
    const Noise measured = noise("sll", 400);
    const bench::LightFloor least = floor(256);
    EXPECT_GT(measured.variance, 1e-4 * measured.square);
    EXPECT_NEAR(least.variance / measured.variance, 1.0, 0.05);
}

TEST_F(LightFloorTest, IsBelowEveryTechnique) {
    for (const char* name : {"HalfOfThemBlack", "InThePlane", "RoomsWithManyLamps"}) {
        show(scene_called(name));
        const bench::LightFloor least = floor(64);
        EXPECT_GT(least.variance, 0.0) << name;
        std::cout << fmt::format("{}: floor {:.3g} ({:.3g}, {:.3g})", name, least.variance,
                                 least.halves[0], least.halves[1]);
        EXPECT_NEAR(0.5 * (least.halves[0] + least.halves[1]), least.variance,
                    1e-3 * least.variance)
            << name;
        for (const TechniqueInfo& info : technique_infos) {
            if (info.name == "brute") continue;
            const Noise measured = noise(info.name, 60);
            std::cout << fmt::format(", {} {:.3g}", info.name, measured.variance);
            EXPECT_LT(least.variance, 1.02 * measured.variance) << name << " " << info.name;
            if (info.name == "uniform") {
                EXPECT_LT(least.variance, 0.5 * measured.variance) << name;
            }
        }
        std::cout << '\n';
    }
}

TEST_F(LightFloorTest, IsBelowTechniquesUnderTheSky) {
    // Windows to the sky and the sun, which is small or a point, are lights as others are.
    for (const char* size : {"1", "0"}) {
        LightScene scene;
        scene.level = "opensky";
        scene.shot.view = {{-192, -64, 56}, {0, 20, 0}, 90};
        scene.shot.dynamic_lights = {{1, {-60, 40, 60}, 16.0f, {10, 10, 30}}};
        show(scene);
        set("pt_sun_size", size);
        const bench::LightFloor least = floor(256);
        EXPECT_GT(least.variance, 0.0);
        std::cout << fmt::format("sun of {} degrees: floor {:.3g} ({:.3g}, {:.3g})", size,
                                 least.variance, least.halves[0], least.halves[1]);
        for (const char* technique : {"sll", "lh", "ris"}) { // by lists, by a tree, by a table
            const Noise measured = noise(technique, 60);
            std::cout << fmt::format(", {} {:.3g}", technique, measured.variance);
            EXPECT_LT(least.variance, 1.02 * measured.variance) << technique;
        }
        std::cout << '\n';
    }
}

TEST_F(LightFloorTest, IsTheColourWhereLightsAreFarAndFew) {
    // Sixty triangles of some twelve units at a hundred and more: any point of one brings the same
    // light, and hardly one hides another. If all are blue, nothing is left to a perfect choice; if
    // some are red and green, one light cannot show the colour of all.
    LightScene scene = scene_called("HalfOfThemBlack");
    show(scene);
    const double colourful = floor(64).variance;
    EXPECT_GT(colourful, 0.5 * noise("sll", 50).square);
    scene.edit = [edit = scene.edit](Level& level) {
        edit(level);
        for (BspTexInfo* info : texinfos_of(level, "test/lamp_red"))
            info->texture = "test/blue";
        for (BspTexInfo* info : texinfos_of(level, "test/lamp_green"))
            info->texture = "test/blue";
    };
    show(scene);
    const Noise measured = noise("sll", 50);
    const double blue = floor(64).variance;
    std::cout << fmt::format("floor over mean square: {:.3g}; {:.3g} if all are blue, sll {:.3g}\n",
                             colourful / measured.square, blue / measured.square,
                             measured.variance / measured.square);
    EXPECT_LT(blue, 0.1 * measured.square);
    EXPECT_LT(blue, measured.variance);
}

TEST_F(LightFloorTest, IsNothingInTheDark) {
    show(scene_called("NoLight"));
    EXPECT_EQ(floor(16).variance, 0.0);
}

} // namespace
} // namespace vigil::test
