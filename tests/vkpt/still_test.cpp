// SPDX-License-Identifier: GPL-2.0-or-later
// A scene in which nothing changes is not copied again, and one in which something does reaches the
// device in the same frame. The level is the room of tests/data/lamp.
#include "formats/picture_bytes.h"
#include "formats/small_models.h"
#include "refresh/vkpt/gpu/commands.h"
#include "render_test.h"

#include <algorithm>
#include <cstring>
#include <set>

namespace vigil::test {
namespace {

class StillTest : public RenderTest, public testing::WithParamInterface<std::string_view> {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        set("pt_nee", "vlc");
        set("pt_guide", "cdq");
        set("pt_trace", GetParam());
        if (GetParam() == "query" && !renderer().device().features().ray_query)
            GTEST_SKIP() << "the device has no ray queries";
        write_game_file("models/plate.glb", triangle_glb(R"("scale":[90,90,90],)"));
        write_game_file("models/box.md2", small_md2());
        write_game_file("models/box/skin.pcx", write_pcx(1, 1));
        load("lamp");
        shot_.view = {{-192, 0, 64}, {10, 0, 0}, 90};
        shot_.entities = {entity(1, "models/box.md2", {0, 0, 32}),
                          entity(2, "models/plate.glb", {100, 0, 32})};
        shot_.spots = {{3, {0, 100, 120}, {60, 0, 0}, 1.5f, {40, 40, 40}}};
        particles_ = {{{50, 20, 60}, 2.0f, {1, 0.5f, 0}, 1.0f}};
        draws_.resize(1);
        draws_[0].size = {8, 4};
        render();
    }
    static refresh::Entity entity(int number, std::string_view model, glm::vec3 origin) {
        refresh::Entity entity;
        entity.number = number;
        entity.model = renderer().register_model(model);
        entity.origin = origin;
        return entity;
    }
    refresh::Frame frame() const {
        refresh::Frame frame = shot_.frame();
        frame.particles = particles_;
        frame.draws = draws_;
        return frame;
    }
    /// One frame; returns what was copied for it, by buffer. Sets `learns_`.
    gpu::ByteCounts render() {
        renderer().render(frame());
        gpu::ByteCounts copied;
        const std::vector<refresh::FrameTimes> times = renderer().take_frame_times(true);
        learns_ = std::ranges::any_of(times.back().passes, [](const refresh::PassTime& pass) {
            return pass.name == "octree_mark";
        });
        for (const refresh::Upload& upload : times.back().uploads)
            copied[upload.name] += upload.bytes;
        expect_host_and_device_are_the_same();
        return copied;
    }
    static std::set<std::string> names(const gpu::ByteCounts& copied) {
        std::set<std::string> names;
        for (const auto& [name, bytes] : copied)
            names.insert(name);
        return names;
    }

    template <typename T>
    static void expect_same(const gpu::Buffer& buffer, std::span<const T> host) {
        const std::vector<T> device =
            gpu::download_now_as<T>(renderer().device(), buffer, 0, host.size());
        EXPECT_EQ(std::memcmp(device.data(), host.data(), host.size_bytes()), 0) << buffer.name();
    }
    static void expect_host_and_device_are_the_same() {
        const vkpt::Scene& scene = *renderer().scene();
        expect_same<shader::Instance>(scene.instances(), scene.host_instances());
        expect_same<shader::BvhTriangle>(scene.triangles(), scene.host_triangles());
        expect_same<shader::Primitive>(scene.primitives(), scene.host_primitives());
        expect_same<shader::Light>(scene.light_buffer(), scene.lights().lights());
    }
    /// Renders what may follow from a change (places of the frame before, changes that fade), and
    /// then expects stillness.
    void expect_still_again() {
        for (int frame = 0; frame < 40; ++frame)
            render();
        EXPECT_EQ(render(), nothing);
    }

    inline static const gpu::ByteCounts nothing;
    bool learns_ = false; // the last frame learned from the one before
    Shot shot_;
    std::vector<refresh::Particle> particles_;
    std::vector<refresh::Draw> draws_;
};

TEST_P(StillTest, NothingIsCopiedWhereNothingChanges) {
    shot_.spots.clear(); // its light is new in the first frame, and looked for until that fades
    load("lamp");
    shot_.entities = {entity(1, "models/box.md2", {0, 0, 32}),
                      entity(2, "models/plate.glb", {100, 0, 32})};
    EXPECT_TRUE(render().contains("instances"));
    set("pt_learn_every", "2"); // its turns are no copies either
    for (int number = 1; number < 24; ++number)
        EXPECT_EQ(render(), nothing) << "frame " << number;
    set("flt_enable", "1"); // its rays pass through another point of each pixel in each frame
    render();
    render(); // the first with a past
    for (int number = 2; number < 6; ++number)
        EXPECT_EQ(render(), nothing) << "filtered frame " << number;
}

TEST_P(StillTest, LearningRestsUntilSomethingChanges) {
    set("pt_rest_after", "40"); // beyond what may follow from the frames before
    const auto learns = [&] {
        render();
        return learns_;
    };
    const auto fall_asleep = [&] {
        for (int frame = 0; frame < 100; ++frame)
            render();
        while (learns() || learns())
            ;
    };
    // What changes is of the frame in which it changes: the next one learns from its samples.
    const auto expect_awake = [&] {
        EXPECT_FALSE(learns());
        for (int frame = 0; frame < 40; ++frame) {
            EXPECT_TRUE(learns()) << "frame " << frame;
            EXPECT_GT(renderer().guiding().statistics(0).samples, 0u);
        }
    };
    fall_asleep();
    // One frame of 31 stores samples, and the next one learns from them.
    int count = 0;
    for (int frame = 0; frame < 62; ++frame)
        count += learns() ? 1 : 0;
    EXPECT_EQ(count, 2);
    fall_asleep();
    shot_.view.angles.y += 1.0f;
    expect_awake();
    fall_asleep();
    shot_.entities[0].origin.x += 1.0f;
    expect_awake();
    fall_asleep();
    shot_.dark_styles = {0};
    expect_awake();
    fall_asleep();
    renderer().reset_guiding();
    EXPECT_TRUE(learns()); // the first octree
    for (int frame = 0; frame < 40; ++frame)
        EXPECT_TRUE(learns()) << "frame " << frame;
    set("pt_rest_after", "0"); // never
    for (int frame = 0; frame < 100; ++frame)
        render();
    for (int frame = 0; frame < 40; ++frame)
        EXPECT_TRUE(learns()) << "frame " << frame;
}

TEST_P(StillTest, GuidersThatGainTooLittleDrawFewRays) {
    set("pt_guide", "cdq");
    set("pt_cdq_rays", "1"); // they soon know what there is to know
    const auto guided_frames = [&](std::string_view gain, float spot_step = 0.0f) {
        set("pt_guide_gain", gain);
        renderer().reset_guiding();
        int count = 0;
        for (int frame = 0; frame < 48; ++frame) {
            shot_.spots[0].origin.x += spot_step;
            render();
            if (frame >= 16) count += renderer().guiding().header().guides != 0 ? 1 : 0;
        }
        return count;
    };
    EXPECT_EQ(guided_frames("1"), 4); // of 32
    EXPECT_EQ(guided_frames("1", 0.1f), 16) << "a light that moves may bring them a gain";
    EXPECT_EQ(guided_frames("0"), 32);
}

TEST_P(StillTest, LearningTakesTurns) {
    set("pt_guide", "brdf");
    set("pt_oct_scale", "100"); // a few leaves with many samples
    const auto turns = [&](std::string_view every, float spot_step = 0.0f, float turn = 1.0f,
                           float fade = 1.0f) {
        set("pt_learn_every", every);
        renderer().reset_guiding();
        std::string learning;
        for (int frame = 0; frame < 24; ++frame) {
            shot_.view.angles.y += turn;
            shot_.spots[0].origin.x += spot_step;
            shot_.spots[0].radiance *= fade;
            render();
            learning += learns_ ? '1' : '0';
        }
        return learning;
    };
    const std::string each(24, '1');
    EXPECT_EQ(turns("1"), each);
    // What four frames stored is learned by the fifth. Then room has to be found for all samples.
    const auto expect_turns = [](const std::string& learning, std::string_view settled) {
        EXPECT_EQ(learning.substr(0, 5), "11111");
        EXPECT_EQ(learning.substr(12), settled);
    };
    expect_turns(turns("2"), "010101010101");
    expect_turns(turns("4"), "010001000100");
    EXPECT_EQ(turns("4", 0.0f, 1.0f, 0.99f), turns("4")) << "a light grows darker";
    EXPECT_EQ(turns("4", 1.0f), each) << "a light moves";
    EXPECT_EQ(turns("4", 0.0f, 97.0f), each) << "each frame shows other surfaces";
    set("pt_view", "samples");
    EXPECT_EQ(turns("4"), each) << "the view counts samples";
    set("pt_view", "none");
    // Where caches have many lights for the samples there are, all frames teach.
    set("pt_oct_scale", "0.3");
    for (uint32_t id = 10; id < 14; ++id) // of eight faces each
        shot_.dynamic_lights.push_back({id, {0, 10.0f * static_cast<float>(id), 80}, 2, {9, 9, 9}});
    EXPECT_EQ(turns("4"), each);
    // A view that begins in the middle of a turn has samples from its second frame on.
    shot_.dynamic_lights.resize(shot_.dynamic_lights.size() - 4);
    set("pt_oct_scale", "100");
    EXPECT_NE(turns("4"), each);
    set("pt_view", "samples");
    render(); // learns what the frame before stored, if anything
    for (int frame = 0; frame < 6; ++frame) {
        render();
        EXPECT_TRUE(learns_) << frame;
    }
}

TEST_P(StillTest, WhatChangesIsCopiedInItsFrame) {
    const std::string top = GetParam() == "query" ? "top-level instances" : "top-level nodes";
    expect_still_again();

    shot_.entities[1].origin.y += 30.0f; // a door, say
    std::set<std::string> moved = names(render());
    EXPECT_TRUE(moved.contains("instances"));
    EXPECT_TRUE(moved.contains(top));
    EXPECT_FALSE(moved.contains("triangles"));
    // It was elsewhere in the frame before, and is not any more.
    EXPECT_EQ(names(render()), std::set<std::string>{"instances"});
    expect_still_again();

    shot_.entities[0].frame = 1; // a pose
    EXPECT_TRUE(names(render()).contains("triangles"));
    expect_still_again();

    shot_.dark_styles = {0};
    EXPECT_TRUE(names(render()).contains("lights"));
    expect_still_again();
    shot_.dark_styles = {};
    EXPECT_TRUE(names(render()).contains("lights"));
    expect_still_again();

    shot_.spots[0].origin.x += 10.0f;
    EXPECT_TRUE(names(render()).contains("lights"));
    expect_still_again();

    particles_[0].origin.z -= 5.0f;
    EXPECT_TRUE(names(render()).contains("triangles"));
    expect_still_again();
    shot_.view.origin.x += 1.0f; // which particles face
    EXPECT_TRUE(names(render()).contains("triangles"));
    expect_still_again();

    shot_.entities.pop_back();
    moved = names(render());
    EXPECT_TRUE(moved.contains("instances"));
    EXPECT_TRUE(moved.contains(top));
    expect_still_again();

    draws_[0].size.x += 1;
    EXPECT_EQ(names(render()), std::set<std::string>{"draws"});
    expect_still_again();
}

TEST_P(StillTest, WhatWasPreparedAndNotDrawnIsCopiedLater) {
    expect_still_again();
    shot_.entities[1].origin.y += 30.0f;
    renderer().scene()->prepare(frame()); // as the command `export` does
    EXPECT_TRUE(names(render()).contains("instances"));
    expect_still_again();
}

INSTANTIATE_TEST_SUITE_P(Trace, StillTest, testing::Values("bvh", "query"),
                         [](const auto& given) { return std::string(given.param); });

} // namespace
} // namespace vigil::test
