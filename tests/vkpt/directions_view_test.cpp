// SPDX-License-Identifier: GPL-2.0-or-later
// `pt_view cdq`: its left square against the quadtree read back, its right one against the map of
// arriving light, that map against closed forms and against the path tracer's own indirect light,
// and when its mean starts anew. Looking teaches nothing.
#include "refresh/vkpt/guiding/leaf_report.h"
#include "render_test.h"
#include "shared/brdf.h"
#include "shared/cdq.h"
#include "shared/direction_map.h"
#include "shared/octree.h"
#include "shared/view_colors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace vigil::test {
namespace {

constexpr uint32_t edge = shader::DIRECTION_MAP_EDGE, cell_count = edge * edge;

class DirectionsView : public RenderTest {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        shot_.view = {{290, 20, 96}, {25, 55, 0}, 90};
        set_size(180, 120); // the legend is larger
        set("pt_view", "cdq");
        set("pt_guide", "cdq");
        set("pt_nee", "sll");
    }
    void render(int frames = 1) {
        for (int i = 0; i < frames; ++i)
            renderer().render(shot_.frame());
    }
    static shader::PrimaryHit crosshair_hit() {
        const glm::uvec2 size = renderer().buffers().size();
        const glm::uvec2 pixel = shader::crosshair_pixel(size);
        return primary_hits()[size_t{pixel.y} * size.x + pixel.x];
    }

    struct DirectionMap {
        std::vector<float> sums, cells;
        double total() const { return std::accumulate(cells.begin(), cells.end(), 0.0); }
    };
    static DirectionMap direction_map() {
        const gpu::Device& device = renderer().device();
        device.wait_idle();
        const std::vector<float> words =
            gpu::download_now_as<float>(device, renderer().buffers().direction_map(), 0,
                                        shader::DIRECTION_MAP_GROUPS + cell_count);
        const auto cells = words.begin() + shader::DIRECTION_MAP_GROUPS;
        return {{words.begin(), cells}, {cells, words.end()}};
    }
    static glm::vec3 direction_of(uint32_t cell) {
        return shader::octahedral_decode((glm::vec2(cell % edge, cell / edge) + 0.5f) /
                                         float{edge});
    }

    /// Calls `check(inset, colour)` for the pixels of one of the squares.
    template <typename Check> static void each_pixel(uint32_t kind, Check check) {
        const refresh::Picture picture = renderer().read_picture(false);
        const glm::uvec2 size(picture.width, picture.height);
        for (uint32_t i = 0; i < size.x * size.y; ++i) {
            const shader::DirectionInset inset =
                shader::direction_inset({i % size.x, i / size.x}, size);
            if (inset.kind != kind) continue;
            const uint8_t* rgba = &picture.rgba[size_t{4} * i];
            check(inset, glm::vec3(rgba[0], rgba[1], rgba[2]) / 255.0f);
        }
    }
    static bool same(const glm::vec3& a, const glm::vec3& b) {
        return glm::distance(a, b) < 2.5f / 255.0f; // the map's sines are rounded differently
    }
    static bool on_horizon(const shader::PrimaryHit& hit, const shader::DirectionInset& inset) {
        return shader::on_horizon(hit.normal, inset.uv, 1.0f / static_cast<float>(inset.edge));
    }

    /// Mean luminance of the indirect light alone, by `paths` paths per pixel.
    double indirect_light(uint32_t paths) {
        const std::vector<float> rgb = trace(params(shot_), paths, LightSamples::Indirect);
        double sum = 0.0;
        for (size_t i = 0; i < rgb.size(); i += 3)
            sum += static_cast<double>(shader::luminance({rgb[i], rgb[i + 1], rgb[i + 2]}));
        return sum / static_cast<double>(rgb.size() / 3);
    }

    Shot shot_;
};

TEST(DirectionInsets, AreTwoWholeSquares) {
    for (const glm::uvec2 size : {glm::uvec2(16, 16), glm::uvec2(33, 97), glm::uvec2(640, 360),
                                  glm::uvec2(1920, 1080), glm::uvec2(300, 1000)}) {
        std::map<uint32_t, uint32_t> counts;
        uint32_t square = 0;
        for (uint32_t y = 0; y < size.y; ++y) {
            for (uint32_t x = 0; x < size.x; ++x) {
                const auto inset = shader::direction_inset({x, y}, size);
                square = inset.edge;
                ++counts[inset.kind];
                if (inset.kind == shader::INSET_NONE) continue;
                EXPECT_GT(x, size.x / 2 - 1);
                EXPECT_GT(y, size.y / 2 - 1);
                EXPECT_GT(std::min(inset.uv.x, inset.uv.y), 0.0f);
                EXPECT_LT(std::max(inset.uv.x, inset.uv.y), 1.0f);
            }
        }
        EXPECT_GT(square, 1u);
        EXPECT_EQ(counts[shader::INSET_QUADTREE], square * square);
        EXPECT_EQ(counts[shader::INSET_ARRIVING], square * square);
    }
}

TEST_F(DirectionsView, QuadtreeIsThatOfTheLeaf) {
    load("rooms");
    set("pt_cdq_migrations", "4");
    render(30);
    const shader::PrimaryHit hit = crosshair_hit();
    ASSERT_NE(hit.primitive, shader::NONE);
    const vkpt::TreeCopy trees(renderer().device(), renderer().guiding());
    const glm::uvec4 tree = trees.leaf_at(hit.position, 32).guide;
    std::set<uint32_t> depths;
    size_t horizon = 0;
    each_pixel(shader::INSET_QUADTREE, [&](const auto& inset, const glm::vec3& color) {
        if (on_horizon(hit, inset)) {
            EXPECT_TRUE(same(color, shader::VIEW_HORIZON));
            ++horizon;
            return;
        }
        const glm::vec3 direction = shader::octahedral_decode(inset.uv);
        const glm::vec3 inside =
            shader::color_map(shader::density_on_scale(shader::cdq_pdf(tree, 128, direction)));
        EXPECT_TRUE(same(color, inside) || same(color, 0.7f * inside))
            << inset.uv.x << " " << inset.uv.y;
        depths.insert(shader::cdq_find(tree, inset.uv).depth);
    });
    EXPECT_GT(horizon, 20u);
    EXPECT_GT(depths.size(), 2u) << "an even tree has two levels, and shows nothing";
}

TEST_F(DirectionsView, ArrivingLightIsThatOfTheMap) {
    load("rooms");
    render(4);
    const shader::PrimaryHit hit = crosshair_hit();
    const DirectionMap map = direction_map();
    // What the work groups added up.
    for (uint32_t group = 0; group < shader::DIRECTION_MAP_GROUPS; ++group) {
        double sum = 0.0;
        for (uint32_t i = 0; i < 64; ++i)
            sum += map.cells[(8 * (group / 8) + i / 8) * edge + 8 * (group % 8) + i % 8];
        EXPECT_NEAR(map.sums[group], sum, 1e-5 * sum);
    }
    // Colours of a density whose integral is 1.
    size_t light = 0;
    each_pixel(shader::INSET_ARRIVING, [&](const auto& inset, const glm::vec3& color) {
        if (on_horizon(hit, inset)) return;
        const glm::uvec2 cell(inset.uv * float{edge});
        const auto density =
            static_cast<float>(map.cells[cell.y * edge + cell.x] / map.total() * cell_count) *
            shader::octahedral_density(shader::octahedral_decode(inset.uv));
        const glm::vec3 expected = density > 0.0f
                                       ? shader::color_map(shader::density_on_scale(density))
                                       : shader::VIEW_EMPTY;
        EXPECT_TRUE(same(color, expected)) << density;
        light += density > 0.0f ? 1 : 0;
    });
    EXPECT_GT(light, 100u);
}

TEST_F(DirectionsView, FurnaceIsEvenAboveTheHorizon) {
    load("furnace");
    set("pt_nee", "brute");
    set("pt_guide", "brdf"); // weights are then the albedo
    shot_.view = {{-60, 30, 100}, {0, 0, 0}, 100};
    constexpr int frames = 16;
    std::vector<double> integrals; // of the radiance over all directions
    for (int i = 0; i < frames; ++i) {
        set("pt_seed", std::to_string(i)); // starts anew
        render();
        integrals.push_back(direction_map().total() / cell_count);
    }
    const shader::PrimaryHit hit = crosshair_hit();
    const double albedo = hit.albedo.x, emitted = 10.0 * albedo;
    const double radiance = emitted * (1.0 + albedo); // one bounce
    const double expected = 2.0 * 3.14159265358979 * radiance;
    for (double& integral : integrals)
        integral -= expected;
    judge_differences("integral of the map", integrals, expected, 0.002);
    // Cells that the horizon does not pass, a tenth of a radian away from it.
    const DirectionMap map = direction_map();
    for (uint32_t cell = 0; cell < cell_count; ++cell) {
        const glm::vec3 direction = direction_of(cell);
        const float above = glm::dot(direction, hit.normal);
        if (above < -0.1f) {
            EXPECT_EQ(map.cells[cell], 0.0f);
        }
        if (above < 0.1f) continue;
        const double seen = map.cells[cell] * shader::octahedral_density(direction);
        EXPECT_NEAR(seen / radiance, 1.0, 0.1); // the density's change across a cell
    }
}

// The light that a grey surface reflects follows from the map, and is what the path tracer finds.
TEST_F(DirectionsView, MapHoldsWhatIndirectRaysBring) {
    load("rooms", [](Level& level) {
        for (BspTexInfo& info : level.bsp.texinfos)
            if ((info.flags & SURF_SKY) == 0) info.texture = "test/white";
    });
    // So narrow a view that all pixels see the point under the crosshair: each traces it.
    set_size(16, 16);
    shot_.view.fov = 0.01f;
    constexpr int batch_count = 48;
    for (const char* technique : {"vlc", "brute"}) {
        set("pt_nee", technique);
        const bool learns = std::string_view(technique) == "vlc";
        set("pt_guide", learns ? "cdq" : "brdf");
        const int frames = learns ? 4 : 16; // rays that find lamps by chance are noisier
        render(8);
        const shader::PrimaryHit hit = crosshair_hit();
        ASSERT_NE(hit.primitive, shader::NONE);
        std::vector<double> differences;
        double level = 0.0;
        for (int batch = 0; batch < batch_count; ++batch) {
            set("pt_seed", std::to_string(100 + batch));
            render(frames);
            const DirectionMap map = direction_map();
            double irradiance = 0.0;
            for (uint32_t cell = 0; cell < cell_count; ++cell)
                irradiance += map.cells[cell] / double{cell_count} *
                              std::max(glm::dot(direction_of(cell), hit.normal), 0.0f);
            const double reflected = irradiance * hit.albedo.x / 3.14159265358979;
            set("pt_view", "none");
            const double indirect = indirect_light(learns ? 48 : 192);
            set("pt_view", "cdq");
            differences.push_back(reflected - indirect);
            level += indirect / batch_count;
        }
        judge_differences(technique, differences, level, learns ? 0.035 : 0.07);
    }
}

TEST_F(DirectionsView, MeanGoesOnWhileNothingChanges) {
    load("rooms");
    const auto frames_after = [&](int frames) {
        render(frames);
        return renderer().view_accumulated();
    };
    EXPECT_EQ(frames_after(3), 3u);
    shot_.time_s += 1.0; // nothing here moves with it
    set("pt_exposure_bias", "1");
    EXPECT_EQ(frames_after(1), 4u);
    shot_.view.angles.y += 1.0f;
    EXPECT_EQ(frames_after(2), 2u);
    shot_.dynamic_lights = {{77, {300, 60, 100}, 16.0f, {20, 10, 5}}};
    EXPECT_EQ(frames_after(2), 2u);
    shot_.dynamic_lights[0].origin.x += 1.0f;
    EXPECT_EQ(frames_after(3), 2u); // where it was a frame ago changes once more
    set("pt_view", "none");
    EXPECT_EQ(frames_after(2), 0u);
    set("pt_view", "cdq");
    EXPECT_EQ(frames_after(1), 1u);
    load("rooms");
    EXPECT_EQ(frames_after(2), 2u);
}

TEST_F(DirectionsView, NothingArrivesWhereNothingIs) {
    load("opensky");
    shot_.view = {{150, 0, 90}, {-80, 0, 0}, 60};
    render(2);
    ASSERT_EQ(crosshair_hit().primitive, shader::NONE);
    EXPECT_EQ(direction_map().total(), 0.0);
    for (const uint32_t kind : {shader::INSET_QUADTREE, shader::INSET_ARRIVING})
        each_pixel(kind, [](const auto&, const glm::vec3& color) {
            EXPECT_TRUE(same(color, shader::VIEW_OFF));
        });
}

TEST_F(DirectionsView, ShowsArrivingLightWithoutQuadtrees) {
    load("rooms");
    for (const char* technique : {"sll", "vlc", "brute"}) {
        SCOPED_TRACE(technique);
        set("pt_nee", technique);
        set("pt_guide", "brdf");
        render(3);
        const shader::PrimaryHit hit = crosshair_hit();
        each_pixel(shader::INSET_QUADTREE, [&](const auto& inset, const glm::vec3& color) {
            EXPECT_TRUE(
                same(color, on_horizon(hit, inset) ? shader::VIEW_HORIZON : shader::VIEW_OFF));
        });
        EXPECT_GT(direction_map().total(), 0.0);
    }
}

TEST_F(DirectionsView, TeachesNothing) {
    load("rooms");
    // Primary hits are all surface samples: vlc's light samples at them, and the only rays of sll.
    for (const auto& [technique, bounces] : {std::pair("sll", "1"), {"vlc", "0"}}) {
        SCOPED_TRACE(technique);
        set("pt_nee", technique);
        set("pt_bounces", bounces);
        render(8);
        const vkpt::TreeCopy tree(renderer().device(), renderer().guiding());
        std::map<uint32_t, uint32_t> counted, hits_of_nodes;
        std::map<uint32_t, vkpt::LeafReport> reports;
        const std::vector<shader::PrimaryHit> hits = primary_hits();
        const std::vector<uint32_t> flags = pixel_flags();
        for (size_t i = 0; i < hits.size(); ++i) {
            if (hits[i].primitive == shader::NONE) continue;
            const vkpt::LeafReport report = tree.leaf_at(hits[i].position, 32);
            // One that explores has a second light sample.
            counted[report.leaf] += flags[i] & shader::PIXEL_EXPLORED ? 2 : 1;
            ++hits_of_nodes[shader::octree_node_of(report.leaf)];
            reports.emplace(report.leaf, report);
        }
        for (const auto& [leaf, report] : reports) {
            EXPECT_EQ(report.samples, counted[leaf]) << "leaf " << leaf;
            EXPECT_LE(report.rays, hits_of_nodes[shader::octree_node_of(leaf)]) << "leaf " << leaf;
        }
    }
}

} // namespace
} // namespace vigil::test
