// SPDX-License-Identifier: GPL-2.0-or-later
// Properties of the bottom-level builder, and its hierarchies walked by the traversal text that the
// GPU runs, compiled here as C++, against brute force.
#include "trace_scenes.h"

#include <algorithm>
#include <gtest/gtest.h>

#include <array>
#include <bit>

namespace {

std::vector<glm::uvec4> bvh_nodes;
std::vector<vigil::shader::BvhTriangle> bvh_triangles;

} // namespace

namespace vigil::shader {

static uvec4 bvh_load_node(uint word) {
    return bvh_nodes.at(word);
}

} // namespace vigil::shader

#include "trace/bvh_traverse.glsl"

namespace vigil::test {
namespace {

void use(const Triangles& triangles) {
    const Bvh bvh = build_bvh(triangles);
    bvh_nodes.clear();
    EXPECT_EQ(append_bvh(bvh, 0, bvh_nodes), 0u);
    bvh_triangles = leaf_triangles(triangles, bvh.order);
}

shader::Hit closest(const shader::Ray& ray, std::uint32_t root = 0, std::uint32_t seed = 0,
                    bool translucent = false) {
    shader::Hit hit{ray.t_max, shader::NONE, shader::NONE, glm::vec2(0.0f), false};
    const bool found = shader::bvh_traverse(root, ray, seed, 0, false, translucent, 255, hit);
    EXPECT_EQ(found, hit.primitive != shader::NONE);
    return hit;
}

bool occluded(const shader::Ray& ray) {
    shader::Hit hit{ray.t_max, shader::NONE, shader::NONE, glm::vec2(0.0f), false};
    return shader::bvh_traverse(0, ray, 0, 0, true, false, 255, hit);
}

/// Traces `rays` both ways and compares with every triangle in double precision: what is hit must
/// be hit there too, at that distance and place, and nothing that double precision hits beyond
/// doubt may lie in front. Returns how many rays hit.
std::size_t compare(const std::vector<shader::Ray>& rays) {
    std::size_t hits = 0;
    for (const shader::Ray& ray : rays) {
        const shader::Hit hit = closest(ray);
        EXPECT_EQ(occluded(ray), hit.primitive != shader::NONE);
        double tolerance = 0.0;
        if (hit.primitive != shader::NONE) {
            hits += 1;
            const ExactHit exact = exact_hit(bvh_triangles.at(hit.primitive), ray);
            tolerance = exact.t_tolerance;
            EXPECT_NEAR(hit.t, exact.t, tolerance);
            EXPECT_NEAR(hit.barycentrics.x, exact.u, exact.tolerance);
            EXPECT_NEAR(hit.barycentrics.y, exact.v, exact.tolerance);
            EXPECT_GE(std::min({exact.u, exact.v, 1.0 - exact.u - exact.v}), -exact.tolerance);
            EXPECT_EQ(hit.front, exact.front);
        }
        for (std::uint32_t i = 0; i < bvh_triangles.size(); ++i) {
            const ExactHit other = exact_hit(bvh_triangles[i], ray);
            if (!other.certain(ray)) continue;
            EXPECT_GT(other.t + other.t_tolerance + tolerance, hit.t) << "missed triangle " << i;
        }
    }
    return hits;
}

Bounds bounds_of(const Triangles& triangles) {
    return build_bvh(triangles).bounds;
}

/// Checks the subtree at `record`: boxes hold what is below them, leaves cover each slot once.
/// Returns its bounds.
Bounds check_subtree(std::uint32_t record, std::uint32_t depth, std::vector<int>& seen) {
    EXPECT_LE(depth, shader::BVH_MAX_DEPTH);
    const glm::uvec4* words = &bvh_nodes.at(std::size_t{record} * shader::BVH_RECORD_WORDS);
    const glm::uvec4 meta = words[3];
    Bounds bounds;
    if ((meta.w & shader::BVH_LEAF) != 0) {
        std::array<glm::vec3, 4> corner;
        for (int i = 0; i < 3; ++i) {
            for (int axis = 0; axis < 3; ++axis)
                corner[i][axis] = std::bit_cast<float>(words[i][axis]);
            corner[3][i] = std::bit_cast<float>(words[i][3]);
        }
        const bool empty = corner[0] == corner[1] && corner[0] == corner[2];
        const bool two = corner[3] != corner[2];
        for (const glm::vec3& point : corner)
            bounds.grow(point);
        if (!empty) seen.at(meta.x) += 1;
        if (two) seen.at(meta.x + 1) += 1;
        return bounds;
    }
    const float step = std::bit_cast<float>(meta.w & shader::BVH_STEP_MASK);
    for (std::uint32_t child = 0; child < 4; ++child) {
        Bounds box;
        bool point = true;
        for (int axis = 0; axis < 3; ++axis) {
            const std::uint32_t interval = words[axis][child];
            const float origin = std::bit_cast<float>(meta[axis]);
            box.lower[axis] = origin + step * static_cast<float>(interval & 0xffff);
            box.upper[axis] = origin + step * static_cast<float>(interval >> 16);
            point = point && interval == 0xffffffff;
        }
        const std::uint32_t next = 4 * (meta.w & shader::BVH_CHILD_NODE_MASK) + child;
        const Bounds below = check_subtree(next, depth + 1, seen);
        if (point) continue; // no child: an empty leaf, which nothing can be hit in
        EXPECT_TRUE(box.contains(below));
        bounds.grow(below);
    }
    return bounds;
}

void check_structure(const Triangles& triangles) {
    use(triangles);
    std::vector<int> seen(bvh_triangles.size(), 0);
    check_subtree(0, 0, seen);
    for (std::size_t slot = 0; slot < seen.size(); ++slot) {
        // Triangles without area may be left out of the count: they look like an empty leaf.
        const shader::BvhTriangle& triangle = bvh_triangles[slot];
        const bool degenerate = triangle.e1 == glm::vec3(0.0f) || triangle.e2 == glm::vec3(0.0f) ||
                                triangle.e1 == triangle.e2;
        EXPECT_TRUE(seen[slot] == 1 || (degenerate && seen[slot] == 0)) << slot;
    }
    EXPECT_LE(bvh_nodes.size(), max_bvh_words(triangles.size()));
    std::vector<int> named(triangles.size(), 0);
    for (const std::uint32_t index : build_bvh(triangles).order)
        named.at(index) += 1;
    for (const int times : named)
        EXPECT_EQ(times, 1);
}

TEST(BvhBuilder, EveryTriangleIsInOneLeafAndBoxesContain) {
    check_structure(random_triangles(5000, 1000.0f, 20.0f, 1));
    check_structure(random_triangles(500, 100.0f, 500.0f, 2));
    check_structure(brush_triangles(4000, 3));
    check_structure(sphere_triangles(40, 100.0f, glm::vec3(1e5f, -1e5f, 0.0f)));
}

TEST(BvhBuilder, DegenerateInputs) {
    check_structure({});
    check_structure(random_triangles(1, 10.0f, 5.0f, 4));
    check_structure(Triangles(1000, BvhInputTriangle{})); // a thousand points in one place
    Triangles same(777, random_triangles(1, 10.0f, 5.0f, 5)[0]);
    check_structure(same);
    Triangles line; // centres that halving alone can sort: exponentially spaced
    for (int i = 0; i < 3000; ++i) {
        const float x = std::ldexp(1.0f, (i % 150) - 120) * 1e-3f;
        line.push_back({{x, 0, 0}, {x, 1e-3f, 0}, {x, 0, 1e-3f}, 255});
    }
    check_structure(line);
}

TEST(BvhBuilder, EmptyModelIsNeverHit) {
    use({});
    Bounds box;
    box.grow(glm::vec3(-10.0f));
    box.grow(glm::vec3(10.0f));
    for (const shader::Ray& ray : random_rays(1000, box, 6))
        EXPECT_FALSE(occluded(ray));
}

TEST(BvhTraversal, MatchesBruteForce) {
    const std::vector<Triangles> scenes = {
        random_triangles(300, 100.0f, 10.0f, 10),
        random_triangles(300, 10.0f, 100.0f, 11),
        brush_triangles(400, 12),
        random_triangles(300, 100.0f, 10.0f, 13, glm::vec3(1e5f, -1e5f, 5e4f)),
        sphere_triangles(12, 64.0f, glm::vec3(512.0f, 0.0f, -4096.0f)),
        random_triangles(3, 10.0f, 5.0f, 14),
    };
    std::uint32_t seed = 20;
    for (const Triangles& triangles : scenes) {
        use(triangles);
        const std::vector<shader::Ray> rays = random_rays(10000, bounds_of(triangles), seed++);
        EXPECT_GT(compare(rays), 10u);
    }
}

TEST(BvhTraversal, RaysFromFarAway) {
    const Triangles triangles = brush_triangles(300, 30);
    use(triangles);
    std::vector<shader::Ray> rays = random_rays(10000, bounds_of(triangles), 31);
    for (shader::Ray& ray : rays)
        ray.origin -= 5e4f * ray.direction;
    EXPECT_GT(compare(rays), 10u);
}

TEST(BvhTraversal, ClosedMeshDoesNotLeak) {
    use(sphere_triangles(64, 1000.0f, glm::vec3(3000.0f, -2000.0f, 100.0f)));
    Bounds inside;
    inside.grow(glm::vec3(2500.0f, -2500.0f, -400.0f));
    inside.grow(glm::vec3(3500.0f, -1500.0f, 600.0f));
    for (shader::Ray ray : random_rays(200000, inside, 40)) {
        ray.t_min = 0.0f;
        ray.t_max = 1e30f;
        if (glm::distance(ray.origin, glm::vec3(3000.0f, -2000.0f, 100.0f)) > 990.0f) continue;
        EXPECT_TRUE(occluded(ray));
    }
}

TEST(BvhTraversal, SeveralModelsInOneBuffer) {
    const Triangles a = random_triangles(500, 100.0f, 10.0f, 50);
    const Triangles b = brush_triangles(300, 51);
    bvh_nodes.clear();
    const Bvh first = build_bvh(a);
    const Bvh second = build_bvh(b);
    EXPECT_EQ(append_bvh(first, 0, bvh_nodes), 0u);
    const auto offset = static_cast<std::uint32_t>(a.size());
    const std::uint32_t root = append_bvh(second, offset, bvh_nodes);
    bvh_triangles = leaf_triangles(a, first.order);
    const auto more = leaf_triangles(b, second.order);
    bvh_triangles.insert(bvh_triangles.end(), more.begin(), more.end());
    std::size_t hits = 0;
    for (const shader::Ray& ray : random_rays(5000, second.bounds, 52)) {
        const shader::Hit hit = closest(ray, root);
        const shader::Hit expected = brute_force(more, ray);
        EXPECT_NEAR(hit.t, expected.t, 1e-4f * expected.t);
        if (hit.primitive == shader::NONE) continue;
        EXPECT_GE(hit.primitive, offset);
        hits += 1;
    }
    EXPECT_GT(hits, 100u);
}

TEST(BvhTraversal, TranslucentTrianglesStopTheirShareFromTheFrontOnly) {
    // One sheet of 20 % coverage; the ray meets it from the front, then from behind.
    Triangles sheet = {{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, 51}};
    use(sheet);
    const int trials = 20000;
    int stopped = 0;
    for (int seed = 0; seed < trials; ++seed) {
        const shader::Ray down{{0, 0, 1}, 0.0f, {0, 0, -1}, 10.0f};
        const shader::Ray up{{0, 0, -1}, 0.0f, {0, 0, 1}, 10.0f};
        stopped += closest(down, 0, static_cast<std::uint32_t>(seed), true).primitive == 0u;
        EXPECT_EQ(closest(up, 0, static_cast<std::uint32_t>(seed), true).primitive, shader::NONE);
    }
    const double p = 51.0 / 255.0;
    const double sigma = std::sqrt(trials * p * (1.0 - p));
    EXPECT_NEAR(stopped, trials * p, 4.0 * sigma);
}

TEST(BvhTraversal, OpaqueTrianglesTellTheirSide) {
    use({{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, 255}});
    EXPECT_TRUE(closest({{0, 0, 1}, 0.0f, {0, 0, -1}, 10.0f}).front);
    EXPECT_FALSE(closest({{0, 0, -1}, 0.0f, {0, 0, 1}, 10.0f}).front);
}

} // namespace
} // namespace vigil::test
