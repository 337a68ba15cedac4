// SPDX-License-Identifier: GPL-2.0-or-later
// Sampling triangular lights: points lie on the light, densities are true, and lights that cannot
// shine say so.
#include "shared/random.h"
#include "shared/triangle_light.h"
#include "statistics.h"

#include <gtest/gtest.h>

namespace vigil::shader {
namespace {

using test::Sample;
using test::z_limit;

Light overhead() {
    return {{-8, -8, 30}, {0, 16, 0}, {16, 0, 0}, vec3(1.0f), 0};
}

/// Solid angle of a triangle seen from the origin (Van Oosterom and Strackee 1983).
double solid_angle(const Light& light) {
    const glm::dvec3 a = glm::normalize(glm::dvec3(light.v0));
    const glm::dvec3 b = glm::normalize(glm::dvec3(light.v0) + glm::dvec3(light.e1));
    const glm::dvec3 c = glm::normalize(glm::dvec3(light.v0) + glm::dvec3(light.e2));
    return 2.0 * std::abs(std::atan2(glm::dot(a, glm::cross(b, c)),
                                     1.0 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a)));
}

TEST(TriangleLight, SamplesIntegrateToTheSolidAngle) {
    Random random = random_begin(uvec2(0, 0), 0, 1);
    for (int i = 0; i < 30; ++i) {
        const float distance = std::pow(10.0f, 1.0f + 2.0f * random_next(random));
        const vec3 v0 = distance * normalize(sample_sphere(random_next2(random)));
        Light light{v0, 20.0f * sample_sphere(random_next2(random)),
                    20.0f * sample_sphere(random_next2(random)), vec3(1.0f), 0};
        if (light_facing(light, vec3(0.0f)) < 0.0f) std::swap(light.e1, light.e2);
        Sample mean;
        for (int k = 0; k < 20000; ++k) {
            const LightSample seen = sample_light(light, vec3(0.0f), random_next2(random));
            ASSERT_NEAR(length(seen.direction), 1.0f, 1e-5f);
            ASSERT_NEAR(seen.geometry * seen.pdf, 1.0f, 1e-5f);
            mean.add(seen.geometry);
        }
        EXPECT_LT(std::abs(mean.mean() - solid_angle(light)),
                  z_limit * mean.standard_error() + 1e-5 * solid_angle(light));
    }
}

TEST(TriangleLight, PointsLieOnTheLight) {
    Random random = random_begin(uvec2(0, 0), 0, 2);
    const Light light = overhead();
    for (int i = 0; i < 1000; ++i) {
        const LightSample seen = sample_light(light, vec3(1, 2, 3), random_next2(random));
        EXPECT_FLOAT_EQ(seen.point.z, 30.0f);
        EXPECT_GE(seen.point.x, -8.0f);
        EXPECT_GE(seen.point.y, -8.0f);
        EXPECT_LE(seen.point.x + seen.point.y, 1e-5f);
        EXPECT_LT(length(vec3(1, 2, 3) + seen.distance * seen.direction - seen.point), 1e-4f);
        EXPECT_FLOAT_EQ(light_pdf(light, vec3(1, 2, 3), seen.point), seen.pdf);
    }
}

TEST(TriangleLight, PdfIsDistanceSquaredOverProjectedArea) {
    const LightSample seen = see_light_point(overhead(), vec3(0.0f), vec3(0, 0, 30));
    EXPECT_FLOAT_EQ(seen.distance, 30.0f);
    EXPECT_FLOAT_EQ(seen.pdf, 900.0f / 128.0f);
    EXPECT_FLOAT_EQ(light_area(overhead()), 128.0f);
    EXPECT_FLOAT_EQ(light_normal(overhead()).z, -1.0f);
}

TEST(TriangleLight, ShinesFromItsFrontOnly) {
    EXPECT_EQ(sample_light(overhead(), vec3(0, 0, 40), vec2(0.5f)).pdf, 0.0f);
    EXPECT_EQ(sample_light(overhead(), vec3(0, 0, 40), vec2(0.5f)).geometry, 0.0f);
    EXPECT_GT(sample_light(overhead(), vec3(0, 0, 20), vec2(0.5f)).pdf, 0.0f);
    EXPECT_EQ(sample_light(overhead(), vec3(500, 0, 30), vec2(0.5f)).pdf, 0.0f) << "in its plane";
    EXPECT_EQ(sample_light(overhead(), vec3(0, 0, 30), vec2(0.5f)).pdf, 0.0f) << "on the light";
}

TEST(TriangleLight, ExtremeShapesStayFinite) {
    const vec3 a(1, 2, 3), b(4, 0, 1);
    for (const Light& light :
         {Light{a, vec3(0), vec3(0), vec3(1), 0}, Light{a, b, b, vec3(1), 0},
          Light{a, b, -b, vec3(1), 0}, Light{a, 1e-15f * b, vec3(0, 1e-15f, 0), vec3(1), 0},
          Light{a, b, b * 1.0001f, vec3(1), 0}, Light{a, 1e10f * b, vec3(0, -1e10f, 0), vec3(1), 0},
          Light{vec3(0), a, b, vec3(1), 0}}) {
        for (const float x : {0.0f, 0.3f, 1.0f - 1.0f / 16777216.0f}) {
            const LightSample seen = sample_light(light, vec3(0.0f), vec2(x, 1.0f - x));
            EXPECT_TRUE(std::isfinite(seen.pdf) && seen.pdf >= 0.0f);
            EXPECT_TRUE(std::isfinite(seen.geometry) && seen.geometry >= 0.0f);
            EXPECT_EQ(seen.pdf > 0.0f, seen.geometry > 0.0f);
            EXPECT_TRUE(std::isfinite(seen.direction.x));
        }
        const vec3 normal = light_normal(light);
        EXPECT_TRUE(length(normal) == 0.0f || std::abs(length(normal) - 1.0f) < 1e-5f);
    }
    // A sliver a thousand times as long as wide has the density its area says.
    const Light sliver{{-500, -0.5f, 10}, {0, 1, 0}, {1000, 0, 0}, vec3(1), 0};
    EXPECT_FLOAT_EQ(see_light_point(sliver, vec3(0.0f), vec3(0, 0, 10)).pdf, 100.0f / 500.0f);
}

} // namespace
} // namespace vigil::shader
