// SPDX-License-Identifier: GPL-2.0-or-later
// Sorting the command line.
#include "console/command_line.h"

#include "common/error.h"
#include "common/scratch_folder.h"

namespace vigil {
namespace {

using Words = std::vector<std::string>;
using Sets = std::vector<std::pair<std::string, std::string>>;

CommandLine parse(std::vector<const char*> words) {
    return parse_command_line(words);
}

TEST(CommandLine, SetsBeforeTheFirstCommandAndStartVariablesComeEarly) {
    const CommandLine line = parse({"+set", "pt_spp", "4", "+map", "mine", "+set", "pt_spp", "8",
                                    "+SET", "game", "other", "+screenshot", "a"});
    EXPECT_EQ(line.early_sets, (Sets{{"pt_spp", "4"}, {"game", "other"}}));
    EXPECT_EQ(line.commands,
              (std::vector<Words>{{"map", "mine"}, {"set", "pt_spp", "8"}, {"screenshot", "a"}}));
}

TEST(CommandLine, NumbersWithAPlusAreArguments) {
    const CommandLine line = parse({"+setviewpos", "+5", "+.5", "-3", "+", "+wait", "2"});
    EXPECT_EQ(line.commands,
              (std::vector<Words>{{"setviewpos", "+5", "+.5", "-3", "+"}, {"wait", "2"}}));
}

TEST(CommandLine, WordsKeepSpacesAndSemicolons) {
    const CommandLine line = parse({"+set", "basedir", "/my games/a;b", "+echo", "x y"});
    EXPECT_EQ(line.early_sets, (Sets{{"basedir", "/my games/a;b"}}));
    EXPECT_EQ(line.commands, (std::vector<Words>{{"echo", "x y"}}));
}

TEST(CommandLine, StrayWordsAndIncompleteSetsAreErrors) {
    EXPECT_NE(test::error_of([] { parse({"mine"}); }).find("mine"), std::string::npos);
    EXPECT_THROW(parse({"--frobnicate"}), Error);
    EXPECT_THROW(parse({"+set", "fov"}), Error);
    EXPECT_THROW(parse({"+set"}), Error);
    EXPECT_THROW(parse({"+set", "fov", "90", "100"}), Error);
}

TEST(CommandLine, HelpAndVersion) {
    EXPECT_TRUE(parse({"--help"}).help);
    EXPECT_TRUE(parse({"+map", "x", "--version"}).version);
    EXPECT_FALSE(parse({}).help);
    EXPECT_FALSE(command_line_help().empty());
}

TEST(CommandLine, EarlySetsStayOutOfTheConfigurationFile) {
    CvarRegistry variables;
    apply_early_sets(parse({"+set", "FOV", "120", "+set", "vid_driver", "headless"}), variables);
    EXPECT_EQ(variables->fov, 120.0f);
    EXPECT_EQ(variables->vid_driver, cvar_choice("vid_driver", "headless"));
    EXPECT_EQ(variables.archive_text(), "");
    EXPECT_THROW(apply_early_sets(parse({"+set", "no_such", "1"}), variables), Error);
}

} // namespace
} // namespace vigil
