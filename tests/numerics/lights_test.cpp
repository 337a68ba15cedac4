// SPDX-License-Identifier: GPL-2.0-or-later
// Lights at the extremes of size, place and brightness, seen from one surface: everything finite
// and not negative, densities those of the draws, means those of double precision.
#include "light/form_factor_reference.h"
#include "record.h"
#include "refresh/vkpt/light/alias_table.h"
#include "refresh/vkpt/light/light_power.h"
#include "refresh/vkpt/light/ltc_table.h"
#include "shared/firewall.h"
#include "shared/light_point.h"
#include "shared/ltc.h"
#include "shared/random.h"
#include "shared/triangle_light.h"

#include <numeric>
#include <vector>

namespace vigil::shader {
namespace {

using test::any_float;
using test::record;
using test::relative_error;
using test::Sample;
using test::slowdown;
using test::Worst;
using test::z_limit;

const vec3 up(0, 0, 1);
constexpr float below_one = 1.0f - 1.0f / 16777216.0f;

Light facing(Light light) {
    if (light_facing(light, vec3(0.0f)) < 0.0f) std::swap(light.e1, light.e2);
    return light;
}

vec3 any_direction(Random& random) {
    return sample_sphere(random_next2(random));
}

/// A triangle of about this size, not thinner than one in `aspect`.
Light any_light(Random& random, float distance, float size, float aspect = 4.0f) {
    for (;;) {
        const Light light{distance * any_direction(random), size * any_direction(random),
                          size * any_direction(random) / aspect * (1.0f + random_next(random)),
                          vec3(1.0f), 0};
        const float sine =
            length(cross(light.e1, light.e2)) / (length(light.e1) * length(light.e2));
        if (sine > 0.2f) return facing(light);
    }
}

/// Solid angle in double precision (Van Oosterom and Strackee 1983); the volume from the edges.
double exact_solid_angle(const Light& light) {
    const glm::dvec3 a(light.v0), e1(light.e1), e2(light.e2), b = a + e1, c = a + e2;
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    const double volume = glm::dot(glm::cross(e1, e2), -a);
    return 2.0 * std::atan2(volume, la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la +
                                        glm::dot(c, a) * lb);
}

double exact_form_factor(const Light& light) {
    const glm::dvec3 v0(light.v0);
    return test::reference_form_factor(glm::dvec3(up), v0, v0 + glm::dvec3(light.e1),
                                       v0 + glm::dvec3(light.e2));
}

/// Every way of drawing a point: sound, and the density told is the one drawn with.
void expect_consistent(const Light& light, Random& random, int draws) {
    for (const int density : {LIGHT_DENSITY_AUTO, LIGHT_DENSITY_AREA, LIGHT_DENSITY_SOLID_ANGLE}) {
        const SphericalTriangle near = near_light(light, vec3(0.0f), density);
        for (int i = 0; i < draws; ++i) {
            vec2 u = random_next2(random);
            if (i < 4) u = vec2(i & 1 ? below_one : 0.0f, i & 2 ? below_one : 0.0f);
            const LightSample seen = sample_light(light, near, vec3(0.0f), u);
            ASSERT_TRUE(is_finite_nonnegative(seen.pdf) && is_finite_nonnegative(seen.geometry) &&
                        is_finite_nonnegative(seen.distance));
            ASSERT_EQ(seen.pdf > 0.0f, seen.geometry > 0.0f);
            if (!(seen.pdf > 0.0f)) continue;
            ASSERT_NEAR(seen.pdf * seen.geometry, 1.0f, 1e-6f);
            ASSERT_NEAR(light_pdf(light, near, vec3(0.0f), seen.point) / seen.pdf, 1.0f, 1e-6f);
        }
    }
}

/// A white Lambertian surface at the origin, from draws, against the form factor. Returns the
/// z-score of their difference; what rounding explains is not counted.
double score_of_mean(const Light& light, Random& random, int draws) {
    const SphericalTriangle near = near_light(light, vec3(0.0f), LIGHT_DENSITY_AUTO);
    const double exact = exact_form_factor(light);
    Sample mean;
    for (int i = 0; i < draws; ++i) {
        const LightSample seen = sample_light(light, near, vec3(0.0f), random_next2(random));
        const float value = std::max(seen.direction.z, 0.0f) * INVERSE_PI * seen.geometry;
        EXPECT_TRUE(is_finite_nonnegative(value));
        mean.add(double(value));
    }
    // Seen edge-on, a dot product loses as many digits as its cosine is small.
    const vec3 across = cross(light.e1, light.e2);
    const double slant = std::abs(double(dot(across, light.v0))) /
                         (double(length(across)) * double(length(light.v0)));
    const double rounding = (1e-5 + 1e-6 / std::max(slant, 1e-9)) * exact;
    const double error = std::max(std::abs(mean.mean() - exact) - rounding, 0.0);
    return error > 0.0 ? error / mean.standard_error() : 0.0;
}

TEST(Lights, AreasOverSixteenPowersOfTen) {
    Random random = random_begin(uvec2(0, 0), 0, 1);
    Worst scores;
    for (float size = 1e-4f; size < 2e4f; size *= 10.0f)
        for (float distance = 0.01f; distance < 2e5f; distance *= 10.0f) {
            Light light = any_light(random, distance, size);
            light.v0.z = std::abs(light.v0.z);
            light = facing(light);
            ASSERT_NO_FATAL_FAILURE(expect_consistent(light, random, 8));
            scores.add(score_of_mean(light, random, 4000));
            const double exact = exact_form_factor(light);
            const LtcSurface surface = ltc_prepare_diffuse(vec3(0.0f), up, 0.5f);
            const float importance = ltc_importance(surface, light, false);
            ASSERT_TRUE(is_finite_nonnegative(importance));
            if (exact > 0.0) {
                ASSERT_GT(importance, 0.0f) << size << " at " << distance;
            }
        }
    EXPECT_LT(scores.value(), z_limit);
    record("lights", "area 1e-8 to 1e8 at distances from 0.01 to 100,000",
           "finite, density that of the draws, mean that of double precision (z < 4.5)",
           "z " + scores.text());
}

TEST(Lights, SliversAndNone) {
    Random random = random_begin(uvec2(0, 0), 0, 2);
    Worst scores;
    for (float aspect = 10.0f; aspect < 2e7f; aspect *= 10.0f)
        for (int i = 0; i < 4; ++i) {
            // Two long edges side by side, or a long and a short one.
            const vec3 along = 100.0f * any_direction(random);
            const vec3 across = 100.0f / aspect * any_direction(random);
            const Light light =
                facing({{3, -2, 40}, along, i % 2 == 0 ? along + across : across, vec3(1.0f), 0});
            ASSERT_NO_FATAL_FAILURE(expect_consistent(light, random, 16));
            if (i % 2 == 1) scores.add(score_of_mean(light, random, 4000));
            ASSERT_TRUE(is_finite_nonnegative(light_power(light)));
            const vec3 normal = light_normal(light);
            ASSERT_TRUE(length(normal) == 0.0f || std::abs(length(normal) - 1.0f) < 1e-5f);
        }
    EXPECT_LT(scores.value(), z_limit);
    record("lights", "slivers, up to 1e7 times as long as wide",
           "finite, density that of the draws, mean that of double precision (z < 4.5)",
           "z " + scores.text());
    for (const Light& light : {Light{{1, 2, 3}, vec3(0), vec3(0), vec3(1), 0},
                               Light{{1, 2, 3}, {4, 0, 1}, {4, 0, 1}, vec3(1), 0},
                               Light{{1, 2, 3}, {4, 0, 1}, {-8, 0, -2}, vec3(1), 0},
                               Light{vec3(0), vec3(0), vec3(0), vec3(1), 0}}) {
        ASSERT_NO_FATAL_FAILURE(expect_consistent(light, random, 8));
        EXPECT_EQ(sample_light(light, vec3(0.0f), vec2(0.3f)).pdf, 0.0f);
        EXPECT_EQ(ltc_importance(ltc_prepare_diffuse(vec3(0.0f), up, 1.0f), light, false), 0.0f);
        EXPECT_EQ(light_solid_angle(light, vec3(0.0f)), 0.0f);
    }
    record("lights", "zero area: a point, a line, all corners in the surface point",
           "no density, no importance, never drawn", "");
}

TEST(Lights, AroundTheHorizon) {
    Random random = random_begin(uvec2(0, 0), 0, 3);
    const LtcSurface surface = ltc_prepare_diffuse(vec3(0.0f), up, 1.0f);
    Worst crossing, touching;
    for (int i = 0; i < 200 / slowdown + 4; ++i) {
        // In the surface's own plane: no height, so nothing arrives.
        Light flat = any_light(random, 20.0f, 10.0f);
        flat.v0.z = flat.e1.z = flat.e2.z = 0.0f;
        ASSERT_EQ(ltc_importance(surface, flat, false), 0.0f);
        ASSERT_EQ(exact_form_factor(facing(flat)), 0.0);
        // Below it.
        Light below = any_light(random, 20.0f, 3.0f);
        below.v0.z = -10.0f - std::abs(below.v0.z);
        ASSERT_EQ(ltc_importance(surface, facing(below), false), 0.0f);
        // Turned away.
        Light behind = any_light(random, 20.0f, 3.0f);
        std::swap(behind.e1, behind.e2);
        ASSERT_EQ(ltc_importance(surface, behind, false), 0.0f);
        ASSERT_EQ(sample_light(behind, vec3(0.0f), vec2(0.5f)).geometry, 0.0f);
        // Half above.
        Light half = any_light(random, 8.0f, 12.0f);
        half.v0.z = -random_next(random);
        half = facing(half);
        ASSERT_NO_FATAL_FAILURE(expect_consistent(half, random, 8));
        if (exact_form_factor(half) > 1e-6) {
            ASSERT_GT(ltc_importance(surface, half, false), 0.0f);
            crossing.add(score_of_mean(half, random, 3000));
        }
        // One corner or one edge on the surface, a thousandth of a unit beside the point: where
        // offset_ray_origin lets rays start.
        Light near{{1e-3f * random_next(random), 0.0f, 0.0f},
                   {0.0f, 10.0f * random_next(random), i % 2 == 0 ? 0.0f : 4.0f},
                   {random_next(random), 0.0f, 10.0f},
                   vec3(1.0f),
                   0};
        near.v0.z -= 2e-3f;
        near = facing(near);
        ASSERT_NO_FATAL_FAILURE(expect_consistent(near, random, 8));
        touching.add(score_of_mean(near, random, 3000));
    }
    EXPECT_LT(crossing.value(), z_limit);
    EXPECT_LT(touching.value(), z_limit);
    record("lights", "in the plane of the surface, below it, turned away", "never drawn", "");
    record("lights", "crossing the horizon", "mean that of double precision (z < 4.5)",
           "z " + crossing.text());
    record("lights", "touching the surface, 0.002 units from the point",
           "mean that of double precision (z < 4.5)", "z " + touching.text());
    // The point itself lies in the light, on its edge, on its corner.
    for (const vec3& v0 : {vec3(0), vec3(-1, -1, 0), vec3(-1, 0, 0)}) {
        const Light light{v0, {0, 4, 0}, {4, 0, 0}, vec3(1.0f), 0};
        ASSERT_NO_FATAL_FAILURE(expect_consistent(light, random, 8));
        EXPECT_EQ(sample_light(light, vec3(0.0f), vec2(0.3f)).geometry, 0.0f);
    }
    record("lights", "the surface point in the light, on its edge, on its corner",
           "finite, and nothing arrives", "");
}

TEST(Lights, RadianceOverManyPowersOfTen) {
    Random random = random_begin(uvec2(0, 0), 0, 4);
    const LtcSurface surface = ltc_prepare_diffuse(vec3(0.0f), up, 0.5f);
    Worst proportion;
    std::vector<float> powers;
    for (int i = 0; i < 2000 / slowdown; ++i) {
        Light light = any_light(random, 30.0f, 10.0f);
        light.v0.z = 20.0f;
        light = facing(light);
        const float one = ltc_importance(surface, light, false);
        const float radiance = std::pow(10.0f, 24.0f * random_next(random) - 12.0f);
        light.radiance = vec3(radiance);
        const float importance = ltc_importance(surface, light, false);
        ASSERT_TRUE(is_finite_nonnegative(importance));
        if (one > 0.0f) {
            ASSERT_GT(importance, 0.0f);
            proportion.add(relative_error(double(importance), double(one) * double(radiance)));
        }
        powers.push_back(light_power(light));
    }
    EXPECT_LT(proportion.value(), 8.0);
    record("lights", "radiance 1e-12 to 1e12",
           "importance positive, and in proportion to 8 * 2^-24", proportion.text() + " * 2^-24");
    // All of them in one table: each keeps a chance.
    for (const AliasEntry& entry : build_alias_table(powers))
        ASSERT_TRUE(is_finite_nonnegative(entry.pdf) && entry.pdf > 0.0f);
    record("lights", "radiance 1e-12 to 1e12 mixed in one table", "each is drawn at times", "");
}

TEST(Lights, AnyBits) {
    Random random = random_begin(uvec2(0, 0), 0, 5);
    const auto vector = [&] {
        const uvec3 words = random_next_words(random);
        return vec3(any_float(words.x), any_float(words.y), any_float(words.z));
    };
    int positive = 0;
    for (int i = 0; i < 400000 / slowdown; ++i) {
        const Light light{vector(), vector(), vector(), vec3(1.0f), 0};
        const vec3 position = i % 2 == 0 ? vec3(0.0f) : vector();
        for (const int density :
             {LIGHT_DENSITY_AUTO, LIGHT_DENSITY_AREA, LIGHT_DENSITY_SOLID_ANGLE}) {
            const SphericalTriangle near = near_light(light, position, density);
            const LightSample seen = sample_light(light, near, position, random_next2(random));
            ASSERT_TRUE(is_finite_nonnegative(seen.geometry) && is_finite_nonnegative(seen.pdf))
                << seen.geometry;
            positive += seen.pdf > 0.0f ? 1 : 0;
        }
        ASSERT_TRUE(is_finite_nonnegative(light_power(light)));
        ASSERT_TRUE(is_finite_nonnegative(light_solid_angle(light, position)));
    }
    EXPECT_GT(positive, 0);
    record("lights", "corners and points of any bits: infinite, NaN, denormal, 1e38",
           "density, worth and solid angle finite and not negative", "");
}

TEST(Precision, SolidAngles) {
    Random random = random_begin(uvec2(0, 0), 0, 6);
    // Coordinates are given, and taken as exact. The angle is 2 atan2(v, d) of a volume v, which
    // loses digits to cancellation where the light is thin or seen along its plane (by a factor c),
    // and of a sum of cosines d, which does where an edge passes close by: errors in proportion to
    //     (c |d| + 1) v / (v^2 + d^2) / angle.
    Worst plain, all;
    for (int i = 0; i < 200000 / slowdown; ++i) {
        const float distance = std::pow(10.0f, 5.0f * random_next(random) - 1.0f);
        const float size = distance * std::pow(10.0f, 5.0f * random_next(random) - 4.0f);
        const Light light =
            any_light(random, distance, size,
                      i % 2 == 0 ? 4.0f : std::pow(10.0f, 4.0f * random_next(random)));
        const double exact = exact_solid_angle(light);
        if (!(exact > 0.0)) continue;
        const glm::dvec3 a(light.v0), e1(light.e1), e2(light.e2);
        const glm::dvec3 b = glm::normalize(a + e1), c = glm::normalize(a + e2);
        const double volume = std::abs(glm::dot(glm::cross(e1, e2), a));
        const double cancels = glm::length(e1) * glm::length(e2) * glm::length(a) / volume;
        const double v = volume / (glm::length(a) * glm::length(a + e1) * glm::length(a + e2));
        const double d =
            1.0 + glm::dot(glm::normalize(a), b) + glm::dot(b, c) + glm::dot(c, glm::normalize(a));
        const double condition = (cancels * std::abs(d) + 1.0) * v / (v * v + d * d) / exact;
        const float by_light = light_solid_angle(light, vec3(0.0f));
        const float by_triangle = spherical_triangle(light.v0, light.e1, light.e2).solid_angle;
        for (const float angle : {by_light, by_triangle}) {
            const double error = relative_error(double(angle), exact);
            all.add(error / std::max(condition, 1.0));
            if (condition < 4.0) plain.add(error);
        }
    }
    EXPECT_LT(plain.value(), 48.0);
    EXPECT_LT(all.value(), 16.0);
    record("precision", "solid angle of a triangle, well conditioned (k < 4)",
           "relative error below 48 * 2^-24", plain.text() + " * 2^-24");
    record("precision", "solid angle of any triangle; k = (c |d| + 1) v / (v^2 + d^2) / angle",
           "relative error below 16 max(k, 1) * 2^-24", all.text() + " k * 2^-24");
}

TEST(Precision, FormFactors) {
    Random random = random_begin(uvec2(0, 0), 0, 7);
    Worst contour, small, whole, cut;
    for (int i = 0; i < 200000 / slowdown; ++i) {
        const float size = 10.0f * std::pow(10.0f, 4.0f * random_next(random) - 3.0f);
        Light light = any_light(random, 10.0f, size);
        const double exact = exact_form_factor(light);
        const vec3 v1 = light.v0 + light.e1, v2 = light.v0 + light.e2;
        const vec3 height(light.v0.z, v1.z, v2.z);
        const float highest = std::max(height.x, std::max(height.y, height.z));
        const float lowest = std::min(height.x, std::min(height.y, height.z));
        const float seen =
            form_factor(up, light.v0, light.e1, light.e2, light_facing(light, vec3(0.0f)));
        ASSERT_TRUE(seen >= 0.0f && seen <= 1.0f);
        ASSERT_EQ(seen > 0.0f, highest > 0.0f);
        if (!(highest > 0.0f)) continue;
        contour.add(std::abs(double(contour_form_factor(up, light.v0, v1, v2, height)) - exact));
        if (!(exact > 1e-12)) continue;
        const double error = std::abs(double(seen) / exact - 1.0);
        // Relative to what the light gives from straight above: light at grazing angles is little.
        const double spread =
            std::abs(double(seen) - exact) / (exact_solid_angle(light) / 3.14159265);
        if (size < 0.1f) small.add(spread);
        (lowest >= 0.0f ? whole : cut).add(lowest >= 0.0f ? error : spread);
    }
    EXPECT_LT(contour.value(), 3e-6);
    EXPECT_LT(small.value(), 0.01);
    EXPECT_LT(whole.value(), 0.2);
    EXPECT_LT(cut.value(), 0.05);
    record("precision", "LTC integral by its contour, cut at the horizon", "within 3e-6",
           contour.text());
    record("precision", "LTC integral of a light of less than a hundredth of its distance",
           "within 1% of its solid angle over pi", fmt::format("{:.2f}%", 100.0 * small.value()));
    record("precision", "LTC integral as used, light whole above the horizon",
           "relative error below 20% (decides choices, not brightness)",
           fmt::format("{:.1f}%", 100.0 * whole.value()));
    record("precision", "LTC integral as used, light cut by the horizon",
           "within 5% of its solid angle over pi (decides choices, not brightness)",
           fmt::format("{:.1f}%", 100.0 * cut.value()));
}

TEST(Precision, AliasTables) {
    Random random = random_begin(uvec2(0, 0), 0, 8);
    Worst stored, built, sums;
    for (const size_t count : {1u, 2u, 7u, 1000u, 100000u})
        for (const float decades : {0.0f, 6.0f, 30.0f}) {
            std::vector<float> weights(count);
            for (float& weight : weights)
                weight = std::pow(10.0f, decades * (random_next(random) - 0.5f));
            const std::vector<AliasEntry> table = build_alias_table(weights);
            ASSERT_EQ(table.size(), count);
            // What the whole table yields, in whole numbers of 2^-32 columns.
            std::vector<double> mass(count, 0.0);
            double sum = 0.0;
            for (size_t i = 0; i < count; ++i) {
                mass[i] += table[i].threshold;
                mass[table[i].alias] += 0x1p32 - table[i].threshold;
            }
            const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
            for (size_t i = 0; i < count; ++i) {
                const double drawn = mass[i] / (0x1p32 * double(count));
                stored.add(relative_error(double(table[i].pdf), drawn));
                built.add(std::abs(drawn - double(weights[i]) / total) * double(count) * 0x1p32);
                sum += double(table[i].pdf);
            }
            sums.add(std::abs(sum - 1.0));
        }
    EXPECT_LE(stored.value(), 1.0);
    EXPECT_LT(sums.value(), 1e-7);
    EXPECT_LT(built.value(), 0x1p32 * 1e-5);
    record("precision", "alias table: the density stored, against how often it draws",
           "relative error of at most 2^-24: one rounding", stored.text() + " * 2^-24");
    record("precision", "alias table: sum of all densities", "1 to within 1e-7", sums.text());
    record("light choice", "alias tables of 1 to 100,000 weights over 30 powers of ten",
           "each probability within 1e-5 of a column's", built.text() + " * 2^-32 of a column");
    EXPECT_TRUE(build_alias_table(std::vector<float>(3, 0.0f)).empty());
    record("light choice", "alias table of one entry; of total 0",
           "always drawn; an empty table, and no light is drawn", "");
}

TEST(Precision, GlossInHalfFloats) {
    Worst alpha, reflectance;
    for (int i = 0; i <= 100000; ++i) {
        const float a = 0.01f + 0.99f * float(i) / 100000.0f;
        const vec2 stored = unpackHalf2x16(packHalf2x16(vec2(a, float(i) / 100000.0f)));
        alpha.add(std::abs(double(stored.x) / double(a) - 1.0));
        reflectance.add(std::abs(double(stored.y) - i / 100000.0));
    }
    EXPECT_LE(alpha.value(), 0x1p-11);
    EXPECT_LE(reflectance.value(), 0x1p-12);
    record("precision", "width of a highlight at the primary hit (half float)",
           "relative error of at most 2^-11", alpha.text());
    record("precision", "reflectance at the primary hit (half float)", "within 2^-12",
           reflectance.text());
}

} // namespace
} // namespace vigil::shader
