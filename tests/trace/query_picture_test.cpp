// SPDX-License-Identifier: GPL-2.0-or-later
// Whole pictures by ray queries and by our BVH in compute, from the same random numbers: equal
// pixel by pixel, but for rays that pass an edge within rounding; and switching between the two.
// Lights are chosen by `uniform`, whose choice does not look at the surface: importances differ in
// their last digits from a hit point that differs in its last digit, and one choice in a thousand
// turns on them.
#include "vkpt/render_test.h"

#include "common/log.h"
#include "common/scratch_folder.h"
#include "formats/small_models.h"

#include <algorithm>

namespace vigil::test {
namespace {

class QueryPicture : public RenderTest {
protected:
    static bool offered() { return renderer().device().features().ray_query; }

    /// The passes of one frame with either backend on what was rendered last, by queries.
    static std::vector<float> trace_by(bool ray_query, const Shot& shot) {
        return trace(params(shot), {Technique::uniform, renderer().scene()->features(), ray_query},
                     2, true);
    }

    /// Values may differ by a thousandth (hit points differ by roundings; 1e-5 was seen), and one
    /// value in a thousand by more (none was seen).
    static void expect_equal_pictures(const Shot& shot) {
        radiance(shot);
        const std::vector<float> compute = trace_by(false, shot);
        const std::vector<float> query = trace_by(true, shot);
        size_t unequal = 0, lit = 0;
        for (size_t i = 0; i < compute.size(); ++i) {
            const float larger = std::max(compute[i], query[i]);
            lit += larger > 0.0f;
            unequal += std::abs(compute[i] - query[i]) > 1e-3f * larger;
        }
        EXPECT_GT(lit, compute.size() / 2);
        EXPECT_LE(unequal, compute.size() / 1000);
    }
};

Shot view_at(glm::vec3 origin, float pitch, float yaw) {
    Shot shot;
    shot.view = {origin, {pitch, yaw, 0.0f}, 90.0f};
    return shot;
}

TEST_F(QueryPicture, EqualToTheComputeBackend) {
    if (!offered()) GTEST_SKIP() << "this device has no VK_KHR_ray_query";
    set("pt_trace", "query");
    set("pt_nee", "uniform");
    load("rooms");
    { // Through a translucent window.
        SCOPED_TRACE("window");
        expect_equal_pictures(view_at({420, 40, 90}, 0, 50));
    }
    { // A door moves between frames, and lights come.
        SCOPED_TRACE("door");
        Shot shot = view_at({40, 40, 60}, 0, 25);
        refresh::Entity door;
        door.number = 1;
        door.model = renderer().register_model("*1");
        door.origin = {-40, -20, 20};
        shot.entities = {door};
        expect_equal_pictures(shot);
        shot.entities[0].origin = {40, -150, 20};
        shot.entities[0].angles = {0, 30, 0};
        shot.dynamic_lights = {{7, {120, 120, 40}, 16.0f, {20, 10, 5}},
                               {8, {200, 60, 100}, 12.0f, {5, 20, 40}}};
        expect_equal_pictures(shot);
    }
}

TEST_F(QueryPicture, FollowsTheFramesOfAModel) {
    if (!offered()) GTEST_SKIP() << "this device has no VK_KHR_ray_query";
    const ScratchFolder folder;
    folder.write("models/box/tris.md2", small_md2());
    files().mount_folder(folder.path());
    set("pt_trace", "query");
    set("pt_nee", "uniform");
    load("rooms");
    // A square of 10 units that lies in the air below the eye, and rises.
    Shot shot = view_at({60, 60, 64}, 80, 45);
    refresh::Entity box;
    box.number = 1;
    box.model = renderer().register_model("models/box/tris.md2");
    box.origin = {60, 60, 40};
    shot.entities = {box};
    expect_equal_pictures(shot);
    const auto visible = [] {
        return std::ranges::count(primary_hits(), 1u, &shader::PrimaryHit::instance);
    };
    const auto low = visible();
    EXPECT_GT(low, 20);
    shot.entities[0].frame = 1;
    expect_equal_pictures(shot);
    EXPECT_GT(visible(), low); // nearer
    shot.entities[0].frame = 0;
    shot.entities[0].old_frame = 1;
    shot.entities[0].backlerp = 0.5f;
    expect_equal_pictures(shot);
    EXPECT_GT(visible(), low);
}

TEST_F(QueryPicture, BackendsSwitchWhileRunning) {
    if (!offered()) GTEST_SKIP() << "this device has no VK_KHR_ray_query";
    load("rooms");
    const Shot shot = view_at({290, 20, 96}, 5, 55);
    for (const char* backend : {"bvh", "query", "query", "bvh", "query"}) {
        set("pt_trace", backend);
        const refresh::RadiancePicture picture = radiance(shot);
        const bool ray_query = backend == std::string_view("query");
        EXPECT_EQ(renderer().scene()->acceleration_structure() != VK_NULL_HANDLE, ray_query);
        EXPECT_EQ(renderer().report_scene(cvars().values()).ray_query, ray_query);
        EXPECT_GT(*std::max_element(picture.rgb.begin(), picture.rgb.end()), 0.0f);
    }
    load("lamp"); // a level more, with the setting kept
    radiance(view_at({-192, 0, 64}, 30, 0));
    EXPECT_NE(renderer().scene()->acceleration_structure(), VK_NULL_HANDLE);
}

TEST_F(QueryPicture, WithoutQueriesOneMessageAndTheComputeBackend) {
    if (offered()) GTEST_SKIP() << "this device has VK_KHR_ray_query";
    load("rooms");
    int warnings = 0;
    const int sink = add_log_sink([&](Severity severity, std::string_view line) {
        warnings += severity == Severity::Warning &&
                    line.find("VK_KHR_ray_query") != std::string_view::npos;
    });
    set("pt_trace", "query");
    for (int frame = 0; frame < 2; ++frame)
        radiance(view_at({290, 20, 96}, 5, 55));
    remove_log_sink(sink);
    EXPECT_EQ(warnings, 1);
    EXPECT_EQ(renderer().scene()->acceleration_structure(), VK_NULL_HANDLE);
}

} // namespace
} // namespace vigil::test
