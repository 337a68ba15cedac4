// SPDX-License-Identifier: GPL-2.0-or-later
// The sampling maps: ranges at the extremes of their input, distributions, bases, and the ray
// offset.
#include "shared/random.h"
#include "shared/sampling.h"
#include "statistics.h"

#include <gtest/gtest.h>

#include <limits>

namespace vigil::shader {
namespace {

using test::chi_square_z;
using test::Sample;
using test::z_limit;

constexpr float below_one = 1.0f - 1.0f / 16777216.0f;
constexpr int draws = 1 << 18;

std::vector<vec2> extreme_inputs() {
    std::vector<vec2> inputs;
    for (const float x : {0.0f, 1.0f / 16777216.0f, 0.25f, 0.5f, 0.75f, below_one})
        for (const float y : {0.0f, 1.0f / 16777216.0f, 0.25f, 0.5f, 0.75f, below_one})
            inputs.emplace_back(x, y);
    return inputs;
}

Random stream(uint seed) {
    return random_begin(uvec2(0, 0), 0, seed);
}

vec3 random_direction(Random& random) {
    return sample_sphere(random_next2(random));
}

TEST(Basis, IsOrthonormalAndRightHandedEverywhere) {
    std::vector<vec3> normals{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    normals.push_back(normalize(vec3(1e-4f, 0, -1)));
    normals.push_back(normalize(vec3(0, -1e-7f, -1)));
    normals.push_back(normalize(vec3(1, 1, -1e-8f)));
    normals.push_back(vec3(1, 0, -0.0f));
    Random random = stream(1);
    for (int i = 0; i < 10000; ++i)
        normals.push_back(normalize(random_direction(random)));
    for (const vec3& n : normals) {
        const Basis b = make_basis(n);
        EXPECT_NEAR(length(b.tangent), 1.0f, 1e-6f);
        EXPECT_NEAR(length(b.bitangent), 1.0f, 1e-6f);
        EXPECT_NEAR(dot(b.tangent, b.bitangent), 0.0f, 1e-6f);
        EXPECT_NEAR(dot(b.tangent, n), 0.0f, 1e-6f);
        EXPECT_NEAR(dot(b.bitangent, n), 0.0f, 1e-6f);
        EXPECT_NEAR(dot(cross(b.tangent, b.bitangent), n), 1.0f, 1e-6f);
        const vec3 d(0.36f, -0.48f, 0.8f);
        EXPECT_LT(length(to_local(b, to_world(b, d)) - d), 1e-6f);
    }
}

TEST(Sampling, ExtremeInputsStayInRange) {
    for (const vec2& u : extreme_inputs()) {
        EXPECT_LE(length(sample_disk(u)), 1.0f);
        const vec3 hemisphere = sample_cosine_hemisphere(u);
        EXPECT_NEAR(length(hemisphere), 1.0f, 1e-6f);
        EXPECT_GE(hemisphere.z, 1.0f / 4096.0f);
        EXPECT_GT(cosine_hemisphere_pdf(hemisphere.z), 0.0f);
        EXPECT_NEAR(length(sample_sphere(u)), 1.0f, 1e-6f);
        for (const float size : {1e-7f, 1e-5f, 0.5f, 1.0f, 2.0f}) {
            const vec3 cone = sample_cone(u, size);
            EXPECT_NEAR(length(cone), 1.0f, 1e-6f);
            EXPECT_GE(1.0f - cone.z, 0.0f);
            EXPECT_LE(1.0f - cone.z, size + 1.2e-7f);
        }
        const vec2 weights = sample_triangle(u);
        EXPECT_GE(weights.x, 0.0f);
        EXPECT_GE(weights.y, 0.0f);
        EXPECT_LE(weights.x + weights.y, 1.0f);
    }
}

TEST(Sampling, CosineHemisphereHasItsDensity) {
    // Equal-probability cells: cos^2 and azimuth are uniform.
    Random random = stream(2);
    std::vector<uint64_t> counts(32 * 32);
    for (int i = 0; i < draws; ++i) {
        const vec3 d = sample_cosine_hemisphere(random_next2(random));
        const double azimuth = std::atan2(d.y, d.x) / (2.0 * 3.14159265358979) + 0.5;
        const int row = std::min(static_cast<int>(d.z * d.z * 32.0f), 31);
        ++counts[row * 32 + std::min(static_cast<int>(azimuth * 32.0), 31)];
    }
    EXPECT_LT(std::abs(chi_square_z(counts)), z_limit);
}

TEST(Sampling, SphereAndDiskAreUniform) {
    Random random = stream(3);
    std::vector<uint64_t> sphere(32 * 32), disk(32 * 32);
    for (int i = 0; i < draws; ++i) {
        const vec3 d = random_direction(random);
        const double azimuth = std::atan2(d.y, d.x) / (2.0 * 3.14159265358979) + 0.5;
        const int row = std::min(static_cast<int>((0.5f * d.z + 0.5f) * 32.0f), 31);
        ++sphere[row * 32 + std::min(static_cast<int>(azimuth * 32.0), 31)];
        const vec2 p = sample_disk(random_next2(random));
        const double angle = std::atan2(p.y, p.x) / (2.0 * 3.14159265358979) + 0.5;
        const int ring = std::min(static_cast<int>(dot(p, p) * 32.0f), 31);
        ++disk[ring * 32 + std::min(static_cast<int>(angle * 32.0), 31)];
    }
    EXPECT_LT(std::abs(chi_square_z(sphere)), z_limit);
    EXPECT_LT(std::abs(chi_square_z(disk)), z_limit);
}

TEST(Sampling, TriangleIsUniform) {
    // Each barycentric coordinate b of a uniform point has P(b > t) = (1 - t)^2, so that value is
    // uniform.
    Random random = stream(4);
    std::vector<uint64_t> counts[3];
    for (auto& c : counts)
        c.resize(256);
    Sample product;
    for (int i = 0; i < draws; ++i) {
        const vec2 w = sample_triangle(random_next2(random));
        const float b[3] = {1.0f - w.x - w.y, w.x, w.y};
        for (int k = 0; k < 3; ++k)
            ++counts[k][std::min(static_cast<int>((1.0f - b[k]) * (1.0f - b[k]) * 256.0f), 255)];
        product.add(w.x * w.y);
    }
    for (const auto& c : counts)
        EXPECT_LT(std::abs(chi_square_z(c)), z_limit);
    EXPECT_LT(std::abs(product.z(1.0 / 12.0)), z_limit);
}

TEST(Sampling, ConeIsUniformAndContainsWhatItDraws) {
    Random random = stream(5);
    for (const float half_angle :
         {0.0047f, 0.1f, 1.0f, 3.0f}) { // the sun's radius is 0.0047 radians
        const float size = cone_size(half_angle);
        EXPECT_NEAR(size, 1.0 - std::cos(static_cast<double>(half_angle)), 1e-6 * size);
        EXPECT_NEAR(cone_pdf(size) * 2.0 * 3.14159265358979 * size, 1.0, 1e-6);
        std::vector<uint64_t> counts(64);
        for (int i = 0; i < draws / 4; ++i) {
            const Basis basis = make_basis(normalize(random_direction(random)));
            const vec3 local = sample_cone(random_next2(random), size);
            EXPECT_TRUE(in_cone(normalize(to_world(basis, local)), basis.normal, size * 1.001f));
            // 1 - cos from the chord, which keeps its digits.
            const double depth = 0.5 * (double(local.x) * local.x + double(local.y) * local.y +
                                        (1.0 - local.z) * (1.0 - local.z));
            ++counts[std::min(static_cast<int>(depth / size * 64.0), 63)];
        }
        EXPECT_LT(std::abs(chi_square_z(counts)), z_limit) << "half angle " << half_angle;
        EXPECT_FALSE(in_cone(vec3(std::sin(half_angle * 1.01f), 0, std::cos(half_angle * 1.01f)),
                             vec3(0, 0, 1), size));
    }
}

// Points of triangles, interpolated from their vertices, end on the right side of their plane after
// the offset, by a margin, and close to it.
TEST(RayOffset, LeavesTheSurfaceByASmallMargin) {
    Random random = stream(6);
    for (const float extent : {64.0f, 1024.0f, 4096.0f, 32768.0f, 131072.0f}) {
        double least = std::numeric_limits<double>::max(), most = 0.0;
        for (int i = 0; i < 50000; ++i) {
            const vec3 v0 = extent * (2.0f * random_next3(random) - 1.0f);
            const vec3 e1 = 512.0f * random_direction(random) * random_next(random);
            const vec3 e2 = 512.0f * random_direction(random) * random_next(random);
            const vec3 n = cross(e1, e2);
            if (length(n) < 1.0f) continue;
            const vec3 normal = normalize(n);
            const vec2 w = sample_triangle(random_next2(random));
            const vec3 position = v0 + w.x * e1 + w.y * e2;
            const vec3 lifted = offset_ray_origin(position, normal);
            const glm::dvec3 plane = glm::normalize(glm::cross(glm::dvec3(e1), glm::dvec3(e2)));
            const double height = glm::dot(plane, glm::dvec3(lifted) - glm::dvec3(v0));
            const vec3 size = abs(position);
            const double offset =
                RAY_OFFSET_SCALE * max(max(size.x, size.y), max(size.z, RAY_OFFSET_REACH));
            least = std::min(least, height / offset);
            most = std::max(most, height / offset);
        }
        EXPECT_GT(least, 0.5) << "extent " << extent;
        EXPECT_LT(most, 1.5) << "extent " << extent;
    }
    EXPECT_LE(offset_ray_origin(vec3(4096, 0, 0), vec3(0, 0, 1)).z, 0.01f);
}

} // namespace
} // namespace vigil::shader
