// SPDX-License-Identifier: GPL-2.0-or-later
// Levels, meshes and poses as triangles: counts, areas, winding, texture coordinates, lights and
// clusters; Quake's angles as matrices, and the camera made of them.
#include "common/file_system.h"
#include "common/scratch_folder.h"
#include "formats/bsp_query.h"
#include "formats/small_models.h"
#include "level/level.h"
#include "refresh/vkpt/frame_params.h"
#include "refresh/vkpt/scene/mesh_geometry.h"
#include "refresh/vkpt/scene/particle_geometry.h"
#include "refresh/vkpt/scene/subdivide.h"
#include "refresh/vkpt/scene/transform.h"
#include "refresh/vkpt/scene/world_geometry.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace vigil::vkpt {
namespace {

class Geometry : public testing::Test {
protected:
    Geometry() {
        files_.mount_game(std::filesystem::path(VIGIL_SOURCE_DIR) / "tests" / "data", "baseq2");
    }

    FileSystem files_;
    TextureSet textures_{files_};
    MaterialSet materials_{files_, textures_};
};

glm::vec3 area_of(const BvhInputTriangle& triangle) {
    return 0.5f * glm::cross(triangle.v1 - triangle.v0, triangle.v2 - triangle.v0);
}

TEST_F(Geometry, FurnaceIsSixWhiteWalls) {
    const auto level = load_level(files_, "furnace");
    const ModelGeometry world = brush_model_geometry(*level, 0, materials_);
    ASSERT_EQ(world.triangles.size(), world.primitives.size());
    double total = 0.0;
    for (size_t i = 0; i < world.triangles.size(); ++i) {
        const glm::vec3 area = area_of(world.triangles[i]);
        total += static_cast<double>(glm::length(area));
        // Walls face inwards, to the middle of the room.
        EXPECT_GT(glm::dot(area, glm::vec3(0, 0, 128) - world.triangles[i].v0), 0.0f) << i;
        EXPECT_EQ(world.triangles[i].coverage, 255u);
        ASSERT_LT(world.primitives[i].light, world.lights.size());
        const LightSource& light = world.lights[world.primitives[i].light];
        EXPECT_EQ(light.v1, world.triangles[i].v1);
    }
    EXPECT_NEAR(total, 6.0 * 256.0 * 256.0, 1.0);
    EXPECT_EQ(world.lights.size(), world.triangles.size());
}

TEST_F(Geometry, FacesKeepTheirAreaAndTextureCoordinates) {
    const auto level = load_level(files_, "rooms");
    const Bsp& bsp = level->bsp;
    for (uint32_t model = 0; model < bsp.models.size(); ++model) {
        const ModelGeometry geometry = brush_model_geometry(*level, model, materials_);
        double expected = 0.0, total = 0.0;
        size_t most = 0;
        for (uint32_t f = bsp.models[model].first_face;
             f < bsp.models[model].first_face + bsp.models[model].face_count; ++f) {
            if (bsp.texinfos[bsp.faces[f].texinfo].flags & SURF_NODRAW) continue;
            const std::vector<glm::vec3> corners = face_polygon(bsp, bsp.faces[f]);
            glm::vec3 sum(0.0f);
            for (size_t i = 0; i < corners.size(); ++i)
                sum += 0.5f * glm::cross(corners[i] - corners[0],
                                         corners[(i + 1) % corners.size()] - corners[0]);
            expected += static_cast<double>(glm::length(sum));
            most += corners.size() - 2;
        }
        for (size_t i = 0; i < geometry.triangles.size(); ++i) {
            total += static_cast<double>(glm::length(area_of(geometry.triangles[i])));
            EXPECT_GT(glm::length(area_of(geometry.triangles[i])), 0.0f)
                << "collinear corners make no triangle";
            EXPECT_TRUE(model == 0 || geometry.primitives[i].cluster == shader::NONE);
        }
        EXPECT_NEAR(total, expected, 1e-4 * expected);
        EXPECT_LE(geometry.triangles.size(), most);
    }
}

TEST_F(Geometry, TwelveLampsAndOneOnTheDoor) {
    const auto level = load_level(files_, "rooms");
    const ModelGeometry world = brush_model_geometry(*level, 0, materials_);
    const ModelGeometry door = brush_model_geometry(*level, 1, materials_);
    // Total emitted power per channel does not depend on how the compiler cut the faces.
    const auto area_sum = [](const ModelGeometry& geometry) {
        double sum = 0.0;
        for (const LightSource& light : geometry.lights)
            sum += 0.5 * static_cast<double>(
                             glm::length(glm::cross(light.v1 - light.v0, light.v2 - light.v0)));
        return sum;
    };
    EXPECT_NEAR(area_sum(world),
                64 * 64 + 16 * 16 + 64 * 8 + 48 * 80 + 2 * 32 * 192 + 32 * 4 + 40 * 8 + 16 * 16 +
                    64 * 8 + 8 * 8 + 16 * 16,
                1.0);
    EXPECT_NEAR(area_sum(door), 16 * 8, 0.1);
    EXPECT_GE(world.lights.size(), 24u);
    EXPECT_EQ(door.lights.size(), 2u);
    for (const LightSource& light : door.lights)
        EXPECT_NEAR(glm::distance(light.radiance, 6.0f * textures_.texture("test/lamp_red").mean),
                    0.0f, 1e-4f);
}

TEST_F(Geometry, SubdivisionKeepsSurfacesAndLights) {
    const auto level = load_level(files_, "rooms");
    const ModelGeometry whole = brush_model_geometry(*level, 0, materials_);
    const auto area_sum = [](const ModelGeometry& geometry) {
        glm::dvec3 sum(0.0); // by texture coordinates too: the area that a texture covers
        for (size_t i = 0; i < geometry.triangles.size(); ++i) {
            const BvhInputTriangle& t = geometry.triangles[i];
            const shader::Primitive& p = geometry.primitives[i];
            const glm::vec2 u = p.uv1 - p.uv0, v = p.uv2 - p.uv0;
            sum += glm::dvec3(glm::length(area_of(t)), std::abs(u.x * v.y - u.y * v.x),
                              glm::dot(area_of(t), glm::vec3(1, 2, 3)));
        }
        return sum;
    };
    const auto is_light = [](const shader::Primitive& p) { return p.light != shader::NONE; };
    const size_t lamps = static_cast<size_t>(std::ranges::count_if(whole.primitives, is_light));
    const glm::dvec3 areas = area_sum(whole);
    for (const int times : {0, 1, 2, 3}) {
        ModelGeometry cut = whole;
        subdivide(cut, times);
        ASSERT_EQ(cut.triangles.size(), cut.primitives.size());
        EXPECT_EQ(cut.triangles.size(),
                  lamps + (whole.triangles.size() - lamps) * (size_t{1} << 2 * times));
        EXPECT_EQ(std::ranges::count_if(cut.primitives, is_light), lamps);
        EXPECT_EQ(cut.lights.size(), whole.lights.size());
        const glm::dvec3 cut_areas = area_sum(cut);
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(cut_areas[i], areas[i], 1e-4 * std::abs(areas[0])) << times << ' ' << i;
    }
}

TEST_F(Geometry, TwoSidedFacesLieApart) {
    // What can be seen from both sides has two faces in one plane; rounding must not choose
    // between.
    const auto level = load_level(files_, "rooms");
    const Bsp& bsp = level->bsp;
    size_t moved = 0;
    const ModelGeometry world = brush_model_geometry(*level, 0, materials_);
    for (const BspFace& face : bsp.faces) {
        if ((bsp.texinfos[face.texinfo].flags & (SURF_TRANS33 | SURF_TRANS66)) == 0) continue;
        const glm::vec3 normal = face_normal(bsp, face);
        const glm::vec3 corner = face_polygon(bsp, face).front();
        for (const BvhInputTriangle& triangle : world.triangles) {
            if (glm::distance(triangle.v0, corner) > 0.1f ||
                glm::dot(glm::normalize(area_of(triangle)), normal) < 0.999f)
                continue;
            ++moved;
            for (const glm::vec3& v : {triangle.v0, triangle.v1, triangle.v2})
                EXPECT_NEAR(glm::dot(v - corner, normal), 1.0f / 32.0f, 1e-4f);
        }
    }
    EXPECT_GE(moved, 2u);
}

TEST_F(Geometry, TrianglesOfOneClusterLieInIt) {
    const auto level = load_level(files_, "rooms");
    const ModelGeometry world = brush_model_geometry(*level, 0, materials_);
    size_t one = 0, several = 0;
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(0.05f, 0.95f);
    for (size_t i = 0; i < world.triangles.size(); ++i) {
        if (world.primitives[i].cluster == shader::NONE) {
            ++several;
            continue;
        }
        ++one;
        const BvhInputTriangle& t = world.triangles[i];
        for (int sample = 0; sample < 20; ++sample) {
            const float a = uniform(random), b = uniform(random) * (1.0f - a);
            const glm::vec3 point =
                t.v0 + a * (t.v1 - t.v0) + b * (t.v2 - t.v0) + 0.02f * glm::normalize(area_of(t));
            EXPECT_EQ(cluster_at(level->bsp, point),
                      static_cast<int32_t>(world.primitives[i].cluster))
                << i << " at " << point.x << " " << point.y << " " << point.z;
        }
    }
    EXPECT_GT(one, 100u);
    std::cout << one << " triangles in one cluster, " << several << " in several\n";
}

TEST_F(Geometry, ClusterTreeAnswersAsTheLevelDoes) {
    for (const char* name : {"rooms", "lamp", "furnace", "opensky"}) {
        const auto level = load_level(files_, name);
        const std::vector<shader::BspTreeNode> tree = cluster_tree(level->bsp);
        std::mt19937 random(2);
        std::uniform_real_distribution<float> uniform(-300.0f, 850.0f);
        for (int i = 0; i < 5000; ++i) {
            const glm::vec3 point(uniform(random), uniform(random), uniform(random));
            int32_t child = 0;
            while (child >= 0) {
                const shader::BspTreeNode& node = tree[static_cast<size_t>(child)];
                child = glm::dot(node.normal, point) >= node.dist ? node.front : node.back;
            }
            ASSERT_EQ(-2 - child, cluster_at(level->bsp, point)) << name;
        }
    }
}

TEST_F(Geometry, ClusterTreeOfALoneLeaf) {
    Bsp bsp;
    bsp.models.resize(1);
    bsp.models[0].headnode = -1; // leaf 0
    bsp.leafs.resize(1);
    bsp.leafs[0].cluster = 3;
    const std::vector<shader::BspTreeNode> tree = cluster_tree(bsp);
    ASSERT_EQ(tree.size(), 1u);
    EXPECT_EQ(-2 - tree[0].front, 3);
    EXPECT_EQ(-2 - tree[0].back, 3);
}

TEST_F(Geometry, MeshesBringTheirLights) {
    const Mesh mesh = parse_glb("t.glb", triangle_glb("", R"({"emissiveFactor":[1,0.5,0.25]})"));
    const ModelGeometry geometry = mesh_geometry(mesh, materials_);
    ASSERT_EQ(geometry.triangles.size(), 1u);
    ASSERT_EQ(geometry.lights.size(), 1u);
    EXPECT_EQ(geometry.primitives[0].light, 0u);
    EXPECT_EQ(geometry.lights[0].radiance, glm::vec3(1.0f, 0.5f, 0.25f));
    EXPECT_EQ(geometry.primitives[0].cluster, shader::NONE);
    // A mesh that does not emit has none; a triangle without area is left out.
    Mesh dark = parse_glb("t.glb", triangle_glb());
    EXPECT_TRUE(mesh_geometry(dark, materials_).lights.empty());
    dark.primitives[0].positions[2] = dark.primitives[0].positions[1];
    EXPECT_TRUE(mesh_geometry(dark, materials_).triangles.empty());
}

TEST_F(Geometry, PosesMixTwoFrames) {
    const Md2 md2 = parse_md2("m.md2", small_md2());
    ASSERT_EQ(md2.frames.size(), 2u);
    const ModelGeometry first = md2_geometry(md2, {0, 0, 0.0f, 0.0f, 5}),
                        second = md2_geometry(md2, {1, 1, 0.0f, 0.0f, 5});
    const ModelGeometry between =
        md2_geometry(md2, {1, 0, 0.25f, 0.0f, 5}); // a quarter of the old one is left
    ASSERT_EQ(first.triangles.size(), md2.indices.size() / 3);
    for (size_t i = 0; i < first.triangles.size(); ++i) {
        EXPECT_NEAR(glm::distance(between.triangles[i].v1,
                                  0.25f * first.triangles[i].v1 + 0.75f * second.triangles[i].v1),
                    0.0f, 1e-4f);
        EXPECT_EQ(between.primitives[i].material, 5u);
        EXPECT_EQ(between.primitives[i].uv2, md2.uvs[md2.indices[3 * i + 2]]);
    }
    // Frame numbers wrap, also below zero.
    EXPECT_EQ(md2_geometry(md2, {3, -1, 0.0f, 0.0f, 5}).triangles[0].v1, second.triangles[0].v1);
    EXPECT_EQ(md2_geometry(md2, {-2, -2, 0.0f, 0.0f, 5}).triangles[0].v1, first.triangles[0].v1);
}

TEST_F(Geometry, ShellsStandOffTheModel) {
    const Md2 md2 = parse_md2("m.md2", small_md2()); // flat, and looks up
    const Md2Pose pose{1, 0, 0.25f, 0.0f, 5};
    Md2Pose shell = pose;
    shell.swell = 4.0f;
    const ModelGeometry body = md2_geometry(md2, pose), around = md2_geometry(md2, shell);
    for (size_t i = 0; i < body.triangles.size(); ++i)
        EXPECT_NEAR(
            glm::distance(around.triangles[i].v2, body.triangles[i].v2 + glm::vec3(0, 0, 4)), 0.0f,
            1e-4f);
}

TEST_F(Geometry, SpritesAreQuadsAroundTheirOrigin) {
    const ModelGeometry quad = sprite_geometry({{32, 24}, {8, -4}, ""}, 7);
    ASSERT_EQ(quad.triangles.size(), 2u);
    double area = 0.0;
    for (size_t i = 0; i < 2; ++i) {
        const BvhInputTriangle& triangle = quad.triangles[i];
        const shader::Primitive& primitive = quad.primitives[i];
        EXPECT_EQ(primitive.material, 7u);
        const glm::vec3 normal = glm::cross(triangle.v1 - triangle.v0, triangle.v2 - triangle.v0);
        EXPECT_LT(normal.x, 0.0f) << "its front looks back at the camera";
        area += 0.5 * static_cast<double>(glm::length(normal));
        const auto expect_corner = [](const glm::vec3& corner, const glm::vec2& uv) {
            EXPECT_EQ(corner,
                      glm::vec3(0.0f, -(-8.0f + 32.0f * uv.x), 4.0f + 24.0f * (1.0f - uv.y)));
        };
        expect_corner(triangle.v0, primitive.uv0);
        expect_corner(triangle.v1, primitive.uv1);
        expect_corner(triangle.v2, primitive.uv2);
    }
    EXPECT_DOUBLE_EQ(area, 32.0 * 24.0);
}

TEST_F(Geometry, ParticlesFade) {
    refresh::Particle particles[2];
    particles[1].alpha = 0.25f;
    refresh::Frame frame;
    frame.particles = particles;
    const ModelGeometry geometry = particle_geometry(frame, 2, materials_);
    EXPECT_EQ(geometry.triangles[0].coverage, 255u);
    EXPECT_EQ(geometry.triangles[1].coverage, 64u);
    EXPECT_EQ(coverage_of(std::numeric_limits<float>::quiet_NaN()), 0u);
    EXPECT_EQ(coverage_of(-1.0f), 0u);
    EXPECT_EQ(coverage_of(7.0f), 255u);
}

TEST(Transform, QuakesAngles) {
    const auto near = [](glm::vec3 a, glm::vec3 b) { return glm::distance(a, b) < 1e-6f; };
    EXPECT_TRUE(near(rotation_from_angles({0, 0, 0})[0], {1, 0, 0}));
    EXPECT_TRUE(near(rotation_from_angles({0, 90, 0})[0], {0, 1, 0})) << "yaw turns left";
    EXPECT_TRUE(near(rotation_from_angles({90, 0, 0})[0], {0, 0, -1}))
        << "positive pitch looks down";
    EXPECT_TRUE(near(rotation_from_angles({0, 0, 90})[1], {0, 0, 1}))
        << "positive roll lifts the left side";
    EXPECT_TRUE(near(rotation_from_angles({0, 90, 0})[2], {0, 0, 1}));
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(-720.0f, 720.0f);
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 angles(uniform(random), uniform(random), uniform(random)),
            origin(uniform(random));
        const glm::mat3 rotation = rotation_from_angles(angles);
        EXPECT_NEAR(glm::determinant(rotation), 1.0f, 1e-5f);
        const glm::mat3 identity = glm::transpose(rotation) * rotation;
        for (glm::length_t c = 0; c < 3; ++c)
            EXPECT_TRUE(glm::distance(identity[c], glm::mat3(1.0f)[c]) < 1e-5f);
        const glm::mat4x3 there = rigid_transform(origin, angles), back = inverse_transform(there);
        const glm::vec3 point(uniform(random), uniform(random), uniform(random));
        EXPECT_NEAR(glm::distance(back * glm::vec4(there * glm::vec4(point, 1.0f), 1.0f), point),
                    0.0f, 2e-3f);
    }
    EXPECT_EQ(rigid_transform({1, 2, 3}, {0, 0, 0}) * glm::vec4(4, 5, 6, 1), glm::vec3(5, 7, 9));
    EXPECT_EQ(scale_transform({1, 2, 3}, 2.0f) * glm::vec4(1, 1, 1, 1), glm::vec3(3, 4, 5));
}

TEST(Camera, FieldOfViewIsHorizontalAtFourToThree) {
    vkpt::FrameDescription params{};
    refresh::View view;
    view.fov = 90.0f;
    set_camera(params, view, {640, 480});
    EXPECT_NEAR(glm::length(params.camera_right), 1.0f, 1e-6f);
    EXPECT_NEAR(glm::length(params.camera_up), 0.75f, 1e-6f);
    // Wider pictures see more at the sides and the same above.
    set_camera(params, view, {1920, 1080});
    EXPECT_NEAR(glm::length(params.camera_up), 0.75f, 1e-6f);
    EXPECT_NEAR(glm::length(params.camera_right), 0.75f * 16.0f / 9.0f, 1e-6f);
    EXPECT_NEAR(params.pixel_angle, 1.5f / 1080.0f, 1e-7f);
    // A vertical angle says it all.
    view.fov_y = 60.0f;
    set_camera(params, view, {300, 200});
    EXPECT_NEAR(glm::length(params.camera_up), std::tan(glm::radians(30.0f)), 1e-6f);
    EXPECT_NEAR(glm::length(params.camera_right), 1.5f * std::tan(glm::radians(30.0f)), 1e-6f);
    view.fov_y = 0.0f;
    // Right-handed: forward x up = right, in Quake's world.
    view.angles = {20, 130, -15};
    set_camera(params, view, {640, 480});
    EXPECT_NEAR(glm::dot(glm::cross(params.camera_forward, glm::normalize(params.camera_up)),
                         glm::normalize(params.camera_right)),
                1.0f, 1e-5f);
    EXPECT_NEAR(glm::length(params.camera_forward), 1.0f, 1e-6f);
}

} // namespace
} // namespace vigil::vkpt
