// SPDX-License-Identifier: GPL-2.0-or-later
// Ray queries against our BVH in compute: the same rays through the same scene, at which both must
// agree on triangle, instance, side, distance and coverage. They round differently, so a ray that
// passes within a few roundings of an edge, or meets two triangles at one distance, may go either
// way; every difference must be such a case in double precision.
#include "gpu/validated.h"
#include "query_gpu.h"
#include "trace_scenes.h"

#include "common/error.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace vigil::test {
namespace {

constexpr float extent = 300.0f; // no coordinate is larger
constexpr size_t ray_count = 100000;

glm::mat4x3 placed(const glm::mat3& linear, const glm::vec3& origin) {
    return {linear[0], linear[1], linear[2], origin};
}

/// Turns about (1, 2, 3).
glm::mat3 turn(float angle) {
    const glm::vec3 axis = glm::normalize(glm::vec3(1, 2, 3));
    const auto column = [&](const glm::vec3& v) {
        return std::cos(angle) * v + std::sin(angle) * glm::cross(axis, v) +
               (1 - std::cos(angle)) * glm::dot(axis, v) * axis;
    };
    return {column({1, 0, 0}), column({0, 1, 0}), column({0, 0, 1})};
}

/// Every `period`-th triangle translucent, with coverages of all sizes.
Triangles with_glass(Triangles triangles, size_t period) {
    for (size_t i = 0; i < triangles.size(); i += period)
        triangles[i].coverage = static_cast<uint32_t>(i * 37 % 255);
    return triangles;
}

/// How a ray meets the plane of a triangle, in double precision.
struct Meeting {
    double t;
    double cosine; // between ray and normal
    double inside; // distance to the nearest edge, in map units; negative outside
};

Meeting meet(const shader::BvhTriangle& triangle, const shader::Ray& ray) {
    const glm::dvec3 e1(triangle.e1), e2(triangle.e2), d(ray.direction);
    const glm::dvec3 s = glm::dvec3(ray.origin) - glm::dvec3(triangle.v0);
    const glm::dvec3 normal = glm::cross(e1, e2);
    const glm::dvec3 p = glm::cross(d, e2), q = glm::cross(s, e1);
    const double determinant = glm::dot(e1, p);
    const double u = glm::dot(s, p) / determinant, v = glm::dot(d, q) / determinant;
    const double area = glm::length(normal);
    return {glm::dot(e2, q) / determinant, std::abs(determinant) / (area * glm::length(d)),
            std::min({u * area / glm::length(e2), v * area / glm::length(e1),
                      (1 - u - v) * area / glm::length(e2 - e1)})};
}

/// Roundings of places of the scene, in map units along a ray that meets a plane at this angle.
double rounding(const Meeting& meeting) {
    return 0x1p-19 * (extent + std::abs(meeting.t)) / std::max(meeting.cosine, 1e-6);
}

class QueryTest : public testing::Test {
protected:
    void SetUp() override {
        device_ = std::make_unique<gpu::Device>(test::validated(), nullptr);
        if (!device_->features().ray_query)
            GTEST_SKIP() << device_->properties().deviceName << " has no VK_KHR_ray_query";
        scene_ = std::make_unique<QueryGpu>(*device_);
    }
    void TearDown() override {
        scene_.reset();
        EXPECT_EQ(device_->validation_messages(), 0);
    }

    /// Whether the ray passes so close to the edge of what it hit, or so close to the ends of its
    /// interval, that another rounding may miss it.
    bool doubtful(const shader::Ray& ray, const shader::TraceAnswer& hit) const {
        const Meeting meeting = meet(scene_->placed_triangle(hit.primitive, hit.instance), ray);
        const double slack = rounding(meeting);
        return meeting.inside < slack || meeting.t < ray.t_min + slack ||
               meeting.t > ray.t_max - slack;
    }

    /// Traces random rays with both backends and compares. Returns how many hit.
    size_t compare(bool instances, bool translucent, uint32_t seed) {
        Bounds bounds;
        bounds.grow(glm::vec3(-150.0f));
        bounds.grow(glm::vec3(150.0f));
        const std::vector<shader::Ray> rays = random_rays(ray_count, bounds, seed);
        const auto compute = scene_->trace(Backend::Compute, rays, instances, translucent);
        const auto query = scene_->trace(Backend::Query, rays, instances, translucent);
        size_t hits = 0, differences = 0;
        for (size_t i = 0; i < rays.size(); ++i) {
            const shader::TraceAnswer& a = compute[i];
            const shader::TraceAnswer& b = query[i];
            EXPECT_EQ(b.occluded, b.primitive != shader::NONE) << "ray " << i;
            if (a.primitive == b.primitive && a.primitive == shader::NONE) continue;
            hits += 1;
            if (a.primitive == b.primitive && a.instance == b.instance) {
                const shader::BvhTriangle triangle =
                    scene_->placed_triangle(a.primitive, a.instance);
                const Meeting meeting = meet(triangle, rays[i]);
                const double slack = rounding(meeting);
                const double height = glm::length(glm::cross(triangle.e1, triangle.e2)) /
                                      std::max({glm::length(triangle.e1), glm::length(triangle.e2),
                                                glm::length(triangle.e2 - triangle.e1)});
                EXPECT_EQ(a.front, b.front) << "ray " << i;
                EXPECT_NEAR(a.t, b.t, slack) << "ray " << i;
                EXPECT_NEAR(a.barycentrics.x, b.barycentrics.x, 1e-5 + slack / height);
                EXPECT_NEAR(a.barycentrics.y, b.barycentrics.y, 1e-5 + slack / height);
                continue;
            }
            differences += 1;
            // The nearer hit is what one of them missed.
            const bool a_nearer =
                b.primitive == shader::NONE || (a.primitive != shader::NONE && a.t < b.t);
            const shader::TraceAnswer& nearer = a_nearer ? a : b;
            const shader::TraceAnswer& farther = a_nearer ? b : a;
            const bool tie =
                farther.primitive != shader::NONE &&
                farther.t - nearer.t <=
                    rounding(
                        meet(scene_->placed_triangle(nearer.primitive, nearer.instance), rays[i]));
            EXPECT_TRUE(tie || doubtful(rays[i], nearer))
                << "ray " << i << ": compute hit " << a.primitive << " of instance " << a.instance
                << " at " << a.t << ", query " << b.primitive << " of " << b.instance << " at "
                << b.t;
        }
        EXPECT_LT(differences, hits / 1000) << "doubtful cases are rare";
        RecordProperty("hits", static_cast<int>(hits));
        RecordProperty("differences", static_cast<int>(differences));
        return hits;
    }

    std::unique_ptr<gpu::Device> device_;
    std::unique_ptr<QueryGpu> scene_;
};

const glm::mat4x3 in_place(1.0f);

TEST_F(QueryTest, OpaqueWorldAlone) {
    scene_->place(scene_->add_model(random_triangles(300, 180.0f, 120.0f, 1)), in_place);
    EXPECT_GT(compare(false, false, 2), ray_count / 4);
}

TEST_F(QueryTest, TranslucentTrianglesDecideByTheSameHash) {
    // Opaque and translucent ones in one model, by the constant and without it.
    scene_->place(scene_->add_model(with_glass(random_triangles(300, 180.0f, 120.0f, 3), 2)),
                  in_place);
    EXPECT_GT(compare(false, true, 4), ray_count / 4);
}

TEST_F(QueryTest, PlacedModels) {
    // Turned, mirrored and stretched; all opaque, all translucent, both; one of nothing.
    const Triangles ball = sphere_triangles(8, 60.0f, glm::vec3(0.0f));
    scene_->place(scene_->add_model(with_glass(random_triangles(100, 180.0f, 120.0f, 5), 3)),
                  in_place);
    const size_t opaque = scene_->add_model(ball);
    const size_t glass = scene_->add_model(with_glass(ball, 1));
    const size_t nothing = scene_->add_model({});
    const size_t mixed = scene_->add_model(with_glass(ball, 4));
    scene_->place(opaque, placed(turn(1.0f), {100, 0, 0}));
    scene_->place(nothing, placed(turn(2.0f), {0, 0, 0}));
    scene_->place(glass, placed(glm::mat3(-1, 0, 0, 0, 1, 0, 0, 0, 1), {-100, 50, 0}));
    scene_->place(mixed,
                  placed(turn(2.5f) * glm::mat3(0.5f, 0, 0, 0, -1.5f, 0, 0, 0, 1), {0, -100, 60}));
    scene_->place(opaque, placed(glm::mat3(0.3f), {0, 100, -60}));
    EXPECT_GT(compare(true, true, 6), ray_count / 4);
}

TEST_F(QueryTest, FadedAndHiddenModels) {
    // The rays of these shaders are light rays; the last model is the last of the top level, and
    // one that they miss.
    const Triangles ball = sphere_triangles(8, 60.0f, glm::vec3(0.0f));
    scene_->place(scene_->add_model(random_triangles(100, 180.0f, 120.0f, 15)), in_place);
    const size_t opaque = scene_->add_model(ball);
    const size_t mixed = scene_->add_model(with_glass(ball, 4));
    const auto place_balls = [&](uint32_t opacity_of_first) {
        const auto lit = [](uint32_t opacity) {
            return opacity << shader::INSTANCE_OPACITY_SHIFT | shader::INSTANCE_LIT;
        };
        scene_->place(opaque, placed(turn(1.0f), {100, 0, 0}), lit(opacity_of_first));
        scene_->place(mixed, placed(turn(2.0f), {-100, 50, 0}), lit(90));
        scene_->place(mixed, placed(turn(3.0f), {0, -100, 60}));
        for (const uint32_t seen : {shader::INSTANCE_SEEN, shader::INSTANCE_FRONT, 0u})
            scene_->place(opaque, placed(turn(4.0f), {0, 100, -60}), 0xff00u | seen);
    };
    place_balls(90);
    EXPECT_GT(compare(true, true, 16), ray_count / 4);
    Bounds bounds;
    bounds.grow(glm::vec3(-150.0f));
    bounds.grow(glm::vec3(150.0f));
    const std::vector<shader::Ray> rays = random_rays(ray_count, bounds, 17);
    std::array<size_t, 7> fronts{}, backs{};
    for (const shader::TraceAnswer& answer : scene_->trace(Backend::Compute, rays, true, true))
        if (answer.primitive != shader::NONE)
            ++(answer.front != 0 ? fronts : backs).at(answer.instance);
    for (size_t i = 0; i < fronts.size(); ++i)
        EXPECT_EQ(fronts[i] > 0, i < 4) << "instance " << i;
    EXPECT_EQ(backs[1], 0u);
    // Of the rays that the first ball stops at its front while it is opaque, each is stopped with a
    // chance of 90 in 255. Five standard errors of that count.
    scene_->clear_placed();
    scene_->place(0, in_place);
    place_balls(255);
    double stopped = 0.0;
    for (const shader::TraceAnswer& answer : scene_->trace(Backend::Compute, rays, true, true))
        stopped += answer.primitive != shader::NONE && answer.instance == 1 && answer.front != 0;
    constexpr double chance = 90.0 / 255.0;
    EXPECT_NEAR(static_cast<double>(fronts[1]), chance * stopped,
                5.0 * std::sqrt(stopped * chance * (1.0 - chance)));
    EXPECT_GT(stopped, 400.0) << "a fault of a third would hide";
}

TEST_F(QueryTest, OpaquePlacedModels) {
    scene_->place(scene_->add_model(random_triangles(100, 180.0f, 120.0f, 7)), in_place);
    scene_->place(scene_->add_model(sphere_triangles(8, 60.0f, glm::vec3(0.0f))),
                  placed(turn(1.0f), {100, 0, 0}));
    EXPECT_GT(compare(true, false, 8), ray_count / 4);
}

TEST_F(QueryTest, StructuresFollowTheScene) {
    scene_->place(scene_->add_model(random_triangles(100, 180.0f, 120.0f, 9)), in_place);
    const size_t body = scene_->add_model(sphere_triangles(6, 50.0f, glm::vec3(0.0f)), true);
    scene_->place(body, placed(turn(1.0f), {100, 0, 0}));
    compare(true, true, 10);

    // Another shape in the same memory.
    scene_->change_model(body, sphere_triangles(6, 80.0f, glm::vec3(-20.0f)));
    EXPECT_FALSE(scene_->prepare_structures());
    compare(true, true, 11);

    // Glass makes a second geometry, so that the structure no longer fits.
    scene_->change_model(body, with_glass(sphere_triangles(6, 90.0f, glm::vec3(0.0f)), 2));
    compare(true, true, 12);

    // More instances than there was room for, then fewer again.
    for (int i = 0; i < 20; ++i)
        scene_->place(body, placed(turn(0.3f * static_cast<float>(i)) * 0.2f,
                                   {20 * i - 200, 150, 10 * i - 100}));
    EXPECT_TRUE(scene_->prepare_structures());
    EXPECT_FALSE(scene_->prepare_structures());
    compare(true, true, 13);
    scene_->clear_placed();
    scene_->place(0, in_place);
    EXPECT_FALSE(scene_->prepare_structures());
    compare(true, true, 14);
}

TEST_F(QueryTest, MoreTrianglesThanCanBeNumberedAreAnError) {
    const std::array corners{glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)};
    const std::array triangles{shader::BvhTriangle{{}, 255, {1, 0, 0}, {0, 1, 0}}};
    vkpt::QueryModel model;
    model.corners = corners;
    model.triangles = triangles;
    model.first_triangle = 1u << 24;
    shader::Instance instance{};
    instance.world_from_object = in_place;
    const size_t index = 0;
    EXPECT_THROW(scene_->structures().prepare({&model, 1}, {&index, 1}, {&instance, 1}), Error);
}

} // namespace
} // namespace vigil::test
