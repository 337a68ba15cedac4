// SPDX-License-Identifier: GPL-2.0-or-later
// Diffuse light importance: the clipped triangle's form factor against double precision and Monte
// Carlo, and the promises light selection rests on: zero exactly where nothing arrives, positive
// where something does.
#include "form_factor_reference.h"
#include "shared/ltc.h"
#include "shared/random.h"
#include "statistics.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace vigil::shader {
namespace {

using test::reference_form_factor;
using test::Sample;
using test::z_limit;

const vec3 up(0, 0, 1);

/// A light seen from the origin, turned so that it faces it.
struct Case {
    vec3 normal;
    Light light{};
};

Light make_light(vec3 v0, vec3 v1, vec3 v2) {
    Light light{};
    light.v0 = v0;
    light.e1 = v1 - v0;
    light.e2 = v2 - v0;
    light.radiance = vec3(1.0f);
    return light;
}

Light facing_origin(Light light) {
    if (light_facing(light, vec3(0.0f)) < 0.0f) std::swap(light.e1, light.e2);
    return light;
}

float importance(const Case& c) {
    return ltc_importance(ltc_prepare_diffuse(vec3(0.0f), c.normal, 1.0f), c.light, false);
}

double reference(const Case& c) {
    const glm::dvec3 v0(c.light.v0);
    return reference_form_factor(glm::dvec3(c.normal), v0, v0 + glm::dvec3(c.light.e1),
                                 v0 + glm::dvec3(c.light.e2));
}

vec3 random_direction(Random& random) {
    return normalize(sample_sphere(random_next2(random)));
}

/// Lights of `size` units at `distance`, anywhere around the origin.
Case random_case(Random& random, float size, float distance) {
    Case c;
    c.normal = random_direction(random);
    const vec3 e1 = size * random_direction(random);
    const vec3 e2 = size * (0.1f + random_next(random)) * random_direction(random);
    const vec3 center = distance * random_direction(random);
    const vec3 v0 = center - (e1 + e2) / 3.0f;
    c.light = facing_origin(make_light(v0, v0 + e1, v0 + e2));
    return c;
}

TEST(FormFactor, AngleOverSineHasItsStatedError) {
    for (int i = 1; i < 100000; ++i) {
        const double angle = 3.14159265358979 * i / 100000.0, sine = std::sin(angle);
        const auto got = half_angle_over_sine(static_cast<float>(std::cos(angle)),
                                              static_cast<float>(sine * sine));
        ASSERT_NEAR(got / (0.5 * angle / sine), 1.0, 3.5e-6) << angle;
    }
    EXPECT_NEAR(half_angle_over_sine(1.0000001f, 0.0f), 0.5f, 2e-6f);
    EXPECT_TRUE(std::isfinite(half_angle_over_sine(-1.0000001f, 0.0f)));
}

// Ordinary lights at all sizes from a speck to all around: whole above the horizon, and cut by it.
TEST(FormFactor, AgreesWithDoublePrecision) {
    Random random = random_begin(uvec2(0, 0), 0, 1);
    for (const float ratio : {0.001f, 0.01f, 0.05f, 0.2f, 0.5f, 1.0f, 3.0f, 10.0f}) {
        std::vector<double> whole, cut;
        for (int i = 0; i < 20000; ++i) {
            const Case c = random_case(random, 64.0f, 64.0f / ratio);
            const double exact = reference(c);
            const float got = importance(c);
            ASSERT_TRUE(std::isfinite(got) && got >= 0.0f);
            ASSERT_LE(got, 1.0f);
            const vec3 z = vec3(dot(c.normal, c.light.v0)) +
                           vec3(0, dot(c.normal, c.light.e1), dot(c.normal, c.light.e2));
            if (max(z.x, max(z.y, z.z)) <= 0.0f) {
                ASSERT_EQ(got, 0.0f);
                continue;
            }
            ASSERT_GT(got, 0.0f);
            // Slivers of light at the horizon are compared by what they add, below.
            EXPECT_NEAR(got, exact, 0.05 * exact + 2e-5) << "size / distance " << ratio;
            if (exact > 1e-3 * ratio * ratio)
                (min(z.x, min(z.y, z.z)) < 0.0f ? cut : whole)
                    .push_back(std::abs(got / exact - 1.0));
        }
        for (auto* errors : {&whole, &cut}) {
            if (errors->size() < 100) continue;
            std::sort(errors->begin(), errors->end());
            const auto at = [&](double share) {
                return (*errors)[static_cast<size_t>(share * double(errors->size() - 1))];
            };
            RecordProperty(errors == &whole ? "whole" : "cut", std::to_string(at(0.99)));
            EXPECT_LT(at(0.5), 0.005) << "size / distance " << ratio;
            EXPECT_LT(at(0.99), 0.05) << "size / distance " << ratio;
        }
    }
}

TEST(FormFactor, AgreesWithMonteCarlo) {
    Random random = random_begin(uvec2(0, 0), 0, 2);
    for (const float ratio : {0.1f, 0.5f, 2.0f}) {
        for (int i = 0; i < 20; ++i) {
            const Case c = random_case(random, 64.0f, 64.0f / ratio);
            const double exact = reference(c);
            if (exact < 1e-4) continue;
            Sample mean;
            for (int k = 0; k < 20000; ++k) {
                const LightSample seen = sample_light(c.light, vec3(0.0f), random_next2(random));
                mean.add(double(max(dot(c.normal, seen.direction), 0.0f)) * seen.geometry /
                         3.14159265358979);
            }
            EXPECT_LT(std::abs(mean.mean() - exact),
                      z_limit * mean.standard_error() + 1e-5 * exact);
        }
    }
}

TEST(FormFactor, KnownValues) {
    // A huge lamp overhead fills half the hemisphere's light: two of them, all.
    const float far = 1e5f;
    const Case half{up, facing_origin(make_light({-far, -far, 1}, {far, -far, 1}, {far, far, 1}))};
    EXPECT_NEAR(importance(half), 0.5f, 1e-3f);
    // An octant of the sphere: a third of each axis' light; seen with the normal along an axis,
    // 1/4.
    const Case octant{up, facing_origin(make_light({1, 0, 0}, {0, 1, 0}, {0, 0, 1}))};
    EXPECT_NEAR(importance(octant), 0.25f, 1e-5f);
    // Contains the normal's direction.
    const Case above{up, facing_origin(make_light({-1, -1, 1}, {2, -1, 1}, {-1, 2, 1}))};
    EXPECT_NEAR(importance(above), reference(above), 1e-5);
}

TEST(FormFactor, IsZeroBehindAndBelow) {
    Case c{up, facing_origin(make_light({-1, -1, 1}, {2, -1, 1}, {-1, 2, 1}))};
    EXPECT_GT(importance(c), 0.0f);
    std::swap(c.light.e1, c.light.e2);
    EXPECT_EQ(importance(c), 0.0f) << "facing away";
    std::swap(c.light.e1, c.light.e2);
    c.normal = -up;
    EXPECT_EQ(importance(c), 0.0f) << "below the horizon";
    c.normal = up;
    c.light.radiance = vec3(0.0f);
    EXPECT_EQ(importance(c), 0.0f) << "dark";
}

TEST(FormFactor, DegenerateLightsAreZeroAndFinite) {
    const vec3 a(3, 4, 5), b(7, 1, 2);
    for (const Light& light :
         {make_light(a, a, a), make_light(a, b, a), make_light(a, b, a + 0.5f * (b - a)),
          make_light(vec3(0), vec3(0), vec3(0)), make_light(vec3(0), a, b)}) {
        // A line's area may round to something tiny: then so does its importance.
        const float got = importance({up, light});
        EXPECT_GE(got, 0.0f);
        EXPECT_LT(got, 1e-6f);
    }
    // In the horizon plane, and in the plane of the point.
    EXPECT_EQ(importance({up, make_light({1, 0, 0}, {2, 0, 0}, {1, 1, 0})}), 0.0f);
    EXPECT_EQ(importance({up, make_light({-1, -1, 0}, {2, -1, 0}, {-1, 2, 0})}), 0.0f);
}

TEST(FormFactor, LightsThatTouchTheHorizonCount) {
    // An edge or a corner in the horizon, the rest above.
    const Case edge{up, facing_origin(make_light({2, -1, 0}, {2, 1, 0}, {2, 0, 1}))};
    EXPECT_NEAR(importance(edge), reference(edge), 0.02 * reference(edge));
    const Case corner{up, facing_origin(make_light({2, 0, 0}, {2, -1, 1}, {2, 1, 1}))};
    EXPECT_NEAR(importance(corner), reference(corner), 0.02 * reference(corner));
    const Case below_edge{up, facing_origin(make_light({2, -1, 0}, {2, 1, 0}, {2, 0, -1}))};
    EXPECT_EQ(importance(below_edge), 0.0f);
}

// Whatever contributes has positive importance: no light may be impossible to choose. Extreme
// shapes: slivers, specks at a great distance, panels that almost touch the point, lights that
// barely rise above the horizon.
TEST(FormFactor, IsPositiveWhereverASampleContributes) {
    Random random = random_begin(uvec2(0, 0), 0, 3);
    int contributing = 0;
    for (int i = 0; i < 200000; ++i) {
        const float size = std::pow(10.0f, 6.0f * random_next(random) - 2.0f);
        const float distance = std::pow(10.0f, 6.0f * random_next(random) - 2.0f);
        Case c = random_case(random, size, distance);
        if (i % 3 == 0) c.light.e2 = mix(c.light.e1, c.light.e2, 1e-4f); // sliver
        if (i % 5 == 0)
            c.normal = normalize(cross(c.light.v0, random_direction(random)) +
                                 1e-3f * c.light.v0 / length(c.light.v0));
        c.light = facing_origin(c.light);
        const float got = importance(c);
        ASSERT_TRUE(std::isfinite(got) && got >= 0.0f && got <= 1.0f);
        for (int k = 0; k < 4; ++k) {
            const LightSample seen = sample_light(c.light, vec3(0.0f), random_next2(random));
            // Above the horizon by more than the rounding of the sample's own coordinates.
            if (seen.pdf > 0.0f &&
                dot(c.normal, seen.direction) * seen.distance > 1e-5f * (distance + size)) {
                ++contributing;
                ASSERT_GT(got, 0.0f) << "size " << size << " distance " << distance;
            }
        }
    }
    EXPECT_GT(contributing, 50000);
}

TEST(FormFactor, ScalesWithAlbedoAndRadiance) {
    Random random = random_begin(uvec2(0, 0), 0, 4);
    const Case c = random_case(random, 10.0f, 30.0f);
    Light bright = c.light;
    bright.radiance = vec3(1.0f, 2.0f, 3.0f) * 1000.0f;
    const LtcSurface surface = ltc_prepare_diffuse(vec3(0.0f), c.normal, 0.25f);
    EXPECT_FLOAT_EQ(ltc_importance(surface, bright, false),
                    0.25f * importance(c) * luminance(bright.radiance));
}

} // namespace
} // namespace vigil::shader
