// SPDX-License-Identifier: GPL-2.0-or-later
// The filter: its picture is calm, has the light of the raw one and its textures, follows lamps
// that go, changes nothing while it is off, and stays finite whatever comes.
#include "render_test.h"

#include "shared/brdf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <iostream>
#include <numeric>

namespace vigil::test {
namespace {

using Pixels = std::vector<float>;

class Filter : public RenderTest {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        set_size(64, 48);
        shot_.view = {{290, 20, 96}, {5, 55, 0}, 90};
        set("pt_nee", "uniform"); // the noisiest
    }

    /// The frame after `before` others; all random numbers start anew with the level.
    Pixels picture(std::string_view level, int before) {
        load(level);
        return next(before);
    }
    Pixels next(int before = 0) {
        for (int i = 0; i < before; ++i)
            renderer().render(shot_.frame());
        return radiance(shot_).rgb;
    }
    /// The mean of `frames` raw frames.
    Pixels converged(int frames) {
        set("flt_enable", "0");
        set("pt_accumulate", "1");
        Pixels result = next(frames - 1);
        set("pt_accumulate", "0");
        return result;
    }
    static float brightness(const Pixels& pixels, size_t pixel) {
        return shader::luminance({pixels[3 * pixel], pixels[3 * pixel + 1], pixels[3 * pixel + 2]});
    }
    static double squared_difference(const Pixels& a, const Pixels& b) {
        double sum = 0.0;
        for (size_t i = 0; i < a.size(); ++i)
            sum += (static_cast<double>(a[i]) - b[i]) * (static_cast<double>(a[i]) - b[i]);
        return sum / static_cast<double>(a.size());
    }
    /// Sum over what only reflects light: lamps are far brighter.
    static double light_of(const Pixels& pixels, const Pixels& expected) {
        double sum = 0.0;
        for (size_t i = 0; i < pixels.size() / 3; ++i)
            if (brightness(expected, i) < 2.0f) sum += static_cast<double>(brightness(pixels, i));
        return sum;
    }
    /// Sum over the same of how far brightnesses are off.
    static double distance(const Pixels& pixels, const Pixels& expected) {
        double sum = 0.0;
        for (size_t i = 0; i < pixels.size() / 3; ++i)
            if (brightness(expected, i) < 2.0f)
                sum += std::abs(brightness(pixels, i) - brightness(expected, i));
        return sum;
    }
    /// Mean over the pixels of the variance of their brightness over `frames` frames.
    double flicker(int frames) {
        std::vector<double> sum, squares;
        for (int frame = 0; frame < frames; ++frame) {
            const Pixels pixels = next();
            sum.resize(pixels.size() / 3);
            squares.resize(sum.size());
            for (size_t i = 0; i < sum.size(); ++i) {
                const double value = brightness(pixels, i);
                sum[i] += value;
                squares[i] += value * value;
            }
        }
        double variance = 0.0;
        for (size_t i = 0; i < sum.size(); ++i)
            variance += squares[i] / frames - sum[i] * sum[i] / (1.0 * frames * frames);
        return variance / static_cast<double>(sum.size());
    }

    Shot shot_;
};

TEST_F(Filter, MakesACalmPictureOfTheSameLight) {
    load("rooms");
    set("pt_nee", "sll");
    set("flt_firefly", "0"); // which takes light away
    next(31);
    const double raw_flicker = flicker(16);
    const Pixels raw = next();
    set("flt_enable", "1");
    next(63);
    const double filtered_flicker = flicker(16);
    const Pixels filtered = next();
    const Pixels expected = converged(256);
    const double error = squared_difference(filtered, expected) / squared_difference(raw, expected);
    const double light = light_of(filtered, expected) / light_of(expected, expected);
    std::cout << fmt::format("flicker 1/{:.0f}, squared error 1/{:.1f}, light {:+.2f}%\n",
                             raw_flicker / filtered_flicker, 1.0 / error, 100.0 * (light - 1.0));
    EXPECT_LT(filtered_flicker, raw_flicker / 50.0);
    EXPECT_LT(error, 1.0 / 15.0);
    EXPECT_NEAR(light, 1.0, 0.02);
}

TEST_F(Filter, APictureThatStandsStillGainsNoContrast) {
    // All camera rays of a frame pass through one point of their pixels, and another one in the
    // next: if that moved the past, each frame would sharpen or blur what the one before has left.
    files().mount_folder(std::filesystem::path(VIGIL_SOURCE_DIR) / "baseq2");
    load("gallery");
    shot_.view = {{306, 214, 62}, {-8, -30, 0}, 72}; // a statue of small triangles, and columns
    set("pt_nee", "sll");
    set("flt_enable", "1");
    set("flt_firefly", "0");
    set("flt_history", "1000");
    set("pt_jitter", "1");
    const Pixels filtered = next(255);
    const Pixels expected = converged(512);
    const double off = distance(filtered, expected) / light_of(expected, expected);
    std::cout << fmt::format("off by {:.1f}%\n", 100.0 * off);
    EXPECT_LT(off, 0.3);
}

TEST_F(Filter, TheFirstPictureOfALevelIsCalm) {
    set("flt_enable", "1");
    set("flt_atrous", "0"); // what frames before bring, and not neighbours
    const Pixels noisy = picture("rooms", 0);
    const Pixels ninth = picture("rooms", 8);
    set("flt_first", "8");
    const Pixels first = picture("rooms", 0);
    EXPECT_EQ(first, ninth);
    load("rooms");
    const uint64_t number = renderer().render(shot_.frame());
    EXPECT_EQ(renderer().render(shot_.frame()), number + 1); // once for a level
    // A demo that is timed shows all that it traces.
    load("rooms");
    refresh::Frame timed = shot_.frame();
    timed.uncapped = true;
    renderer().render(timed);
    const Pixels as_timed = renderer().read_radiance().rgb;
    const Pixels expected = converged(256);
    const double error = squared_difference(noisy, expected);
    std::cout << fmt::format("squared error of the first picture: 1/{:.1f}; as timed {:.3f}\n",
                             error / squared_difference(first, expected),
                             squared_difference(as_timed, expected) / error);
    EXPECT_LT(squared_difference(first, expected), 0.2 * error);
    EXPECT_GT(squared_difference(as_timed, expected), 0.8 * error);
}

/// Sums of light over a picture's pixels that reflect it, one for each seed.
struct Sums {
    std::vector<double> of;
    double mean() const {
        return std::accumulate(of.begin(), of.end(), 0.0) / static_cast<double>(of.size());
    }
    /// Of the mean.
    double variance() const {
        double squares = 0.0;
        for (const double sum : of)
            squares += (sum - mean()) * (sum - mean());
        const auto count = static_cast<double>(of.size());
        return squares / (count * (count - 1.0));
    }
};

TEST_F(Filter, HalfOfTheIndirectLightHasTheMeanOfAll) {
    constexpr int frames = 64, seeds = 12;
    set_size(48, 32);
    load("rooms");
    set("pt_nee", "sll");
    const Pixels expected = converged(64);
    set("pt_bounces", "0");
    const double direct = light_of(converged(64), expected);
    set("pt_bounces", "1");
    set("flt_enable", "1");
    set("flt_firefly", "0"); // which takes light away
    set("flt_taa", "0");     // which leaves some frames out
    set("flt_history", "1000");
    const auto sums_at = [&](const char* rate) {
        set("pt_indirect_rate", rate);
        Sums sums;
        for (int seed = 0; seed < seeds; ++seed) {
            set("pt_seed", std::to_string(seed));
            renderer().reset_guiding();
            sums.of.push_back(light_of(next(frames - 1), expected));
        }
        return sums;
    };
    const Sums full = sums_at("full"), half = sums_at("half");
    const double indirect = full.mean() - direct;
    ASSERT_GT(indirect, 0.2 * direct) << "there is indirect light";
    const double error = std::sqrt(full.variance() + half.variance());
    const double difference = half.mean() - full.mean();
    std::cout << fmt::format("half against all: {:+.2f}% +- {:.2f}% of the indirect light\n",
                             100.0 * difference / indirect, 100.0 * error / indirect);
    EXPECT_LT(error, 0.01 * indirect) << "4% too much or too little are seen";
    EXPECT_LT(std::abs(difference), 3.5 * error);
}

TEST_F(Filter, FollowsACameraThatMoves) {
    const refresh::View start = shot_.view;
    const auto error_after_flight = [&] {
        load("rooms");
        shot_.view = start;
        set("flt_enable", "1");
        set("flt_taa", "0"); // which rounds the edges of lamps, the brightest of all
        for (int frame = 0; frame < 40; ++frame) {
            shot_.view.angles.y += 0.3f;
            shot_.view.origin.y += 0.5f;
            renderer().render(shot_.frame());
        }
        const Pixels filtered = next();
        set("flt_enable", "0");
        const Pixels raw = next();
        const Pixels expected = converged(256);
        return squared_difference(filtered, expected) / squared_difference(raw, expected);
    };
    const double error = error_after_flight();
    set("flt_history_moving", "1000"); // edges of light would grow soft
    const double error_of_long_past = error_after_flight();
    std::cout << fmt::format("squared error 1/{:.1f}, with a long past 1/{:.1f}\n", 1.0 / error,
                             1.0 / error_of_long_past);
    EXPECT_LT(error, 1.0 / 10.0);
    EXPECT_LT(error, 0.95 * error_of_long_past);
}

TEST_F(Filter, SurfacesThatComeIntoViewHaveNoSpeckles) {
    load("rooms");
    set("flt_enable", "1");
    set("flt_taa", "0");
    int speckles = 0, of = 0;
    double few_passes = 0.0, all_passes = 0.0;
    for (int cut = 0; cut < 6; ++cut) {
        const auto first_picture = [&](const char* passes) {
            set("flt_atrous", passes);
            shot_.view.angles.y += 180.0f;
            next(20);
            shot_.view.angles.y -= 180.0f;
            return next();
        };
        shot_.view.angles.y += 60.0f;
        const Pixels three = first_picture("3"), five = first_picture("5");
        const Pixels expected = converged(128);
        set("flt_enable", "1");
        few_passes += squared_difference(three, expected);
        all_passes += squared_difference(five, expected);
        for (size_t y = 1; y < 47; ++y)
            for (size_t x = 1; x < 63; ++x) {
                std::array<float, 9> around;
                for (size_t i = 0; i < 9; ++i)
                    around[i] = brightness(three, 64 * (y + i / 3 - 1) + x + i % 3 - 1);
                const float own = around[4];
                std::ranges::nth_element(around, &around[4]);
                const size_t pixel = 64 * y + x;
                ++of;
                if (own > 2.0f * around[4] && own > 2.0f * brightness(expected, pixel)) ++speckles;
            }
    }
    std::cout << fmt::format("speckles {} of {}, squared error by five passes {:.2f} of three\n",
                             speckles, of, all_passes / few_passes);
    EXPECT_LT(speckles, of / 500);
    EXPECT_LT(all_passes, 0.9 * few_passes);
}

TEST_F(Filter, SurfacesThatComeIntoViewHaveNoGrid) {
    // Passes that look far join pixels of one grid: what one grid has more than the next must not
    // be left.
    set("flt_enable", "1");
    const Pixels first = picture("rooms", 0);
    set("pt_nee", "sll");
    const Pixels expected = converged(512);
    const auto off = [&](size_t pixel) {
        return brightness(first, pixel) / brightness(expected, pixel) - 1.0f;
    };
    const size_t width = 64;
    double between = 0.0, all = 0.0; // how far off pixels are: from both beside, and from the truth
    for (const size_t step : {size_t{1}, width})
        for (size_t pixel = step; pixel + step < expected.size() / 3; ++pixel) {
            const bool ends_row = pixel % width == 0 || pixel % width == width - 1;
            if (step == 1 && ends_row) continue;
            const float own = brightness(expected, pixel);
            const auto is_like = [&](size_t other) { // no edge lies between, nor a lamp there
                return std::abs(brightness(expected, other) - own) < 0.1f * own && own < 2.0f;
            };
            if (!is_like(pixel - step) || !is_like(pixel + step)) continue;
            between += std::abs(off(pixel) - 0.5f * (off(pixel - step) + off(pixel + step)));
            all += std::abs(off(pixel));
        }
    std::cout << fmt::format("{:.3f} of the error is between neighbours\n", between / all);
    EXPECT_LT(between, 0.3 * all);
}

TEST_F(Filter, PaintKeepsItsPastWhileTheCameraMoves) {
    load_with_materials("rooms", R"({"test/white50": {"roughness": 0.3, "specular": 0.04},
                        "test/grey20": {"roughness": 0.3, "specular": 0.04}})");
    ASSERT_TRUE(renderer().scene()->features().gloss);
    set("flt_enable", "1");
    set("flt_taa", "0");
    set("flt_atrous", "0"); // the past alone
    double error = 0.0, raw_error = 0.0;
    for (int place = 0; place < 4; ++place) {
        for (int frame = 0; frame < 12; ++frame) {
            const float step = place % 2 == 0 ? -3.0f : 3.0f; // to the side
            shot_.view.origin += step * glm::vec3(0.82f, -0.57f, 0.0f);
            renderer().render(shot_.frame());
        }
        const Pixels filtered = next();
        set("flt_enable", "0");
        const Pixels raw = next();
        const Pixels expected = converged(256);
        set("flt_enable", "1");
        error += distance(filtered, expected);
        raw_error += distance(raw, expected);
    }
    std::cout << fmt::format("error 1/{:.1f}\n", raw_error / error);
    EXPECT_LT(error, raw_error / 2.5);
}

TEST_F(Filter, AModelKeepsItsPastWhateverComesBeforeItInTheList) {
    load("rooms");
    shot_.view = {{40, 40, 60}, {0, 25, 0}, 90};
    set("flt_taa", "0");
    set("flt_atrous", "0"); // the past alone
    refresh::Entity door, other;
    door.number = 2;
    door.model = other.model = renderer().register_model("*1");
    door.origin = {-40, -20, 20};
    other.number = 1;
    other.origin = {0, 0, -2000};
    shot_.entities = {door};
    const Pixels expected = converged(256);
    const std::vector<shader::PrimaryHit> hits = primary_hits();
    ASSERT_GT(std::ranges::count(hits, 1u, &shader::PrimaryHit::instance), 100);
    // Of what shows the door.
    const auto off = [&](const Pixels& pixels) {
        double sum = 0.0;
        for (size_t i = 0; i < hits.size(); ++i)
            if (hits[i].instance == 1)
                sum += std::abs(brightness(pixels, i) - brightness(expected, i));
        return sum;
    };
    const double raw = off(next());
    set("flt_enable", "1");
    const double alone = off(next(23));
    for (int frame = 0; frame < 24; ++frame) {
        shot_.entities = {door};
        if (frame % 2 == 0) shot_.entities.insert(shot_.entities.begin(), other);
        if (frame < 23) renderer().render(shot_.frame());
    }
    const double with_others = off(next());
    std::cout << fmt::format("error 1/{:.1f}, with others 1/{:.1f}\n", raw / alone,
                             raw / with_others);
    EXPECT_LT(alone, raw / 2.0);
    EXPECT_LT(with_others, 1.3 * alone);
}

TEST_F(Filter, ForgetsALampThatIsGone) {
    load("rooms");
    set("pt_nee", "sll"); // which finds the lamp at once
    set("pt_bounces", "0");
    const Pixels without = converged(256);
    set("flt_enable", "1");
    shot_.dynamic_lights = {{7, {330, 80, 100}, 4.0f, {2000, 2000, 2000}, false}};
    const Pixels with = next(40);
    shot_.dynamic_lights.clear();
    const auto excess = [&](const Pixels& pixels) { return sum_of(pixels) - sum_of(without); };
    ASSERT_GT(excess(with), 0.3 * sum_of(without)) << "the lamp lights what is seen";
    const double after_four = excess(next(3)) / excess(with);
    set("flt_antilag", "0");
    shot_.dynamic_lights = {{7, {330, 80, 100}, 4.0f, {2000, 2000, 2000}, false}};
    next(40);
    shot_.dynamic_lights.clear();
    const double without_antilag = excess(next(3)) / excess(with);
    std::cout << fmt::format("left after 4 frames: {:.1f}%, without flt_antilag {:.1f}%\n",
                             100.0 * after_four, 100.0 * without_antilag);
    EXPECT_LT(std::abs(after_four), 0.1);
    EXPECT_GT(without_antilag, 0.5);
}

TEST_F(Filter, ShowsALampThatComes) {
    load("rooms");
    set("pt_nee", "sll"); // which finds the lamp at once
    set("pt_bounces", "0");
    set("flt_enable", "1");
    const Pixels before = next(40);
    shot_.dynamic_lights = {{7, {330, 80, 100}, 4.0f, {2000, 2000, 2000}, false}};
    const Pixels after = next(3);
    const Pixels expected = converged(256);
    const double shown = (sum_of(after) - sum_of(before)) / (sum_of(expected) - sum_of(before));
    std::cout << fmt::format("shown after 4 frames: {:.1f}%\n", 100.0 * shown);
    EXPECT_GT(shown, 0.9);
    EXPECT_LT(shown, 1.1);
}

TEST_F(Filter, ChangesNothingWhileItIsOff) {
    const Pixels before = picture("rooms", 2);
    set("flt_enable", "1");
    EXPECT_NE(picture("rooms", 2), before);
    set("flt_enable", "0");
    EXPECT_EQ(picture("rooms", 2), before);
    // Nor does it choose pixels that trace indirect light.
    set("pt_indirect_rate", "half");
    EXPECT_EQ(picture("rooms", 2), before);
    // Neither does it where a reference is made.
    set("pt_accumulate", "1");
    const Pixels reference = picture("rooms", 2);
    set("flt_enable", "1");
    EXPECT_EQ(picture("rooms", 2), reference);
}

TEST_F(Filter, LeavesTheRawSideOfAComparisonAlone) {
    const Pixels raw = picture("rooms", 2);
    set("flt_enable", "1");
    set("pt_indirect_rate", "half");
    set("pt_compare", "raw");
    const Pixels compared = picture("rooms", 2);
    int left = 0, right = 0;
    for (size_t y = 0; y < 48; ++y)
        for (size_t x = 0; x < 64; ++x) {
            const size_t i = 3 * (64 * y + x);
            (x < 32 ? left : right) += !std::equal(&raw[i], &raw[i] + 3, &compared[i]);
        }
    // Where a translucent surface is seen, the filter's frames see another one.
    EXPECT_GT(left, 32 * 48 / 2);
    EXPECT_LT(right, 32 * 48 / 20);
}

TEST_F(Filter, StaysFiniteWhateverComes) {
    set("flt_enable", "1");
    set("pt_jitter", "1");
    const auto is_fine = [&](const char* what) {
        EXPECT_TRUE(all_finite_nonnegative(next())) << what;
    };
    load("rooms");
    is_fine("the first frame");
    shot_.view.origin += glm::vec3(0, 40, 10);
    shot_.view.angles.y += 170.0f;
    is_fine("a cut");
    set_size(33, 17);
    is_fine("another size");
    for (const char* percent : {"50", "25", "100"}) {
        set("vid_scale", percent);
        is_fine(percent);
    }
    set("vid_fps_target", "1000"); // never reached: sizes go down frame by frame
    for (int frame = 0; frame < 30; ++frame)
        is_fine("a size that changes");
    set("vid_fps_target", "0");
    is_fine("all pixels again");
    set("pt_indirect_rate", "half");
    is_fine("half of the indirect light");
    shot_.view.angles.y -= 150.0f;
    is_fine("a cut at half rate");
    set("flt_history", "1");
    is_fine("a history of one frame");
    set("flt_history", "1000");
    is_fine("a long history");
    for (const char* steps : {"0", "1", "6"}) {
        set("flt_atrous", steps);
        is_fine(steps);
    }
    set("flt_sigma", "0");
    is_fine("no tolerance");
    set("flt_taa", "0");
    is_fine("no anti-aliasing");
    set("flt_taa", "1");
    is_fine("anti-aliasing again");
    set("pt_emissive_scale", "1e6");
    is_fine("very bright");
    set("pt_emissive_scale", "0");
    is_fine("no light");
    set("pt_spp", "3");
    is_fine("several paths");
    load("opensky");
    shot_.view = {{-192, -64, 56}, {0, 20, 0}, 90};
    is_fine("another level");
    shot_.view.angles = {-89, 0, 0};
    is_fine("nothing but sky");
    set_size(16, 16);
    is_fine("the smallest picture");
}

} // namespace
} // namespace vigil::test
