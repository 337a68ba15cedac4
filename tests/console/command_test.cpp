// SPDX-License-Identifier: GPL-2.0-or-later
// Running commands: order, pauses, recursion, errors, and the built-in commands.
#include "console/command.h"

#include "common/error.h"
#include "common/scratch_folder.h"
#include "console/builtin_commands.h"

#include <fmt/ranges.h>
#include <map>

namespace vigil {
namespace {

using test::LogCapture;
using Words = std::vector<std::string>;

class CommandTest : public testing::Test {
protected:
    CommandTest() {
        add_builtin_commands(commands, [this](std::string_view name) {
            const auto file = files.find(std::string(name));
            if (file == files.end()) fail("{}: no such file in the game folders", name);
            const bool packed = name.starts_with("packed");
            return ScriptText{file->second, packed ? Trust::Archive : Trust::Person};
        });
        commands.add("do", "[WORDS...]: remembers its words", [this](CommandArguments arguments) {
            done.push_back(fmt::format("{}", fmt::join(arguments, " ")));
        });
        commands.add("explode", "fails", [](CommandArguments) { fail("bang"); });
    }

    CvarRegistry variables;
    CommandRegistry commands{variables};
    std::map<std::string, std::string> files;
    Words done;
    LogCapture log;
};

TEST_F(CommandTest, RunsInOrderAndGoesOnAfterFailures) {
    commands.execute_text("do 1; explode; nonsense; do 2; wait x; do \"3 4\"");
    EXPECT_EQ(done, (Words{"1", "2", "3 4"}));
    EXPECT_EQ(commands.failures(), 3);
    EXPECT_EQ(log.count(Severity::Error), 3u);
    EXPECT_TRUE(log.contains("explode: bang"));
    EXPECT_TRUE(log.contains("nonsense: unknown command"));
}

TEST_F(CommandTest, AnyStandardExceptionIsReported) {
    commands.add("oops", "throws", [](CommandArguments) { throw std::out_of_range("index 7"); });
    commands.execute_text("oops; do 1");
    EXPECT_TRUE(log.contains("oops: index 7"));
    EXPECT_EQ(done, Words{"1"});
}

TEST_F(CommandTest, NamesIgnoreCase) {
    commands.execute_text("DO 1; SET FOV 100; Fov 110");
    EXPECT_EQ(done, Words{"1"});
    EXPECT_EQ(variables->fov, 110.0f);
}

TEST_F(CommandTest, WaitShowsThatManyFrames) {
    commands.execute_text("do a; wait 2; do b; wait; do c; wait 0; do d");
    EXPECT_EQ(done, (Words{"a"}));
    commands.run_frame();
    EXPECT_EQ(done, (Words{"a"}));
    EXPECT_FALSE(commands.idle());
    commands.run_frame();
    EXPECT_EQ(done, (Words{"a", "b"}));
    commands.run_frame();
    EXPECT_EQ(done, (Words{"a", "b", "c", "d"}));
    EXPECT_TRUE(commands.idle());
}

TEST_F(CommandTest, AWaitHoldsOnlyItsOwnScript) {
    commands.execute_text("wait 2; do late");
    commands.execute_text("do typed");
    EXPECT_EQ(done, (Words{"typed"}));
    commands.run_frame();
    commands.run_frame();
    EXPECT_EQ(done, (Words{"typed", "late"}));
}

TEST_F(CommandTest, CommandsCanHoldTheirScriptUntilSomethingIsDone) {
    int frames_left = 3;
    commands.add("load", "takes 3 frames", [&](CommandArguments) {
        commands.pause_script_until([&] { return --frames_left == 0; });
    });
    commands.execute_text("load; do after");
    for (int i = 0; i < 2; ++i)
        commands.run_frame();
    EXPECT_TRUE(done.empty());
    commands.run_frame();
    EXPECT_EQ(done, Words{"after"});
}

TEST_F(CommandTest, AConditionThatThrowsEndsThePause) {
    commands.add("load", "fails", [&](CommandArguments) {
        commands.pause_script_until([]() -> bool { fail("the device is gone"); });
    });
    commands.execute_text("load; do after");
    commands.run_frame();
    EXPECT_TRUE(log.contains("the device is gone"));
    EXPECT_EQ(commands.failures(), 1);
    EXPECT_EQ(done, Words{"after"});
}

TEST_F(CommandTest, ExecRunsInPlaceAndWaitsInsideHoldTheCaller) {
    files["a.cfg"] = "do 1\nwait\ndo 2 // comment\n";
    commands.execute_text("exec a.cfg; do 3");
    EXPECT_EQ(done, (Words{"1"}));
    commands.run_frame();
    EXPECT_EQ(done, (Words{"1", "2", "3"}));
}

TEST_F(CommandTest, FailuresInFilesNameFileAndLine) {
    files["a.cfg"] = "do 1\n\npt_spp many\n";
    commands.execute_text("exec a.cfg; exec b.cfg");
    EXPECT_TRUE(log.contains("pt_spp: \"many\" is not a number")) << log.all();
    EXPECT_TRUE(log.contains("(a.cfg, line 3)")) << log.all();
    EXPECT_TRUE(log.contains("exec: b.cfg: no such file"));
    EXPECT_EQ(commands.failures(), 2);
}

TEST_F(CommandTest, EndlessRecursionStopsWithOneMessage) {
    files["loop.cfg"] = "exec loop.cfg; exec loop.cfg";
    commands.execute_text("exec loop.cfg; do never");
    EXPECT_EQ(commands.failures(), 1);
    EXPECT_TRUE(done.empty());
    commands.execute_text("alias l l; l; do never");
    EXPECT_EQ(commands.failures(), 2);
    commands.execute_text("do usable");
    EXPECT_EQ(done, Words{"usable"});
}

TEST_F(CommandTest, DoublingAliasesStopEvenWithinTheDepthLimit) {
    for (int i = 1; i < 30; ++i)
        commands.execute_text(fmt::format("alias a{} \"a{}; a{}\"", i, i - 1, i - 1));
    commands.execute_text("alias a0 \"alias x y\"; a29; do never");
    EXPECT_EQ(commands.failures(), 1);
    EXPECT_TRUE(done.empty());
}

TEST_F(CommandTest, AnAliasMayRepeatItselfFrameByFrame) {
    commands.execute_text("alias tick \"do t; wait; tick\"; tick");
    for (int i = 0; i < 99; ++i)
        commands.run_frame();
    EXPECT_EQ(done.size(), 100u);
    EXPECT_EQ(commands.failures(), 0);
    commands.clear();
    EXPECT_TRUE(commands.idle());
}

TEST_F(CommandTest, CommandsThatRunThemselvesStop) {
    commands.add("again", "runs itself", [&](CommandArguments) { commands.execute_text("again"); });
    commands.execute_text("again; do 1");
    EXPECT_EQ(commands.failures(), 1);
    EXPECT_EQ(done, Words{"1"});
}

TEST_F(CommandTest, ClearDropsTheRestOfEveryScript) {
    commands.add("quit", "ends", [&](CommandArguments) { commands.clear(); });
    commands.execute_text("wait; do 1");
    commands.execute_text("wait; quit; do 2");
    commands.execute_text("wait; do 3");
    commands.run_frame();
    commands.run_frame();
    EXPECT_EQ(done, Words{"1"});
    EXPECT_TRUE(commands.idle());
    commands.execute_text("do 4");
    EXPECT_EQ(done, (Words{"1", "4"}));
}

TEST_F(CommandTest, CommandsMayRemoveThemselves) {
    commands.add("once", "goes away", [&](CommandArguments) { commands.remove("once"); });
    commands.execute_text("once; once");
    EXPECT_EQ(commands.failures(), 1);
}

TEST_F(CommandTest, NamesAreTakenOnce) {
    EXPECT_THROW(commands.add("do", "", {}), Error);
    EXPECT_THROW(commands.add("fov", "", {}), Error);
    commands.execute_text("alias do x; alias fov x");
    EXPECT_EQ(commands.failures(), 2);
}

TEST_F(CommandTest, VariablesExpandOutsideQuotes) {
    commands.execute_text("do shot_$pt_nee-$pt_spp \"$pt_nee\" $ 5$; do $no_such");
    EXPECT_EQ(done, Words{"shot_vlc-1 $pt_nee $ 5$"});
    EXPECT_EQ(commands.failures(), 1);
}

TEST_F(CommandTest, PreSplitWordsAreNotSplitAgain) {
    const std::vector<Words> script = {{"do", "a;b c"}, {"wait", "1"}, {"do", "$fov"}};
    commands.execute_words(script);
    commands.run_frame();
    EXPECT_EQ(done, (Words{"a;b c", "90"}));
}

TEST_F(CommandTest, AMissingQuoteIsAnError) {
    commands.execute_text("do \"a b\ndo 2");
    EXPECT_EQ(done, Words{"2"});
    EXPECT_EQ(commands.failures(), 1);
}

TEST_F(CommandTest, VariablesAreShownSetResetAndToggled) {
    commands.execute_text("pt_spp");
    EXPECT_TRUE(log.contains("pt_spp \"1\"")) << log.all();
    commands.execute_text("pt_spp 4; set fov 100; seta vid_vsync 0; pt_nee 0; toggle pt_nee");
    EXPECT_EQ(variables->pt_spp, 4);
    EXPECT_EQ(variables->fov, 100.0f);
    EXPECT_EQ(variables->vid_vsync, 0);
    EXPECT_EQ(variables.get_text("pt_nee"), technique_infos[1].name);
    commands.execute_text("reset fov; toggle vid_vsync; toggle pt_spp 1 4 16; pt_nee " +
                          std::to_string(std::size(technique_infos) - 1));
    EXPECT_EQ(variables->fov, 90.0f);
    EXPECT_EQ(variables->vid_vsync, 1);
    EXPECT_EQ(variables->pt_spp, 16);
    EXPECT_EQ(variables.get_text("pt_nee"), std::rbegin(technique_infos)->name);
    commands.execute_text("toggle pt_nee; toggle pt_spp 1 4 16; toggle vid_vsync");
    EXPECT_EQ(variables.get_text("pt_nee"), "sll");
    EXPECT_EQ(variables->pt_spp, 1);
    EXPECT_EQ(variables->vid_vsync, 0);
    EXPECT_EQ(commands.failures(), 0) << log.all();

    commands.execute_text("set; set fov; set fov 1 2; fov 1 2; set nope 1; toggle outdir; "
                          "toggle sensitivity x y; reset; toggle vid_width");
    EXPECT_EQ(commands.failures(), 9) << log.all();
}

TEST_F(CommandTest, StartVariablesTellThatTheyAreReadAtTheStart) {
    commands.execute_text("set game other");
    EXPECT_EQ(variables->game, "other");
    EXPECT_TRUE(log.contains("read when the program starts"));
}

TEST_F(CommandTest, ListsAndHelp) {
    commands.execute_text("cvarlist vid_");
    EXPECT_TRUE(log.contains("vid_width"));
    EXPECT_FALSE(log.contains("pt_spp"));
    commands.execute_text("cvarlist; cmdlist; help; help exec; help fov; echo hello  world");
    EXPECT_TRUE(log.contains("pt_spp"));
    EXPECT_TRUE(log.contains("exec FILE"));
    EXPECT_TRUE(log.contains("hello world"));
    commands.execute_text("alias a b; alias; alias a; unalias a");
    EXPECT_EQ(commands.failures(), 0) << log.all();
    commands.execute_text("help nope; unalias a; alias a");
    EXPECT_EQ(commands.failures(), 3);
}

TEST_F(CommandTest, TakesAsManyWordsAsItsHelpSays) {
    const auto counts = [&](std::string_view arguments) {
        std::string taken;
        commands.add("take", fmt::format("{}: takes words", arguments),
                     [&](CommandArguments words) { taken += std::to_string(words.size()); });
        commands.execute_text("take; take 1; take 1 2; take 1 2 3; take 1 2 3 4");
        commands.remove("take");
        return taken;
    };
    EXPECT_EQ(counts(""), "0");
    EXPECT_EQ(counts("A B"), "2");
    EXPECT_EQ(counts("A [B]"), "12");
    EXPECT_EQ(counts("[A [B...]]"), "01234");
    EXPECT_EQ(counts("A [B] [C D]"), "124");
    EXPECT_EQ(counts("A B..."), "234");
    EXPECT_TRUE(log.contains("take: usage: take A [B]: takes words"));
}

TEST_F(CommandTest, ArchivedTextRunsAsAScript) {
    variables.set("fov", "101.5");
    variables.set("vid_width", "320");
    const std::string text = variables.archive_text();
    variables.reset("fov");
    variables.reset("vid_width");
    commands.execute_text(text, "config.cfg");
    EXPECT_EQ(variables->fov, 101.5f);
    EXPECT_EQ(variables->vid_width, 320);
    EXPECT_EQ(commands.failures(), 0) << log.all();
}

TEST_F(CommandTest, ScriptsOfArchivesCannotSetGuardedVariables) {
    files["packed.cfg"] = "set outdir /etc\nvid_width 1\nseta vid_fullscreen 1\ntoggle vid_vsync\n"
                          "reset outdir\nset game other\nset basedir /\nset timedemo_json x\n"
                          "set vk_device 1\nset vid_driver sdl\nset pt_spp 4\nset fov 100\n";
    variables.set("outdir", "mine");
    commands.execute_text("exec packed.cfg");
    EXPECT_EQ(commands.failures(), 10);
    EXPECT_TRUE(log.contains("outdir: not set"));
    EXPECT_TRUE(log.contains("(packed.cfg, line 1)"));
    for (const CvarInfo& info : cvar_infos) {
        if (!info.guarded || info.name == "outdir") continue;
        EXPECT_EQ(variables.get_text(info.name), cvar_default_text(info)) << info.name;
    }
    EXPECT_EQ(variables->outdir, "mine");
    // The others are set, but the configuration file keeps what it had.
    EXPECT_EQ(variables->pt_spp, 4);
    EXPECT_EQ(variables->fov, 100.0f);
    EXPECT_EQ(variables.archive_text(), "");
}

TEST_F(CommandTest, WhatAnArchiveMadeStaysItsOwn) {
    files["packed.cfg"] = "alias later \"wait 2; vid_width 320; do later\"\nexec own.cfg\n"
                          "alias mine \"vid_width 321\"\n";
    files["own.cfg"] = "vid_height 99\n";
    commands.execute_text("alias mine \"vid_width 111\"; exec packed.cfg");
    EXPECT_EQ(commands.failures(), 1) << "a person's file, but the archive's doing";
    commands.execute_text("later"); // a person runs the archive's alias
    commands.run_frame();
    commands.run_frame();
    EXPECT_EQ(commands.failures(), 2);
    EXPECT_EQ(done, (Words{"later"}));
    commands.execute_text("mine"); // replaced by the archive
    EXPECT_EQ(commands.failures(), 3);
    EXPECT_EQ(variables->vid_width, 640);
    EXPECT_EQ(variables->vid_height, 360);
    commands.execute_text("exec own.cfg; vid_width 320"); // a person again
    EXPECT_EQ(variables->vid_height, 99);
    EXPECT_EQ(variables->vid_width, 320);
}

TEST_F(CommandTest, TextsThatDoubleThemselvesStop) {
    std::string script = "set outdir xxxxxxxxxxxxxxxx\n";
    for (int i = 0; i < 60; ++i)
        script += "set outdir $outdir$outdir\n";
    script += "do";
    for (int i = 0; i < 1000; ++i)
        script += " $outdir";
    commands.execute_text(script);
    EXPECT_EQ(variables->outdir.size(), cvar_max_bytes);
    EXPECT_TRUE(log.contains("outdir: the text has 8192 bytes (limit 4096)"));
    EXPECT_TRUE(log.contains("do: the command is longer than 65536 bytes"));
    EXPECT_TRUE(done.empty());
}

TEST_F(CommandTest, ScriptsThatPileUpStop) {
    std::string lines = "exec big.cfg\n";
    for (int i = 0; i < 60'000; ++i)
        lines += "x\n";
    files["big.cfg"] = lines;
    commands.execute_text("exec big.cfg");
    EXPECT_TRUE(log.contains("exec: more than 100000 commands wait to run; stopped"));
    EXPECT_EQ(commands.failures(), 1);

    // A file that takes long to read, again and again.
    files["short.cfg"] = "do\n//" + std::string(1'000'000, ' ');
    std::string calls;
    for (int i = 0; i < 1000; ++i)
        calls += "exec short.cfg\n";
    commands.execute_text(calls);
    EXPECT_EQ(done.size(), 33u);
    EXPECT_EQ(commands.failures(), 2);
    EXPECT_TRUE(log.contains("exec: scripts or aliases call each other without end; stopped"));
    for (int i = 0; i < 2000; ++i)
        commands.execute_text(fmt::format("alias a{} b", i));
    EXPECT_EQ(commands.aliases().size(), 1024u);
    EXPECT_TRUE(log.contains("there are 1024 aliases already"));
}

} // namespace
} // namespace vigil
