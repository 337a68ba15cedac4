// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers of entities and lights that a front end does not keep stable, as
// docs/internals/front-end.md says: caches and motion forget, the picture keeps its mean, and
// nothing grows.
#include "formats/small_models.h"
#include "render_test.h"

#include "refresh/vkpt/gpu/commands.h"

#include <algorithm>
#include <fmt/format.h>
#include <iostream>

namespace vigil::test {
namespace {

class Ids : public RenderTest {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        write_game_file("models/box.md2", small_md2());
        write_game_file("models/other.md2", small_md2());
        load("lamp", [](Level& level) {
            for (BspTexInfo& info : level.bsp.texinfos)
                info.value = 0;
        });
        const refresh::ModelHandle models[] = {renderer().register_model("models/box.md2"),
                                               renderer().register_model("models/other.md2")};
        shot_.view = {{-192, 0, 64}, {40, 0, 0}, 80};
        for (int i = 0; i < 3; ++i) {
            refresh::Entity entity;
            entity.number = i;
            entity.model = models[i % 2];
            entity.origin = {-120, 20 * i, 10};
            shot_.entities.push_back(entity);
            shot_.dynamic_lights.push_back({static_cast<uint32_t>(i),
                                            {-140.0f + 60.0f * static_cast<float>(i), 30, 60},
                                            3.0f,
                                            {20, 20, 20}});
        }
    }

    /// The shot with numbers as they are, or with others in each frame; half the time entities
    /// even change places.
    Shot shot(int frame, bool stable) const {
        Shot result = shot_;
        if (stable) return result;
        for (refresh::Entity& entity : result.entities)
            entity.number = (entity.number + frame / 2) % 3;
        for (refresh::DynamicLight& light : result.dynamic_lights)
            light.id += 1000 + 3 * static_cast<uint32_t>(frame);
        return result;
    }
    /// Draws frames, some of them to learn from, and calls `seen` with each one after these.
    template <class Seen> void draw(bool stable, Seen seen) const {
        set("pt_spp", "16");
        renderer().reset_guiding();
        for (int frame = 0; frame < 40; ++frame) {
            set("pt_seed", std::to_string(frame + (stable ? 0 : 1000)));
            const std::vector<float> rgb = radiance(shot(frame, stable)).rgb;
            if (frame >= frames_to_learn) seen(rgb);
        }
    }

    /// One batch a frame.
    PictureBatches frames(bool stable) const {
        PictureBatches batches(48, 32, 8);
        draw(stable, [&](const std::vector<float>& rgb) { batches.add(rgb); });
        return batches;
    }

    Shot shot_;
};

TEST_F(Ids, UnstableOnesKeepTheMean) {
    for (const std::string_view technique : {"sll", "vlc"}) {
        set("pt_nee", technique);
        set("pt_sll_stats", technique == "sll" ? "1" : "0");
        judge(technique, frames(false), frames(true), {0.02});
    }
}

TEST_F(Ids, NothingGrowsByThem) {
    for (int frame = 0; frame < 4; ++frame)
        renderer().render(shot(frame, false).frame());
    const size_t triangles = renderer().scene()->host_triangles().size();
    const size_t lights = renderer().scene()->lights().lights().size();
    EXPECT_LE(lights, 2u * 3 * vkpt::dynamic_light_triangles + 2);
    for (int frame = 4; frame < 40; ++frame)
        renderer().render(shot(frame, false).frame());
    EXPECT_EQ(renderer().scene()->host_triangles().size(), triangles);
    EXPECT_EQ(renderer().scene()->lights().lights().size(), lights);
}

TEST_F(Ids, CachesForgetLightsWithOtherNumbers) {
    // With stable numbers caches know the lights that are seen after a while; with others in each
    // frame they are looked for anew: more surfaces explore.
    set("pt_nee", "vlc");
    // Leaves of a fine octree have a few samples in so small a picture, and look for long.
    set("pt_oct_start", "0");
    // Whole subgroups explore, so one frame has few that do: all are counted.
    const auto explored = [&](bool stable) {
        std::ptrdiff_t pixels = 0;
        draw(stable, [&](const std::vector<float>&) {
            pixels += std::ranges::count_if(pixel_flags(), [](uint32_t flags) {
                return (flags & shader::PIXEL_EXPLORED) != 0;
            });
        });
        return pixels;
    };
    const auto with_stable = explored(true), without = explored(false);
    std::cout << fmt::format("exploring pixels: {} with stable numbers, {} without\n", with_stable,
                             without);
    EXPECT_GT(without, 2 * with_stable);
}

} // namespace
} // namespace vigil::test
