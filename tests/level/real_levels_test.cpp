// SPDX-License-Identifier: GPL-2.0-or-later
// Six levels that other people built and other tools compiled: counts as their README states them,
// geometry that fits its planes, and clear messages when the files are cut.
#include "formats/bsp_query.h"
#include "formats/fault.h"
#include "formats/image.h"
#include "formats/real_levels.h"
#include "formats/small_level.h"
#include "level/pvs.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <set>

namespace vigil {
namespace {

class RealLevels : public testing::TestWithParam<RealLevel> {
protected:
    void SetUp() override {
        const auto folder = real_levels_folder();
        if (!folder) GTEST_SKIP() << "no real levels: set VIGIL_SHARED to the folder of levels/";
        name_ = std::string("maps/") + GetParam().name + ".bsp";
        bytes_ = read_file(*folder / "baseq2" / name_);
    }

    std::string name_;
    Bytes bytes_;
};

size_t count_faces(const Bsp& bsp, auto predicate) {
    return static_cast<size_t>(
        std::count_if(bsp.faces.begin(), bsp.faces.end(),
                      [&](const BspFace& face) { return predicate(bsp.texinfos[face.texinfo]); }));
}

TEST_P(RealLevels, CountsAreThoseOfTheReadme) {
    const Bsp bsp = parse_bsp(name_, bytes_);
    const RealLevel& expected = GetParam();
    EXPECT_EQ(bsp.faces.size(), expected.faces);
    EXPECT_EQ(bsp.cluster_count, expected.clusters);
    EXPECT_EQ(bsp.models.size() - 1, expected.brush_models);
    EXPECT_EQ(count_faces(bsp, is_emissive), expected.emissive_faces);
    EXPECT_EQ(count_faces(bsp, [](const BspTexInfo& t) { return (t.flags & SURF_SKY) != 0; }),
              expected.sky_faces);
    EXPECT_EQ(bsp.worldspawn().classname(), "worldspawn");
    const auto is_start = [](const Entity& e) { return e.classname() == "info_player_start"; };
    EXPECT_TRUE(std::any_of(bsp.entities.begin(), bsp.entities.end(), is_start));
}

TEST_P(RealLevels, EmissiveFacesPerClusterAreThoseOfTheReadme) {
    const Bsp bsp = parse_bsp(name_, bytes_);
    const Pvs pvs(bsp);
    EXPECT_EQ(pvs.damaged_rows(), 0u);
    std::vector<std::set<uint32_t>> lamps(bsp.cluster_count);
    for (const BspLeaf& leaf : bsp.leafs) {
        if (leaf.cluster < 0) continue;
        for (uint32_t i = 0; i < leaf.leaf_face_count; ++i) {
            const uint32_t face = bsp.leaf_faces[leaf.first_leaf_face + i];
            if (face < bsp.models[0].face_count &&
                is_emissive(bsp.texinfos[bsp.faces[face].texinfo]))
                lamps[static_cast<size_t>(leaf.cluster)].insert(face);
        }
    }
    std::vector<size_t> counts;
    for (uint32_t from = 0; from < bsp.cluster_count; ++from) {
        std::set<uint32_t> seen;
        for (uint32_t to = 0; to < bsp.cluster_count; ++to)
            if (pvs.visible(static_cast<int>(from), static_cast<int>(to)))
                seen.insert(lamps[to].begin(), lamps[to].end());
        counts.push_back(seen.size());
    }
    std::sort(counts.begin(), counts.end());
    EXPECT_EQ(counts.back(), GetParam().max_emissive_in_pvs);
    EXPECT_EQ(counts[counts.size() / 2], GetParam().median_emissive_in_pvs);
}

TEST_P(RealLevels, PolygonsLieOnTheirPlanesAndFaceTheirNormals) {
    const Bsp bsp = parse_bsp(name_, bytes_);
    size_t without_area = 0;
    for (size_t i = 0; i < bsp.faces.size(); ++i) {
        const BspFace& face = bsp.faces[i];
        const BspPlane& plane = bsp.planes[face.plane];
        const auto polygon = face_polygon(bsp, face);
        glm::vec3 area(0.0f);
        for (size_t k = 0; k < polygon.size(); ++k) {
            area +=
                glm::cross(polygon[k] - polygon[0], polygon[(k + 1) % polygon.size()] - polygon[0]);
            EXPECT_NEAR(glm::dot(plane.normal, polygon[k]), plane.dist, 0.25f) << "face " << i;
        }
        const float facing = glm::dot(area, face_normal(bsp, face));
        EXPECT_GE(facing, 0.0f) << "face " << i;
        without_area += facing == 0.0f;
    }
    EXPECT_LE(without_area, 2u) << "these levels hold a few faces that are mere lines";
}

TEST_P(RealLevels, PlayersStartInAClusterThatSeesItself) {
    const Bsp bsp = parse_bsp(name_, bytes_);
    const Pvs pvs(bsp);
    for (const Entity& entity : bsp.entities) {
        if (entity.classname() != "info_player_start") continue;
        const glm::vec3 origin = entity.get_vec3("origin");
        const int32_t cluster = cluster_at(bsp, origin);
        ASSERT_GE(cluster, 0);
        EXPECT_TRUE(pvs.visible(cluster, cluster));
    }
}

TEST_P(RealLevels, CutFilesAreRefused) {
    std::set<size_t> cuts = {0, 3, 8, level_header_size - 1};
    for (size_t lump = 0; lump < level_lump_count; ++lump) {
        uint32_t offset = 0, length = 0;
        std::memcpy(&offset, bytes_.data() + 8 + 8 * lump, 4);
        std::memcpy(&length, bytes_.data() + 12 + 8 * lump, 4);
        if (length > 0) cuts.insert({offset, offset + length / 2, offset + length - 1});
    }
    for (const size_t cut : cuts)
        expect_fault(name_, "", [&] { parse_bsp(name_, std::span(bytes_).first(cut)); });
}

TEST(RealTextures, AllDecode) {
    const auto folder = real_levels_folder();
    if (!folder) GTEST_SKIP() << "no real levels: set VIGIL_SHARED to the folder of levels/";
    size_t decoded = 0;
    for (const auto& entry : std::filesystem::directory_iterator(*folder / "baseq2" / "textures")) {
        const std::string name = entry.path().filename().string();
        const Image image = decode_image(name, read_file(entry.path()));
        EXPECT_EQ(image.rgba.size(), size_t{4} * image.width * image.height) << name;
        ++decoded;
    }
    EXPECT_GT(decoded, 0u);
}

INSTANTIATE_TEST_SUITE_P(All, RealLevels, testing::ValuesIn(real_levels),
                         [](const auto& level) { return std::string(level.param.name); });

} // namespace
} // namespace vigil
