// SPDX-License-Identifier: GPL-2.0-or-later
// What the renderer reports of its guiding: leaves read back against the primary hits that fell
// into them, the leaf under the crosshair, the memory, and the counts that come with frame times.
#include "refresh/vkpt/guiding/leaf_report.h"

#include "refresh/vkpt/guiding/guiding_counts.h"
#include "render_test.h"
#include "shared/octree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace vigil::test {
namespace {

class GuidingReports : public RenderTest {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        load("rooms");
        shot_.view = {{290, 20, 96}, {5, 55, 0}, 90};
        set("pt_nee", "vlc");
    }
    void render(int frames) {
        for (int i = 0; i < frames; ++i)
            renderer().render(shot_.frame());
    }
    static std::vector<shader::PrimaryHit> lit_hits() {
        std::vector<shader::PrimaryHit> hits = primary_hits();
        std::erase_if(hits, [](const auto& hit) { return hit.primitive == shader::NONE; });
        return hits;
    }
    /// The counts of the last frame.
    static std::map<std::string, double> last_counts() {
        const std::vector<refresh::FrameTimes> times = renderer().take_frame_times(true);
        std::map<std::string, double> counts;
        if (times.empty()) return counts;
        for (const refresh::FrameCount& count : times.back().counts)
            counts[count.name] = count.value;
        return counts;
    }
    /// Whether a light of the cache under the crosshair belongs to this dynamic light.
    static bool caches_dynamic_light(uint32_t number) {
        for (const auto& bucket : renderer().report_guiding().buckets)
            for (const refresh::CachedLight& light : bucket)
                if (light.owner == refresh::CachedLight::Owner::DynamicLight &&
                    light.number == number)
                    return true;
        return false;
    }

    Shot shot_;
};

TEST_F(GuidingReports, LeavesHoldTheHitsThatFellIntoThem) {
    set("pt_bounces", "0"); // primary hits are all surface samples
    set("pt_oct_scale", "0.25");
    render(8);
    const vkpt::TreeCopy tree(renderer().device(), renderer().guiding());
    std::map<uint32_t, uint32_t> counted;
    std::map<uint32_t, vkpt::LeafReport> reports;
    const std::vector<shader::PrimaryHit> hits = primary_hits();
    const std::vector<uint32_t> flags = pixel_flags();
    for (size_t i = 0; i < hits.size(); ++i) {
        const shader::PrimaryHit& hit = hits[i];
        if (hit.primitive == shader::NONE) continue;
        const vkpt::LeafReport report = tree.leaf_at(hit.position, 32);
        // One that explores has a second light sample.
        counted[report.leaf] += flags[i] & shader::PIXEL_EXPLORED ? 2 : 1;
        for (glm::length_t axis = 0; axis < 3; ++axis) {
            EXPECT_GE(hit.position[axis], report.corner[axis] - 0.01f);
            EXPECT_LE(hit.position[axis], report.corner[axis] + report.size + 0.01f);
        }
        reports.emplace(report.leaf, report);
    }
    EXPECT_GT(reports.size(), 8u);
    for (const auto& [leaf, report] : reports) {
        EXPECT_EQ(report.samples, counted[leaf]) << "leaf " << leaf;
        EXPECT_EQ(report.dropped(),
                  report.samples > report.room ? report.samples - report.room : 0);
        // The cubes halve from level to level; the path's last number is the leaf's child number.
        EXPECT_NEAR(report.size * std::exp2(static_cast<float>(report.path.size())),
                    65536.0f / renderer().guiding().header().scale, 0.1f);
        EXPECT_EQ(report.path.back(), leaf % 8);
    }
}

TEST_F(GuidingReports, NeighboursTouch) {
    set("pt_oct_scale", "0.25");
    render(8);
    const vkpt::TreeCopy tree(renderer().device(), renderer().guiding());
    const shader::GuidingHeader& header = renderer().guiding().header();
    size_t found = 0;
    for (const shader::PrimaryHit& hit : lit_hits()) {
        const vkpt::LeafReport report = tree.leaf_at(hit.position, 32);
        // In smallest cells. A neighbour that is divided finer counts with its part at the middle.
        const glm::vec3 low = glm::round((report.corner - header.corner) * header.scale);
        const float size = std::round(report.size * header.scale);
        for (size_t face = 0; face < 6; ++face) {
            if (report.neighbours[face] == shader::NONE) continue;
            const auto axis = static_cast<glm::length_t>(face / 2);
            glm::vec3 beyond = low + 0.5f * size;
            beyond[axis] = face % 2 ? low[axis] + size : low[axis] - 1.0f;
            const glm::vec3 place = header.corner + (beyond + 0.5f) / header.scale;
            EXPECT_EQ(tree.leaf_at(place, 32).leaf, report.neighbours[face]);
            ++found;
        }
    }
    EXPECT_GT(found, 100u);
}

TEST_F(GuidingReports, CrosshairHasItsLeafAndItsLights) {
    render(8);
    const refresh::GuidingReport report = renderer().report_guiding();
    ASSERT_TRUE(report.on && report.position);
    const vkpt::LeafReport leaf =
        vkpt::TreeCopy(renderer().device(), renderer().guiding()).leaf_at(*report.position, 32);
    EXPECT_EQ(report.leaf.leaf, leaf.leaf);
    EXPECT_EQ(report.earlier.leaf, leaf.leaf);
    EXPECT_EQ(report.leaf.path, leaf.path);
    ASSERT_EQ(report.buckets.size(), leaf.buckets.size());
    ASSERT_FALSE(report.buckets.empty());
    for (size_t i = 0; i < leaf.buckets.size(); ++i) {
        EXPECT_TRUE(std::ranges::is_sorted(report.buckets[i], std::greater{},
                                           &refresh::CachedLight::power));
        std::vector<uint32_t> ids;
        for (const refresh::CachedLight& light : report.buckets[i]) {
            ids.push_back(light.id);
            EXPECT_GT(light.power, 0.0f);
            EXPECT_EQ(light.owner, refresh::CachedLight::Owner::World);
        }
        EXPECT_TRUE(std::ranges::is_permutation(ids, leaf.buckets[i]));
    }
}

TEST_F(GuidingReports, KnowWhoseLightsTheyAre) {
    // The steady lamps out, so that the others fill the caches.
    shot_.view = {{40, 40, 60}, {0, 35, 0}, 90};
    refresh::Entity door;
    door.number = 5;
    door.model = renderer().register_model("*1");
    door.origin = {-40, -20, 20};
    shot_.entities = {door};
    shot_.dynamic_lights = {{77, {120, 120, 40}, 16.0f, {2000, 1000, 500}}};
    render(10);
    EXPECT_TRUE(caches_dynamic_light(77));
    shot_.dynamic_lights.clear();
    render(10);
    EXPECT_FALSE(caches_dynamic_light(77));
}

TEST_F(GuidingReports, CrosshairHasItsQuadtree) {
    set("pt_guide", "cdq");
    for (const char* technique : {"vlc", "sll"}) {
        SCOPED_TRACE(technique);
        set("pt_nee", technique);
        set("pt_cdq_bits", "64");
        render(6);
        const refresh::GuidingReport report = renderer().report_guiding();
        EXPECT_TRUE(report.on && report.quadtrees && report.position);
        EXPECT_GT(report.leaf.samples, 0u);
        EXPECT_GT(report.leaf.rays, 0u);
        EXPECT_EQ(report.quadtree.bits, 64u);
        EXPECT_EQ(report.quadtree.cells.size(), 49u);
    }
    set("pt_guide", "brdf");
    render(1);
    EXPECT_FALSE(renderer().report_guiding().quadtrees);
    set("pt_guide", "cdq");
    load("opensky");
    EXPECT_FALSE(renderer().report_guiding().quadtrees);
    shot_.view = {{150, 0, 90}, {-80, 0, 0}, 60};
    render(2);
    EXPECT_TRUE(renderer().report_guiding().quadtrees);
    EXPECT_FALSE(renderer().report_guiding().position);
}

TEST_F(GuidingReports, NodesCountTheRaysThatBroughtLight) {
    set("pt_guide", "cdq");
    set("pt_bounces", "0"); // one ray per primary hit
    set("pt_sky_scale", "0");
    set("pt_nee", "brute"); // rays find lights
    render(6);
    const vkpt::TreeCopy tree(renderer().device(), renderer().guiding());
    std::map<uint32_t, vkpt::LeafReport> reports;
    for (const shader::PrimaryHit& hit : lit_hits()) {
        const vkpt::LeafReport report = tree.leaf_at(hit.position, 32);
        reports.emplace(report.leaf, report);
    }
    std::map<uint32_t, uint32_t> samples, rays; // by node
    for (const auto& [leaf, report] : reports) {
        samples[shader::octree_node_of(leaf)] += report.samples;
        rays[shader::octree_node_of(leaf)] = report.rays;
    }
    uint32_t all = 0;
    for (const auto& [node, count] : rays) {
        EXPECT_LE(count, samples.at(node)) << "node " << node;
        all += count;
    }
    EXPECT_GT(all, 0u);
}

TEST_F(GuidingReports, SayWhenThereIsNothingToTell) {
    set("pt_nee", "sll");
    render(1);
    EXPECT_FALSE(renderer().report_guiding().on);
    EXPECT_EQ(renderer().report_guiding().technique, Technique::sll);
    EXPECT_FALSE(renderer().report_guiding().on);
    EXPECT_EQ(renderer().report_guiding().technique, Technique::sll);
    set("pt_nee", "vlc");
    load("opensky");
    EXPECT_FALSE(renderer().report_guiding().on) << "before the level's first frame";
    shot_.view = {{150, 0, 90}, {-80, 0, 0}, 60};
    render(2);
    EXPECT_TRUE(renderer().report_guiding().on);
    EXPECT_FALSE(renderer().report_guiding().position);
}

// While a technique without caches guides rays, caches grow old unseen: what they name may be gone.
TEST_F(GuidingReports, CachesAreOfTheTechniqueThatIsInUse) {
    set("pt_guide", "cdq");
    render(3);
    set("pt_nee", "sll");
    render(4);
    set("pt_nee", "vlc");
    for (int frame = 0; frame < 3; ++frame) {
        render(1);
        const vkpt::TreeCopy tree(renderer().device(), renderer().guiding());
        for (const shader::PrimaryHit& hit : lit_hits())
            for (const auto& bucket : tree.leaf_at(hit.position, 32).buckets)
                for (const uint32_t light : bucket)
                    ASSERT_LT(light, renderer().scene()->lights().lights().size()) << frame;
    }
}

TEST_F(GuidingReports, MemoryAddsUp) {
    render(2);
    const refresh::GuidingReport report = renderer().report_guiding();
    EXPECT_TRUE(report.on);
    EXPECT_EQ(report.bytes, renderer().guiding().memory_bytes());
    ASSERT_EQ(report.memory.size(), 6u);
    uint64_t sum = 0;
    for (const refresh::GuidingReport::Amount& part : report.memory) {
        EXPECT_GT(part.amount, 0u) << part.name;
        sum += part.amount;
    }
    EXPECT_EQ(sum, report.bytes);
    EXPECT_EQ(report.rooms.front().room, renderer().guiding().header().node_capacity);
    for (const refresh::GuidingReport::Room& room : report.rooms)
        EXPECT_LE(room.need, room.room) << room.name;
    EXPECT_GE(report.leaves, 8u);
    EXPECT_GE(report.depth, 1u);
}

TEST_F(GuidingReports, CountsComeWithTheTimesOfTheirFrame) {
    // The first frame counts nothing; of a finer octree it would count what is expected.
    set("pt_oct_start", "0");
    set("pt_bounces", "0");
    set("pt_vlc_beside", "0"); // one light sample for each hit
    renderer().take_frame_times(true);
    render(6);
    const auto hits = static_cast<double>(lit_hits().size());
    std::map<std::string, double> counts = last_counts();
    EXPECT_EQ(counts["samples"], hits); // of the frame before, which saw the same
    EXPECT_EQ(counts["samples_kept"] + counts["samples_dropped"], counts["samples"]);
    EXPECT_GT(counts["octree_leaves"], 8.0);
    EXPECT_GT(counts["lights_per_cache"], 0.0);
    EXPECT_LE(counts["lights_per_cache"], counts["most_lights"]);
    EXPECT_GE(counts["buckets_per_cache"], 1.0);

    renderer().reset_guiding();
    render(1);
    counts = last_counts();
    EXPECT_EQ(counts["octree_leaves"], 8.0);
    EXPECT_EQ(counts["samples"], 0.0);
    EXPECT_EQ(counts["caches"], 0.0);

    set("pt_nee", "uniform");
    render(2);
    EXPECT_TRUE(last_counts().empty());
}

} // namespace
} // namespace vigil::test
