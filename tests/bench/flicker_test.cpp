// SPDX-License-Identifier: GPL-2.0-or-later
// Flicker of pictures whose noise is known, standing still and past a camera that moves.
#include "bench/flicker.h"

#include "shared/brdf.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <utility>
#include <vector>

namespace vigil::bench {

namespace {

constexpr glm::uvec2 size{64, 32};

/// A camera that looks along +x at the wall x = 100 and moves along -y, to its right.
shader::FrameParams camera_at(float right) {
    shader::FrameParams camera{};
    camera.camera_origin = {0.0f, -right, 0.0f};
    camera.camera_forward = {1.0f, 0.0f, 0.0f};
    camera.camera_right = {0.0f, -1.0f, 0.0f};
    camera.camera_up = {0.0f, 0.0f, 0.5f};
    camera.size = size;
    camera.pixel_angle = 1.0f / 32.0f;
    return camera;
}
constexpr float pixel_width = 100.0f / 32.0f; // of the wall

/// Light of the wall at a point.
using Light = std::function<double(const glm::vec3& point)>;

/// What the camera sees of the wall, in stripes of two colours.
SeenFrame frame_at(float right, const Light& light, unsigned instance = 1) {
    const shader::FrameParams camera = camera_at(right);
    std::vector<float> rgb;
    std::vector<shader::PrimaryHit> hits;
    for (unsigned y = 0; y < size.y; ++y)
        for (unsigned x = 0; x < size.x; ++x) {
            const float across = (static_cast<float>(x) + 0.5f) / (0.5f * size.x) - 1.0f;
            const float down = (static_cast<float>(y) + 0.5f) / (0.5f * size.y) - 1.0f;
            shader::PrimaryHit hit{};
            hit.position = camera.camera_origin +
                           100.0f * (camera.camera_forward + across * camera.camera_right -
                                     down * camera.camera_up);
            hit.normal = {-1.0f, 0.0f, 0.0f};
            hit.albedo = glm::vec3(std::fmod(hit.position.y + 1000.0f, 8.0f) < 4.0f ? 0.2f : 0.8f);
            hit.primitive = 7;
            hit.instance = instance;
            hits.push_back(hit);
            const auto value = static_cast<float>(light(hit.position));
            for (int c = 0; c < 3; ++c)
                rgb.push_back(hit.albedo[c] * value);
        }
    return seen_frame(rgb, std::move(hits), camera);
}

/// Differs from pixel to pixel of the wall.
double pattern(const glm::vec3& point) {
    const double column = std::floor(static_cast<double>(point.y / pixel_width) + 0.25);
    const double line = std::floor(static_cast<double>(point.z / pixel_width) + 0.25);
    return 2.0 + std::sin(2.1 * column + 78.2 * line);
}

} // namespace

TEST(Flicker, IsTheMeanVarianceOfLuminance) {
    Flicker flicker;
    // The first pixel has the luminances 1, 2 and 6, whose variance is 7; the second always 5.
    for (const float value : {1.0f, 2.0f, 6.0f})
        flicker.add(std::vector<float>{value, value, value, 5.0f, 5.0f, 5.0f});
    EXPECT_NEAR(flicker.variance(), 3.5, 1e-6);
    Flicker green;
    for (const float value : {0.0f, 1.0f})
        green.add(std::vector<float>{0.0f, value, 0.0f});
    EXPECT_NEAR(green.variance(), 0.5 * std::pow(shader::luminance({0.0f, 1.0f, 0.0f}), 2.0f),
                1e-6);
}

TEST(MovingFlicker, PointsAreFoundAgain) {
    // Steps of a whole number of pixels: the same points are seen again, and nothing flickers.
    for (const float pixels : {0.0f, 1.0f, 5.0f, -3.0f})
        EXPECT_NEAR(
            moving_flicker(frame_at(0.0f, pattern), frame_at(pixels * pixel_width, pattern)), 0.0,
            1e-9)
            << pixels;
    // It would, were they looked for one pixel further.
    SeenFrame wrong = frame_at(0.0f, pattern);
    wrong.camera = camera_at(pixel_width);
    for (shader::PrimaryHit& hit : wrong.hits)
        hit.position.y -= pixel_width;
    EXPECT_GT(moving_flicker(wrong, frame_at(pixel_width, pattern)), 0.1);
}

TEST(MovingFlicker, IsTheVarianceOfIndependentNoise) {
    constexpr double sigma = 0.3;
    std::mt19937 random(5);
    std::normal_distribution<double> noise(2.0, sigma);
    double sum = 0.0;
    constexpr int pairs = 40;
    for (int pair = 0; pair < pairs; ++pair) {
        const auto light = [&](const glm::vec3&) { return noise(random); };
        sum += moving_flicker(frame_at(0.0f, light), frame_at(3.0f * pixel_width, light)) / pairs;
    }
    // Half a squared difference of two has the standard deviation sqrt(2) sigma^2.
    const double error = std::sqrt(2.0 / (pairs * (size.x - 3.0) * size.y)) * sigma * sigma;
    EXPECT_NEAR(sum, sigma * sigma, 4.0 * error);
}

TEST(MovingFlicker, OnlyPointsCountThatBothSaw) {
    const Light half = [](const glm::vec3& point) { return point.y > 0.0f ? 1.0 : 9.0; };
    // Half of each: what is right of the first frame, it did not see.
    SeenFrame before = frame_at(0.0f, half);
    SeenFrame now = frame_at(32.0f * pixel_width, half);
    EXPECT_EQ(moving_flicker(before, now), 0.0);
    // Other surfaces: another instance, another direction, another plane, nothing to light.
    EXPECT_TRUE(std::isnan(moving_flicker(frame_at(0.0f, half, 2), now)));
    EXPECT_TRUE(std::isnan(moving_flicker(frame_at(1000.0f, half), now)));
    const auto spoiled = [&](auto&& spoil) {
        SeenFrame other = before;
        for (shader::PrimaryHit& hit : other.hits)
            spoil(hit);
        return moving_flicker(other, now);
    };
    EXPECT_TRUE(std::isnan(spoiled([](auto& hit) { hit.normal = {0.0f, 0.0f, 1.0f}; })));
    EXPECT_TRUE(std::isnan(spoiled([](auto& hit) { hit.position.x += 20.0f; })));
    std::vector<shader::PrimaryHit> none = before.hits;
    for (shader::PrimaryHit& hit : none)
        hit.primitive = shader::NONE;
    const std::vector<float> rgb(3 * none.size(), 1.0f);
    EXPECT_TRUE(std::isnan(moving_flicker(seen_frame(rgb, none, camera_at(0.0f)), now)));
}

} // namespace vigil::bench
