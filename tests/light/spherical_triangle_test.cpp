// SPDX-License-Identifier: GPL-2.0-or-later
// Triangles seen from a point, from tiny to huge and from round to needle: the solid angle is that
// of double precision, and points are drawn evenly in it.
#include "shared/random.h"
#include "shared/spherical_triangle.h"
#include "shared/triangle_light.h"
#include "statistics.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>

namespace vigil::shader {
namespace {

using test::z_limit;

/// Solid angle of a triangle of offsets, positive if they are counter-clockwise from inside.
double exact_solid_angle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    // Edges first: differences of far corners keep their digits in double precision.
    const double volume = glm::dot(a, glm::cross(b - a, c - a));
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    return 2.0 * std::atan2(volume, la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la +
                                        glm::dot(c, a) * lb);
}

struct Shape {
    const char* name;
    vec3 a, e1, e2;
};

/// Lit towards the origin: cross(e1, e2) points there.
const Shape shapes[] = {
    {"round, near", {-8, -8, 12}, {0, 16, 0}, {16, 0, 0}},
    {"a thousandth of its distance", {300, 200, 900}, {0, 1, 0.2f}, {1, 0, -0.1f}},
    {"a hundred thousandth", {3000, 2000, 9000}, {0, 0.1f, 0.01f}, {0.1f, 0, 0}},
    {"a needle", {-100, -0.05f, 20}, {0, 0.1f, 0}, {200, 0, 0}},
    {"long, seen along its plane", {1, -3, 0.01f}, {200, 1, 0}, {180, -9, 0}},
    {"long, seen along its length", {1, 0, 0.5f}, {400, 2, 100}, {400, -2, 100}},
    {"nearly half of all directions", {-3000, -2000, 0.25f}, {6000, 100, 0}, {2900, 5000, 0}},
    {"one corner close by", {0.001f, 0, 0.001f}, {0, 8, 3}, {8, -1, 1}},
};

/// With the edges in the order in which the lit side is seen.
Shape lit(Shape shape) {
    if (-dot(cross(shape.e1, shape.e2), shape.a) < 0.0f) std::swap(shape.e1, shape.e2);
    return shape;
}

TEST(SphericalTriangle, SolidAngleIsExact) {
    for (const Shape& given : shapes) {
        const Shape shape = lit(given);
        const glm::dvec3 a(shape.a), e1(shape.e1), e2(shape.e2);
        const double exact = std::abs(exact_solid_angle(a, a + e1, a + e2));
        const SphericalTriangle seen = spherical_triangle(shape.a, shape.e1, shape.e2);
        EXPECT_NEAR(static_cast<double>(seen.solid_angle) / exact, 1.0, 1e-5) << shape.name;
        const Light light{shape.a, shape.e1, shape.e2, vec3(1.0f), 0};
        EXPECT_NEAR(static_cast<double>(light_solid_angle(light, vec3(0.0f))) / exact, 1.0, 1e-5)
            << shape.name;
        const Light back{shape.a, shape.e2, shape.e1, vec3(1.0f), 0};
        EXPECT_EQ(light_solid_angle(back, vec3(0.0f)), 0.0f) << shape.name;
    }
}

/// Nine cells of a triangle: it is cut into three at a point of it, and each of these again.
struct Cells {
    struct Cell {
        std::array<glm::dvec2, 3> corners; // weights of e1 and e2
    };
    std::vector<Cell> cells;

    explicit Cells(Random& random) { cut({{{{0, 0}, {1, 0}, {0, 1}}}}, 2, random); }

    void cut(const Cell& cell, int depth, Random& random) {
        if (depth == 0) {
            cells.push_back(cell);
            return;
        }
        const vec3 u = random_next3(random) + 0.3f;
        const glm::dvec3 share = glm::dvec3(u) / static_cast<double>(u.x + u.y + u.z);
        const glm::dvec2 inside =
            share.x * cell.corners[0] + share.y * cell.corners[1] + share.z * cell.corners[2];
        for (size_t i = 0; i < 3; ++i)
            cut({{cell.corners[i], cell.corners[(i + 1) % 3], inside}}, depth - 1, random);
    }

    size_t find(const glm::dvec2& point) const {
        // The cell in which the point lies deepest; rounding may put it outside of all.
        const auto depth = [&](const Cell& cell) {
            double least = 1e30;
            for (size_t i = 0; i < 3; ++i) {
                const glm::dvec2 a = cell.corners[i], along = cell.corners[(i + 1) % 3] - a;
                const glm::dvec2 to = point - a;
                least = std::min(least, along.x * to.y - along.y * to.x);
            }
            return least;
        };
        return static_cast<size_t>(std::ranges::max_element(cells, {}, depth) - cells.begin());
    }
};

TEST(SphericalTriangle, PointsAreDrawnEvenlyInSolidAngle) {
    constexpr int draws = 40000;
    Random random = random_begin(uvec2(0, 0), 0, 31);
    for (const Shape& shape : shapes) {
        for (int turn = 0; turn < 3; ++turn) { // another corner comes first
            SCOPED_TRACE(shape.name);
            Shape turned = shape;
            for (int i = 0; i < turn; ++i)
                turned = {shape.name, turned.a + turned.e1, turned.e2 - turned.e1, -turned.e1};
            const SphericalTriangle triangle = spherical_triangle(turned.a, turned.e1, turned.e2);
            const Cells cells(random);
            std::vector<double> shares;
            double sum = 0.0;
            for (const Cells::Cell& cell : cells.cells) {
                std::array<glm::dvec3, 3> corner;
                for (size_t i = 0; i < 3; ++i)
                    corner[i] = glm::dvec3(turned.a) + cell.corners[i].x * glm::dvec3(turned.e1) +
                                cell.corners[i].y * glm::dvec3(turned.e2);
                shares.push_back(std::abs(exact_solid_angle(corner[0], corner[1], corner[2])));
                sum += shares.back();
            }
            std::vector<uint64_t> counts(shares.size(), 0);
            for (int i = 0; i < draws; ++i) {
                const vec2 weights = sample_spherical_triangle(triangle, random_next2(random));
                ASSERT_GE(weights.x, 0.0f);
                ASSERT_GE(weights.y, 0.0f);
                ASSERT_LE(weights.x + weights.y, 1.0f + 1e-6f);
                ++counts[cells.find(weights)];
            }
            // Cells too small to expect ten points in go together.
            std::vector<uint64_t> seen{0};
            std::vector<double> expected{0.0};
            for (size_t i = 0; i < shares.size(); ++i) {
                const double share = shares[i] / sum;
                if (share * draws < 10.0) {
                    seen[0] += counts[i];
                    expected[0] += share;
                } else {
                    seen.push_back(counts[i]);
                    expected.push_back(share);
                }
            }
            if (expected[0] * draws < 3.0) {
                EXPECT_LT(seen[0], 20u);
                expected[1] += expected[0];
                seen[1] += seen[0];
                expected.erase(expected.begin());
                seen.erase(seen.begin());
            }
            if (seen.size() < 2) continue;
            EXPECT_LT(std::abs(test::chi_square_z(seen, expected)), z_limit);
        }
    }
}

TEST(SphericalTriangle, CornersOfTheUnitSquareStayInside) {
    Random random = random_begin(uvec2(0, 0), 0, 32);
    const float most = 1.0f - 1.0f / 16777216.0f;
    for (int i = 0; i < 20000; ++i) {
        const vec3 a =
            sample_sphere(random_next2(random)) * std::pow(10.0f, 6 * random_next(random));
        const vec3 e1 =
            sample_sphere(random_next2(random)) * std::pow(10.0f, 8 * random_next(random) - 3);
        const vec3 e2 =
            sample_sphere(random_next2(random)) * std::pow(10.0f, 8 * random_next(random) - 3);
        const SphericalTriangle triangle = spherical_triangle(a, e1, e2);
        for (const vec2 u : {vec2(0, 0), vec2(most, 0), vec2(0, most), vec2(most, most)}) {
            const vec2 weights = sample_spherical_triangle(triangle, u);
            ASSERT_TRUE(weights.x >= 0.0f && weights.y >= 0.0f &&
                        weights.x + weights.y <= 1.0f + 1e-6f)
                << weights.x << " " << weights.y;
        }
    }
}

TEST(SphericalTriangle, EveryDensityOfALightHasItsSolidAngleAsMean) {
    Random random = random_begin(uvec2(0, 0), 0, 33);
    for (const int density : {LIGHT_DENSITY_AUTO, LIGHT_DENSITY_AREA, LIGHT_DENSITY_SOLID_ANGLE}) {
        for (const size_t shape :
             {0u, 1u, 2u}) { // area sampling has no finite variance beside a light
            const Shape& given = shapes[shape];
            const Shape s = lit(given);
            const Light light{s.a, s.e1, s.e2, vec3(1.0f), 0};
            const SphericalTriangle near = near_light(light, vec3(0.0f), density);
            EXPECT_TRUE(density != LIGHT_DENSITY_AREA || near.solid_angle == 0.0f);
            EXPECT_TRUE(density != LIGHT_DENSITY_SOLID_ANGLE || near.solid_angle > 0.0f);
            test::Sample mean;
            for (int i = 0; i < 20000; ++i) {
                const LightSample seen =
                    sample_light(light, near, vec3(0.0f), random_next2(random));
                ASSERT_NEAR(seen.geometry * light_pdf(light, near, vec3(0.0f), seen.point), 1.0f,
                            1e-4f);
                mean.add(static_cast<double>(seen.geometry));
            }
            const glm::dvec3 a(s.a), e1(s.e1), e2(s.e2);
            const double exact = std::abs(exact_solid_angle(a, a + e1, a + e2));
            EXPECT_LT(std::abs(mean.mean() - exact), z_limit * mean.standard_error() + 1e-5 * exact)
                << s.name << ", density " << density;
        }
    }
}

} // namespace
} // namespace vigil::shader
