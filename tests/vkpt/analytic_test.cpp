// SPDX-License-Identifier: GPL-2.0-or-later
// Scenes whose picture is known in closed form: a closed white furnace, a square lamp over a floor,
// an even sky and a sun over a court. Radiances follow from the units of docs/internals/units.md:
// VALUE * 0.1
// * mean texel for faces, _sun_light * 0.1 for the sun's irradiance.
#include "render_test.h"

#include "formats/small_models.h"
#include "refresh/vkpt/gpu/commands.h"
#include "refresh/vkpt/scene/texture_set.h"

#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <iostream>

namespace vigil::test {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int batch_count = 24, block = 4;

/// Share of the light of a parallel rectangle [x0, x1] x [y0, y1] at `height` above that reaches a
/// floor point at the origin, cosine-weighted: its form factor (Howell's catalogue, B-4, summed
/// over the four corners).
double form_factor(double x0, double x1, double y0, double y1, double height) {
    const auto corner = [height](double x, double y) {
        const double a = x / height, b = y / height, p = std::sqrt(1.0 + a * a),
                     q = std::sqrt(1.0 + b * b);
        return (a / p * std::atan(b / p) + b / q * std::atan(a / q)) / (2.0 * pi);
    };
    return corner(x1, y1) - corner(x0, y1) - corner(x1, y0) + corner(x0, y0);
}

class Analytic : public RenderTest {
protected:
    /// The linear colour of a flat texture, as the renderer stores it.
    static glm::dvec3 texel(std::string_view name) {
        vkpt::TextureSet textures(files());
        return textures.texture(name).mean;
    }

    /// Primary hits of the last frame; all of them must lie on the floor, z = 0.
    static std::vector<glm::dvec2> floor_points() {
        std::vector<glm::dvec2> points;
        for (const shader::PrimaryHit& hit : primary_hits()) {
            EXPECT_NE(hit.primitive, shader::NONE);
            EXPECT_NEAR(hit.position.z, 0.0f, 1e-2f);
            points.push_back({hit.position.x, hit.position.y});
        }
        return points;
    }

    /// Averages a value of floor points over blocks, three channels each.
    template <typename Value>
    static std::vector<double> expect_on_floor(const std::vector<glm::dvec2>& points, int block,
                                               Value value) {
        PictureBatches exact(cvars()->vid_width, cvars()->vid_height, block);
        std::vector<float> rgb;
        for (const glm::dvec2& point : points) {
            const glm::dvec3 color = value(point);
            for (glm::length_t c = 0; c < 3; ++c)
                rgb.push_back(static_cast<float>(color[c]));
        }
        exact.add(rgb);
        std::vector<double> expected;
        for (size_t i = 0; i < 3 * exact.blocks(); ++i)
            expected.push_back(exact.value(0, i % 3, i / 3));
        return expected;
    }

    /// The middle of a furnace's wall with two rays after the camera's, by `paths` paths a batch.
    void judge_two_rays(std::string_view label, int paths) {
        load("furnace");
        set("pt_bounces", "1");
        Shot shot;
        shot.view = {{0, 0, 128}, {0, 0, 0}, 50};
        const PictureBatches seen = batches(shot, batch_count, paths, 100, block);
        const glm::dvec3 rho = texel("test/white");
        std::vector<double> expected;
        for (size_t i = 0; i < 3 * seen.blocks(); ++i) {
            const double r = rho[static_cast<glm::length_t>(i % 3)];
            expected.push_back(10.0 * r * (1.0 + r + r * r));
        }
        judge(label, seen, expected, {0.003});
    }
};

TEST_F(Analytic, WhiteFurnaceByBruteForceIsExact) {
    // Every path meets the same radiance everywhere, so one path is enough; a ray that slips out
    // between two triangles, or any energy lost or gained in a bounce, shows in its pixel.
    load("furnace");
    const glm::dvec3 rho = texel("test/white"), emitted = 10.0 * rho;
    set("pt_nee", "brute");
    for (const int bounces : {0, 1, 2, 8}) {
        set("pt_bounces", std::to_string(bounces));
        set("pt_spp", "16");
        for (const glm::vec3 angles :
             {glm::vec3(0, 0, 0), glm::vec3(-70, 40, 0), glm::vec3(40, 200, 15)}) {
            Shot shot;
            shot.view = {{-60, 30, 100}, angles, 100};
            const std::vector<float> seen = radiance(shot).rgb;
            for (size_t i = 0; i < seen.size(); ++i) {
                const double r = rho[static_cast<glm::length_t>(i % 3)],
                             e = emitted[static_cast<glm::length_t>(i % 3)];
                double expected = e;
                for (int ray = 0; ray <= bounces; ++ray)
                    expected = e + r * expected;
                ASSERT_NEAR(static_cast<double>(seen[i]) / expected, 1.0, 1e-5)
                    << "value " << i << " bounces " << bounces;
            }
        }
    }
}

TEST_F(Analytic, WhiteFurnaceByTechniques) {
    // Light sampling in a furnace has no variance in the indirect hit: points close to an edge see
    // the wall beside them with 1 / distance^2 and scores would mean nothing. So one bounce, in the
    // middle of a wall.
    load("furnace");
    const glm::dvec3 rho = texel("test/white");
    set("pt_bounces", "0");
    Shot shot;
    shot.view = {{0, 0, 128}, {0, 0, 0}, 50};
    for (const TechniqueInfo& info : technique_infos) {
        if (info.name == "brute") continue;
        set("pt_nee", info.name);
        // What learns has almost no noise here but for the few samples that find a light anew,
        // which takes many to become a normal distribution.
        renderer().render(shot.frame());
        const int paths = renderer().technique()->uses_guiding() ? 160 : 16;
        const PictureBatches seen = batches(shot, batch_count, paths, 100, block);
        std::vector<double> expected;
        for (size_t i = 0; i < 3 * seen.blocks(); ++i) {
            const double r = rho[static_cast<glm::length_t>(i % 3)];
            expected.push_back(10.0 * r * (1.0 + r));
        }
        judge(info.name, seen, expected, {0.01});
    }
}

TEST_F(Analytic, WhiteFurnaceByGuidedRays) {
    // Rays alone find all light; the mixture that draws them has to weigh them rightly.
    set("pt_nee", "brute");
    for (const GuiderInfo& info : guider_infos) {
        if (info.name == "brdf") continue;
        set("pt_guide", info.name);
        judge_two_rays(info.name, 32);
    }
}

TEST_F(Analytic, WhiteFurnaceWhereRaysEnd) {
    // Drawn evenly in solid angle, points of a near wall have no singular weights.
    set("pt_nee", "lh");
    set("pt_light_density", "solid_angle");
    judge_two_rays("lh", 64);
}

TEST_F(Analytic, TailsInAFurnaceAreAllBounces) {
    // Every surface reflects the same, so a node's mean is that of each place in it. A white room
    // must not grow brighter for ever.
    set("pt_nee", "lh");
    set("pt_light_density", "solid_angle");
    set("pt_guide", "cdq");
    set("pt_guide_directions", "1"); // many rays go below the horizon, and bring nothing
    set("pt_tail", "1");
    set("pt_learn_every", "1");
    set("pt_rest_after", "0");
    struct Room {
        const char* texture;
        int bounces, frames_to_settle;
        double least; // of what is expected
    };
    // A white room's light is that of fifty bounces, of which each takes some frames.
    for (const Room& room : {Room{"test/white50", 1, 60, 0.995}, Room{"test/white50", 2, 60, 0.995},
                             Room{"test/white", 1, 400, 0.3}}) {
        SCOPED_TRACE(fmt::format("{}, {} bounces", room.texture, room.bounces));
        load("furnace", [&](Level& level) {
            for (BspTexInfo& info : level.bsp.texinfos)
                info.texture = room.texture;
        });
        set("pt_bounces", std::to_string(room.bounces));
        Shot shot;
        shot.view = {{0, 0, 128}, {0, 0, 0}, 50};
        for (int frame = 0; frame < room.frames_to_settle; ++frame)
            renderer().render(shot.frame());
        constexpr int frames = 64;
        double sum = 0.0;
        for (int frame = 0; frame < frames; ++frame) {
            const std::vector<float> seen = radiance(shot).rgb;
            EXPECT_TRUE(all_finite_nonnegative(seen));
            sum += sum_of(seen) / static_cast<double>(seen.size());
        }
        // Of what arrives in a white room 0.98 goes on (TAIL_LARGEST_ALBEDO).
        const double r = texel(room.texture).x, e = 10.0 * r;
        double expected = e / (1.0 - std::min(r, 0.98));
        for (int ray = 0; ray <= room.bounces; ++ray)
            expected = e + r * expected;
        EXPECT_GT(sum / frames / expected, room.least);
        EXPECT_LT(sum / frames / expected, 1.005);
    }
}

TEST_F(Analytic, SquareLampOverAFloor) {
    load("lamp");
    const glm::dvec3 radiance_of_lamp = 10.0 * texel("test/lamp"), rho = texel("test/white50");
    set("pt_bounces", "0"); // the walls are black anyway
    Shot shot;
    shot.view = {{-192, 0, 64}, {50, 0, 0}, 60};
    for (const TechniqueInfo& info : technique_infos) {
        const bool brute = info.name == "brute";
        set("pt_nee", info.name);
        const PictureBatches seen = batches(shot, batch_count, brute ? 256 : 32, 300, block);
        const std::vector<double> expected =
            expect_on_floor(floor_points(), block, [&](glm::dvec2 p) {
                return rho * radiance_of_lamp *
                       form_factor(-32 - p.x, 32 - p.x, -32 - p.y, 32 - p.y, 128);
            });
        judge(info.name, seen, expected,
              brute ? Bounds{.everywhere = 0.02, .five_blocks = 0.2} : Bounds{.everywhere = 0.003});
    }
}

TEST_F(Analytic, ASheetUnderALamp) {
    // A sheet between lamp and floor, which looks down: what its opacity does not stop arrives.
    write_game_file("models/sheet.glb",
                    triangle_glb(R"("scale":[3000,3000,3000],"translation":[-900,-900,0],)"));
    load("lamp");
    const refresh::ModelHandle sheet = renderer().register_model("models/sheet.glb");
    const glm::dvec3 radiance_of_lamp = 10.0 * texel("test/lamp"), rho = texel("test/white50");
    set("pt_bounces", "0");
    Shot shot;
    shot.view = {{-192, 0, 64}, {50, 0, 0}, 60};
    struct Row {
        float alpha;
        uint32_t flags;
        double passes;
    };
    const Row rows[] = {{0.4f, 0, 1.0 - 102.0 / 255.0},
                        {0.6f, refresh::entity_hidden_from_camera, 1.0 - 153.0 / 255.0},
                        {1.0f, refresh::entity_hidden_from_light, 1.0},
                        {1.0f, refresh::entity_weapon, 1.0}};
    // Of the paths sent to the lamp a share p arrives, so that the relative standard error of n is
    // sqrt((1 - p) / (p n)). With p = 0.4 and 16 paths it is 0.16% of all, 0.32% of a quadrant,
    // 0.7% of five blocks. Rays alone meet the lamp with a chance of about 0.02 p: with 256 paths,
    // 0.37%, 0.74% and, where the floor is darkest, 2.4%. Six errors of all are surely found, and
    // fourteen of a part, of which 24 batches tell the error.
    constexpr Bounds by_lights{.everywhere = 0.01, .quadrant = 0.05, .five_blocks = 0.1};
    constexpr Bounds by_rays{.everywhere = 0.025, .quadrant = 0.1, .five_blocks = 0.35};
    for (const Row& row : rows) {
        refresh::Entity entity;
        entity.model = sheet;
        entity.origin = {0, 0, 100};
        entity.angles = {0, 0, 90};
        entity.alpha = row.alpha;
        entity.flags = row.flags;
        shot.entities = {entity};
        for (const std::string_view technique : {"sll", "vlc", "brute"}) {
            const bool brute = technique == "brute";
            set("pt_nee", technique);
            const PictureBatches seen = batches(shot, batch_count, brute ? 256 : 16, 900, block);
            const std::vector<double> expected =
                expect_on_floor(floor_points(), block, [&](glm::dvec2 p) {
                    return row.passes * rho * radiance_of_lamp *
                           form_factor(-32 - p.x, 32 - p.x, -32 - p.y, 32 - p.y, 128);
                });
            judge(fmt::format("{} {} {}", technique, row.alpha, row.flags), seen, expected,
                  brute ? by_rays : by_lights);
        }
    }
}

/// The court without what stands in it; where that stood the floor has holes.
void clear_court(Level& level) {
    for (const std::string_view texture : {"test/grey20", "test/red"})
        for (BspTexInfo* info : texinfos_of(level, texture))
            info->flags |= SURF_NODRAW;
}

/// Whether noise is so little that there is nothing for statistics to judge.
bool has_no_noise(const PictureBatches& seen) {
    for (size_t batch = 1; batch < seen.batches(); ++batch)
        for (size_t i = 0; i < 3 * seen.blocks(); ++i)
            if (std::abs(seen.value(batch, i % 3, i / 3) / seen.value(0, i % 3, i / 3) - 1.0) >
                3e-4)
                return false;
    return true;
}

/// Its walls reflect nothing: what rays bring to the floor comes from the sky alone.
void blacken_walls(Level& level) {
    for (BspTexInfo* info : texinfos_of(level, "test/sand"))
        info->texture = "test/black";
}

TEST_F(Analytic, EvenSkyOverACourt) {
    load("opensky", [](Level& level) {
        clear_court(level);
        level.bsp.entities[0].set("sky", "");
        level.bsp.entities[0].set("_sky_color", "0.5 0.75 1");
        level.bsp.entities[0].set("_sun_light", "0");
    });
    const glm::dvec3 rho = texel("test/white50"), sky(0.5, 0.75, 1.0);
    set("pt_bounces", "0");
    Shot shot;
    shot.view = {{-80, -60, 100}, {60, 160, 0}, 60};
    const auto expect_sky = [&](std::string_view label, int paths) {
        const PictureBatches seen = batches(shot, batch_count, paths, 500, block);
        EXPECT_FALSE(renderer().scene()->has_sun());
        const std::vector<double> expected =
            expect_on_floor(floor_points(), block, [&](glm::dvec2 p) {
                return rho * sky * form_factor(-256 - p.x, 256 - p.x, -256 - p.y, 256 - p.y, 192);
            });
        judge(label, seen, expected, {0.01});
    };
    for (const TechniqueInfo& info : technique_infos) {
        set("pt_nee", info.name);
        expect_sky(fmt::format("sky {}", info.name), 32);
    }
    // In two lights, in many, and found by rays alone.
    set("pt_nee", "sll");
    for (const char* lights : {"2", "500"}) {
        set("pt_sky_lights", lights);
        expect_sky(fmt::format("sky in {} lights", lights), 32);
    }
    set("pt_env_nee", "0");
    expect_sky("sky by rays", 32);
}

TEST_F(Analytic, SunOverACourt) {
    load("opensky", [](Level& level) {
        clear_court(level);
        level.bsp.entities[0].set("sky", "");
        level.bsp.entities[0].set("_sky_color", "0 0 0");
    });
    // _sun_light 200, _sun_color 1 0.9 0.75, 55 degrees above the horizon: every point of the floor
    // that the camera sees sees the whole disc through the open roof.
    const glm::dvec3 rho = texel("test/white50");
    const glm::dvec3 expected_color =
        rho * 20.0 * glm::dvec3(1.0, 0.9, 0.75) * std::sin(55.0 * pi / 180.0) / pi;
    set("pt_bounces", "0");
    Shot shot;
    shot.view = {{80, 80, 80}, {60, 40, 0}, 70};
    for (const char* size : {"20", "8", "0.5", "0"}) { // the disc's size changes nothing
        set("pt_sun_size", size);
        const bool small = std::string_view(size).starts_with('0');
        for (const TechniqueInfo& info : technique_infos) {
            const bool brute = info.name == "brute";
            if (brute && small) continue; // no ray meets it by chance
            set("pt_nee", info.name);
            const PictureBatches seen = batches(shot, batch_count, brute ? 192 : 32, 700, 8);
            const std::vector<double> expected =
                expect_on_floor(floor_points(), 8, [&](glm::dvec2) { return expected_color; });
            const std::string label = fmt::format("sun {:3} {:7}", size, info.name);
            if (has_no_noise(seen)) {
                for (size_t i = 0; i < expected.size(); ++i)
                    EXPECT_NEAR(seen.mean(i % 3, i / 3) / expected[i], 1.0, 3e-4) << label;
                std::cout << label << ": without noise\n";
                continue;
            }
            if (brute)
                judge(label, seen, expected,
                      {.everywhere = 0.03, .quadrant = 0.15, .five_blocks = 0.3});
            else
                judge(label, seen, expected, {.everywhere = 0.02});
        }
    }
}

// With a ray that is sent anyway, sky and sun are found by both, and each counts in part. A sun
// that rays meet often, and a sky: parts that do not add up to 1 would show.
TEST_F(Analytic, SkyAndSunByLightSamplesAndRays) {
    load("opensky", [](Level& level) {
        clear_court(level);
        blacken_walls(level);
        level.bsp.entities[0].set("sky", "");
        level.bsp.entities[0].set("_sky_color", "0.5 0.75 1");
    });
    ASSERT_EQ(texel("test/black"), glm::dvec3(0.0));
    const glm::dvec3 rho = texel("test/white50"), sky(0.5, 0.75, 1.0);
    const glm::dvec3 sun =
        20.0 * glm::dvec3(1.0, 0.9, 0.75) * std::sin(55.0 * pi / 180.0) / pi; // 55 degrees high
    set("pt_bounces", "1"); // the ray of the primary hit is sent, and no other
    set("pt_sun_size", "20");
    Shot shot;
    shot.view = {{80, 80, 80}, {60, 40, 0}, 70};
    struct Part {
        const char* name;
        const char* sky_scale;
        const char* sun_scale;
    };
    for (const Part& part : {Part{"sky", "1", "0"}, {"sun", "0", "1"}, {"both", "3", "1"}}) {
        set("pt_sky_scale", part.sky_scale);
        set("pt_sun_scale", part.sun_scale);
        const double skies = std::atof(part.sky_scale), suns = std::atof(part.sun_scale);
        for (const char* technique : {"sll", "lh", "vlc", "uniform"})
            for (const char* guide : {"brdf", "cdq"}) {
                const bool guided = std::string_view(guide) == "cdq";
                if (guided && std::string_view(technique) != "lh") continue;
                set("pt_nee", technique);
                set("pt_guide", guide);
                const PictureBatches seen = batches(shot, batch_count, 48, 700, 8);
                const std::vector<double> expected =
                    expect_on_floor(floor_points(), 8, [&](glm::dvec2 p) {
                        const double form =
                            form_factor(-256 - p.x, 256 - p.x, -256 - p.y, 256 - p.y, 192);
                        return rho * (skies * form * sky + suns * sun);
                    });
                judge(fmt::format("{:4} {:7} {}", part.name, technique, guide), seen, expected,
                      {.everywhere = 0.02, .quadrant = 0.08, .five_blocks = 0.15});
            }
    }
}

} // namespace
} // namespace vigil::test
