// SPDX-License-Identifier: GPL-2.0-or-later
// What a front end says of entities besides their place: which rays see them, glow, skins, shells,
// sprites; and its sky. Each with both ways of tracing, where the device has two. The level is the
// room of tests/data/lamp, 512 x 512 x 256 units, mostly with its lamp put out.
#include "common/error.h"
#include "formats/picture_bytes.h"
#include "formats/small_models.h"
#include "refresh/vkpt/gpu/commands.h"
#include "refresh/vkpt/scene/transform.h"
#include "render_test.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace vigil::test {
namespace {

constexpr int width = 48, height = 32;
constexpr std::string_view white =
    R"({"pbrMetallicRoughness":{"baseColorFactor":[1,1,1,1],"metallicFactor":0}})";

class EntityTest : public RenderTest, public testing::WithParamInterface<std::string_view> {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        set("pt_trace", GetParam());
        if (GetParam() == "query" && !renderer().device().features().ray_query)
            GTEST_SKIP() << "the device has no ray queries";
        write_game_file(
            "models/plate.glb",
            triangle_glb(R"("scale":[900,900,900],"translation":[-270,-270,0],)", white));
        write_game_file("models/box.md2", small_md2());
        const Image red{1, 1, {255, 0, 0, 255}};
        write_game_file("models/box/skin.pcx", write_pcx(1, 1)); // green
        write_game_file("skins/red.tga", write_tga(red, {2, 32, 0x28}));
    }

    void load_dark() {
        load("lamp", [](Level& level) {
            for (BspTexInfo& info : level.bsp.texinfos)
                info.value = 0;
        });
    }
    static refresh::Entity placed(refresh::ModelHandle model, glm::vec3 origin, glm::vec3 angles) {
        refresh::Entity entity;
        entity.number = 1;
        entity.model = model;
        entity.origin = origin;
        entity.angles = angles;
        return entity;
    }
    /// A plate across the view of a camera at (-192, 0, 64) that looks along +x.
    static refresh::Entity plate(float x) {
        return placed(renderer().register_model("models/plate.glb"), {x, 0, 64}, {0, -90, 0});
    }
    static Shot along_x(std::vector<refresh::Entity> entities) {
        return {{{-192, 0, 64}, {0, 0, 0}, 20}, std::move(entities), {}, 0};
    }
    /// A pixel's radiance where all pixels have the same.
    static glm::vec3 even_radiance(const Shot& shot) {
        const std::vector<float> rgb = radiance(shot).rgb;
        const glm::vec3 first(rgb[0], rgb[1], rgb[2]);
        for (size_t i = 0; i < rgb.size(); ++i)
            EXPECT_EQ(rgb[i], first[static_cast<glm::length_t>(i % 3)]) << "value " << i;
        return first;
    }
};

TEST_P(EntityTest, GlowShowsToTheCameraAlone) {
    load_dark();
    refresh::Entity glowing = plate(100);
    glowing.glow = {3, 2, 1};
    EXPECT_EQ(even_radiance(along_x({glowing})), glm::vec3(3, 2, 1));
    // From behind it is black, and nothing beside it is lit.
    glowing.angles.y = 90;
    EXPECT_EQ(even_radiance(along_x({glowing})), glm::vec3(0));
    Shot away = along_x({plate(100)});
    away.entities[0].glow = {3, 2, 1};
    away.view.angles.y = 180;
    EXPECT_EQ(even_radiance(away), glm::vec3(0));
    EXPECT_TRUE(renderer().scene()->features().effects);
    EXPECT_FALSE(renderer().scene()->features().translucent);
    even_radiance(along_x({plate(100)}));
    EXPECT_FALSE(renderer().scene()->features().effects);
}

TEST_P(EntityTest, CameraRaysSeeWhatTheyMay) {
    load_dark();
    // The room ends at x = 256.
    refresh::Entity near = plate(100), behind_the_wall = plate(400), nearest = plate(0);
    near.glow = {1, 1, 1};
    behind_the_wall.glow = {2, 2, 2};
    behind_the_wall.number = 2;
    nearest.glow = {4, 4, 4};
    nearest.number = 3;
    nearest.flags = refresh::entity_hidden_from_camera;
    EXPECT_EQ(even_radiance(along_x({near, behind_the_wall, nearest})), glm::vec3(1));
    behind_the_wall.flags = refresh::entity_in_front;
    EXPECT_EQ(even_radiance(along_x({near, behind_the_wall, nearest})), glm::vec3(2));
    behind_the_wall.flags = refresh::entity_weapon;
    EXPECT_EQ(even_radiance(along_x({near, behind_the_wall, nearest})), glm::vec3(2));
    behind_the_wall.flags |= refresh::entity_hidden_from_camera;
    EXPECT_EQ(even_radiance(along_x({near, behind_the_wall, nearest})), glm::vec3(1));
    near.alpha = 0.0f;
    EXPECT_EQ(even_radiance(along_x({near, behind_the_wall, nearest})), glm::vec3(0));
}

TEST_P(EntityTest, HaveAnAngleOfViewOfTheirOwn) {
    write_game_file("models/chip.glb",
                    triangle_glb(R"("scale":[40,40,40],"translation":[5,3,0],)", white));
    load_dark();
    refresh::Entity chip =
        placed(renderer().register_model("models/chip.glb"), {0, 0, 0}, {0, -90, 0});
    chip.flags = refresh::entity_weapon;
    chip.glow = {1, 1, 1};
    Shot shot;
    shot.view = {{-192, 10, 64}, {5, 20, 10}, 90, 40};
    // The picture of what lies 150 units ahead in the camera's own axes.
    const auto coverage = [&](float fov_y, glm::vec2 scale) {
        shot.view.fov_y = fov_y;
        const glm::mat3 axes = rotation_from_angles(shot.view.angles);
        chip.origin = shot.view.origin + 150.0f * axes[0];
        chip.angles = {20, -60, 30};
        chip.view_scale = scale;
        shot.entities = {chip};
        std::vector<bool> covered;
        for (const float value : radiance(shot).rgb)
            covered.push_back(value > 0.5f);
        return covered;
    };
    const auto differ = [](const std::vector<bool>& a, const std::vector<bool>& b) {
        int count = 0;
        for (size_t i = 0; i < a.size(); ++i)
            count += a[i] != b[i] ? 1 : 0;
        return count;
    };
    const std::vector<bool> seen = coverage(40, glm::vec2(1));
    const int size = static_cast<int>(std::ranges::count(seen, true));
    EXPECT_GT(size, 3 * 60);
    // A pixel may lie on an edge: rounding decides.
    constexpr int edge = 3 * 2;
    const float wider = std::tan(glm::radians(30.0f)) / std::tan(glm::radians(20.0f));
    EXPECT_GT(differ(seen, coverage(60, glm::vec2(1))), size / 4);
    EXPECT_LE(differ(seen, coverage(60, glm::vec2(wider))), edge);
    // In the other hand it is its mirror image.
    std::vector<bool> mirrored = coverage(40, {-1, 1});
    EXPECT_GT(differ(seen, mirrored), size / 4);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width / 2; ++x)
            for (int c = 0; c < 3; ++c) {
                const auto left = static_cast<size_t>(3 * (y * width + x) + c);
                const auto right = static_cast<size_t>(3 * (y * width + width - 1 - x) + c);
                const bool kept = mirrored[left];
                mirrored[left] = mirrored[right];
                mirrored[right] = kept;
            }
    EXPECT_LE(differ(seen, mirrored), edge);
}

TEST_P(EntityTest, OpacityIsAChance) {
    load_dark();
    refresh::Entity half = plate(100);
    half.glow = {1, 1, 1};
    half.alpha = 0.3f;
    const auto mean_of = [](const Shot& shot) {
        double sum = 0.0;
        set("pt_spp", "16");
        for (int seed = 0; seed < 8; ++seed) {
            set("pt_seed", std::to_string(seed));
            for (const float value : radiance(shot).rgb)
                sum += static_cast<double>(value) / 3.0;
        }
        return sum / (8.0 * width * height);
    };
    const double rays = 8.0 * 16.0 * width * height;
    const auto score = [&](double seen, double expected) {
        return (seen - expected) / std::sqrt(expected * (1.0 - expected) / rays);
    };
    const double alpha = 77.0 / 255.0; // round(0.3 * 255)
    EXPECT_LT(std::abs(score(mean_of(along_x({half})), alpha)), score_limit);
    // Two are met one after the other, each with numbers of its own.
    refresh::Entity second = half;
    second.origin.x = 150;
    second.number = 2;
    EXPECT_LT(std::abs(score(mean_of(along_x({half, second})), alpha + (1 - alpha) * alpha)),
              score_limit);
    // Seen from behind, what is not opaque is not there.
    half.angles.y = 90;
    second.glow = {1, 1, 1};
    second.alpha = 1.0f;
    EXPECT_EQ(even_radiance(along_x({half, second})), glm::vec3(1));
}

TEST_P(EntityTest, HiddenBodyCastsItsShadow) {
    // Over a floor under a lamp: what the camera cannot see is dark all the same.
    load("lamp");
    set("pt_bounces", "0");
    refresh::Entity cover =
        placed(renderer().register_model("models/plate.glb"), {0, 0, 100}, {0, 0, 90});
    Shot shot;
    shot.view = {{-192, 0, 64}, {50, 0, 0}, 60};
    set("pt_spp", "4");
    const auto light = [&] { return sum_of(radiance(shot).rgb); };
    EXPECT_GT(light(), 0.0);
    cover.flags = refresh::entity_hidden_from_camera;
    shot.entities = {cover};
    EXPECT_EQ(light(), 0.0);
    shot.view.origin.z = 120; // its camera rays start above
    EXPECT_EQ(light(), 0.0);
    for (const shader::PrimaryHit& hit : primary_hits())
        EXPECT_EQ(hit.instance, 0u);
    shot.entities[0].flags |= refresh::entity_hidden_from_light;
    EXPECT_GT(light(), 0.0);
}

TEST_P(EntityTest, LampsThatLightRaysMissAreDark) {
    write_game_file("models/lamp.glb",
                    triangle_glb(R"("scale":[90,90,90],"translation":[-30,-30,0],)",
                                 R"({"emissiveFactor":[1,1,1]})"));
    load_dark();
    Shot shot;
    shot.view = {{-192, 0, 64}, {50, 0, 0}, 60};
    set("pt_spp", "16");
    shot.entities = {placed(renderer().register_model("models/lamp.glb"), {0, 0, 100}, {0, 0, 90})};
    for (const std::string_view technique : {"sll", "brute"}) {
        set("pt_nee", technique);
        shot.entities[0].flags = 0;
        EXPECT_GT(sum_of(radiance(shot).rgb), 0.0) << technique;
        shot.entities[0].flags = refresh::entity_hidden_from_light;
        EXPECT_EQ(sum_of(radiance(shot).rgb), 0.0) << technique;
    }
    set("pt_nee", "sll");
    shot.entities.clear();
    shot.dynamic_lights = {{1, {-140, 0, 10}, 4.0f, {9, 9, 9}}};
    const auto instances = [&] {
        EXPECT_GT(sum_of(radiance(shot).rgb), 0.0);
        uint32_t most = 0;
        for (const shader::PrimaryHit& hit : primary_hits())
            if (hit.primitive != shader::NONE) most = std::max(most, hit.instance);
        return most;
    };
    EXPECT_EQ(instances(), 1u);
    shot.dynamic_lights[0].visible = false;
    EXPECT_EQ(instances(), 0u);
}

TEST_P(EntityTest, SkinsAndShells) {
    load_dark();
    const refresh::ModelHandle box = renderer().register_model("models/box.md2");
    const refresh::SkinHandle red = renderer().register_skin("skins/red.tga");
    EXPECT_EQ(renderer().register_skin("skins/red.tga"), red);
    EXPECT_THROW(renderer().register_skin("skins/none.tga"), Error);
    // From just above: its square of 10 units, at z = 1, fills the picture.
    Shot shot;
    shot.view = {{105, 105, 7}, {90, 0, 0}, 40};
    shot.entities = {placed(box, {100, 100, 0}, {0, 0, 0})};
    shot.entities[0].glow = glm::vec3(1);
    EXPECT_EQ(even_radiance(shot), glm::vec3(0, 1, 0));
    shot.entities[0].skin = 5; // the last it has
    EXPECT_EQ(even_radiance(shot), glm::vec3(0, 1, 0));
    shot.entities[0].custom_skin = red;
    EXPECT_EQ(even_radiance(shot), glm::vec3(1, 0, 0));
    shot.entities[0].custom_skin = 1000;
    EXPECT_EQ(even_radiance(shot), glm::vec3(0, 1, 0));
    // A shell hides the body from above, half a unit off or four; light rays meet the body alone.
    const auto height_of_shell = [&](uint32_t flags) {
        refresh::Entity shell = placed(box, {100, 100, 0}, {0, 0, 0});
        shell.number = 2;
        shell.shell = {0, 0, 1};
        shell.flags = flags;
        shot.entities.resize(1);
        shot.entities.push_back(shell);
        EXPECT_EQ(even_radiance(shot), glm::vec3(0, 0, refresh::particle_radiance));
        EXPECT_EQ(renderer().scene()->host_instances()[2].flags & shader::INSTANCE_LIT, 0u);
        return primary_hits()[0].position.z;
    };
    EXPECT_NEAR(height_of_shell(0), 5.0f, 1e-3f);
    EXPECT_NEAR(height_of_shell(refresh::entity_in_front), 1.5f, 1e-3f);
}

TEST_P(EntityTest, NewModelsTakeNoPoseThatIsShown) {
    load_dark();
    const refresh::ModelHandle box = renderer().register_model("models/box.md2");
    Shot shot = along_x({});
    for (const int number : {2, 3}) {
        refresh::Entity& entity = shot.entities.emplace_back(placed(box, {}, {}));
        entity.number = number;
        entity.frame = number % 2;
    }
    const auto poses = [&] {
        radiance(shot);
        std::map<uint32_t, uint32_t> roots;
        for (const shader::Instance& instance : renderer().scene()->host_instances())
            roots[instance.entity] = instance.bvh_root;
        return roots;
    };
    const auto before = poses();
    shot.entities.insert(shot.entities.begin(), placed(box, {}, {}));
    auto after = poses();
    after.erase(1);
    EXPECT_EQ(after, before);
}

TEST_P(EntityTest, SpritesFaceTheCamera) {
    // 4 x 4 texels: each colour tells its place; every third is not there, one is there by half.
    constexpr uint32_t half_texel = 6; // white
    Image picture{4, 4, {}};
    for (uint32_t i = 0; i < 16; ++i) {
        const auto bit = [&](uint32_t n) {
            return static_cast<uint8_t>((i + 1) >> n & 1 ? 255 : 0);
        };
        const int alpha = i == half_texel ? 128 : i % 3 == 2 ? 0 : 255;
        for (const uint8_t value : {bit(0), bit(1), bit(2), static_cast<uint8_t>(alpha)})
            picture.rgba.push_back(value);
    }
    write_game_file("sprites/a.tga", write_tga(picture, {2, 32, 0x28}));
    const Sp2Frame frames[] = {{{8, 8}, {4, 4}, "sprites/a.tga"},
                               {{32, 24}, {10, 16}, "sprites/a.tga"}};
    write_game_file("sprites/test.sp2", write_sp2(frames));
    load_dark();
    set("pt_texture_filter", "nearest");
    Shot shot;
    shot.view = {{-150, 30, 90}, {10, 30, 5}, 90};
    const glm::mat3 axes = rotation_from_angles(shot.view.angles);
    constexpr float distance = 32.0f;
    shot.entities = {placed(renderer().register_model("sprites/test.sp2"),
                            shot.view.origin + distance * axes[0], {11, 22, 33})};
    shot.entities[0].frame = 3; // wraps to 1
    shot.entities[0].glow = glm::vec3(1);
    constexpr int frames_seen = 64;
    std::vector<double> mean(3 * width * height);
    for (int seed = 0; seed < frames_seen; ++seed) {
        set("pt_seed", std::to_string(seed));
        const std::vector<float> rgb = radiance(shot).rgb;
        for (size_t i = 0; i < mean.size(); ++i)
            mean[i] += static_cast<double>(rgb[i]) / frames_seen;
    }
    int inside = 0, half = 0;
    double half_sum = 0.0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            // Where the pixel's ray meets the sprite's plane, in its units from the lower left.
            const float right = (2.0f * (static_cast<float>(x) + 0.5f) / width - 1.0f) * 1.125f;
            const float up = (1.0f - 2.0f * (static_cast<float>(y) + 0.5f) / height) * 0.75f;
            const glm::vec2 place =
                (glm::vec2(10, 16) + distance * glm::vec2(right, up)) / glm::vec2(32, 24) * 4.0f;
            const glm::vec2 cell = glm::floor(place);
            if (glm::any(glm::lessThan(glm::abs(place - glm::round(place)), glm::vec2(1e-3f))))
                continue; // on a border
            const size_t at = 3 * static_cast<size_t>(y * width + x);
            const glm::dvec3 seen(mean[at], mean[at + 1], mean[at + 2]);
            if (glm::any(glm::lessThan(cell, glm::vec2(0))) ||
                glm::any(glm::greaterThan(cell, glm::vec2(3)))) {
                EXPECT_EQ(seen, glm::dvec3(0)) << x << ' ' << y;
                continue;
            }
            ++inside;
            const size_t texel = static_cast<size_t>((3 - cell.y) * 4 + cell.x);
            glm::dvec3 expected(0);
            for (glm::length_t c = 0; c < 3; ++c)
                if (picture.rgba[4 * texel + 3] != 0 &&
                    picture.rgba[4 * texel + static_cast<size_t>(c)] != 0)
                    expected[c] = 1.0;
            if (texel == half_texel) {
                ++half;
                half_sum += seen.x;
                continue;
            }
            EXPECT_EQ(seen, expected) << x << ' ' << y << " texel " << texel;
        }
    EXPECT_GT(inside, 100);
    ASSERT_GT(half, 4);
    const double share = 128.0 / 255.0, rays = frames_seen * half;
    EXPECT_LT(std::abs(half_sum / half - share) / std::sqrt(share * (1.0 - share) / rays),
              score_limit);
    // Light rays pass through.
    EXPECT_EQ(renderer().scene()->host_instances()[1].flags & shader::INSTANCE_LIT, 0u);
}

TEST_P(EntityTest, SkyOfTheFrontEnd) {
    load("opensky", [](Level& level) {
        level.bsp.entities[0].set("_sun_light", "0");
        level.bsp.entities[0].set("_sky_color", "0.25 0.5 1");
    });
    const auto sky_of = [](float yaw, double time) {
        Shot shot;
        shot.view = {{-80, -60, 100}, {-60, yaw, 0}, 60};
        shot.time_s = time;
        const std::vector<float> rgb = radiance(shot).rgb;
        const std::vector<shader::PrimaryHit> hits = primary_hits();
        std::vector<glm::vec3> sky(hits.size(), glm::vec3(-1));
        for (size_t i = 0; i < hits.size(); ++i)
            if (hits[i].primitive == shader::NONE)
                sky[i] = {rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]};
        return sky;
    };
    const auto difference = [](const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
        double sum = 0.0;
        int pixels = 0;
        for (size_t i = 0; i < a.size(); ++i) {
            if (a[i].x < 0.0f || b[i].x < 0.0f) continue;
            sum += static_cast<double>(glm::distance(a[i], b[i]));
            ++pixels;
        }
        EXPECT_GT(pixels, 500);
        return sum / pixels;
    };
    const auto level_sky = sky_of(0, 0), beside = sky_of(-90, 0);
    EXPECT_GT(difference(level_sky, beside), 0.01);
    // Turned by 90 degrees counter-clockwise, what was at yaw -90 is at 0.
    renderer().set_sky("court", 45.0f, {0, 0, 3});
    EXPECT_EQ(sky_of(0, 0), level_sky);
    EXPECT_LT(difference(sky_of(0, 2), beside), 1e-4);
    EXPECT_GT(difference(sky_of(0, 2), level_sky), 0.01);
    renderer().set_sky("none", 45.0f, {0, 0, 1});
    for (const glm::vec3& pixel : sky_of(0, 1)) {
        if (pixel.x < 0.0f) continue;
        EXPECT_EQ(pixel, glm::vec3(0.25f, 0.5f, 1.0f));
    }
    renderer().set_sky("court", 45.0f, {0, 0, 0}); // about nothing
    EXPECT_EQ(sky_of(0, 2), level_sky);
    vkpt::VkptRenderer other(files(), nullptr, cvars().values());
    EXPECT_THROW(other.set_sky("court", 0, {0, 0, 1}), Error);
    EXPECT_THROW(other.register_skin("skins/red.tga"), Error);
}

INSTANTIATE_TEST_SUITE_P(Traced, EntityTest, testing::Values("bvh", "query"),
                         [](const auto& row) { return std::string(row.param); });

} // namespace
} // namespace vigil::test
