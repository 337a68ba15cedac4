// SPDX-License-Identifier: GPL-2.0-or-later
// materials.json: its ranges with both ends, and the one that we ship.
#include "formats/material_table.h"

#include "common/error.h"
#include "common/file_system.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace vigil::test {
namespace {

TEST(MaterialTable, BothEndsOfTheRangesAreAllowed) {
    const MaterialTable table = parse_material_table(
        "x.json",
        R"({"A": {"roughness": 0.1, "specular": 1}, "b": {"roughness": 1, "specular": 0.04}, "c": {"roughness": 0.5, "specular": 0}})");
    ASSERT_EQ(table.size(), 2u) << "what does not shine is no entry";
    EXPECT_EQ(table.at("a").roughness, 0.1f);
    EXPECT_EQ(table.at("a").specular, 1.0f);
    EXPECT_EQ(table.at("b").roughness, 1.0f);
}

TEST(MaterialTable, OthersAreRefusedByName) {
    for (const char* roughness : {"0.0999", "1.001", "-1", "1e300", "\"smooth\"", "null"})
        EXPECT_THROW(parse_material_table(
                         "x.json", fmt::format(R"({{"a": {{"roughness": {}, "specular": 0.1}}}})",
                                               roughness)),
                     Error)
            << roughness;
}

TEST(MaterialTable, OursIsRight) {
    FileSystem files;
    files.mount_game(VIGIL_SOURCE_DIR, "baseq2");
    const MaterialTable table =
        parse_material_table("materials.json", files.read_text("materials.json"));
    EXPECT_EQ(table.at("vigil/marble_floor").roughness, 0.1f);
}

TEST(MaterialTable, LightReplacesTheLevels) {
    const MaterialTable table = parse_material_table(
        "x.json",
        R"({"A": {"light": 120}, "b": {"light": 0, "specular": 0.1}, "c": {"specular": 0.1}})");
    EXPECT_EQ(table.at("a").light, 120.0f);
    EXPECT_EQ(table.at("a").specular, 0.0f);
    EXPECT_EQ(table.at("b").light, 0.0f);
    EXPECT_EQ(table.at("c").light, std::nullopt);
    for (const char* light : {"-1", "10001", "1e300", "null", "\"on\""})
        EXPECT_THROW(
            parse_material_table("x.json", fmt::format(R"({{"a": {{"light": {}}}}})", light)),
            Error)
            << light;
}

} // namespace
} // namespace vigil::test
