// SPDX-License-Identifier: GPL-2.0-or-later
// The Light Hierarchy on the GPU against a plain walk through the very words it reads
// (light/light_hierarchy_oracle.h): the probability of every light at every primary hit, and how
// often each is drawn.
#include "light/light_hierarchy_oracle.h"
#include "light_answers.h"
#include "refresh/vkpt/light/ltc_table.h"
#include "render_test.h"
#include "technique_settings.h"

#include <cmath>
#include <fmt/format.h>
#include <iostream>

namespace vigil::test {
namespace {

constexpr uint32_t draws_per_pixel = 2048;

/// The technique's buffers, read back.
struct Downloaded {
    shader::LightHierarchyHeader header;
    std::vector<glm::uvec4> nodes;
    std::vector<uint32_t> leaf_lights, places, parents;

    HierarchyWords words() const { return {header, nodes, leaf_lights, places, parents}; }
};

class HierarchyOracle : public RenderTest {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        set_size(24, 16);
        set("pt_nee", "lh");
    }

    static Downloaded download(uint64_t lights) {
        const gpu::Device& device = renderer().device();
        vkpt::LightTechnique::Bindings buffers{};
        renderer().technique()->bind(buffers);
        Downloaded result;
        result.header = gpu::download_now_as<shader::LightHierarchyHeader>(
            device, *buffers[BINDING_LIGHT_PLACES], 0, 1)[0];
        const uint64_t nodes = result.header.node_count;
        const uint64_t slots = uint64_t{4} * result.header.groups;
        constexpr uint64_t header_words = sizeof(result.header) / sizeof(uint32_t);
        result.nodes = gpu::download_now_as<glm::uvec4>(
            device, *buffers[BINDING_LIGHT_NODES], 0,
            nodes * shader::light_node_stride(result.header.groups));
        result.leaf_lights = gpu::download_now_as<uint32_t>(
            device, *buffers[BINDING_LEAF_LIGHTS], 0, nodes * slots * result.header.leaf_size);
        result.places = gpu::download_now_as<uint32_t>(device, *buffers[BINDING_LIGHT_PLACES],
                                                       header_words, lights);
        result.parents =
            gpu::download_now_as<uint32_t>(device, *buffers[BINDING_LIGHT_PARENTS], 0, nodes);
        return result;
    }

    static shader::LtcSurface prepare(const shader::PrimaryHit& hit) {
        return shader::ltc_prepare_diffuse(shader::offset_ray_origin(hit.position, hit.normal),
                                           hit.normal, shader::luminance(hit.albedo));
    }

    /// What a shot's hits say against the oracle, for all shapes of the hierarchy.
    void judge(const Shot& shot, size_t least_lights) {
        vkpt::SidePass pass = light_technique_pass(renderer(), "lh");
        for (const TechniqueSettings& settings : technique_settings()) {
            if (settings.technique != "lh") continue;
            SCOPED_TRACE(settings.label);
            settings.set();
            radiance(shot);
            const LightAnswers answers = ask_lights(pass, renderer(), draws_per_pixel);
            const std::span<const shader::Light> lights = renderer().scene()->lights().lights();
            ASSERT_GE(lights.size(), least_lights);
            judge(answers, lights, download(lights.size()).words());
        }
    }

    static void judge(const LightAnswers& answers, std::span<const shader::Light> lights,
                      const HierarchyWords& words) {
        uint32_t judged = 0, doubtful = 0, scored = 0;
        double scores = 0.0, worst_score = 0.0, worst_error = 0.0;
        for (size_t pixel = 0; pixel < answers.hits.size(); ++pixel) {
            if (!answers.has_surface(pixel)) continue;
            const OracleProbabilities oracle =
                oracle_probabilities(words, lights, prepare(answers.hits[pixel]));
            if (oracle.doubtful) {
                ++doubtful;
                continue;
            }
            ++judged;
            const std::span<const LightAnswer> row = answers.row(pixel);
            SelectionBins bins(draws_per_pixel);
            double sum = 0.0;
            for (size_t light = 0; light < lights.size(); ++light) {
                const double exact = oracle.by_light[light];
                const double seen = static_cast<double>(row[light].probability);
                sum += exact;
                bins.add(exact, row[light].draws);
                // Heights above the horizon are small differences of large numbers: the oracle
                // knows how small.
                const double allowed = 1e-3 * (exact + 1e-5) + oracle.errors[light];
                worst_error = std::max(worst_error, std::abs(seen - exact) / allowed);
                ASSERT_LT(std::abs(seen - exact), allowed)
                    << "pixel " << pixel << " light " << light << ": " << seen << " instead of "
                    << exact;
                // Never drawn where the oracle says never.
                ASSERT_TRUE(exact > 0.0 || row[light].draws == 0);
            }
            bins.add(std::max(1.0 - sum, 0.0), row[lights.size()].draws);
            const std::optional<double> score = bins.score();
            if (!score) continue;
            ++scored;
            scores += *score;
            worst_score = std::abs(*score) > std::abs(worst_score) ? *score : worst_score;
        }
        const double together = scores / std::sqrt(static_cast<double>(scored));
        std::cout << fmt::format("{} lights, {} pixels, {} left out: largest error {:.2f} of what "
                                 "single precision allows, "
                                 "chi-square {:+.2f} together, {:+.2f} at the worst\n",
                                 lights.size(), judged, doubtful, worst_error, together,
                                 worst_score);
        EXPECT_GT(judged, 250u);
        EXPECT_LT(doubtful, judged / 5);
        EXPECT_LT(std::abs(together), score_limit);
        EXPECT_LT(std::abs(worst_score), score_limit);
    }
};

TEST_F(HierarchyOracle, AgreesOnStaticLights) {
    load("rooms");
    Shot shot;
    shot.view = {{290, 20, 96}, {5, 55, 0}, 90};
    judge(shot, 20);
}

TEST_F(HierarchyOracle, AgreesOnMovingLights) {
    load("rooms");
    Shot shot;
    shot.view = {{40, 40, 60}, {0, 35, 0}, 90};
    refresh::Entity door;
    door.number = 1;
    door.model = renderer().register_model("*1");
    door.origin = {-40, -20, 20};
    door.angles = {10, 20, 30};
    shot.entities = {door};
    shot.dynamic_lights = {{7, {120, 120, 40}, 16.0f, {20, 10, 5}},
                           {8, {200, 60, 100}, 2.0f, {5, 20, 40}}};
    judge(shot, 20);
    // What moved, vanished and appeared since is found as well.
    shot.entities[0].origin.z += 30;
    shot.dynamic_lights = {{8, {100, 60, 100}, 2.0f, {5, 0, 40}},
                           {9, {150, 60, 20}, 5.0f, {1, 2, 3}}};
    judge(shot, 20);
}

TEST_F(HierarchyOracle, AgreesOnManyLights) {
    load("rooms");
    Shot shot;
    shot.view = {{40, 40, 60}, {0, 35, 0}, 90};
    for (int i = 0; i < 120; ++i) {
        const auto t = static_cast<float>(i);
        shot.dynamic_lights.push_back(
            {static_cast<uint32_t>(i + 1),
             {20.0f + 1.9f * t, 130 + 90 * std::sin(t), 60 + 50 * std::cos(3 * t)},
             1.0f + 0.05f * t,
             glm::vec3(std::exp(-0.1f * t)) * glm::vec3(30, 20, 10)});
    }
    judge(shot, 900);
}

} // namespace
} // namespace vigil::test
