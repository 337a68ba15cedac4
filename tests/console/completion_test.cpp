// SPDX-License-Identifier: GPL-2.0-or-later
// Completion of console lines.
#include "common/error.h"
#include "console/builtin_commands.h"
#include "console/command.h"

#include <gtest/gtest.h>
#include <random>

namespace vigil {
namespace {

using Words = std::vector<std::string>;

class CompletionTest : public testing::Test {
protected:
    CompletionTest() {
        add_builtin_commands(commands, [](std::string_view) { return ScriptText(); });
        commands.add(
            "map", "NAME: loads a level", [](CommandArguments) {},
            [](CommandArguments finished) {
                return finished.empty() ? Words{"warehouse", "mine", "many", "a b"} : Words();
            });
    }

    CvarRegistry variables;
    CommandRegistry commands{variables};
};

TEST_F(CompletionTest, FirstWordsAreCommandsAliasesAndVariables) {
    commands.set_alias("mapcycle", "map mine");
    const Completion result = commands.complete("MA");
    EXPECT_EQ(result.candidates, (Words{"map", "mapcycle"}));
    EXPECT_EQ(result.common, "map");
    EXPECT_EQ(result.word_begin, 0u);
    EXPECT_EQ(commands.complete("vid_wi").candidates, Words{"vid_width"});
    EXPECT_TRUE(commands.complete("zzz").candidates.empty());
    EXPECT_FALSE(commands.complete("").candidates.empty());
}

TEST_F(CompletionTest, ArgumentsComeFromTheCommand) {
    Completion result = commands.complete("map m");
    EXPECT_EQ(result.candidates, (Words{"many", "mine"}));
    EXPECT_EQ(result.common, "m");
    EXPECT_EQ(result.word_begin, 4u);
    EXPECT_EQ(commands.complete("map ").candidates.size(), 4u);
    EXPECT_TRUE(commands.complete("map mine ").candidates.empty());
    EXPECT_TRUE(commands.complete("nope ").candidates.empty());
}

TEST_F(CompletionTest, OnlyTheLastCommandOfTheLineCounts) {
    EXPECT_EQ(commands.complete("wait 5; map wa").candidates, Words{"warehouse"});
    EXPECT_EQ(commands.complete("map mine;vid_wi").candidates, Words{"vid_width"});
}

TEST_F(CompletionTest, OpenQuotesHoldTheWord) {
    const Completion result = commands.complete("map \"a");
    EXPECT_EQ(result.candidates, Words{"a b"});
    EXPECT_EQ(result.word_begin, 5u);
    EXPECT_EQ(commands.complete("map \"a ").candidates, Words{"a b"});
}

TEST_F(CompletionTest, VariablesOfferTheirChoices) {
    EXPECT_EQ(commands.complete("pt_tonemap ").candidates, (Words{"filmic", "none", "reinhard"}));
    EXPECT_EQ(commands.complete("set pt_nee p").candidates, Words{"power"});
    EXPECT_EQ(commands.complete("toggle pt_ne").candidates, Words{"pt_nee"});
    EXPECT_TRUE(commands.complete("pt_nee sll p").candidates.empty());
    EXPECT_TRUE(commands.complete("pt_spp ").candidates.empty());
}

TEST_F(CompletionTest, AnyLineIsFine) {
    std::mt19937 random(11);
    const std::string_view alphabet("mapset_ \";/$\x80", 13);
    for (int round = 0; round < 3000; ++round) {
        std::string line;
        for (auto length = random() % 20; length > 0; --length)
            line += alphabet[random() % alphabet.size()];
        const Completion result = commands.complete(line);
        EXPECT_LE(result.word_begin, line.size());
    }
}

} // namespace
} // namespace vigil
