// SPDX-License-Identifier: GPL-2.0-or-later
// The compute backend on the device: both tracing functions, with the nodes read either way,
// against every triangle tested on the host. Hits are judged in double precision, so that only
// roundings and ties are forgiven.
#include "bench/trace_rig.h"
#include "common/log.h"
#include "gpu/validated.h"
#include "trace_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace vigil::test {
namespace {

using bench::TraceRig;

glm::mat4x3 turned(float angle, const glm::vec3& origin, float scale = 1.0f) {
    const float c = scale * std::cos(angle);
    const float s = scale * std::sin(angle);
    return {{c, s, 0}, {-s, c, 0}, {0, 0, scale}, origin};
}

class TraceGpuTest : public testing::TestWithParam<TraceRig::Nodes> {
protected:
    void SetUp() override {
        sink_ = add_log_sink([](Severity severity, std::string_view line) {
            if (severity != Severity::Info) std::cerr << line << '\n';
        });
        device_ = std::make_unique<gpu::Device>(test::validated(), nullptr);
        rig_ = std::make_unique<TraceRig>(*device_, GetParam());
    }
    void TearDown() override {
        rig_.reset();
        EXPECT_EQ(device_->validation_messages(), 0);
        remove_log_sink(sink_);
    }

    /// The ray in the space of an instance; 0 is the world.
    shader::Ray local_ray(const shader::Ray& ray, std::uint32_t instance) const {
        if (instance == 0) return ray;
        const glm::mat4x3& m = rig_->instance(instance).object_from_world;
        return {m * glm::vec4(ray.origin, 1.0f), ray.t_min, m * glm::vec4(ray.direction, 0.0f),
                ray.t_max};
    }

    struct Placed {
        std::uint32_t instance;
        std::size_t model;
    };

    /// Traces the rays and compares with everything that `placed` names. Returns how many rays hit.
    std::size_t compare(const std::vector<shader::Ray>& rays, const std::vector<Placed>& placed) {
        const TraceRig::Batch batch = rig_->make_batch(rays);
        rig_->trace(batch, false);
        rig_->trace(batch, true);
        const auto answers = rig_->answers(batch);
        const auto occluded = rig_->occluded(batch);
        std::size_t hits = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const shader::RayAnswer& answer = answers[i];
            const bool hit = answer.primitive != shader::NONE;
            const auto seed = static_cast<std::uint32_t>(i);
            EXPECT_EQ(occluded[i], hit ? 1u : 0u);
            double tolerance = 0.0;
            if (hit) {
                hits += 1;
                const shader::BvhTriangle& triangle = rig_->triangles().at(answer.primitive);
                const ExactHit exact = exact_hit(triangle, local_ray(rays[i], answer.instance));
                tolerance = 4.0 * exact.t_tolerance; // the transform rounds, too
                EXPECT_NEAR(answer.t, exact.t, tolerance);
                EXPECT_NEAR(answer.barycentrics.x, exact.u, 4.0 * exact.tolerance);
                EXPECT_NEAR(answer.barycentrics.y, exact.v, 4.0 * exact.tolerance);
                EXPECT_EQ(answer.front != 0, exact.front);
                EXPECT_TRUE(shader::bvh_covered(triangle.flags, exact.front, seed, answer.instance,
                                                answer.primitive));
            } else {
                EXPECT_EQ(answer.t, rays[i].t_max);
            }
            for (const Placed& place : placed) {
                const shader::Ray ray = local_ray(rays[i], place.instance);
                for (std::uint32_t p = 0; p < rig_->triangles().size(); ++p) {
                    if (rig_->sources()[p].model != place.model) continue;
                    const shader::BvhTriangle& triangle = rig_->triangles()[p];
                    const ExactHit other = exact_hit(triangle, ray);
                    // Within the margin of an edge the transform's rounding decides.
                    const bool clear = std::min({other.u, other.v, 1.0 - other.u - other.v}) >
                                       4.0 * (other.tolerance - shader::BVH_EDGE_MARGIN);
                    if (!clear || !other.certain(ray)) continue;
                    if (!shader::bvh_covered(triangle.flags, other.front, seed, place.instance, p))
                        continue;
                    EXPECT_GT(other.t + 4.0 * other.t_tolerance + tolerance, answer.t)
                        << "ray " << i << " missed primitive " << p;
                }
            }
        }
        return hits;
    }

    int sink_ = 0;
    std::unique_ptr<gpu::Device> device_;
    std::unique_ptr<TraceRig> rig_;
};

TEST_P(TraceGpuTest, WorldAlone) {
    const Triangles triangles = brush_triangles(500, 1);
    rig_->add_model(triangles);
    rig_->finish(false);
    EXPECT_GT(compare(random_rays(20000, build_bvh(triangles).bounds, 2), {{0, 0}}), 1000u);
}

TEST_P(TraceGpuTest, TurnedAndScaledInstances) {
    const Triangles world = brush_triangles(200, 3);
    rig_->add_model(world);
    const std::size_t ball = rig_->add_model(sphere_triangles(8, 100.0f, glm::vec3(0.0f)));
    const std::size_t cloud = rig_->add_model(random_triangles(80, 200.0f, 60.0f, 4));
    rig_->place(ball, turned(0.5f, {300, -200, 100}));
    rig_->place(cloud, turned(2.0f, {-500, 400, 0}, 2.5f));
    rig_->place(ball, turned(4.0f, {0, 0, 700}, 0.3f));
    rig_->place(cloud, turned(1.0f, {800, 800, -300}));
    rig_->finish(false);
    const std::vector<Placed> placed = {{0, 0}, {1, ball}, {2, cloud}, {3, ball}, {4, cloud}};
    EXPECT_GT(compare(random_rays(10000, build_bvh(world).bounds, 5), placed), 200u);
}

TEST_P(TraceGpuTest, TranslucentTrianglesFollowTheHash) {
    Triangles world = random_triangles(300, 200.0f, 80.0f, 6);
    for (std::size_t i = 0; i < world.size(); ++i)
        world[i].coverage = static_cast<std::uint32_t>(i * 29 % 256);
    rig_->add_model(world);
    const std::size_t model = rig_->add_model(world);
    rig_->place(model, turned(1.0f, {100, 0, 0}));
    rig_->finish(true);
    EXPECT_GT(compare(random_rays(10000, build_bvh(world).bounds, 7), {{0, 0}, {1, model}}), 1000u);
}

TEST_P(TraceGpuTest, CoverageIsTheShareOfRaysThatStop) {
    // Front towards +z; 30 % coverage. Every ray has a seed of its own.
    rig_->add_model(Triangles{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, 77}});
    rig_->finish(true);
    const std::size_t count = 50000;
    std::vector<shader::Ray> rays(count, {{0, 0, 1}, 0.0f, {0, 0, -1}, 10.0f});
    rays.insert(rays.end(), count, {{0, 0, -1}, 0.0f, {0, 0, 1}, 10.0f});
    const TraceRig::Batch batch = rig_->make_batch(rays);
    rig_->trace(batch, true);
    const auto occluded = rig_->occluded(batch);
    const auto middle = occluded.begin() + count;
    const auto stopped = static_cast<double>(std::count(occluded.begin(), middle, 1u));
    const double p = 77.0 / 255.0;
    EXPECT_NEAR(stopped, count * p, 4.0 * std::sqrt(count * p * (1.0 - p)));
    EXPECT_EQ(std::count(middle, occluded.end(), 1u), 0); // from behind it does not exist
}

TEST_P(TraceGpuTest, NothingToHit) {
    rig_->add_model(Triangles{});
    rig_->finish(false);
    Bounds box;
    box.grow(glm::vec3(-100.0f));
    box.grow(glm::vec3(100.0f));
    EXPECT_EQ(compare(random_rays(1000, box, 8), {{0, 0}}), 0u);
}

INSTANTIATE_TEST_SUITE_P(, TraceGpuTest,
                         testing::Values(TraceRig::Nodes::Storage, TraceRig::Nodes::Texels),
                         [](const auto& access) {
                             return access.param == TraceRig::Nodes::Texels ? "Texels" : "Storage";
                         });

} // namespace
} // namespace vigil::test
