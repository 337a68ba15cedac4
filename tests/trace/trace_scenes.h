// SPDX-License-Identifier: GPL-2.0-or-later
// Triangles, rays and the slow truths the tracing tests compare with: brute force with the shared
// triangle test, and the same in double precision to tell which hits are beyond doubt.
#pragma once

#include "refresh/vkpt/scene/bvh_builder.h"
#include "shared/bvh.h"

#include <random>
#include <vector>

namespace vigil::test {

using Triangles = std::vector<BvhInputTriangle>;

/// Triangles with corners `size` around centres that are uniform in [-extent, extent]^3 + offset.
Triangles random_triangles(std::size_t count, float extent, float size, std::uint32_t seed,
                           glm::vec3 offset = glm::vec3(0.0f));
/// Rooms as levels have them: axis-aligned quads of very different sizes, many long and thin, all
/// flat.
Triangles brush_triangles(std::size_t count, std::uint32_t seed);
/// A closed sphere.
Triangles sphere_triangles(int rings, float radius, glm::vec3 center);

/// Leaf-ordered triangles as the GPU gets them.
std::vector<shader::BvhTriangle> leaf_triangles(const Triangles& triangles,
                                                const std::vector<std::uint32_t>& order);

/// Rays from in and around `bounds`, a part of them along the axes, in coordinate planes or
/// starting on triangles.
std::vector<shader::Ray> random_rays(std::size_t count, const Bounds& bounds, std::uint32_t seed);

/// Closest hit by testing everything; t = ray.t_max when there is none.
shader::Hit brute_force(const std::vector<shader::BvhTriangle>& triangles, const shader::Ray& ray,
                        std::uint32_t seed = 0, std::uint32_t instance = 0);

/// Where a ray meets a triangle's plane, in double precision, and how far single precision may be
/// off.
struct ExactHit {
    double t, u, v;
    double tolerance;   // of u and v
    double t_tolerance; // of t
    bool front;

    /// Whether the ray hits the triangle beyond doubt.
    bool certain(const shader::Ray& ray) const {
        return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > ray.t_min + t_tolerance &&
               t < ray.t_max - t_tolerance;
    }
};
ExactHit exact_hit(const shader::BvhTriangle& triangle, const shader::Ray& ray);

} // namespace vigil::test
