// SPDX-License-Identifier: GPL-2.0-or-later
// What the choice of lights knows of sky and sun: the brightness of the sky through a plane, the
// sun as a triangle, and both among the lights of a frame.
#include "common/file_system.h"
#include "common/scratch_folder.h"
#include "formats/picture_bytes.h"
#include "formats/sky.h"
#include "light/form_factor_reference.h"
#include "refresh/vkpt/light/light_power.h"
#include "refresh/vkpt/scene/light_set.h"
#include "refresh/vkpt/scene/sun.h"
#include "refresh/vkpt/scene/transform.h"
#include "shared/ltc.h"

#include <array>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <random>

namespace vigil::vkpt {
namespace {

constexpr float pi = 3.14159265f;

std::vector<glm::vec3> directions(int count) {
    std::mt19937 random(3);
    std::normal_distribution<float> normal;
    std::vector<glm::vec3> all{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    while (static_cast<int>(all.size()) < count)
        all.push_back(glm::normalize(glm::vec3(normal(random), normal(random), normal(random))));
    return all;
}

/// A sky whose sides are of one colour each.
SkyBrightness flat_sky(const std::array<glm::vec3, 6>& sides, glm::vec3 factor = glm::vec3(1.0f),
                       bool turns = false) {
    const FileSystem files;
    TextureSet textures(files);
    std::vector<const TextureSet::Entry*> entries;
    for (const glm::vec3& color : sides)
        entries.push_back(&textures.flat(color));
    const uint32_t first = textures.consecutive(entries);
    return SkyBrightness(textures, first, factor, turns);
}

std::array<glm::vec3, 6> sides_of(float all, float up) {
    std::array<glm::vec3, 6> sides;
    sides.fill(glm::vec3(all));
    sides[4] = glm::vec3(up);
    return sides;
}

TEST(SkyBrightness, OfAnEvenSkyIsItsRadiance) {
    const glm::vec3 radiance(0.5f, 0.75f, 1.0f);
    std::array<glm::vec3, 6> sides;
    sides.fill(radiance);
    const SkyBrightness plain(radiance), pictures = flat_sky(sides, glm::vec3(2.0f));
    for (const glm::vec3& outwards : directions(200)) {
        EXPECT_EQ(plain.through(outwards), radiance);
        EXPECT_LT(glm::distance(pictures.through(outwards), 2.0f * radiance), 1e-3f);
    }
}

TEST(SkyBrightness, OfABrightTopFollowsItsFormFactor) {
    const SkyBrightness sky = flat_sky(sides_of(0.0f, 3.0f));
    // A square of 2 by 2 at distance 1 (Howell's catalogue, B-4, four corners).
    const float corner = std::atan(1.0f / std::sqrt(2.0f)) / std::sqrt(2.0f) / pi;
    const float above = 4.0f * corner, beside = 0.25f * (1.0f - above);
    EXPECT_NEAR(sky.through({0, 0, 1}).x, 3.0f * above, 0.01f * above);
    for (const glm::vec3& side : {glm::vec3(1, 0, 0), {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}})
        EXPECT_NEAR(sky.through(side).x, 3.0f * beside, 0.02f * beside);
    // Seen from there nothing shines: a thousandth of the mean remains.
    EXPECT_NEAR(sky.through({0, 0, -1}).x, 3.0f / 6.0f * 1e-3f, 1e-6f);
}

TEST(SkyBrightness, OfABlackSkyIsNothing) {
    const SkyBrightness sky = flat_sky(sides_of(0.0f, 0.0f));
    for (const glm::vec3& outwards : directions(50))
        EXPECT_EQ(sky.through(outwards), glm::vec3(0.0f));
    EXPECT_EQ(SkyBrightness().through({0, 0, 1}), glm::vec3(0.0f));
}

TEST(SkyBrightness, OfASkyThatTurnsIsItsMean) {
    const SkyBrightness sky = flat_sky(sides_of(0.0f, 3.0f), glm::vec3(1.0f), true);
    for (const glm::vec3& outwards : directions(50))
        EXPECT_NEAR(sky.through(outwards).x, 0.5f, 1e-3f);
}

TEST(SkyBrightness, OfTheBrightestTexelIsFinite) {
    // RGB9E5 ends at 65408.
    const SkyBrightness sky = flat_sky(sides_of(0.0f, 1e5f));
    const SkyBrightness clamped = flat_sky(sides_of(0.0f, 65408.0f));
    for (const glm::vec3& outwards : directions(100)) {
        const glm::vec3 seen = sky.through(outwards);
        EXPECT_EQ(seen, clamped.through(outwards));
        EXPECT_TRUE(std::isfinite(seen.x) && seen.x > 0.0f && seen.x <= 65408.0f);
    }
}

class SkyPictures : public testing::Test {
protected:
    /// A sky of black pictures but for one white texel of the side `up`.
    SkyBrightness one_texel(uint32_t width, uint32_t height, uint32_t x, uint32_t y, float factor) {
        for (size_t side = 0; side < sky_sides.size(); ++side) {
            Image image{width, height, std::vector<uint8_t>(size_t{4} * width * height, 0)};
            for (size_t i = 3; i < image.rgba.size(); i += 4)
                image.rgba[i] = 255;
            if (side == 4)
                for (size_t c = 0; c < 3; ++c)
                    image.rgba[4 * (size_t{y} * width + x) + c] = 255;
            const Bytes bytes = write_tga(image, {.descriptor = 0x20});
            std::filesystem::create_directories(folder_.path() / "env");
            std::ofstream(folder_.path() / "env" /
                              fmt::format("dot{}.tga", sky_sides.at(side).suffix),
                          std::ios::binary)
                .write(reinterpret_cast<const char*>(bytes.data()),
                       static_cast<std::streamsize>(bytes.size()));
        }
        FileSystem files;
        files.mount_folder(folder_.path());
        TextureSet textures(files);
        const std::optional<uint32_t> first = textures.sky_box("dot");
        EXPECT_TRUE(first);
        return SkyBrightness(textures, first.value_or(0), glm::vec3(factor), false);
    }

    test::ScratchFolder folder_;
};

TEST_F(SkyPictures, OneTexelIsSeenFromEverywhere) {
    // Of 64 by 64 texels one of 1e5, near the middle.
    const SkyBrightness sky = one_texel(64, 64, 33, 33, 1e5f);
    // Its solid angle is nearly (1/32)^2, and a plane that faces it takes that over pi.
    const float expected = 1e5f / (32.0f * 32.0f) / pi;
    EXPECT_NEAR(sky.through({0, 0, 1}).x, expected, 0.02f * expected);
    for (const glm::vec3& outwards : directions(200)) {
        const float seen = sky.through(outwards).x;
        EXPECT_TRUE(std::isfinite(seen));
        EXPECT_GT(seen, 1e-4f * expected);
        if (outwards.z > 0.2f) {
            EXPECT_NEAR(seen, expected * outwards.z, 0.1f * expected);
        }
    }
}

TEST_F(SkyPictures, EachTexelOfPicturesOfAnySizeCounts) {
    for (const auto& [width, height] :
         {std::pair<uint32_t, uint32_t>{1, 1}, {3, 5}, {17, 3}, {21, 1}})
        for (uint32_t y = 0; y < height; ++y)
            for (uint32_t x = 0; x < width; ++x) {
                const SkyBrightness sky = one_texel(width, height, x, y, 1.0f);
                for (const glm::vec3& outwards : directions(8))
                    ASSERT_GT(sky.through(outwards).x, 0.0f)
                        << width << " " << height << " " << x << " " << y;
            }
}

Sun sun_of(float degrees, glm::vec3 direction = glm::normalize(glm::vec3(0.3f, -0.5f, 0.7f))) {
    return {direction, {20.0f, 18.0f, 15.0f}, 0.5f * degrees * pi / 180.0f};
}

TEST(Sun, SendsWhatItsIrradianceSays) {
    for (const float degrees : {0.01f, 0.53f, 1.0f, 20.0f, 90.0f, 180.0f}) {
        const Sun sun = sun_of(degrees);
        const double half = static_cast<double>(sun.half_angle);
        EXPECT_NEAR(static_cast<double>(sun.radiance().x) * 3.14159265358979 * std::sin(half) *
                        std::sin(half),
                    20.0, 1e-3)
            << degrees;
        // Radiance times solid angle.
        const double size = 2.0 * std::sin(0.5 * half) * std::sin(0.5 * half);
        EXPECT_NEAR(static_cast<double>(sun.flux().x),
                    static_cast<double>(sun.radiance().x) * 2.0 * 3.14159265358979 * size, 2e-3)
            << degrees;
    }
    EXPECT_EQ(sun_of(0.0f).radiance(), glm::vec3(0.0f)) << "no ray meets a point";
    EXPECT_EQ(sun_of(0.0f).flux(), glm::vec3(20, 18, 15));
}

TEST(Sun, AsALightLightsASurfaceThatFacesItRight) {
    for (const float degrees : {0.0f, 0.01f, 1.0f, 30.0f, 90.0f, 170.0f, 180.0f})
        for (const glm::vec3& direction : directions(20)) {
            const Sun sun = sun_of(degrees, direction);
            const shader::Light light = sun_light(sun, 512.0f * 512.0f);
            EXPECT_EQ(light.flags, shader::LIGHT_SUN);
            const glm::dvec3 v0(light.v0), e1(light.e1), e2(light.e2);
            const double form =
                test::reference_form_factor(glm::dvec3(direction), v0, v0 + e1, v0 + e2);
            // A triangle that is near is chosen by a form factor of three points, within some
            // percent.
            const double tolerance = degrees < 40.0f ? 0.005 : 0.1;
            for (glm::length_t c = 0; c < 3; ++c)
                EXPECT_NEAR(static_cast<double>(light.radiance[c]) * form * 3.14159265358979 /
                                static_cast<double>(sun.irradiance[c]),
                            1.0, tolerance)
                    << degrees;
            // It is seen where it is.
            const glm::vec3 middle = light.v0 + (light.e1 + light.e2) / 3.0f;
            EXPECT_GT(glm::dot(glm::normalize(middle), direction), 0.9999f) << degrees;
            EXPECT_LT(glm::dot(shader::light_normal(light), direction), -0.9999f) << degrees;
        }
}

TEST(Sun, AsALightHasThePowerThatSkyFacesLetIn) {
    for (const float degrees : {0.0f, 1.0f, 30.0f, 90.0f, 180.0f})
        for (const float area : {1.0f, 100.0f, 512.0f * 512.0f, 1e8f}) {
            const Sun sun = sun_of(degrees);
            const double power =
                3.14159265358979 * static_cast<double>(light_power(sun_light(sun, area)));
            const double expected =
                static_cast<double>(shader::luminance(sun.irradiance)) * static_cast<double>(area);
            EXPECT_NEAR(power, expected, 1e-3 * expected) << degrees << " " << area;
        }
    EXPECT_EQ(sun_light(sun_of(1.0f), 0.0f).radiance, glm::vec3(0.0f)) << "nothing lets it in";
    Sun dark = sun_of(1.0f);
    dark.irradiance = glm::vec3(0.0f);
    EXPECT_EQ(sun_light(dark, 100.0f).radiance, glm::vec3(0.0f));
}

TEST(Sun, AsALightMattersToWhateverSeesAPartOfIt) {
    const glm::vec3 positions[] = {{0, 0, 0}, {-1000, 2000, 500}, {4000, -4000, 4000}};
    for (const float degrees : {0.0f, 0.01f, 1.0f, 20.0f, 90.0f, 150.0f, 180.0f}) {
        const Sun sun = sun_of(degrees);
        const shader::Light light = sun_light(sun, 512.0f * 512.0f);
        const shader::Basis basis = shader::make_basis(sun.direction);
        // Of a sun that fills half of the sky a tenth of a degree at the rim is left out.
        const float step = degrees > 170.0f ? 1e-4f : 1e-5f; // there rounding takes as much
        const float seen = 0.5f * pi + std::min(sun.half_angle, 89.9f * pi / 180.0f);
        for (const glm::vec3& position : positions) {
            const shader::Light there = shader::light_from(light, position);
            const auto importance = [&](float angle, float turn) {
                const glm::vec3 across =
                    std::cos(turn) * basis.tangent + std::sin(turn) * basis.bitangent;
                const glm::vec3 normal =
                    glm::normalize(std::cos(angle) * sun.direction + std::sin(angle) * across);
                return shader::ltc_importance(shader::ltc_prepare_diffuse(position, normal, 1.0f),
                                              there, false);
            };
            for (int i = 0; i <= 200; ++i)
                for (int t = 0; t < 24; ++t) {
                    // Where the triangle reaches least far is among them: 60 degrees.
                    const float turn = 2.0f * pi * static_cast<float>(t) / 24.0f;
                    // Evenly, and close to where the last of the disc sets.
                    const float angle = i <= 100 ? seen * static_cast<float>(i) / 101.0f
                                                 : seen - step * static_cast<float>(i - 100);
                    const float value = importance(angle, turn);
                    ASSERT_TRUE(std::isfinite(value));
                    ASSERT_GT(value, 0.0f) << degrees << " degrees, seen under " << angle;
                    // A small disc is known well.
                    if (degrees <= 1.0f && angle < 1.3f) {
                        const float exact =
                            shader::luminance(sun.irradiance) / pi * std::cos(angle);
                        ASSERT_NEAR(value, exact, 0.1f * exact) << degrees << " " << angle;
                    }
                }
            // And not to what is turned away from all of it.
            if (degrees < 60.0f) {
                EXPECT_EQ(importance(pi - 0.1f, 1.0f), 0.0f);
            }
        }
    }
}

const std::vector<float> full_styles(256, 1.0f);
const glm::mat4x3 identity(1.0f);

/// Looks down: the sky is above it.
LightSource window(float coverage = 1.0f) {
    return {{0, 0, 100}, {0, 8, 100}, {8, 0, 100}, glm::vec3(1.0f), coverage, 0, shader::LIGHT_SKY};
}

LightSource lamp() {
    return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, glm::vec3(1.0f), 1.0f, 0, 0};
}

struct Sky {
    SkyBrightness brightness{glm::vec3(2, 3, 4)};
    Sun sun{glm::vec3(0, 0, 1), glm::vec3(5.0f), 0.01f};
    Environment environment{&brightness, 1, 1.0f, sun_light(sun, 100.0f), std::sin(sun.half_angle)};
};

void frame(LightSet& set, const Environment& environment, float emissive_scale = 1.0f) {
    set.begin_frame(full_styles, emissive_scale, environment);
    set.end_frame();
}

TEST(LightSetEnvironment, TheSunComesAfterAllOtherLightsOfTheWorld) {
    Sky sky;
    LightSet set({lamp(), window(0.5f)}, true);
    EXPECT_EQ(set.static_count(), 3u);
    EXPECT_EQ(set.sun(), 2u);
    frame(set, sky.environment);
    ASSERT_EQ(set.lights().size(), 3u);
    EXPECT_EQ(set.lights()[0].flags, 0u);
    EXPECT_EQ(set.lights()[1].flags, shader::LIGHT_SKY);
    EXPECT_EQ(set.lights()[2].flags, shader::LIGHT_SUN);
    EXPECT_EQ(set.lights()[1].radiance, 0.5f * glm::vec3(2, 3, 4)) << "half of it is sky";
    EXPECT_EQ(set.lights()[2].v0, sky.environment.sun.v0);
    EXPECT_EQ(set.lights()[2].radiance, sky.environment.sun.radiance);
    // What moves comes after it.
    set.begin_frame(full_styles, 1.0f, sky.environment);
    EXPECT_EQ(set.place(7, std::vector<LightSource>{lamp()}, identity, glm::vec3(1.0f)), 3u);
    set.end_frame();
    EXPECT_EQ(set.sun(), 2u);
    EXPECT_EQ(LightSet({lamp()}).sun(), shader::NONE);
}

TEST(LightSetEnvironment, WindowsFollowTheSkyAlone) {
    Sky sky;
    LightSource styled = window();
    styled.style = 3;
    LightSet set({lamp(), styled});
    std::vector<float> styles = full_styles;
    styles[3] = 0.25f;
    sky.environment.sky_scale = 2.0f;
    set.begin_frame(styles, 8.0f, sky.environment);
    set.end_frame();
    EXPECT_EQ(set.lights()[0].radiance, glm::vec3(8.0f));
    EXPECT_EQ(set.lights()[1].radiance, glm::vec3(4, 6, 8));
    frame(set, Environment{});
    EXPECT_EQ(set.lights()[1].radiance, glm::vec3(0.0f)) << "no sky";
    // Through the plane of a window one sees the sky behind it: this one's is above.
    const SkyBrightness top = flat_sky(sides_of(0.0f, 1.0f));
    frame(set, {&top, 2, 1.0f, {}, 0.0f});
    EXPECT_EQ(set.lights()[1].radiance, top.through({0, 0, 1}));
    EXPECT_GT(set.lights()[1].radiance.x, 0.5f);
}

TEST(LightSetEnvironment, RevisionsTellWhatChanged) {
    Sky sky;
    LightSet set({lamp(), window()}, true);
    frame(set, sky.environment);
    uint64_t all = set.revision(), sun = set.sun_revision();
    const uint64_t moving = set.moving_revision();
    frame(set, sky.environment);
    EXPECT_EQ(set.revision(), all);
    EXPECT_EQ(set.sun_revision(), sun);
    // Another sky.
    const SkyBrightness other(glm::vec3(1.0f));
    sky.environment.sky = &other;
    ++sky.environment.sky_revision;
    frame(set, sky.environment);
    EXPECT_GT(set.revision(), all);
    EXPECT_EQ(set.sun_revision(), sun);
    EXPECT_EQ(set.lights()[1].radiance, glm::vec3(1.0f));
    all = set.revision();
    sky.environment.sky_scale = 3.0f;
    frame(set, sky.environment);
    EXPECT_GT(set.revision(), all);
    EXPECT_EQ(set.sun_revision(), sun);
    all = set.revision();
    // Another sun: where it shines in is looked at again.
    sky.sun.direction = {0, 0.6f, 0.8f};
    sky.environment.sun = sun_light(sky.sun, 100.0f);
    frame(set, sky.environment);
    EXPECT_GT(set.revision(), all);
    EXPECT_GT(set.sun_revision(), sun);
    sun = set.sun_revision();
    // A wider one, too.
    sky.sun.half_angle = 0.5f;
    sky.environment.sun = sun_light(sky.sun, 100.0f);
    sky.environment.sun_sine = std::sin(0.5f);
    frame(set, sky.environment);
    EXPECT_GT(set.sun_revision(), sun);
    EXPECT_EQ(set.moving_revision(), moving) << "nothing moved but the sun";
}

TEST(LightSetEnvironment, TheSunEntersThroughWindowsThatFaceAPartOfIt) {
    Sky sky;
    LightSet set({window(), lamp()}, true);
    const auto enters = [&](glm::vec3 direction, float half_angle) {
        sky.sun.direction = glm::normalize(direction);
        sky.sun.half_angle = half_angle;
        sky.environment.sun = sun_light(sky.sun, 100.0f);
        sky.environment.sun_sine = std::sin(half_angle);
        frame(set, sky.environment);
        EXPECT_FALSE(set.sun_enters(set.lights()[1])) << "a lamp is no window";
        EXPECT_FALSE(set.sun_enters(set.lights()[2])) << "nor is the sun";
        return set.sun_enters(set.lights()[0]);
    };
    EXPECT_TRUE(enters({0, 0, 1}, 0.0f));
    EXPECT_TRUE(enters({1, 0, 0.001f}, 0.0f));
    EXPECT_FALSE(enters({1, 0, -0.001f}, 0.0f));
    EXPECT_FALSE(enters({0, 0, -1}, 0.0f));
    EXPECT_TRUE(enters({1, 0, -0.3f}, 0.4f)) << "its upper rim does";
    EXPECT_FALSE(enters({1, 0, -0.5f}, 0.4f));
    EXPECT_TRUE(enters({0, 0, -1}, 0.5f * pi)) << "it fills half of all directions";
    // A dark one enters nowhere.
    sky.sun.irradiance = glm::vec3(0.0f);
    EXPECT_FALSE(enters({0, 0, 1}, 0.1f));
    LightSet sunless({window()});
    frame(sunless, sky.environment);
    EXPECT_FALSE(sunless.sun_enters(sunless.lights()[0]));
}

TEST(LightSetEnvironment, WindowsThatMoveLetTheSunInAnywhere) {
    Sky sky;
    LightSet set({lamp()}, true);
    frame(set, sky.environment);
    EXPECT_FALSE(set.has_moving_sky());
    const uint64_t sun = set.sun_revision();
    set.begin_frame(full_styles, 1.0f, sky.environment);
    const std::vector<LightSource> sources{window()};
    const uint32_t id =
        set.place(1, sources, rigid_transform({0, 0, 50}, {0, 0, 180}), glm::vec3(1.0f)).value();
    set.end_frame();
    EXPECT_TRUE(set.has_moving_sky());
    EXPECT_GT(set.sun_revision(), sun);
    EXPECT_EQ(set.lights()[id].flags, shader::LIGHT_SKY);
    EXPECT_EQ(set.lights()[id].radiance, glm::vec3(2, 3, 4));
}

TEST(LightSetEnvironment, ASunThatIsNotFiniteStaysDark) {
    Sky sky;
    LightSet set({window()}, true);
    sky.environment.sun.radiance.y = std::numeric_limits<float>::quiet_NaN();
    frame(set, sky.environment);
    EXPECT_EQ(set.lights()[1].radiance, glm::vec3(0.0f));
    EXPECT_FALSE(set.sun_enters(set.lights()[0]));
}

} // namespace
} // namespace vigil::vkpt
