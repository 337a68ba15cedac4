// SPDX-License-Identifier: GPL-2.0-or-later
// What is left of texture and shadows of pictures that were made flatter by a known amount.
#include "bench/detail.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace vigil::bench {

namespace {

constexpr glm::ivec2 size{64, 48};

/// A floor seen from above, a unit per pixel: boards of two colours on its left half; on its right
/// half one colour, on which every fifth pair of columns lies in shadow.
struct Floor {
    std::vector<shader::PrimaryHit> hits;
    std::vector<double> light;

    Floor() {
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const bool left = x < size.x / 2;
                shader::PrimaryHit hit{};
                hit.position = {x, y, 0};
                hit.normal = {0.0f, 0.0f, 1.0f};
                hit.albedo = glm::vec3(left && x % 4 < 2 ? 0.25f : 0.5f);
                hit.primitive = left ? 0 : 1;
                hit.instance = left ? 0 : 1; // no step counts between the halves
                hits.push_back(hit);
                light.push_back(!left && x % 10 < 2 ? 1.0 : 2.0);
            }
    }

    /// Colours and shadows with a share of their contrast.
    std::vector<float> picture(double colors, double shadows) const {
        std::vector<float> rgb;
        for (std::size_t i = 0; i < hits.size(); ++i) {
            const double albedo = 0.375 + colors * (static_cast<double>(hits[i].albedo.x) - 0.375);
            rgb.insert(rgb.end(), 3,
                       static_cast<float>(albedo * (1.5 + shadows * (light[i] - 1.5))));
        }
        return rgb;
    }
};

Reference exact(const std::vector<float>& picture) {
    Reference reference(picture.size());
    for (int batch = 0; batch < 2; ++batch)
        reference.add(picture);
    return reference;
}

} // namespace

TEST(Detail, IsTheShareOfContrastThatIsLeft) {
    const Floor floor;
    const Reference reference = exact(floor.picture(1.0, 1.0));
    for (const double share : {0.0, 0.4, 1.0}) {
        const Detail colors = detail_kept(floor.picture(share, 1.0), reference, floor.hits, size);
        EXPECT_NEAR(colors.texture, share, 1e-5);
        const Detail shadows = detail_kept(floor.picture(1.0, share), reference, floor.hits, size);
        EXPECT_NEAR(shadows.shadow, share, 1e-5);
    }
    const Detail all = detail_kept(floor.picture(1.0, 1.0), reference, floor.hits, size);
    EXPECT_EQ(all.texture_pairs, 15u * size.y); // two of four columns end a board
    EXPECT_EQ(all.shadow_pairs, 6u * size.y);   // both sides of columns 40, 50 and 60
}

TEST(Detail, ABlurTakesIt) {
    const Floor floor;
    const std::vector<float> sharp = floor.picture(1.0, 1.0);
    std::vector<float> blurred = sharp;
    for (int y = 0; y < size.y; ++y)
        for (int x = 1; x + 1 < size.x; ++x)
            for (int c = 0; c < 3; ++c) {
                const std::size_t at = 3 * (static_cast<std::size_t>(y) * size.x + x) + c;
                blurred[at] = (sharp[at - 3] + sharp[at] + sharp[at + 3]) / 3.0f;
            }
    // The mean over three columns has a third of a step at each of three places.
    const Detail detail = detail_kept(blurred, exact(sharp), floor.hits, size);
    EXPECT_NEAR(detail.texture, 1.0 / 3.0, 0.1);
    EXPECT_NEAR(detail.shadow, 1.0 / 3.0, 0.1);
}

TEST(Detail, NoiseIsNone) {
    const Floor floor;
    const std::vector<float> flat = floor.picture(0.0, 0.0);
    std::mt19937 random(6);
    std::normal_distribution<float> noise(0.0f, 0.3f);
    double texture = 0.0, shadow = 0.0;
    constexpr int frames = 50;
    const Reference reference = exact(floor.picture(1.0, 1.0));
    for (int frame = 0; frame < frames; ++frame) {
        std::vector<float> picture = flat;
        for (float& value : picture)
            value += noise(random);
        const Detail detail = detail_kept(picture, reference, floor.hits, size);
        texture += detail.texture / frames;
        shadow += detail.shadow / frames;
    }
    // A step over its own square: the noise of a step, sqrt(2) 0.3 over a mean of some 0.5, over a
    // step of 0.67, by the roots of some 300 pairs and 50 frames.
    EXPECT_NEAR(texture, 0.0, 4.0 * 0.02);
    EXPECT_NEAR(shadow, 0.0, 4.0 * 0.02);
}

TEST(Detail, NoiseOfTheReferenceIsTakenOff) {
    const Floor floor;
    const std::vector<float> sharp = floor.picture(1.0, 1.0);
    std::mt19937 random(7);
    // Of the mean of 16 batches: 0.05, of steps of some 0.4.
    std::normal_distribution<float> noise(0.0f, 0.2f);
    Reference reference(sharp.size());
    for (int batch = 0; batch < 16; ++batch) {
        std::vector<float> values = sharp;
        for (std::size_t i = 0; i < values.size(); i += 3) { // channels share paths
            const float error = noise(random);
            for (int c = 0; c < 3; ++c)
                values[i + c] += error;
        }
        reference.add(values);
    }
    // Without that, a hundredth and more would be missing.
    EXPECT_NEAR(detail_kept(sharp, reference, floor.hits, size).texture, 1.0, 0.03);
}

TEST(Detail, OnlyStepsOnOneSurfaceCount) {
    Floor floor;
    const std::vector<float> sharp = floor.picture(1.0, 1.0);
    const auto spoiled = [&](auto&& spoil) {
        Floor other;
        for (int i = 0; shader::PrimaryHit & hit : other.hits)
            spoil(hit, i++ % size.x);
        return detail_kept(sharp, exact(sharp), other.hits, size);
    };
    const Detail instances = spoiled([](auto& hit, int x) { hit.instance = x; });
    EXPECT_EQ(instances.texture_pairs + instances.shadow_pairs, 0u);
    EXPECT_TRUE(std::isnan(instances.texture));
    EXPECT_TRUE(std::isnan(instances.shadow));
    const Detail steps =
        spoiled([](auto& hit, int x) { hit.position.z = static_cast<float>(x % 2); });
    EXPECT_EQ(steps.texture_pairs + steps.shadow_pairs, 0u);
    const Detail sky = spoiled([](auto& hit, int) { hit.primitive = shader::NONE; });
    EXPECT_EQ(sky.texture_pairs + sky.shadow_pairs, 0u);
}

} // namespace vigil::bench
