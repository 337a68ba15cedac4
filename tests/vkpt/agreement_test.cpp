// SPDX-License-Identifier: GPL-2.0-or-later
// The GPU against the host, function by function: camera rays against brute-force intersection, PVS
// clusters, the sky box's geometry, texture look-ups and the orientation of textures on walls.
#include "formats/bsp_query.h"
#include "formats/image.h"
#include "formats/picture_bytes.h"
#include "formats/sky.h"
#include "refresh/vkpt/scene/transform.h"
#include "render_test.h"
#include "shared/bvh.h"
#include "shared/random.h"
#include "test_pass.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <iostream>
#include <random>

namespace vigil::test {
namespace {

class Agreement : public RenderTest {
protected:
    /// Results of probe.comp for these arguments.
    static std::vector<glm::vec4> probe(uint32_t function,
                                        const std::vector<glm::vec4>& arguments) {
        vkpt::SidePass pass = test_pass(renderer(), "probe", renderer().compiled_features());
        pass.add_buffer(gpu::bytes_of(arguments));
        pass.add_buffer(arguments.size() * sizeof(glm::vec4));
        const auto count = static_cast<uint32_t>(arguments.size());
        pass.run({(count + 63) / 64, 1, 1}, {function, count});
        return pass.read<glm::vec4>(1, count);
    }

    /// A view of `rooms` with everything in it that moves.
    Shot crowded_view(std::mt19937& random) {
        const auto uniform = [&](float low, float high) {
            return std::uniform_real_distribution<float>(low, high)(random);
        };
        Shot shot;
        shot.view = {{uniform(10, 790), uniform(10, 246), uniform(10, 150)},
                     {uniform(-80, 80), uniform(-180, 180), uniform(-30, 30)},
                     uniform(60, 120)};
        refresh::Entity door;
        door.number = 1;
        door.model = renderer().register_model("*1");
        door.origin = {uniform(-50, 50), uniform(-50, 50), uniform(0, 40)};
        door.angles = {uniform(-20, 20), uniform(-90, 90), 0};
        shot.entities = {door};
        for (uint32_t id = 0; id < 5; ++id)
            shot.dynamic_lights.push_back({id,
                                           {uniform(20, 780), uniform(20, 230), uniform(20, 140)},
                                           uniform(4, 20),
                                           {1, 1, 1}});
        return shot;
    }
};

glm::mat4x3 rigid_transform_of(const refresh::Entity& entity) {
    return vkpt::rigid_transform(entity.origin, entity.angles);
}

/// Turns a view to a point.
void look_at(refresh::View& view, glm::vec3 point) {
    const glm::vec3 way = point - view.origin;
    view.angles = {-glm::degrees(std::atan2(way.z, glm::length(glm::vec2(way)))),
                   glm::degrees(std::atan2(way.y, way.x)), 0.0f};
}

/// Closest hit of everything the scene holds, one triangle after another, with the shared triangle
/// test.
shader::Hit brute_force(const vkpt::Scene& scene, const shader::Ray& ray, uint32_t seed) {
    shader::Hit hit{ray.t_max, shader::NONE, shader::NONE, {}, false};
    for (size_t i = 0; i < scene.host_instances().size(); ++i) {
        const glm::mat4x3& to_object = scene.host_instances()[i].object_from_world;
        const glm::vec3 origin = to_object * glm::vec4(ray.origin, 1.0f);
        const glm::vec3 direction = glm::mat3(to_object) * ray.direction;
        const auto range = scene.instance_triangles(i);
        for (uint32_t index = range.first; index < range.first + range.count; ++index) {
            const shader::BvhTriangle& triangle = scene.host_triangles()[index];
            float t, u, v;
            bool front;
            if (shader::bvh_triangle_hit(triangle.v0, triangle.e1, triangle.e2, origin, direction,
                                         ray.t_min, hit.t, t, u, v, front) &&
                shader::bvh_covered(triangle.flags, front, seed, static_cast<uint32_t>(i), index))
                hit = {t, index, static_cast<uint32_t>(i), {u, v}, front};
        }
    }
    return hit;
}

/// Distance along the ray to the plane of one triangle of the scene.
float plane_distance(const vkpt::Scene& scene, const shader::Ray& ray, uint32_t primitive,
                     uint32_t instance) {
    const glm::mat4x3& to_object = scene.host_instances()[instance].object_from_world;
    const glm::vec3 origin = to_object * glm::vec4(ray.origin, 1.0f),
                    direction = glm::mat3(to_object) * ray.direction;
    const shader::BvhTriangle& triangle = scene.host_triangles()[primitive];
    const glm::vec3 normal = glm::cross(triangle.e1, triangle.e2);
    return glm::dot(normal, triangle.v0 - origin) / glm::dot(normal, direction);
}

TEST_F(Agreement, CameraRaysHitWhatBruteForceHits) {
    load("rooms");
    std::mt19937 random(1);
    size_t pixels = 0, ties = 0, translucent = 0;
    for (int view = 0; view < 24; ++view) {
        const Shot shot = crowded_view(random);
        radiance(shot);
        vkpt::FrameDescription frame = params(shot);
        frame.frame = static_cast<uint32_t>(1000 + view);
        trace(frame, 1);
        const std::vector<shader::PrimaryHit> hits = primary_hits();
        const vkpt::Scene& scene = *renderer().scene();
        for (uint32_t index = 0; index < hits.size(); ++index) {
            const glm::uvec2 pixel(index % frame.size.x, index / frame.size.x);
            const glm::vec2 screen =
                (glm::vec2(pixel) + 0.5f) / glm::vec2(frame.size) * 2.0f - 1.0f;
            shader::Ray ray{};
            ray.origin = frame.camera_origin;
            ray.direction = glm::normalize(frame.camera_forward + screen.x * frame.camera_right -
                                           screen.y * frame.camera_up);
            ray.t_max = 1e30f;
            shader::Random numbers =
                shader::random_path(pixel, {frame.frame, 0}, 0, 0); // camera rays
            const uint32_t seed = shader::random_next_words(numbers).x;
            const shader::Hit expected = brute_force(scene, ray, seed);
            ++pixels;
            const shader::PrimaryHit& seen = hits[index];
            if (expected.primitive != shader::NONE)
                translucent += scene.host_triangles()[expected.primitive].flags < 255 ? 1 : 0;
            // The inside of a wall counts as nothing.
            const uint32_t primitive = expected.front ? expected.primitive : shader::NONE;
            if (seen.primitive == primitive &&
                (primitive == shader::NONE || seen.instance == expected.instance)) {
                if (primitive == shader::NONE) continue;
                EXPECT_NEAR(glm::distance(seen.position, ray.origin + expected.t * ray.direction),
                            0.0f, 0.01f);
                continue;
            }
            // A tie: both lie at the same distance, as along a shared edge or where coplanar faces
            // overlap.
            ++ties;
            if (seen.primitive != shader::NONE && expected.primitive != shader::NONE) {
                EXPECT_NEAR(plane_distance(scene, ray, seen.primitive, seen.instance), expected.t,
                            1e-3f * expected.t + 0.01f)
                    << "view " << view << " pixel " << pixel.x << ", " << pixel.y;
            }
        }
    }
    std::cout << fmt::format("{} rays, {} ties, {} hit glass\n", pixels, ties, translucent);
    EXPECT_LT(ties, pixels / 1000);
    EXPECT_GT(translucent, 100u);
}

TEST_F(Agreement, ClustersOfWorldAndMovingSurfaces) {
    load("rooms");
    std::mt19937 random(2);
    size_t checked = 0, moving = 0, differing = 0;
    for (int view = 0; view < 8; ++view) {
        Shot shot = crowded_view(random);
        shot.view.fov = 60;
        look_at(shot.view, rigid_transform_of(shot.entities[0]) * glm::vec4(264, 128, 56, 1));
        radiance(shot);
        const std::vector<shader::PrimaryHit> hits = primary_hits();
        std::vector<glm::vec4> pixels;
        for (size_t i = 0; i < hits.size(); ++i)
            if (hits[i].primitive != shader::NONE)
                pixels.push_back(glm::vec4(static_cast<float>(i), 0, 0, 0));
        const std::vector<glm::vec4> seen = probe(3, pixels);
        for (size_t i = 0; i < seen.size(); ++i) {
            const shader::PrimaryHit& hit = hits[static_cast<size_t>(pixels[i].x)];
            const auto cluster = std::bit_cast<int32_t>(seen[i].x); // NONE is -1
            // A world triangle in one cluster knows it; other points are located half a unit above.
            const bool known =
                hit.instance == 0 &&
                renderer().scene()->host_primitives()[hit.primitive].cluster != shader::NONE;
            const glm::vec3 position = hit.position + (known ? 0.02f : 0.5f) * hit.normal;
            ++checked;
            moving += hit.instance != 0 ? 1 : 0;
            if (cluster == cluster_at(level().bsp, position)) continue;
            // Close to a splitting plane rounding decides: some point close by must lie in that
            // cluster.
            ++differing;
            bool close = false;
            for (int corner = 0; corner < 8; ++corner) {
                const glm::vec3 way(corner & 1 ? 0.03f : -0.03f, corner & 2 ? 0.03f : -0.03f,
                                    corner & 4 ? 0.03f : -0.03f);
                close |= cluster == cluster_at(level().bsp, position + way);
            }
            EXPECT_TRUE(close) << "at " << position.x << " " << position.y << " " << position.z
                               << ": " << cluster << " instead of "
                               << cluster_at(level().bsp, position);
        }
    }
    std::cout << fmt::format("{} points, {} on moving models, {} differ\n", checked, moving,
                             differing);
    EXPECT_GT(moving, 200u);
    EXPECT_LT(differing, checked / 200);
}

TEST_F(Agreement, SkyBoxSidesAndTexels) {
    load("opensky", [](Level& level) { level.bsp.entities[0].set("_sun_light", "0"); });
    Shot shot;
    shot.view = {{-192, -64, 56}, {0, 20, 0}, 90};
    radiance(shot);
    std::mt19937 random(3);
    std::vector<glm::vec4> directions;
    std::vector<glm::vec3> coordinates, colors;
    for (size_t side = 0; side < sky_sides.size(); ++side) {
        const std::string file = fmt::format("env/court{}.png", sky_sides[side].suffix);
        const Image image = decode_image(file, files().read(file));
        for (int i = 0; i < 200; ++i) {
            // The middle of a texel, where the bilinear filter shows that texel alone.
            const auto x = static_cast<uint32_t>(random() % image.width),
                       y = static_cast<uint32_t>(random() % image.height);
            const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(image.width);
            const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(image.height);
            directions.push_back(
                {glm::normalize(sky_sides[side].forward + (2 * u - 1) * sky_sides[side].right -
                                (2 * v - 1) * sky_sides[side].up),
                 0});
            coordinates.push_back({static_cast<float>(side), u, v});
            const uint8_t* texel = &image.rgba[4 * (size_t{y} * image.width + x)];
            colors.push_back(
                {srgb_to_linear(texel[0]), srgb_to_linear(texel[1]), srgb_to_linear(texel[2])});
        }
    }
    const std::vector<glm::vec4> found = probe(0, directions), sky = probe(4, directions);
    for (size_t i = 0; i < found.size(); ++i) {
        ASSERT_EQ(found[i].x, coordinates[i].x) << i;
        ASSERT_NEAR(found[i].y, coordinates[i].y, 1e-5f) << i;
        ASSERT_NEAR(found[i].z, coordinates[i].z, 1e-5f) << i;
        // Texels are stored with 9 bits below the largest component; the filter adds a little of
        // the neighbours.
        const float largest = std::max({colors[i].x, colors[i].y, colors[i].z});
        for (glm::length_t c = 0; c < 3; ++c)
            ASSERT_NEAR(sky[i][c], colors[i][c], largest / 512 + 1e-3f) << i;
    }
}

/// A TGA of 8 x 4 texels, each of another colour, rows from the top, one bright texel in the top
/// left corner.
Image marked_picture() {
    Image image{8, 4, {}};
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x) {
            const bool corner = x == 0 && y == 0;
            image.rgba.insert(image.rgba.end(),
                              {static_cast<uint8_t>(corner ? 255 : 20 + 20 * x),
                               static_cast<uint8_t>(corner ? 255 : 30 + 40 * y), 100, 255});
        }
    return image;
}

class Textures : public Agreement {
protected:
    void SetUp() override {
        Agreement::SetUp();
        write_game_file("textures/test/marked.tga", write_tga(picture_, {2, 24, 0x20}));
        // On the walls of the court, in place of sand.
        load("opensky", [](Level& level) {
            for (BspTexInfo* info : texinfos_of(level, "test/sand"))
                info->texture = "test/marked";
        });
        shot_.view = {{150, 0, 90}, {0, 0, 0}, 90};
        radiance(shot_);
        // The wall ahead shows it.
        const shader::PrimaryHit ahead = primary_hits()[16 * 48 + 24];
        ASSERT_NE(ahead.primitive, shader::NONE);
        const vkpt::Scene& scene = *renderer().scene();
        header_ = scene.host_materials()
                      .materials()[scene.host_primitives()[ahead.primitive].material]
                      .texture;
    }

    glm::dvec3 texel(int x, int y) const {
        const auto wrap = [](int value, uint32_t size) {
            const int rest = value % static_cast<int>(size);
            return static_cast<size_t>(rest < 0 ? rest + static_cast<int>(size) : rest);
        };
        const uint8_t* bytes =
            &picture_
                 .rgba[4 * (wrap(y, picture_.height) * picture_.width + wrap(x, picture_.width))];
        return {srgb_to_linear(bytes[0]), srgb_to_linear(bytes[1]), srgb_to_linear(bytes[2])};
    }

    const Image picture_ = marked_picture();
    Shot shot_;
    uint32_t header_ = 0;
};

TEST_F(Textures, FetchEveryLevelOfDetail) {
    // 8 x 4, 4 x 2, 2 x 1, 1 x 1 with box-filtered colours.
    const shader::Texture& header = renderer().scene()->host_textures().headers()[header_];
    ASSERT_EQ(header.mip_count, 4u);
    std::vector<glm::vec4> places;
    std::vector<glm::dvec3> expected;
    for (int mip = 0; mip < 4; ++mip) {
        const int width = 8 >> mip, height = std::max(4 >> mip, 1);
        const int sx = 8 / width, sy = 4 / height;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                places.push_back({header_, mip, x, y});
                glm::dvec3 sum(0.0);
                for (int j = 0; j < sy; ++j)
                    for (int i = 0; i < sx; ++i)
                        sum += texel(x * sx + i, y * sy + j);
                expected.push_back(sum / static_cast<double>(sx * sy));
            }
    }
    const std::vector<glm::vec4> seen = probe(2, places);
    for (size_t i = 0; i < seen.size(); ++i)
        for (glm::length_t c = 0; c < 3; ++c)
            EXPECT_NEAR(seen[i][c], expected[i][c], 1.0 / 512) << i;
}

TEST_F(Textures, FilterBilinearAndNearest) {
    std::mt19937 random(4);
    std::uniform_real_distribution<float> uniform(-3.0f, 3.0f);
    std::vector<glm::vec4> places;
    for (int i = 0; i < 500; ++i)
        places.push_back({header_, uniform(random), uniform(random), 0.0f});
    const std::vector<glm::vec4> bilinear = probe(1, places);
    set("pt_texture_filter", "nearest");
    radiance(shot_);
    const std::vector<glm::vec4> nearest = probe(1, places);
    for (size_t i = 0; i < places.size(); ++i) {
        const double x = static_cast<double>(places[i].y) * 8,
                     y = static_cast<double>(places[i].z) * 4;
        const double fx = x - 0.5 - std::floor(x - 0.5), fy = y - 0.5 - std::floor(y - 0.5);
        const int ix = static_cast<int>(std::floor(x - 0.5)),
                  iy = static_cast<int>(std::floor(y - 0.5));
        const glm::dvec3 mixed =
            glm::mix(glm::mix(texel(ix, iy), texel(ix + 1, iy), fx),
                     glm::mix(texel(ix, iy + 1), texel(ix + 1, iy + 1), fx), fy);
        const glm::dvec3 single =
            texel(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)));
        const bool on_edge =
            std::min(std::abs(x - std::round(x)), std::abs(y - std::round(y))) < 1e-4;
        for (glm::length_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(bilinear[i][c], mixed[c], 1.0 / 512) << i;
            if (!on_edge) {
                EXPECT_NEAR(nearest[i][c], single[c], 1.0 / 512) << i;
            }
        }
    }
}

TEST_F(Textures, FullFilterNeverTakesASmallerLevel) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(-3.0f, 3.0f);
    std::vector<glm::vec4> near, far;
    for (int i = 0; i < 200; ++i) {
        near.push_back({header_, uniform(random), uniform(random), 0.0f});
        far.push_back({near.back().x, near.back().y, near.back().z, 0.7f}); // most of a repeat
    }
    const std::vector<glm::vec4> expected = probe(1, near);
    const std::vector<glm::vec4> averaged = probe(1, far);
    set("pt_texture_filter", "full");
    radiance(shot_);
    EXPECT_EQ(probe(1, near), expected);
    EXPECT_EQ(probe(1, far), expected);
    EXPECT_NE(averaged, expected);
}

TEST_F(Textures, WallsShowThemUprightWhereTexinfoSays) {
    set("pt_texture_filter", "nearest");
    shot_.view.fov = 8; // so close that the finest level of detail shows
    radiance(shot_);
    size_t checked = 0, corners = 0;
    const vkpt::Scene& scene = *renderer().scene();
    for (const shader::PrimaryHit& hit : primary_hits()) {
        if (hit.primitive == shader::NONE || std::abs(hit.position.x - 256.0f) > 0.1f)
            continue; // the wall ahead
        ASSERT_LT(scene.host_primitives()[hit.primitive].material,
                  scene.host_materials().materials().size());
        // The map says: 1 texel is 0.5 units, s along -y, t along -z. So seen from inside, u grows
        // to the right and v down.
        const double s = static_cast<double>(-hit.position.y) * 2.0,
                     t = static_cast<double>(-hit.position.z) * 2.0;
        if (std::min(std::abs(s - std::round(s)), std::abs(t - std::round(t))) < 0.02) continue;
        const int x = static_cast<int>(std::floor(s)), y = static_cast<int>(std::floor(t));
        for (glm::length_t c = 0; c < 3; ++c)
            ASSERT_NEAR(hit.albedo[c], texel(x, y)[c], 1.0 / 256)
                << hit.position.y << " " << hit.position.z;
        ++checked;
        corners +=
            texel(x, y) == glm::dvec3(srgb_to_linear(255), srgb_to_linear(255), srgb_to_linear(100))
                ? 1
                : 0;
    }
    std::cout << fmt::format("{} pixels, {} of them marked corners\n", checked, corners);
    EXPECT_GT(checked, 300u);
    EXPECT_GT(corners, 3u);
}

} // namespace
} // namespace vigil::test
