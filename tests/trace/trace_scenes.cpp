// SPDX-License-Identifier: GPL-2.0-or-later
// See trace_scenes.h. Everything follows from the seeds.
#include "trace_scenes.h"

#include <cmath>

namespace vigil::test {

namespace {

class Random {
public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    /// Uniform in [low, high).
    float between(float low, float high) {
        return low + (high - low) * static_cast<float>(engine_() >> 8) * 0x1p-24f;
    }
    glm::vec3 in_cube(float extent) {
        const float x = between(-extent, extent);
        const float y = between(-extent, extent);
        return {x, y, between(-extent, extent)};
    }
    glm::vec3 direction() {
        const float z = between(-1.0f, 1.0f);
        const float phi = between(0.0f, 6.2831853f);
        const float r = std::sqrt(std::max(0.0f, 1.0f - z * z));
        return {r * std::cos(phi), r * std::sin(phi), z};
    }
    std::uint32_t below(std::uint32_t count) {
        return static_cast<std::uint32_t>(engine_() % count);
    }

private:
    std::mt19937 engine_;
};

} // namespace

Triangles random_triangles(std::size_t count, float extent, float size, std::uint32_t seed,
                           glm::vec3 offset) {
    Random random(seed);
    Triangles triangles(count);
    for (BvhInputTriangle& triangle : triangles) {
        const glm::vec3 center = random.in_cube(extent) + offset;
        triangle.v0 = center + random.in_cube(size);
        triangle.v1 = center + random.in_cube(size);
        triangle.v2 = center + random.in_cube(size);
    }
    return triangles;
}

Triangles brush_triangles(std::size_t count, std::uint32_t seed) {
    Random random(seed);
    Triangles triangles;
    while (triangles.size() + 1 < count) {
        const int axis = static_cast<int>(random.below(3));
        glm::vec3 corner = glm::floor(random.in_cube(128.0f)) * 16.0f;
        glm::vec3 a(0.0f);
        glm::vec3 b(0.0f);
        a[(axis + 1) % 3] = 8.0f * static_cast<float>(1 + random.below(64));
        b[(axis + 2) % 3] = random.below(3) == 0 ? 512.0f : 8.0f;
        triangles.push_back({corner, corner + a, corner + a + b, 255});
        triangles.push_back({corner, corner + a + b, corner + b, 255});
    }
    return triangles;
}

Triangles sphere_triangles(int rings, float radius, glm::vec3 center) {
    const int segments = 2 * rings;
    const auto point = [&](int ring, int segment) {
        const float theta = 3.14159265f * static_cast<float>(ring) / static_cast<float>(rings);
        const float phi =
            6.2831853f * static_cast<float>(segment % segments) / static_cast<float>(segments);
        const float r = ring == 0 || ring == rings ? 0.0f : std::sin(theta);
        return center + radius * glm::vec3(r * std::cos(phi), r * std::sin(phi), std::cos(theta));
    };
    Triangles triangles;
    for (int ring = 0; ring < rings; ++ring) {
        for (int segment = 0; segment < segments; ++segment) {
            const glm::vec3 a = point(ring, segment);
            const glm::vec3 b = point(ring + 1, segment);
            const glm::vec3 c = point(ring + 1, segment + 1);
            const glm::vec3 d = point(ring, segment + 1);
            if (ring + 1 < rings) triangles.push_back({a, b, c, 255});
            if (ring > 0) triangles.push_back({a, c, d, 255});
        }
    }
    return triangles;
}

std::vector<shader::BvhTriangle> leaf_triangles(const Triangles& triangles,
                                                const std::vector<std::uint32_t>& order) {
    std::vector<shader::BvhTriangle> result;
    result.reserve(order.size());
    for (const std::uint32_t index : order) {
        const BvhInputTriangle& t = triangles[index];
        result.push_back({t.v0, t.coverage, t.v1 - t.v0, t.v2 - t.v0});
    }
    return result;
}

std::vector<shader::Ray> random_rays(std::size_t count, const Bounds& bounds, std::uint32_t seed) {
    Random random(seed);
    const glm::vec3 center = bounds.empty() ? glm::vec3(0.0f) : bounds.center();
    const glm::vec3 extent = bounds.empty() ? glm::vec3(1.0f) : bounds.extent() + 1.0f;
    std::vector<shader::Ray> rays(count);
    for (shader::Ray& ray : rays) {
        ray.origin = center + extent * random.in_cube(0.75f);
        ray.direction = random.direction();
        ray.t_min = 0.0f;
        ray.t_max = 1e30f;
        switch (random.below(8)) {
        case 0: { // along an axis
            const int axis = static_cast<int>(random.below(3));
            const float sign = random.below(2) == 0 ? -1.0f : 1.0f;
            ray.direction = glm::vec3(random.below(2) == 0 ? 0.0f : -0.0f);
            ray.direction[axis] = sign;
            break;
        }
        case 1: // in a coordinate plane
            ray.direction[static_cast<int>(random.below(3))] = 0.0f;
            ray.direction = glm::normalize(ray.direction);
            break;
        case 2: // from a point on the integer grid, where brushes have their planes
            ray.origin = glm::floor(ray.origin / 16.0f) * 16.0f;
            break;
        case 3: // short
            ray.t_max = 0.1f * glm::length(extent) * random.between(0.0f, 1.0f);
            ray.t_min = 0.1f * ray.t_max;
            break;
        default:
            break;
        }
    }
    return rays;
}

shader::Hit brute_force(const std::vector<shader::BvhTriangle>& triangles, const shader::Ray& ray,
                        std::uint32_t seed, std::uint32_t instance) {
    shader::Hit hit{ray.t_max, shader::NONE, shader::NONE, glm::vec2(0.0f), false};
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        float t, u, v;
        bool front;
        if (shader::bvh_triangle_hit(triangles[i].v0, triangles[i].e1, triangles[i].e2, ray.origin,
                                     ray.direction, ray.t_min, hit.t, t, u, v, front) &&
            shader::bvh_covered(triangles[i].flags, front, seed, instance, i)) {
            hit = {t, i, instance, glm::vec2(u, v), front};
        }
    }
    return hit;
}

ExactHit exact_hit(const shader::BvhTriangle& triangle, const shader::Ray& ray) {
    const glm::dvec3 e1(triangle.e1);
    const glm::dvec3 e2(triangle.e2);
    const glm::dvec3 d(ray.direction);
    const glm::dvec3 p = glm::cross(d, e2);
    const double determinant = glm::dot(e1, p);
    const glm::dvec3 s = glm::dvec3(ray.origin) - glm::dvec3(triangle.v0);
    const glm::dvec3 q = glm::cross(s, e1);
    ExactHit hit;
    hit.u = glm::dot(s, p) / determinant;
    hit.v = glm::dot(d, q) / determinant;
    hit.t = glm::dot(e2, q) / determinant;
    hit.front = determinant > 0.0;
    // Vertices are off by a rounding of their coordinates (v1 and v2 are not stored), products by
    // roundings of their factors: sixteen such steps, all at once and in the worst direction,
    // divided by the determinant.
    const double epsilon = 16.0 / 16777216.0;
    const glm::dvec3 v0(triangle.v0);
    const double edge = std::max(glm::length(e1), glm::length(e2));
    const double reach = glm::length(s) + glm::length(v0) + 2.0 * edge;
    const double error = epsilon * glm::length(d) * reach * edge / std::abs(determinant);
    hit.tolerance = error + shader::BVH_EDGE_MARGIN;
    hit.t_tolerance = error * edge * glm::length(s) / (glm::length(d) * edge) +
                      epsilon * std::abs(hit.t) + error * edge / glm::length(d);
    if (determinant == 0.0) hit.u = -1.0; // parallel: no hit
    return hit;
}

} // namespace vigil::test
