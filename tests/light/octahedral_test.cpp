// SPDX-License-Identifier: GPL-2.0-or-later
// The octahedral map: inverse both ways, safe at axes, folds and corners, and the density factor it
// promises.
#include "shared/octahedral.h"
#include "shared/random.h"
#include "shared/sampling.h"
#include "statistics.h"

#include <gtest/gtest.h>

namespace vigil::shader {
namespace {

std::vector<vec3> special_directions() {
    std::vector<vec3> directions;
    for (const float x : {-1.0f, -1e-20f, -0.0f, 0.0f, 1e-20f, 1.0f})
        for (const float y : {-1.0f, -1e-20f, -0.0f, 0.0f, 1e-20f, 1.0f})
            for (const float z : {-1.0f, -1e-20f, -0.0f, 0.0f, 1e-20f, 1.0f})
                if (x * x + y * y + z * z > 0.5f) directions.push_back(normalize(vec3(x, y, z)));
    return directions;
}

void expect_round_trip(vec3 direction) {
    const vec2 uv = octahedral_encode(direction);
    EXPECT_GE(uv.x, 0.0f);
    EXPECT_GE(uv.y, 0.0f);
    EXPECT_LT(uv.x, 1.0f);
    EXPECT_LT(uv.y, 1.0f);
    const vec3 back = octahedral_decode(uv);
    EXPECT_NEAR(length(back), 1.0f, 1e-6f);
    EXPECT_LT(length(back - direction), 2e-6f)
        << direction.x << ' ' << direction.y << ' ' << direction.z;
}

TEST(Octahedral, AxesEdgesAndCornersRoundTrip) {
    for (const vec3& direction : special_directions())
        expect_round_trip(direction);
}

TEST(Octahedral, DirectionsRoundTrip) {
    Random random = random_begin(uvec2(0, 0), 0, 1);
    for (int i = 0; i < 100000; ++i)
        expect_round_trip(normalize(sample_sphere(random_next2(random))));
}

TEST(Octahedral, SquareRoundTripsAndDecodesToUnitVectors) {
    for (int y = 0; y <= 64; ++y) {
        for (int x = 0; x <= 64; ++x) {
            const vec2 uv(static_cast<float>(x) / 64.0f, static_cast<float>(y) / 64.0f);
            const vec3 d = octahedral_decode(uv);
            EXPECT_NEAR(length(d), 1.0f, 1e-6f);
            // Opposite points of the border are the same direction: leave the border out.
            if (x % 64 == 0 || y % 64 == 0) continue;
            EXPECT_LT(length(octahedral_encode(d) - uv), 1e-6f) << x << ' ' << y;
        }
    }
}

TEST(Octahedral, HandlesAnyLengthAndZero) {
    EXPECT_EQ(octahedral_encode(vec3(0.0f)), vec2(0.5f));
    const vec3 d(0.3f, -0.5f, -0.2f);
    for (const float scale : {1e-30f, 1e-3f, 1e4f, 1e30f})
        EXPECT_LT(length(octahedral_encode(scale * d) - octahedral_encode(d)), 1e-6f);
}

// The density factor is the ratio of areas: of a small square cell, and of the solid angle it maps
// to.
TEST(Octahedral, DensityIsTheRatioOfAreas) {
    constexpr int size = 512;
    const auto corner = [](int x, int y) {
        const vec2 p(2.0f * static_cast<float>(x) / size - 1.0f,
                     2.0f * static_cast<float>(y) / size - 1.0f);
        double z = 1.0 - std::abs(double(p.x)) - std::abs(double(p.y));
        glm::dvec3 q(p.x, p.y, z);
        if (z < 0.0) {
            q.x = (1.0 - std::abs(double(p.y))) * (p.x >= 0.0f ? 1.0 : -1.0);
            q.y = (1.0 - std::abs(double(p.x))) * (p.y >= 0.0f ? 1.0 : -1.0);
        }
        return glm::normalize(q);
    };
    double sphere = 0.0;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const glm::dvec3 a = corner(x, y), b = corner(x + 1, y), c = corner(x + 1, y + 1),
                             d = corner(x, y + 1);
            const double solid_angle = 0.5 * glm::length(glm::cross(c - a, d - b));
            sphere += solid_angle;
            const vec2 uv((static_cast<float>(x) + 0.5f) / size,
                          (static_cast<float>(y) + 0.5f) / size);
            // Cells on the fold |x| + |y| = 1 bend.
            if (std::abs(std::abs(2 * uv.x - 1) + std::abs(2 * uv.y - 1) - 1) < 2.0f / size)
                continue;
            const double ratio = 1.0 / (double(size) * size) / solid_angle;
            EXPECT_NEAR(octahedral_density(octahedral_decode(uv)) / ratio, 1.0, 1e-3)
                << x << ' ' << y;
        }
    }
    EXPECT_NEAR(sphere, 4.0 * 3.14159265358979, 1e-3);
}

} // namespace
} // namespace vigil::shader
