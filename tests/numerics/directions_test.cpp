// SPDX-License-Identifier: GPL-2.0-or-later
// Directions at the extremes: axes, edges and corners of the octahedron, denormals, any bits; and
// how exact the octahedral map and its density are.
#include "record.h"
#include "shared/octahedral.h"
#include "shared/random.h"
#include "shared/sampling.h"

#include <array>
#include <limits>
#include <vector>

namespace vigil::shader {
namespace {

using test::any_float;
using test::record;
using test::slowdown;
using test::Worst;

bool in_square(vec2 uv) {
    return uv.x >= 0.0f && uv.y >= 0.0f && uv.x <= OCTAHEDRAL_MAX && uv.y <= OCTAHEDRAL_MAX;
}

/// The map in double precision: the direction of a point of the square.
glm::dvec3 exact_direction(vec2 uv) {
    const glm::dvec2 p = 2.0 * glm::dvec2(uv) - 1.0;
    const double z = 1.0 - std::abs(p.x) - std::abs(p.y);
    glm::dvec3 q(p, z);
    if (z < 0.0)
        q = {(1.0 - std::abs(p.y)) * (p.x >= 0.0 ? 1.0 : -1.0),
             (1.0 - std::abs(p.x)) * (p.y >= 0.0 ? 1.0 : -1.0), z};
    return glm::normalize(q);
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Unit vectors along axes, edges and corners, and beside them by a denormal, by one unit in the
/// last place, and by a little.
std::vector<vec3> extreme_directions() {
    std::vector<vec3> directions;
    const std::array<float, 5> near{0.0f, 1e-45f, 1e-38f, 0x1p-24f, 1e-3f};
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z) {
                if (x == 0 && y == 0 && z == 0) continue;
                for (const float dx : near)
                    for (const float dy : near)
                        for (const float sign : {-1.0f, 1.0f})
                            directions.push_back(normalize(
                                vec3(float(x) + sign * dx, float(y) - dy, float(z) + sign * dy)));
            }
    return directions;
}

TEST(Directions, EdgesAndCornersMapThereAndBack) {
    Worst angle;
    for (const vec3& direction : extreme_directions()) {
        const vec2 uv = octahedral_encode(direction);
        ASSERT_TRUE(in_square(uv)) << direction.x << " " << direction.y << " " << direction.z;
        angle.add(angle_between(glm::dvec3(octahedral_decode(uv)), glm::dvec3(direction)));
        const float density = octahedral_density(direction);
        ASSERT_TRUE(density >= 0.0481f && density <= 0.2500001f);
    }
    EXPECT_LT(angle.value(), 4e-7);
    record("directions", "axes, edges and corners of the octahedron, and beside them by a denormal",
           "in the square, and back to within 4e-7 radians", angle.text());
}

TEST(Directions, AnyBitsStayInTheSquare) {
    Random random = random_begin(uvec2(0, 0), 0, 1);
    for (int i = 0; i < 3000000 / slowdown; ++i) {
        const uvec3 words = random_next_words(random);
        ASSERT_TRUE(in_square(
            octahedral_encode(vec3(any_float(words.x), any_float(words.y), any_float(words.z)))));
    }
    const float big = std::numeric_limits<float>::max(), tiny = 1e-45f, nan = NAN;
    for (const vec3& v :
         {vec3(0), vec3(tiny, 0, 0), vec3(-tiny), vec3(big), vec3(nan), vec3(INFINITY),
          vec3(big, -big, -big), vec3(0, 0, nan), vec3(0, 0, -0.0f)})
        ASSERT_TRUE(in_square(octahedral_encode(v)));
    record("directions", "any bits: denormal, zero, overflowing and infinite lengths, NaN",
           "a point of the square", "");
}

TEST(Directions, MapAndDensityAreAsExactAsStated) {
    Random random = random_begin(uvec2(0, 0), 0, 2);
    Worst decode, encode, density, unit;
    for (int i = 0; i < 1000000 / slowdown; ++i) {
        const vec2 uv = random_next2(random);
        const glm::dvec3 exact = exact_direction(uv);
        const vec3 direction = octahedral_decode(uv);
        decode.add(angle_between(glm::dvec3(direction), exact));
        unit.add(test::relative_error(glm::length(glm::dvec3(direction)), 1.0));
        const vec2 again = octahedral_encode(direction);
        encode.add(glm::length(glm::dvec2(again) - glm::dvec2(uv)));
        // The density's own rounding, at the direction that it is given.
        const glm::dvec3 size = glm::abs(glm::dvec3(direction));
        const double sum = size.x + size.y + size.z;
        density.add(
            test::relative_error(double(octahedral_density(direction)), 0.25 / (sum * sum * sum)));
    }
    EXPECT_LT(decode.value(), 3e-7);
    EXPECT_LT(encode.value(), 3e-7);
    EXPECT_LT(density.value(), 10.0);
    EXPECT_LT(unit.value(), 4.0);
    record("precision", "octahedral map, square to direction", "within 3e-7 radians",
           decode.text());
    record("precision", "octahedral map, there and back", "within 3e-7 of the square",
           encode.text());
    record("precision", "octahedral density (Jacobian)", "relative error below 10 * 2^-24",
           density.text() + " * 2^-24");
}

TEST(Directions, BasesAreAsExactAsStated) {
    Random random = random_begin(uvec2(0, 0), 0, 3);
    std::vector<vec3> normals = extreme_directions();
    for (int i = 0; i < 300000 / slowdown; ++i)
        normals.push_back(normalize(sample_sphere(random_next2(random))));
    Worst error;
    for (const vec3& normal : normals) {
        const Basis basis = make_basis(normal);
        const glm::dvec3 t(basis.tangent), b(basis.bitangent), n(basis.normal);
        error.add(std::abs(glm::dot(t, b)));
        error.add(std::abs(glm::dot(t, n)));
        error.add(std::abs(glm::dot(b, n)));
        error.add(std::abs(glm::length(t) - 1.0));
        error.add(std::abs(glm::length(b) - 1.0));
    }
    EXPECT_LT(error.value(), 5e-7);
    record("precision", "bases around normals, those of all axes and edges included",
           "products and lengths within 5e-7", error.text());
}

} // namespace
} // namespace vigil::shader
