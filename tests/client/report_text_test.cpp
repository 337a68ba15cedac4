// SPDX-License-Identifier: GPL-2.0-or-later
// What the console says of the renderer's reports, word for word.
#include "client/measure/report_text.h"

#include <gtest/gtest.h>

namespace vigil::client {
namespace {

using refresh::CachedLight;
using refresh::GuidingReport;
using refresh::SceneReport;

SceneReport scene() {
    SceneReport report;
    report.level = "rooms";
    report.features = {{"lights", true, "emissive triangles", 30}, {"sun", false, "no sky faces"}};
    report.triangles = 1200;
    report.materials = 12;
    report.textures = 9;
    report.instances = 1;
    report.lights = 30;
    report.static_lights = 28;
    report.bytes = 3 << 20;
    return report;
}

TEST(ReportText, Scene) {
    refresh::Settings settings;
    settings.pt_nee = static_cast<int>(Technique::uniform);
    EXPECT_EQ(
        scene_text(scene(), {}, {}, settings),
        "rooms: 1200 triangles, 12 materials, 9 textures, 30 lights (28 of the static world), "
        "1 instances\n"
        "  lights          on   30 emissive triangles\n"
        "  sun             off  no sky faces\n"
        "  scene memory    3.0 MiB\n"
        "  ray tracing     our BVH in compute\n"
        "  light sampling  uniform: Every light of the level with equal probability. A baseline.\n"
        "  guiding         off");
}

TEST(ReportText, SceneWithAllThatMayBeSaid) {
    SceneReport report = scene();
    report.ray_query = true;
    report.ray_query_bytes = 1 << 20;
    report.filter_bytes = 3 << 19;
    report.missing_textures = {"a/b", "c"};
    refresh::GuidingReport guiding;
    guiding.on = true;
    guiding.leaves = 57;
    guiding.depth = 3;
    guiding.caches = 20;
    guiding.bytes = 5 << 19;
    refresh::Settings settings;
    settings.pt_compare = choice_index(compare_choices, "vlc+cdq");
    const std::string text = scene_text(report, guiding, {7, 0}, settings);
    for (const std::string_view line :
         {"  scene memory    3.0 MiB, 1.0 MiB of it for ray queries\n",
          "  filter memory   1.5 MiB\n", "  2 missing textures: a/b c\n",
          "  ray tracing     VK_KHR_ray_query\n", "  compared with   vlc+cdq\n",
          "  guiding         octree of 57 leaves, depth 3, 20 caches, 2.5 MiB\n"})
        EXPECT_NE(text.find(line), std::string::npos) << line << " in\n" << text;
    EXPECT_TRUE(
        text.ends_with("\n  7 radiance values were not finite. pt_view nonfinite shows where."));
}

TEST(ReportText, Guiding) {
    refresh::GuidingReport guiding;
    guiding.technique = Technique::lh;
    EXPECT_EQ(guiding_text(guiding),
              "Guiding was off in the last frame: pt_nee lh needs none. `scene` says why.");
    guiding.on = true;
    guiding.memory = {{"octree nodes, twice", 1 << 20}, {"light samples", 4 << 20}};
    guiding.bytes = 5 << 20;
    guiding.rooms = {{"inner nodes", 40, 50, 100}, {"light samples", 150, 160, 200}};
    EXPECT_EQ(guiding_text(guiding),
              "guiding memory, bytes\n"
              "  octree nodes, twice         1048576      1.00 MiB\n"
              "  light samples               4194304      4.00 MiB\n"
              "  all                         5242880      5.00 MiB\n"
              "                               in use   at most yet      room for\n"
              "  inner nodes                      40            50           100\n"
              "  light samples                   150           160           200");
}

GuidingReport crosshair() {
    GuidingReport report;
    report.on = true;
    report.quadtrees = true;
    report.position = {1.0f, 2.5f, -3.0f};
    report.leaf.leaf = 12;
    report.leaf.path = {1, 4};
    report.leaf.corner = {0.0f, 0.0f, -8.0f};
    report.leaf.size = 16.0f;
    report.leaf.samples = 50;
    report.leaf.room = 40;
    report.leaf.rays = 7;
    report.leaf.ray_room = 60;
    report.leaf.explore_share = 0.25f;
    report.leaf.neighbours = {1, 2, 3, 4, 5, refresh::OctreeLeaf::none};
    report.earlier = report.leaf;
    report.buckets = {{{3, 20.0f, CachedLight::Owner::World},
                       {40, 10.5f, CachedLight::Owner::Entity, 5},
                       {41, 1.0f, CachedLight::Owner::DynamicLight, 77},
                       {99, 0.0f, CachedLight::Owner::Gone}},
                      {{4, 1.0f}}};
    report.quadtree.bits = 64;
    report.quadtree.deepest = 5;
    report.quadtree.below_horizon = 0.125f;
    report.quadtree.share = 0.3f;
    report.quadtree.cells = {{{0.0f, 1.0f, 0.0f}, 5, 4.0f}, {{0.0f, 0.0f, 1.0f}, 2, 0.25f}};
    return report;
}

constexpr std::string_view leaf_lines =
    "under the crosshair: 1.0 2.5 -3.0\n"
    "leaf 12: path 1.4, depth 2\n"
    "  cube            0.0 0.0 -8.0 and on, 16.0 map units wide\n"
    "  samples         50 in this frame, room for 40, 10 dropped\n"
    "  source          leaf - of the frame before\n"
    "  neighbours      -x 1  +x 2  -y 3  +y 4  -z 5  +z -\n";

TEST(ReportText, LightCache) {
    GuidingReport report = crosshair();
    EXPECT_EQ(light_cache_text(report),
              std::string(leaf_lines) +
                  "  cache           5 lights in 2 buckets\n"
                  "  25% of samples gain from a search for other lights\n"
                  "  bucket 0: 4 lights\n"
                  "    light 3      power 20         static world\n"
                  "    light 40     power 10.5       entity 5\n"
                  "    light 41     power 1          dynamic light 77\n"
                  "    light 99     power 0          of nothing that is there now\n"
                  "  bucket 1: 1 light\n"
                  "    light 4      power 1          static world");
    // Long ones are cut.
    report.buckets.assign(10, std::vector<CachedLight>(12));
    const std::string cut = light_cache_text(report);
    EXPECT_NE(cut.find("\n    and 2 weaker ones\n"), std::string::npos) << cut;
    EXPECT_TRUE(cut.ends_with("\n  and 2 more buckets")) << cut;
    // Of something that moves.
    report.earlier.leaf = 13;
    EXPECT_NE(light_cache_text(report).find(
                  "its light cache is that of where it was a frame ago:\nleaf 13: path 1.4"),
              std::string::npos);
    report.position.reset();
    EXPECT_EQ(light_cache_text(report),
              "There is no surface under the crosshair: sky, or the inside of a wall.");
    report.on = false;
    EXPECT_EQ(light_cache_text(report),
              "Guiding was off in the last frame: pt_nee sll needs none. `scene` says why.");
    report = crosshair();
    report.teaches = false;
    EXPECT_NE(light_cache_text(report).find("this frame stored no samples or rays\n"),
              std::string::npos);
}

TEST(ReportText, Quadtree) {
    GuidingReport report = crosshair();
    EXPECT_EQ(quadtree_text(report),
              std::string(leaf_lines) +
                  "  rays            7 of its node's in this frame, room for 60\n"
                  "  guided rays     30 % of all from here\n"
                  "  quadtree        64 bits, 2 leaves, the smallest at level 5\n"
                  "  density         0.25 to 4 per steradian\n"
                  "  below horizon   12.5 % of its draws\n"
                  "  its densest leaves (yaw from +x, pitch down positive, degrees):\n"
                  "    yaw    90.0  pitch   -0.0  level  5  4 per steradian\n"
                  "    yaw     0.0  pitch  -90.0  level  2  0.25 per steradian");
    report.quadtree.cells.resize(49);
    EXPECT_TRUE(quadtree_text(report).ends_with("\n    and 41 less dense ones"));
    report.earlier.leaf = 13;
    EXPECT_NE(
        quadtree_text(report).find("its quadtree is that of leaf 13, where it was a frame ago:\n"),
        std::string::npos);
    report.position.reset();
    EXPECT_EQ(quadtree_text(report),
              "There is no surface under the crosshair: sky, or the inside of a wall.");
    report.quadtrees = false;
    EXPECT_EQ(quadtree_text(report),
              "No quadtrees guided rays in the last frame. pt_guide cdq makes them.");
}

} // namespace
} // namespace vigil::client
