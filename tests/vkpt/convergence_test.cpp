// SPDX-License-Identifier: GPL-2.0-or-later
// Every light-sampling technique converges to the mean of brute force, which samples no lights: the
// same scenes from independent seeds, compared block by block and colour by colour
// (picture_comparison.h). A bias of 0.3% to 1.4% of the picture is found, as each line of the
// output says. The technique table is the list of what is tested.
#include "refresh/vkpt/gpu/commands.h"
#include "render_test.h"
#include "technique_settings.h"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <iostream>
#include <optional>

namespace vigil::test {
namespace {

struct Plan {
    int brute_paths = 24; // paths per pixel and batch
    int paths = 8;        // the same of the others
    /// Against brute force, whose noise is the larger part.
    Bounds bounds{.everywhere = 0.015, .quadrant = 0.08, .five_blocks = 0.35, .blocks = 41};
    /// Against the first technique: a bias of one technique alone. Of five blocks the larger one of
    /// this bound and the technique's own holds.
    Bounds between{.everywhere = 0.01, .blocks = 41};
};
/// Where most of the light and of the noise is the sky's, which all techniques find by chance.
const Plan under_the_sky{24,
                         24,
                         {.everywhere = 0.03, .quadrant = 0.12, .five_blocks = 0.35, .blocks = 41},
                         {.everywhere = 0.02, .quadrant = 0.08, .five_blocks = 0.25, .blocks = 41}};
// A frame of many pixels and few paths takes less time than one of few and many: each dispatch has
// a cost of its own.
constexpr int width = 96, height = 64;
constexpr int brute_batches = 32, sampled_batches = 16, block = 8;

/// VIGIL_TEST_PATHS=10 traces ten times as many paths, to look for smaller biases by hand.
int path_factor() {
    const char* text = std::getenv("VIGIL_TEST_PATHS");
    return text ? std::max(std::atoi(text), 1) : 1;
}

class Convergence : public RenderTest {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        set_size(width, height);
    }

    /// All techniques, with rays drawn as pt_guide `guide` says, against brute force on one
    /// picture, whose rays are drawn by the BRDF alone.
    void expect_equal_means(const Shot& shot, const Plan& plan, const char* guide = "brdf",
                            bool defaults_alone = false) {
        set("pt_nee", "brute");
        set("pt_guide", "brdf");
        const PictureBatches brute =
            batches(shot, brute_batches, plan.brute_paths * path_factor(), 1000, block);
        set("pt_guide", guide);
        std::optional<PictureBatches> first;
        for (const TechniqueSettings& settings : technique_settings()) {
            if (settings.technique == "brute" || !settings.pictures) continue;
            if (defaults_alone && settings.label != "Default") continue;
            settings.set();
            const PictureBatches sampled =
                batches(shot, sampled_batches, plan.paths * path_factor(), 5000, block);
            judge(label_of(settings), sampled, brute, plan.bounds);
            Bounds between = plan.between;
            between.five_blocks = std::max(between.five_blocks, settings.five_blocks);
            if (first) judge(label_of(settings) + " and first", sampled, *first, between);
            if (!first) first = sampled;
        }
    }

    static std::string label_of(const TechniqueSettings& settings) {
        return fmt::format("{:8} {:10}", settings.technique, settings.label);
    }
};

Shot view_at(glm::vec3 origin, float pitch, float yaw, float fov = 90.0f) {
    Shot shot;
    shot.view = {origin, {pitch, yaw, 0.0f}, fov};
    return shot;
}

TEST_F(Convergence, RoomWithManyLamps) {
    load("rooms");
    expect_equal_means(view_at({290, 20, 96}, 5, 55), {});
}

TEST_F(Convergence, ThroughATranslucentWindow) {
    load("rooms");
    expect_equal_means(view_at({420, 40, 90}, 0, 50), {});
}

TEST_F(Convergence, DoorWithALampMoved) {
    load("rooms");
    Shot shot = view_at({40, 40, 60}, 0, 25);
    refresh::Entity door;
    door.number = 1;
    door.model = renderer().register_model("*1");
    // Pushed out of the wall into the room, then turned as well.
    door.origin = {-40, -20, 20};
    shot.entities = {door};
    expect_equal_means(shot, {});
    shot.entities[0].angles = {0, 30, 0};
    shot.entities[0].origin = {40, -150, 20};
    expect_equal_means(shot, {});
}

TEST_F(Convergence, GuidedRays) {
    load("rooms");
    set("pt_bounces", "2"); // guided at each hit
    expect_equal_means(view_at({290, 20, 96}, 5, 55), {.paths = 12}, "cdq");
}

TEST_F(Convergence, GuidedRaysToTheSky) {
    load("opensky");
    set("pt_cdq_bits", "32");
    set("pt_cdq_migrations", "4");
    set("pt_sun_size", "40");
    Shot shot = view_at({-192, -64, 56}, 0, 20);
    shot.dynamic_lights = {{1, {-60, 40, 60}, 16.0f, {10, 10, 30}}};
    for (const char* as_lights : {"0", "1"}) {
        SCOPED_TRACE(as_lights);
        set("pt_env_nee", as_lights);
        expect_equal_means(shot, under_the_sky, "cdq");
    }
}

TEST_F(Convergence, DynamicLights) {
    load("rooms");
    Shot shot = view_at({40, 40, 60}, 0, 45);
    shot.dynamic_lights = {{7, {120, 120, 40}, 16.0f, {20, 10, 5}},
                           {8, {200, 60, 100}, 12.0f, {5, 20, 40}},
                           {9, {60, 200, 120}, 20.0f, {8, 8, 2}}};
    expect_equal_means(shot, {});
}

/// Frame `number` of a scene in which lights move, appear, vanish and change colour from each frame
/// to the next, and a lamp swings on a door.
Shot restless_shot(int number) {
    Shot shot = view_at({40, 40, 60}, 0, 45);
    const float t = static_cast<float>(number);
    shot.dynamic_lights = {{7, {100 + 12 * t, 120, 40}, 16.0f, {20, 10, 5}}};
    if (number % 2 == 0) shot.dynamic_lights.push_back({8, {200, 60, 100}, 12.0f, {5, 20, 40}});
    if (number % 3 != 1)
        shot.dynamic_lights.push_back({9, {60, 200 - 9 * t, 120}, 20.0f, {8, 8 - t, 2 + t}});
    refresh::Entity door;
    door.number = 1;
    door.origin = {-40, -20, 20 + 3 * t};
    shot.entities = {door};
    return shot;
}

TEST_F(Convergence, LightsThatChangeEveryFrame) {
    load("rooms");
    constexpr int frames = 6, sequences = 2;
    const refresh::ModelHandle model = renderer().register_model("*1");
    const auto shot_of = [&](int number) {
        Shot shot = restless_shot(number);
        shot.entities[0].model = model;
        return shot;
    };
    set("pt_nee", "brute");
    const PictureBatches brute =
        batches(shot_of(frames - 1), brute_batches, 2 * Plan().brute_paths, 1000, block);
    // What is judged is the last frame of a sequence that begins with nothing learned: what is
    // known then is of frames in which the lights were others.
    int learning = 0;
    for (const TechniqueSettings& settings : technique_settings()) {
        settings.set();
        if (!settings.pictures) continue;
        renderer().render(shot_of(0).frame());
        if (!renderer().technique()->learns()) continue;
        ++learning;
        PictureBatches sampled(cvars()->vid_width, cvars()->vid_height, block);
        int seed = 0;
        for (int batch = 0; batch < sampled_batches; ++batch) {
            std::vector<float> sum;
            for (int sequence = 0; sequence < sequences * path_factor(); ++sequence) {
                set("pt_seed", std::to_string(++seed));
                renderer().reset_guiding();
                for (int number = 0; number + 1 < frames; ++number)
                    renderer().render(shot_of(number).frame());
                const refresh::RadiancePicture last = radiance(shot_of(frames - 1));
                sum.resize(last.rgb.size(), 0.0f);
                for (std::size_t i = 0; i < sum.size(); ++i)
                    sum[i] += last.rgb[i];
            }
            for (float& value : sum)
                value /= static_cast<float>(sequences * path_factor());
            sampled.add(sum);
        }
        judge(label_of(settings), sampled, brute,
              {.everywhere = 0.025, .quadrant = 0.15, .five_blocks = 0.5, .blocks = 41});
    }
    EXPECT_GE(learning, 3);
}

/// A scene under a sun that turns by some degrees from each frame to the next.
class TurningSun : public Convergence {
protected:
    static constexpr int frames = 12;
    static constexpr int first_judged = 2; // the frames before it see an octree of eight leaves
    static constexpr int judged = frames - first_judged;
    static constexpr float degrees_per_frame = 6.0f;

    static void turn_sun(vkpt::FrameDescription& params, int number) {
        const float angle = glm::radians(degrees_per_frame * static_cast<float>(number));
        const glm::vec3 sun = params.sun_direction;
        params.sun_direction = {std::cos(angle) * sun.x - std::sin(angle) * sun.y,
                                std::sin(angle) * sun.x + std::cos(angle) * sun.y, sun.z};
    }

    /// The mean picture of the frames that are judged, each with `paths` paths per pixel under its
    /// sun. What was learned is adapted before every frame if `learns`; begins with nothing
    /// learned.
    std::vector<float> mean_picture(const Shot& shot, int seed, uint32_t paths, bool learns) {
        std::vector<float> mean;
        renderer().reset_guiding();
        gpu::FrameCommands commands(renderer().device());
        for (int number = 0; number < frames; ++number) {
            if (learns) {
                const shader::GuidingWork counted = adapt(commands);
                if (number > 0) migrations_.push_back(counted.cdq_migrations);
            } else if (number < first_judged) {
                continue;
            }
            vkpt::FrameDescription frame = params(shot);
            turn_sun(frame, number);
            frame.frame = static_cast<uint32_t>(number);
            frame.settings.pt_seed = seed;
            const std::vector<float> picture = trace(frame, paths);
            if (number < first_judged) continue;
            mean.resize(picture.size(), 0.0f);
            for (std::size_t i = 0; i < mean.size(); ++i)
                mean[i] += picture[i] / static_cast<float>(judged);
        }
        return mean;
    }

    std::vector<uint32_t> migrations_; // of all quadtrees, before every frame but the first ones
};

TEST_F(TurningSun, GuidedRaysOfAllTechniques) {
    set("pt_env_nee", "0"); // its rays find the sun, which turns in shader parameters alone
    load("opensky");
    set("pt_cdq_migrations", "4");
    set("pt_sun_size", "40");
    Shot shot = view_at({-192, -64, 56}, 0, 20);
    shot.dynamic_lights = {{1, {-60, 40, 60}, 16.0f, {10, 10, 30}}};
    set("pt_nee", "brute");
    radiance(shot);
    PictureBatches brute(cvars()->vid_width, cvars()->vid_height, block);
    for (int batch = 0; batch < brute_batches; ++batch)
        brute.add(
            mean_picture(shot, 1000 + batch, 4u * static_cast<uint32_t>(path_factor()), false));

    // Every frame has one path per pixel, whose rays the next frame's quadtrees are made of.
    const int sequences = path_factor();
    set("pt_guide", "cdq");
    for (const TechniqueInfo& info : technique_infos) {
        SCOPED_TRACE(info.name);
        set("pt_nee", info.name);
        radiance(shot); // makes what the technique needs
        migrations_.clear();
        PictureBatches sampled(cvars()->vid_width, cvars()->vid_height, block);
        int seed = 5000;
        for (int batch = 0; batch < sampled_batches; ++batch) {
            std::vector<float> sum;
            for (int sequence = 0; sequence < sequences; ++sequence) {
                const std::vector<float> picture = mean_picture(shot, ++seed, 1, true);
                sum.resize(picture.size(), 0.0f);
                for (std::size_t i = 0; i < sum.size(); ++i)
                    sum[i] += picture[i] / static_cast<float>(sequences);
            }
            sampled.add(sum);
        }
        judge(fmt::format("{:8}", info.name), sampled, brute,
              {.everywhere = 0.035, .quadrant = 0.15, .five_blocks = 0.5, .blocks = 41});
        // Quadtrees were changing all the time.
        EXPECT_GT(*std::ranges::min_element(migrations_), 0u);
    }
}

TEST_F(Convergence, GlossyWalls) {
    // Walls, floor and ceiling of the middle room shine; the importance of lights has a second lobe
    // there.
    load_with_materials("rooms", R"({"test/white50": {"roughness": 0.35, "specular": 0.3},
                        "test/grey20": {"roughness": 0.6, "specular": 0.08}})");
    const Shot shot = view_at({290, 20, 96}, 5, 55);
    expect_equal_means(shot, {});
    EXPECT_TRUE(renderer().scene()->features().gloss);
}

TEST_F(Convergence, LampOverAFloor) {
    load("lamp");
    expect_equal_means(
        view_at({-192, 0, 64}, 30, 0),
        {48, 8, {.everywhere = 0.02, .quadrant = 0.1, .five_blocks = 0.4, .blocks = 41}});
}

TEST_F(Convergence, SkyAndSunWithALight) {
    load("opensky");
    set("pt_sun_size", "40"); // large enough to be met by chance
    Shot shot = view_at({-192, -64, 56}, 0, 20);
    shot.dynamic_lights = {{1, {-60, 40, 60}, 16.0f, {10, 10, 30}}};
    expect_equal_means(shot, under_the_sky);
}

/// Makes the court's red block of a material through which a third of the light goes.
void make_translucent(Level& level) {
    for (BspTexInfo* info : texinfos_of(level, "test/red"))
        info->flags |= SURF_TRANS33;
}

/// Hangs a pane of glass under the roof of the court: all that comes from the sky goes through it,
/// or is stopped. Its side is towards the floor.
void hang_pane(Level& level) {
    Bsp& bsp = level.bsp;
    BspTexInfo info;
    info.s = {1, 0, 0, 0};
    info.t = {0, 1, 0, 0};
    info.flags = SURF_TRANS66;
    info.texture = "test/glass";
    BspFace face;
    face.plane = static_cast<uint32_t>(bsp.planes.size());
    bsp.planes.push_back({{0, 0, -1}, -160, 5});
    face.first_edge = static_cast<uint32_t>(bsp.surf_edges.size());
    face.edge_count = 4;
    face.texinfo = static_cast<uint32_t>(bsp.texinfos.size());
    face.styles = {255, 255, 255, 255};
    bsp.texinfos.push_back(info);
    // The file walks a face clockwise.
    const auto corner = static_cast<uint32_t>(bsp.vertices.size());
    bsp.vertices.insert(bsp.vertices.end(),
                        {{-256, -256, 160}, {256, -256, 160}, {256, 40, 160}, {-256, 40, 160}});
    for (uint32_t i = 0; i < 4; ++i) {
        bsp.surf_edges.push_back(static_cast<int32_t>(bsp.edges.size()));
        bsp.edges.push_back({corner + i, corner + (i + 1) % 4});
    }
    bsp.faces.push_back(face);
    ++bsp.models[0].face_count;
}

/// Sky and sun behind glass, found by light samples and by rays drawn as pt_guide says; the
/// reference finds them by rays alone.
class SkyThroughGlass : public Convergence {
protected:
    void expect_same(const char* guide) {
        load("opensky", [](Level& level) {
            make_translucent(level);
            hang_pane(level);
        });
        set("pt_sun_size", "40");
        const Shot shot = view_at({-192, -64, 56}, 0, 20);
        const Plan plan{24,
                        12,
                        {.everywhere = 0.03, .quadrant = 0.2, .five_blocks = 0.6, .blocks = 41},
                        {.everywhere = 0.03, .quadrant = 0.2, .five_blocks = 0.6, .blocks = 41}};
        expect_equal_means(shot, plan, guide, true);
        EXPECT_TRUE(renderer().scene()->features().translucent);
    }
};

TEST_F(SkyThroughGlass, WithRaysOfTheBrdf) {
    expect_same("brdf");
}

TEST_F(SkyThroughGlass, WithGuidedRays) {
    expect_same("cdq");
}

TEST_F(SkyThroughGlass, WithRaysOfALobe) {
    expect_same("lobe");
}

} // namespace
} // namespace vigil::test
