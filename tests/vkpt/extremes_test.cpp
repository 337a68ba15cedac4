// SPDX-License-Identifier: GPL-2.0-or-later
// Settings, counts and clocks at their ends, on whole pictures: shares of exactly 0 and 1, a
// hundred thousand lights, octrees that split always and never, frames after years. What can be
// unbiased is compared with brute force; nothing may be counted that is not finite (render_test.h).
#include "common/error.h"
#include "formats/picture_bytes.h"
#include "formats/sky.h"
#include "light_scenes.h"
#include "numerics/record.h"
#include "refresh/vkpt/gpu/commands.h"

#include <algorithm>
#include <iostream>
#include <random>

namespace vigil::test {
namespace {

class Extremes : public RenderTest {
protected:
    static constexpr Bounds court_bounds{.everywhere = 0.015, .quadrant = 0.08, .five_blocks = 0.2};

    using Settings = std::vector<std::pair<const char*, const char*>>;

    /// These settings have the mean of what was measured before.
    void expect_equal_means(const Shot& shot, const PictureBatches& reference,
                            const Settings& settings, const Bounds& bounds, int paths = 32) {
        std::string name;
        for (const auto& [variable, value] : settings) {
            name += fmt::format("{} {}  ", variable, value);
            set(variable, value);
        }
        judge(name, batches(shot, 12, paths, 5000, 4), reference, bounds);
    }
};

TEST_F(Extremes, SharesOfZeroAndOne) {
    load("rooms");
    Shot shot;
    shot.view = {{290, 20, 96}, {5, 55, 0}, 90};
    set_size(32, 24);
    // Unbiased (convergence_test.cpp), and far less noisy than brute force.
    set("pt_nee", "lh");
    const PictureBatches reference = batches(shot, 16, 64, 1000, 4);
    const auto expect = [&](const std::vector<Settings>& rows, int paths) {
        for (const Settings& row : rows)
            expect_equal_means(shot, reference, row, {.everywhere = 0.012, .five_blocks = 0.12},
                               paths);
    };
    expect({{{"pt_nee", "vlc"}, {"pt_vlc_explore", "1"}, {"pt_explore_local", "1"}},
            {{"pt_vlc_beside", "0"}},
            {{"pt_explore_local", "0"}},
            {{"pt_vlc_beside", "1"}},
            {{"pt_vlc_explore", "0.05"}, {"pt_explore_local", "1"}}},
           64);
    // What is found seldom, as by a twentieth of draws among all lights, is skewed, and takes many
    // paths.
    expect({{{"pt_explore_local", "0"}, {"pt_vlc_adapt", "0"}}}, 512);
    const int guided = 128 * subgroup_factor();
    expect({{{"pt_explore_local", "0.8"},
             {"pt_guide", "cdq"},
             {"pt_cdq_adapt", "0"},
             {"pt_cdq_brdf", "1"}}},
           guided);
    // The same, of light that no guider has found yet.
    expect({{{"pt_cdq_brdf", "0"}}}, 512);
    expect({{{"pt_cdq_adapt", "1"}},
            {{"pt_cdq_margin", "0"}, {"pt_vlc_hysteresis", "0"}},
            {{"pt_cdq_margin", "1"}, {"pt_vlc_hysteresis", "1"}},
            {{"pt_guide_directions", "1"}},
            {{"pt_guide_directions", "16"}},
            {{"pt_guide_directions", "2"}, {"pt_guide_gain", "1"}}},
           guided);
    record("shares", "pt_vlc_explore 1, pt_explore_local 0 and 1", "mean that of lh");
    record("shares",
           "pt_cdq_brdf 0 and 1, learned from there, pt_cdq_margin 0 and 1, "
           "pt_vlc_hysteresis 0 and 1, pt_guide_directions 1 and 16, pt_guide_gain 1",
           "mean that of lh");
    // Without any exploring a light that no cache has is never found: documented, and darker.
    set("pt_guide", "brdf");
    set("pt_vlc_explore", "0");
    const PictureBatches blind = batches(shot, 12, 24, 5000, 4);
    double seen = 0.0, exact = 0.0;
    for (const double mean : blind.means())
        seen += mean;
    for (const double mean : reference.means())
        exact += mean;
    std::cout << fmt::format("without exploring {:.2f}% of the light\n", 100.0 * seen / exact);
    EXPECT_LT(seen, 1.02 * exact);
    EXPECT_GT(seen, 0.5 * exact);
    record("shares", "pt_vlc_explore 0", "biased, as its help says: finite, and not brighter",
           fmt::format("{:.1f}% of the light", 100.0 * seen / exact));
}

TEST_F(Extremes, CachesThatKnowNothing) {
    load("lamp", [](Level& level) {
        for (BspTexInfo& info : level.bsp.texinfos)
            info.value = 0;
    });
    Shot dark;
    dark.view = {{-192, 0, 64}, {50, 0, 0}, 60};
    dark.dynamic_lights = {{9, {-100, 0, -200}, 8.0f, {5, 5, 5}}}; // below the floor
    Shot lit = dark;
    lit.dynamic_lights = {{7, {-120, 40, 60}, 16.0f, {20, 10, 5}},
                          {8, {-40, -60, 100}, 12.0f, {5, 20, 40}}};
    set_size(24, 16);
    set("pt_nee", "lh");
    const PictureBatches reference = batches(lit, 12, 64, 1000, 4);
    set("pt_nee", "vlc");
    for (const int frames : {0, frames_to_learn}) {
        learn(dark, frames);
        radiance(lit); // its samples count in the next frame, which does not come
        vkpt::FrameDescription frame = params(lit);
        PictureBatches seen(cvars()->vid_width, cvars()->vid_height, 4);
        for (int batch = 0; batch < 12; ++batch) {
            frame.settings.pt_seed = 5000 + batch;
            // A quarter of the rows of pixels looks where it was dark: more noise.
            seen.add(
                trace(frame, static_cast<uint32_t>(frames == 0 ? 64 : 1024 * subgroup_factor())));
        }
        judge(fmt::format("after {} dark frames", frames), seen, reference,
              {.everywhere = 0.03, .quadrant = 0.08, .five_blocks = 0.15});
    }
    record("scenes", "lights in the first frame, and after frames without any",
           "vlc has the mean of lh");
}

TEST_F(Extremes, AHundredThousandLights) {
    // Turned anyhow, under the roof of the hall.
    load("lamp", [](Level& level) {
        for (BspTexInfo& info : level.bsp.texinfos)
            info.value = 0;
        hang_scattered(level, 100000, 1.5f, 40);
    });
    Shot shot;
    shot.view = {{-192, 0, 64}, {50, 0, 0}, 60};
    set_size(24, 16);
    set("pt_bounces", "0");
    set("pt_nee", "ris");
    set("pt_ris_candidates", "1024");
    const PictureBatches reference = batches(shot, 12, 64, 1000, 4);
    EXPECT_GE(renderer().scene()->lights().lights().size(), 100000u);
    for (const char* technique : {"sll", "lh", "vlc"})
        expect_equal_means(shot, reference, {{"pt_nee", technique}},
                           {.everywhere = 0.03, .quadrant = 0.08, .five_blocks = 0.15}, 64);
    record("scenes", "100,000 lights in one room", "sll, lh and vlc have the mean of ris");
}

TEST_F(Extremes, OctreesThatSplitAlwaysAndNever) {
    load("lamp");
    Shot shot;
    shot.view = {{-192, 0, 64}, {50, 0, 0}, 60};
    set("pt_nee", "uniform");
    const PictureBatches reference = batches(shot, 12, 32, 1000, 4);
    const Settings always{
        {"pt_oct_split", "1"}, {"pt_oct_collapse", "0"}, {"pt_oct_scale", "0.001"}};
    const Settings never{{"pt_oct_split", "2147483647"},
                         {"pt_oct_collapse", "2147483647"},
                         {"pt_oct_scale", "1000"}};
    set("pt_nee", "vlc");
    set("pt_guide", "cdq");
    expect_equal_means(shot, reference, always, {0.01});
    gpu::FrameCommands commands(renderer().device());
    const uint32_t most = adapt(commands).nodes;
    expect_equal_means(shot, reference, never, {0.01});
    const uint32_t least = adapt(commands).nodes;
    EXPECT_GT(most, 8 * least);
    EXPECT_LE(least, 9u);
    record("octree", "the smallest and the largest thresholds that variables can have",
           "mean that of a technique without one", fmt::format("{} and {} nodes", most, least));
}

TEST_F(Extremes, ClocksOfYears) {
    Shot shot{{{-192, -64, 56}, {0, 20, 0}, 90}, {}, {}, 0};
    const auto picture = [&] {
        load("opensky"); // random numbers start anew
        return radiance(shot).rgb;
    };
    const std::vector<float> early = picture();
    EXPECT_GT(sum_of(early), 0.0);
    for (const double time_s : {4095.999, 4096.0, 86400.0 * 365.0, 1e15}) {
        shot.time_s = time_s;
        EXPECT_EQ(picture(), early) << time_s;
    }
    record("counters that wrap", "clocks of 4,096 seconds to 30 million years",
           "the same picture, as nothing here moves");
}

TEST_F(Extremes, FrameCountersOfYears) {
    load("lamp");
    Shot shot;
    shot.view = {{-192, 0, 64}, {50, 0, 0}, 60};
    radiance(shot);
    vkpt::FrameDescription frame = params(shot);
    // Random sequences where counters of 30 and of 32 bits end.
    const auto from = [&](uint32_t first) {
        PictureBatches seen(cvars()->vid_width, cvars()->vid_height, 4);
        for (uint32_t i = 0; i < 12; ++i) {
            frame.frame = first + i;
            seen.add(trace(frame, 16));
        }
        return seen;
    };
    const PictureBatches early = from(0);
    judge("frame 2^30 - 6", from(0x3ffffffau), early, {0.01});
    judge("frame 2^32 - 12", from(0xfffffff4u), early, {0.01});
    EXPECT_NE(from(0x40000000u).means(), early.means()) << "the same random numbers again";
    // The mean of so many frames: one more changes nothing to speak of. From two frames on a mean
    // has what rounding left out.
    for (const uint32_t number : {0x40000000u, 0xffffffffu}) {
        frame.frame = number;
        frame.accumulated = 0;
        trace(frame, 4);
        frame.accumulated = 1;
        const std::vector<float> first = trace(frame, 4);
        frame.accumulated = number;
        const std::vector<float> mean = trace(frame, 4);
        EXPECT_TRUE(all_finite_nonnegative(mean));
        EXPECT_NEAR(sum_of(mean), sum_of(first), 1e-4 * sum_of(first));
    }
    record("counters that wrap", "frame 2^32 - 1 (2.3 years at 60 per second), averaged or not",
           "the mean is that of the first frames, and hardly moves");
}

TEST_F(Extremes, OnePixel) {
    load("lamp");
    Shot shot;
    shot.view = {{-192, 0, 64}, {50, 0, 0}, 60};
    set("pt_nee", "vlc");
    set("pt_guide", "cdq");
    radiance(shot);
    renderer().device().wait_idle();
    renderer().buffers().resize({1, 1}, {1, 1}, false);
    renderer().buffers().bind(*renderer().scene(), *renderer().technique(),
                              *renderer().technique());
    const std::vector<float> pixel = trace(params(shot), 64);
    ASSERT_EQ(pixel.size(), 3u);
    EXPECT_TRUE(all_finite_nonnegative(pixel));
    EXPECT_GT(pixel[0], 0.0f);
    EXPECT_EQ(radiance(shot).rgb.size(), size_t{3} * 48 * 32); // and back
    record("sizes", "one pixel", "lit, finite");
}

TEST_F(Extremes, PicturesThatDoNotFitLeaveTheProgramUsable) {
    load("lamp");
    Shot shot;
    shot.view = {{-192, 0, 64}, {20, 0, 0}, 90};
    radiance(shot);
    const std::vector<float> before = trace(params(shot), 4);
    EXPECT_GT(sum_of(before), 0.0);
    set_size(16384, 16384);
    std::string message;
    try {
        radiance(shot);
    } catch (const Error& error) {
        message = error.what();
    }
    EXPECT_NE(message.find("MiB"), std::string::npos)
        << "12 GiB of primary hits fit into one buffer? " << message;
    set_size(48, 32);
    EXPECT_EQ(radiance(shot).width, 48);
    EXPECT_EQ(trace(params(shot), 4), before);
    record("sizes", "16,384 x 16,384 pixels on a device that cannot",
           "one message with the size, and the picture of before goes on");
}

/// The court under sky and sun.
Shot court() {
    Shot shot;
    shot.view = {{-192, -64, 56}, {10, 20, 0}, 90};
    return shot;
}

TEST_F(Extremes, SkiesInManyPieces) {
    set_size(32, 24);
    set("pt_nee", "lh");
    load("opensky");
    const PictureBatches reference = batches(court(), 16, 64, 1000, 4);
    for (const char* lights : {"2", "4096"})
        for (const char* technique : {"sll", "lh"})
            expect_equal_means(court(), reference,
                               {{"pt_nee", technique}, {"pt_sky_lights", lights}}, court_bounds);
    expect_equal_means(court(), reference, {{"pt_nee", "vlc"}, {"pt_sky_lights", "2"}},
                       court_bounds); // its caches hold few lights
    record("scenes", "windows to the sky in 2 and in 4,096 lights", "the mean of 24");
    // The roof in two thousand faces, and one without area.
    set("pt_sky_lights", "24");
    set("pt_subdivide", "5");
    load("opensky", [](Level& level) {
        Bsp& bsp = level.bsp;
        const auto sky = std::ranges::find_if(bsp.faces, [&](const BspFace& face) {
            return (bsp.texinfos[face.texinfo].flags & SURF_SKY) != 0;
        });
        BspFace flat = *sky;
        const auto corner = static_cast<uint32_t>(bsp.vertices.size());
        bsp.vertices.insert(bsp.vertices.end(), {{0, 0, 192}, {20, 0, 192}, {40, 0, 192}});
        flat.first_edge = static_cast<uint32_t>(bsp.surf_edges.size());
        flat.edge_count = 3;
        for (uint32_t i = 0; i < 3; ++i) {
            bsp.surf_edges.push_back(static_cast<int32_t>(bsp.edges.size()));
            bsp.edges.push_back({corner + i, corner + (i + 1) % 3});
        }
        bsp.faces.push_back(flat);
        ++bsp.models[0].face_count;
    });
    for (const char* technique : {"sll", "lh"})
        expect_equal_means(court(), reference, {{"pt_nee", technique}}, court_bounds);
    const vkpt::Scene& scene = *renderer().scene();
    EXPECT_GE(std::ranges::count_if(
                  scene.host_primitives(),
                  [&](const shader::Primitive& primitive) {
                      return (scene.host_materials().materials()[primitive.material].flags &
                              shader::MATERIAL_SKY) != 0;
                  }),
              2048);
    record("scenes", "two thousand sky faces, and one without area", "the mean of two faces");
}

TEST_F(Extremes, LevelsWithoutVisibility) {
    set_size(32, 24);
    set("pt_nee", "lh");
    load("opensky");
    const PictureBatches reference = batches(court(), 16, 64, 1000, 4);
    load("opensky", [](Level& level) {
        level.bsp.visibility.clear();
        level.bsp.visibility_offsets.clear();
        level.pvs = Pvs(level.bsp);
        EXPECT_TRUE(level.pvs.sees_everything());
    });
    for (const char* technique : {"sll", "lh", "vlc"})
        expect_equal_means(court(), reference, {{"pt_nee", technique}}, court_bounds);
    record("scenes", "sky and sun in a level without visibility", "the mean of the one with it");
}

TEST_F(Extremes, OneBrightTexelOfSky) {
    for (const SkySide& side : sky_sides) {
        Image image{64, 64, std::vector<uint8_t>(size_t{4} * 64 * 64, 0)};
        for (size_t i = 3; i < image.rgba.size(); i += 4)
            image.rgba[i] = 255;
        if (side.suffix == "up") std::fill_n(image.rgba.begin() + 4 * (64 * 33 + 33), 4, 255);
        write_game_file(fmt::format("env/dot{}.tga", side.suffix),
                        write_tga(image, {.descriptor = 0x20}));
    }
    set("pt_sky_scale", "1e5");
    load("opensky", [](Level& level) {
        level.bsp.entities[0].set("sky", "dot");
        level.bsp.entities[0].set("_sun_light", "0");
    });
    for (const TechniqueInfo& info : technique_infos) {
        set("pt_nee", info.name);
        learn(court(), frames_to_learn);
        const std::vector<float> seen = trace(params(court()), 64);
        EXPECT_TRUE(all_finite_nonnegative(seen)) << info.name;
        EXPECT_GT(sum_of(seen), 0.0) << info.name;
    }
    record("scenes", "one texel of 100,000 in a black sky", "every technique: lit, finite");
}

} // namespace
} // namespace vigil::test
