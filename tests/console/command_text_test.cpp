// SPDX-License-Identifier: GPL-2.0-or-later
// The splitter of console text.
#include "console/command_text.h"

#include <gtest/gtest.h>
#include <random>

namespace vigil {
namespace {

using Words = std::vector<std::string>;

std::vector<Words> split(std::string_view text) {
    std::vector<Words> commands;
    for (const CommandText& command : split_commands(text)) {
        commands.emplace_back();
        for (const CommandWord& word : command.words)
            commands.back().push_back(word.text);
    }
    return commands;
}

TEST(CommandText, SplitsAtNewlinesSemicolonsAndSpaces) {
    EXPECT_EQ(split("map  a;wait\t5\r\n\n;;screenshot x"),
              (std::vector<Words>{{"map", "a"}, {"wait", "5"}, {"screenshot", "x"}}));
    EXPECT_TRUE(split("").empty());
    EXPECT_TRUE(split(" ;\n; ").empty());
}

TEST(CommandText, QuotesProtectSpacesSemicolonsAndComments) {
    EXPECT_EQ(split("alias a \"echo b; echo c\" // text"),
              (std::vector<Words>{{"alias", "a", "echo b; echo c"}}));
    EXPECT_EQ(split("set basedir \"\""), (std::vector<Words>{{"set", "basedir", ""}}));
    EXPECT_EQ(split("set basedir \"/a b//c\""),
              (std::vector<Words>{{"set", "basedir", "/a b//c"}}));
}

TEST(CommandText, CommentsStartOnlyAtTheStartOfAWord) {
    EXPECT_EQ(split("echo a//b\n// whole line; echo c\necho d //e\necho f"),
              (std::vector<Words>{{"echo", "a//b"}, {"echo", "d"}, {"echo", "f"}}));
}

TEST(CommandText, KnowsLinesAndOpenQuotes) {
    const auto commands = split_commands("\necho a\n\n\"b c\necho d");
    ASSERT_EQ(commands.size(), 3u);
    EXPECT_EQ(commands[0].line, 2);
    EXPECT_EQ(commands[1].line, 4);
    EXPECT_TRUE(commands[1].open_quote);
    EXPECT_EQ(commands[2].line, 5);
    EXPECT_FALSE(commands[2].open_quote);
}

TEST(CommandText, QuotedWordsReadBack) {
    for (const char* word : {"plain", "", "two words", "a;b", "//c", "$pt_nee", "tab\there"})
        EXPECT_EQ(split(quote_word(word)), (std::vector<Words>{{word}})) << word;
}

TEST(CommandText, AnyBytesGiveCommandsWithWords) {
    std::mt19937 random(7);
    const std::string_view alphabet("ab \n;\"/$\\\0\x80\xff", 12);
    for (int round = 0; round < 5000; ++round) {
        std::string text;
        for (auto length = random() % 40; length > 0; --length)
            text += alphabet[random() % alphabet.size()];
        for (const CommandText& command : split_commands(text))
            EXPECT_FALSE(command.words.empty());
    }
}

} // namespace
} // namespace vigil
