// SPDX-License-Identifier: GPL-2.0-or-later
// Octahedral geometry in double precision, and midpoint integration over spherical triangles.
#include "sphere_cells.h"

namespace vigil::test {
namespace {

using glm::dvec2, glm::dvec3;

dvec2 fold(dvec2 p) {
    return {std::copysign(1.0 - std::abs(p.y), p.x), std::copysign(1.0 - std::abs(p.x), p.y)};
}

/// The point of the octahedron above a point of the square; exact where `uv` is dyadic.
dvec3 octahedron_point(dvec2 uv) {
    const dvec2 p = 2.0 * uv - 1.0;
    const double z = 1.0 - std::abs(p.x) - std::abs(p.y);
    return {z >= 0.0 ? p : fold(p), z};
}

/// Van Oosterom and Strackee, "The Solid Angle of a Plane Triangle", 1983; by differences, so that
/// small triangles keep their digits.
double solid_angle_of(dvec3 a, dvec3 b, dvec3 c) {
    a = glm::normalize(a), b = glm::normalize(b), c = glm::normalize(c);
    const double volume = std::abs(glm::dot(a, glm::cross(b - a, c - a)));
    return 2.0 * std::atan2(volume, 1.0 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
}

/// Adds the integral over a triangle in one face of the octahedron.
void integrate_triangle(dvec3 a, dvec3 b, dvec3 c, int cuts, const Density& density,
                        SquareIntegral& sum) {
    const dvec3 u = (b - a) / double(cuts), v = (c - a) / double(cuts);
    const auto add = [&](dvec3 p, dvec3 q, dvec3 r) {
        const double solid_angle = solid_angle_of(p, q, r);
        sum.solid_angle += solid_angle;
        sum.density += solid_angle * density(glm::normalize(p + q + r));
    };
    for (int j = 0; j < cuts; ++j)
        for (int i = 0; i + j < cuts; ++i) {
            const dvec3 p = a + double(i) * u + double(j) * v;
            add(p, p + u, p + v);
            if (i + j + 1 < cuts) add(p + u, p + u + v, p + v);
        }
}

} // namespace

dvec2 square_point(dvec3 d) {
    const double sum = std::abs(d.x) + std::abs(d.y) + std::abs(d.z);
    const dvec2 p = dvec2(d.x, d.y) / sum;
    return 0.5 * (d.z >= 0.0 ? p : fold(p)) + 0.5;
}

SquareIntegral integrate_square(dvec2 corner, double size, int cuts, const Density& density) {
    const dvec2 p = 2.0 * (corner + 0.5 * size) - 1.0;
    // The fold between the halves may run along one of the square's diagonals: cut there. Corners:
    // the diagonal's ends, and the two beside it.
    const bool rising = p.x * p.y < 0.0;
    const dvec3 start = octahedron_point(corner + size * dvec2(0.0, rising ? 0.0 : 1.0));
    const dvec3 end = octahedron_point(corner + size * dvec2(1.0, rising ? 1.0 : 0.0));
    SquareIntegral sum;
    for (const double side : {0.0, 1.0}) {
        const dvec2 beside = rising ? dvec2(side, 1.0 - side) : dvec2(side, side);
        integrate_triangle(octahedron_point(corner + size * beside), start, end, cuts, density,
                           sum);
    }
    return sum;
}

uint32_t quarter_of(const Quadtree::Node& node, dvec2 uv) {
    const dvec2 centre = node.corner + 0.5 * node.size;
    return (uv.x >= centre.x ? 1u : 0u) + (uv.y >= centre.y ? 2u : 0u);
}

} // namespace vigil::test
