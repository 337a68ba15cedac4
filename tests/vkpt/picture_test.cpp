// SPDX-License-Identifier: GPL-2.0-or-later
// From radiance to the picture: running means, automatic exposure, tone curves and the sRGB
// encoding, held against the same in double precision on the host.
#include "refresh/vkpt/gpu/commands.h"
#include "render_test.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace vigil::test {
namespace {

using glm::dvec3;

double luminance(const dvec3& color) {
    return glm::dot(color, dvec3(0.2126, 0.7152, 0.0722));
}

/// Mean over the 8 x 8 tiles that are not black of the cube root of their mean luminance.
double mean_tile_root(const std::vector<dvec3>& colors, int width, int height) {
    double roots = 0.0, tiles = 0.0;
    for (int top = 0; top < height; top += 8) {
        for (int left = 0; left < width; left += 8) {
            double sum = 0.0, count = 0.0;
            for (int y = top; y < std::min(top + 8, height); ++y) {
                for (int x = left; x < std::min(left + 8, width); ++x) {
                    sum += luminance(colors[static_cast<size_t>(y * width + x)]);
                    count += 1.0;
                }
            }
            if (sum / count <= 1e-6) continue;
            roots += std::cbrt(sum / count);
            tiles += 1.0;
        }
    }
    return roots / tiles;
}

/// Displayed value in 0..255 of one pixel, not rounded.
dvec3 displayed(dvec3 color, double exposure, int curve) {
    color *= exposure;
    if (curve == 1) color *= (1.0 + luminance(color) / 16.0) / (1.0 + luminance(color));
    if (curve == 2) {
        color *= 0.8;
        color = color * (2.51 * color + 0.03) / (color * (2.43 * color + 0.59) + 0.14);
    }
    for (glm::length_t c = 0; c < 3; ++c) {
        const double linear = std::clamp(color[c], 0.0, 1.0);
        color[c] = 255.0 * (linear <= 0.0031308 ? 12.92 * linear
                                                : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055);
    }
    return color;
}

class PictureTest : public RenderTest {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        load("rooms");
        shot_.view = {{290, 20, 96}, {5, 55, 0}, 90};
        set("pt_nee", "uniform");
    }

    Shot shot_;
};

TEST_F(PictureTest, ExposureAndToneCurves) {
    set("pt_spp", "4");
    for (const int curve : {0, 1, 2}) {
        for (const double exposure : {0.0, 0.7}) {
            for (const double bias : {0.0, 1.5, -3.0}) {
                set("pt_tonemap", std::to_string(curve));
                set("pt_exposure", fmt::format("{}", exposure));
                set("pt_exposure_bias", fmt::format("{}", bias));
                const refresh::RadiancePicture seen = radiance(shot_);
                const refresh::Picture picture = renderer().read_picture(false);
                ASSERT_EQ(picture.width * picture.height, seen.width * seen.height);
                const auto pixels = static_cast<size_t>(seen.width * seen.height);
                std::vector<dvec3> colors;
                for (size_t i = 0; i < pixels; ++i)
                    colors.push_back(
                        dvec3(seen.rgb[3 * i], seen.rgb[3 * i + 1], seen.rgb[3 * i + 2]));
                const double root = mean_tile_root(colors, seen.width, seen.height);
                const double factor =
                    (exposure > 0.0 ? exposure : 0.18 / std::pow(root, 3.0)) * std::exp2(bias);
                for (size_t i = 0; i < pixels; ++i) {
                    const dvec3 expected = displayed(colors[i], factor, curve);
                    for (size_t c = 0; c < 3; ++c)
                        ASSERT_NEAR(picture.rgba[4 * i + c],
                                    expected[static_cast<glm::length_t>(c)], 0.55)
                            << "curve " << curve << " exposure " << exposure << " bias " << bias
                            << " pixel " << i;
                    ASSERT_EQ(picture.rgba[4 * i + 3], 255);
                }
            }
        }
    }
}

TEST_F(PictureTest, AccumulationIsTheMeanOfItsFrames) {
    radiance(shot_);
    constexpr uint32_t frames = 6;
    std::vector<double> mean;
    for (uint32_t i = 0; i < frames; ++i) {
        vkpt::FrameDescription single = params(shot_);
        single.frame = 77 + i;
        const std::vector<float> seen = trace(single, 1);
        mean.resize(seen.size());
        for (size_t k = 0; k < seen.size(); ++k)
            mean[k] += static_cast<double>(seen[k]) / frames;
    }
    std::vector<float> running;
    for (uint32_t i = 0; i < frames; ++i) {
        vkpt::FrameDescription next = params(shot_);
        next.frame = 77 + i;
        next.accumulated = i;
        running = trace(next, 1);
    }
    for (size_t k = 0; k < mean.size(); ++k)
        ASSERT_NEAR(running[k], mean[k], 1e-5 * mean[k] + 1e-7) << k;

    // Paths of one frame are those of as many frames: spp and frames number them alike.
    vkpt::FrameDescription at_once = params(shot_);
    at_once.frame = 0;
    const std::vector<float> together = trace(at_once, 4);
    std::vector<double> apart(together.size());
    for (uint32_t i = 0; i < 4; ++i) {
        at_once.frame = i;
        const std::vector<float> seen = trace(at_once, 1);
        for (size_t k = 0; k < seen.size(); ++k)
            apart[k] += static_cast<double>(seen[k]) / 4.0;
    }
    for (size_t k = 0; k < apart.size(); ++k)
        ASSERT_NEAR(together[k], apart[k], 1e-5 * apart[k] + 1e-7) << k;
}

TEST_F(PictureTest, AccumulationGoesOnUntilSomethingChanges) {
    EXPECT_EQ(radiance(shot_).frames, 1);
    EXPECT_EQ(radiance(shot_).frames, 1) << "nothing accumulates by itself";
    set("pt_accumulate", "1");
    const auto count = [&] { return radiance(shot_).frames; };
    EXPECT_EQ(count(), 1);
    EXPECT_EQ(count(), 2);
    EXPECT_EQ(count(), 3);
    // What comes after the mean does not touch it.
    set("pt_tonemap", "none");
    set("pt_exposure_bias", "1");
    set("pt_view", "normal");
    EXPECT_EQ(count(), 4);
    set("pt_view", "none");
    // What the mean depends on starts it anew.
    const auto expect_restart = [&](const char* what) {
        EXPECT_EQ(count(), 1) << what;
        EXPECT_EQ(count(), 2) << what;
    };
    shot_.view.origin.x += 1.0f;
    expect_restart("the camera moved");
    shot_.view.angles.y += 1.0f;
    expect_restart("the camera turned");
    set("pt_nee", "power");
    expect_restart("another technique");
    set("pt_emissive_scale", "2");
    expect_restart("brighter lamps");
    set("pt_spp", "2");
    expect_restart("more paths");
    set("pt_seed", "5");
    expect_restart("another seed");
    shot_.dynamic_lights = {{1, {400, 100, 80}, 4.0f, {1, 1, 1}}};
    expect_restart("a light appeared");
    shot_.dynamic_lights[0].origin.z += 1.0f;
    EXPECT_EQ(count(), 1) << "a light moved";
    set_size(64, 32);
    expect_restart("another size");
    // Moving on ends it in the same frame: the mean holds nothing of the view before.
    const std::vector<float> still = radiance(shot_).rgb;
    set("pt_accumulate", "0");
    const refresh::RadiancePicture alone = radiance(shot_);
    EXPECT_EQ(alone.frames, 1);
    EXPECT_NE(alone.rgb, still);
}

TEST_F(PictureTest, FewerPixelsThanThePictureAreScaledUp) {
    set_size(64, 48);
    set("pt_exposure", "1");
    set("pt_accumulate", "1");
    const auto picture = [&](const char* percent) {
        set("vid_scale", percent);
        for (int frame = 0; frame < 24; ++frame)
            renderer().render(shot_.frame());
        EXPECT_EQ(renderer().read_radiance().width, 64 * std::stoi(percent) / 100);
        refresh::Picture seen = renderer().read_picture(false);
        EXPECT_EQ(seen.width, 64);
        EXPECT_EQ(seen.height, 48);
        return seen.rgba;
    };
    const std::vector<uint8_t> whole = picture("100");
    const std::vector<uint8_t> scaled = picture("50");
    set_size(32, 24);
    for (int frame = 0; frame < 24; ++frame)
        renderer().render(shot_.frame());
    EXPECT_EQ(renderer().read_radiance().width, 16) << "of another picture, too";
    set("vid_scale", "100");
    for (int frame = 0; frame < 24; ++frame)
        renderer().render(shot_.frame());
    const std::vector<uint8_t> half = renderer().read_picture(false).rgba;
    double error = 0.0, nearest_error = 0.0;
    for (size_t y = 0; y < 48; ++y)
        for (size_t x = 0; x < 64; ++x)
            for (size_t c = 0; c < 3; ++c) {
                const double expected = whole[4 * (64 * y + x) + c];
                error += std::pow(scaled[4 * (64 * y + x) + c] - expected, 2.0);
                nearest_error += std::pow(half[4 * (32 * (y / 2) + x / 2) + c] - expected, 2.0);
            }
    EXPECT_GT(error, 0.0);
    EXPECT_LT(error, 0.8 * nearest_error) << "repeating pixels would do as well";
}

TEST_F(PictureTest, ARateThatIsReachedChangesNoPixel) {
    load("rooms");
    radiance(shot_);
    const std::vector<uint8_t> plain = renderer().read_picture(false).rgba;
    set("vid_fps_target", "0.001");
    load("rooms"); // the same random numbers again
    radiance(shot_);
    EXPECT_EQ(renderer().read_picture(false).rgba, plain);
}

TEST_F(PictureTest, SameSeedSamePicture) {
    radiance(shot_);
    vkpt::FrameDescription frame = params(shot_);
    const std::vector<float> once = trace(frame, 2), again = trace(frame, 2);
    EXPECT_EQ(once, again);
    frame.settings.pt_seed = 1;
    EXPECT_NE(once, trace(frame, 2));
}

} // namespace
} // namespace vigil::test
