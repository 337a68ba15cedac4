// SPDX-License-Identifier: GPL-2.0-or-later
// The quarters of a quadtree's leaves as regions of the sphere, in double precision. The octahedral
// map takes straight lines within one face of the octahedron to great circles, so every quarter is
// two spherical triangles: densities are integrated over them with exact solid angles, without the
// map's density factor. No code is shared with shaders/shared.
#pragma once

#include "quadtree.h"

#include <functional>

namespace vigil::test {

/// Direction to a point of [0, 1)^2, not rounded to a border; the zero vector has none.
glm::dvec2 square_point(glm::dvec3 direction);

/// Integral over the square from `corner` of a density per steradian, and the square's solid angle.
/// Each triangle is cut into `cuts`^2 that count by the density at their centre: the error falls
/// with 1 / `cuts`^2 where the density is smooth. The square must not cross the axes of the map.
struct SquareIntegral {
    double density = 0.0, solid_angle = 0.0;
};
using Density = std::function<double(glm::dvec3)>;
SquareIntegral integrate_square(glm::dvec2 corner, double size, int cuts, const Density& density);

/// Quarter 0..3 of the node's square that holds a point of it, numbered as its children would be.
uint32_t quarter_of(const Quadtree::Node& node, glm::dvec2 uv);

} // namespace vigil::test
