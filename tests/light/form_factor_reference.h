// SPDX-License-Identifier: GPL-2.0-or-later
// The cosine-weighted integral over a triangle in double precision: clipped as a polygon, each
// edge's angle by atan2, which is exact for tiny and for straight angles alike. Written apart from
// the code under test.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <vector>

namespace vigil::test {

/// Form factor in [0, 1] of the triangle (v0, v1, v2), seen from the origin with this unit normal,
/// if its front (counter-clockwise) side faces the origin; else 0.
inline double reference_form_factor(glm::dvec3 normal, glm::dvec3 v0, glm::dvec3 v1,
                                    glm::dvec3 v2) {
    if (glm::dot(glm::cross(v1 - v0, v2 - v0), -v0) <= 0.0) return 0.0;
    const glm::dvec3 corners[3] = {v0, v1, v2};
    std::vector<glm::dvec3> polygon;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 a = corners[i], b = corners[(i + 1) % 3];
        const double za = glm::dot(normal, a), zb = glm::dot(normal, b);
        if (za >= 0.0) polygon.push_back(a);
        if ((za > 0.0 && zb < 0.0) || (za < 0.0 && zb > 0.0))
            polygon.push_back(a + (b - a) * (za / (za - zb)));
    }
    if (polygon.size() < 3) return 0.0;
    // Small triangles cancel in the contour: integrate the point form over recursive quarters
    // instead.
    const double extent = glm::dot(v1 - v0, v1 - v0) + glm::dot(v2 - v0, v2 - v0);
    double sum = 0.0;
    if (extent < 1e-6 * glm::dot(v0, v0)) {
        for (size_t i = 2; i < polygon.size(); ++i) {
            const glm::dvec3 area =
                0.5 * glm::cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
            const glm::dvec3 c = (polygon[0] + polygon[i - 1] + polygon[i]) / 3.0;
            const double r2 = glm::dot(c, c);
            sum += glm::dot(normal, c) * glm::dot(area, -c) / (3.14159265358979323846 * r2 * r2);
        }
        return sum;
    }
    for (size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const glm::dvec3 c = glm::cross(b, a);
        const double length = glm::length(c);
        if (length > 0.0) sum += std::atan2(length, glm::dot(a, b)) * glm::dot(normal, c) / length;
    }
    return sum / (2.0 * 3.14159265358979323846);
}

} // namespace vigil::test
