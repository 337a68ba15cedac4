// SPDX-License-Identifier: GPL-2.0-or-later
// Entity text: the token rules, the getters and their fallbacks, and what is refused.
#include "fault.h"
#include "formats/entity.h"

namespace vigil {
namespace {

std::vector<Entity> parse(std::string_view text) {
    return parse_entities("x.bsp", text);
}

TEST(Entities, KeysAndValuesArriveInOrder) {
    const auto entities = parse("{ \"classname\" \"light\" \"origin\" \"1 -2.5 3e1\" }\n{}");
    ASSERT_EQ(entities.size(), 2u);
    EXPECT_EQ(entities[0].classname(), "light");
    EXPECT_EQ(entities[0].get_vec3("origin"), glm::vec3(1, -2.5f, 30));
    EXPECT_TRUE(entities[1].pairs.empty());
}

TEST(Entities, TheLastDuplicateWins) {
    const auto entities = parse("{ \"light\" \"100\" \"Light\" \"200\" }");
    EXPECT_EQ(entities[0].pairs.size(), 1u);
    EXPECT_EQ(entities[0].get_int("LIGHT"), 200);
}

TEST(Entities, QuotesCommentsAndBareWords) {
    const auto entities = parse("// made by hand {\n{ classname light // \"x\"\n"
                                "\"wad\" \"c:\\quake\\\" \"message\" \"a // b\\nc {d}\" }");
    ASSERT_EQ(entities.size(), 1u);
    EXPECT_EQ(entities[0].classname(), "light");
    EXPECT_EQ(entities[0].get_string("wad"), "c:\\quake\\");
    EXPECT_EQ(entities[0].get_string("message"), "a // b\nc {d}");
}

TEST(Entities, BracesInQuotesAreText) {
    const auto entities = parse("{ \"a\" \"{\" \"}\" \"b\" }");
    EXPECT_EQ(entities[0].get_string("a"), "{");
    EXPECT_EQ(entities[0].get_string("}"), "b");
}

TEST(Entities, TextEndsAtItsNul) {
    using namespace std::string_view_literals;
    EXPECT_EQ(parse("{ \"a\" \"b\" }\0{ garbage"sv).size(), 1u);
    EXPECT_TRUE(parse("\0\0"sv).empty());
    EXPECT_TRUE(parse("").empty());
}

TEST(Entities, GettersFallBackOnMissingOrUnusableValues) {
    const auto entities = parse("{ word abc  two \"1 2\"  inf inf  big 1e999  wide 1e300"
                                "  neg -9e20  plus \"+5\"  half .5  text \" 7 px\"  empty \"\" }");
    const Entity& e = entities[0];
    EXPECT_EQ(e.get_float("none", 3.0f), 3.0f);
    for (const char* key : {"word", "inf", "big", "wide", "empty"})
        EXPECT_EQ(e.get_float(key, 4.0f), 4.0f) << key;
    EXPECT_EQ(e.get_vec3("two", glm::vec3(9)), glm::vec3(9));
    EXPECT_EQ(e.get_int("neg"), std::numeric_limits<int>::min());
    EXPECT_EQ(e.get_float("plus"), 5.0f);
    EXPECT_EQ(e.get_float("half"), 0.5f);
    EXPECT_EQ(e.get_int("half", 2), 0);
    EXPECT_EQ(e.get_int("text"), 7);
    EXPECT_EQ(e.get_string("none", "x"), "x");
    EXPECT_EQ(e.get_string("empty", "x"), "");
}

TEST(Entities, AnglesAreThreeOrAYaw) {
    const auto entities = parse_entities(
        "t",
        R"({"angles" "10 20 30" "angle" "90"} {"angle" "90"} {"angle" "-1"} {"angle" "-2"} {})");
    EXPECT_EQ(entities[0].get_angles(), glm::vec3(10, 20, 30));
    EXPECT_EQ(entities[1].get_angles(), glm::vec3(0, 90, 0));
    EXPECT_EQ(entities[2].get_angles(), glm::vec3(0, -1, 0));
    EXPECT_EQ(entities[4].get_angles(), glm::vec3(0));
    EXPECT_EQ(entities[0].get_model_angles(), glm::vec3(10, 20, 30));
    EXPECT_EQ(entities[1].get_model_angles(), glm::vec3(0, 90, 0));
    EXPECT_EQ(entities[2].get_model_angles(), glm::vec3(-90, 0, 0));
    EXPECT_EQ(entities[3].get_model_angles(), glm::vec3(90, 0, 0));
    EXPECT_EQ(entities[4].get_model_angles(), glm::vec3(0));
}

TEST(Entities, FaultsAreNamedWithTheirLine) {
    const auto refuse = [](std::string_view part, std::string_view text) {
        expect_fault("x.bsp", part, [&] { parse(text); });
    };
    refuse("line 2: a string has no closing quote", "{\n\"classname");
    refuse("line 1: key 'a' has no value", "{ \"a\" }");
    refuse("line 1: key 'a' has no value", "{ \"a\"");
    refuse("line 3: entity 0 has no closing brace", "{\n\"a\" \"b\"\n");
    refuse("line 1: entity 1 holds another '{'", "{} { {");
    refuse("found 'worldspawn' where '{' begins an entity", "worldspawn {}");
    refuse("found '}' where '{' begins an entity", "}");
    std::string many = "{";
    for (int i = 0; i < 2000; ++i)
        many += " k" + std::to_string(i) + " v";
    refuse("more than 1024 keys", many + "}");
}

} // namespace
} // namespace vigil
