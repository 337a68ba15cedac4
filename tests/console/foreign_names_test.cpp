// SPDX-License-Identifier: GPL-2.0-or-later
// Names of Quake II RTX: every row is sound, and the console takes them.
#include "common/error.h"
#include "common/scratch_folder.h"
#include "common/sentence_fault.h"
#include "console/builtin_commands.h"
#include "console/command_line.h"

#include <algorithm>

namespace vigil {
namespace {

using test::LogCapture;

class ForeignNameTest : public testing::Test {
protected:
    ForeignNameTest() {
        add_builtin_commands(commands, {});
        commands.add("screenshot", "[NAME]: Writes the picture.",
                     [this](CommandArguments words) { shots.emplace_back(words[0]); });
    }
    CvarRegistry variables;
    CommandRegistry commands{variables};
    std::vector<std::string> shots;
    LogCapture log;
};

TEST_F(ForeignNameTest, EveryRowIsSound) {
    EXPECT_TRUE(std::ranges::is_sorted(foreign_names(), {}, &ForeignName::name));
    for (const ForeignName& row : foreign_names()) {
        EXPECT_EQ(find_foreign_name(row.name), &row);
        EXPECT_EQ(find_cvar(row.name), nullptr) << row.name << " is a variable of ours";
        EXPECT_FALSE(commands.commands().contains(row.name)) << row.name;
        EXPECT_EQ(test::sentence_fault(row.about), "") << row.name;
        if (find_cvar(row.target) != nullptr) {
            // Whatever is usual there has a meaning here.
            for (const char* value : {"0", "1", "2", "60"})
                EXPECT_NO_THROW(variables.set(row.target, converted_value(row, value)))
                    << row.name << " " << value;
            EXPECT_FALSE(row.convert.empty()) << row.name;
        } else {
            EXPECT_TRUE(row.target.empty() || commands.commands().contains(row.target)) << row.name;
            EXPECT_TRUE(row.convert.empty()) << row.name;
        }
    }
    EXPECT_EQ(find_foreign_name("tm_"), nullptr);
    EXPECT_EQ(find_foreign_name("zzz"), nullptr);
    EXPECT_EQ(find_foreign_name(""), nullptr);
}

TEST_F(ForeignNameTest, ValuesConvert) {
    const auto value = [](std::string_view name, std::string_view text) {
        return converted_value(*find_foreign_name(name), text);
    };
    EXPECT_EQ(value("pt_num_bounce_rays", "0"), "0");
    EXPECT_EQ(value("pt_accumulation_rendering", "2"), "1");
    EXPECT_EQ(value("profiler", "1"), "passes");
    EXPECT_EQ(value("tm_enable", "0"), "none");
    EXPECT_EQ(value("tm_reinhard", "1"), "reinhard");
    EXPECT_EQ(value("tm_exposure_bias", "-1.5"), "-1.5");
    EXPECT_EQ(value("sun_brightness", "10"), "1");
    EXPECT_EQ(value("physical_sky_brightness", "-1"), "0.5");
    EXPECT_EQ(value("drs_enable", "1"), "60");
    EXPECT_EQ(value("pt_num_bounce_rays", "0.5"), "1");
    EXPECT_EQ(value("pt_num_bounce_rays", "2"), "2");
    EXPECT_THROW(value("profiler", "on"), Error);
    EXPECT_THROW(value("sun_brightness", ""), Error);
}

TEST_F(ForeignNameTest, TheConsoleTakesThem) {
    commands.execute_text("set pt_num_bounce_rays 0; SUN_Brightness 5; seta tm_enable 0; "
                          "screenshotpng one; toggle profiler; help tm_enable; viewsize 50");
    EXPECT_EQ(commands.failures(), 0) << log.all();
    EXPECT_EQ(variables->pt_bounces, 0);
    EXPECT_EQ(variables->pt_sun_scale, 0.5f);
    EXPECT_EQ(variables.get_text("pt_tonemap"), "none");
    EXPECT_EQ(variables.get_text("scr_stats"), "groups");
    EXPECT_EQ(variables->vid_scale, 50);
    EXPECT_EQ(shots, std::vector<std::string>{"one"});
    EXPECT_TRUE(log.contains("pt_num_bounce_rays 0 is pt_bounces 0 here"));
    EXPECT_TRUE(log.contains("tm_enable is an alias for pt_tonemap, as Quake II RTX calls it. 0 is "
                             "none, more is filmic."));
    commands.execute_text("reset pt_num_bounce_rays; sun_angle; q2rtxlist drs");
    EXPECT_EQ(variables->pt_bounces, 1);
    EXPECT_TRUE(log.contains("pt_sun_size \"-1\""));
    EXPECT_TRUE(log.contains("drs_target is an alias for vid_fps_target"));

    // One line for what has no counterpart; a script goes on.
    const std::size_t before = log.lines.size();
    commands.execute_text("set tm_white_point 8; gr_enable 1");
    EXPECT_EQ(log.lines.size(), before + 2) << log.all();
    EXPECT_TRUE(log.contains("gr_enable of Quake II RTX has no counterpart here. There is no fog"));
    EXPECT_EQ(commands.failures(), 0);
    commands.execute_text("reset tm_white_point; tm_enable a b; profiler x");
    EXPECT_EQ(commands.failures(), 3);
    // Guarded variables are so by every name.
    commands.execute_text("viewsize 30", {}, Trust::Archive);
    EXPECT_EQ(variables->vid_scale, 50);
}

TEST_F(ForeignNameTest, CompletionKnowsThem) {
    const auto first = [&](std::string_view line) { return commands.complete(line).candidates; };
    EXPECT_EQ(first("pt_num"), std::vector<std::string>{"pt_num_bounce_rays"});
    EXPECT_EQ(first("set sun_br"), std::vector<std::string>{"sun_brightness"});
    EXPECT_EQ(first("help profi"), std::vector<std::string>{"profiler"});
    EXPECT_TRUE(first("tm_white").empty()); // nothing to set
}

TEST_F(ForeignNameTest, TheCommandLineSetsThemEarly) {
    const std::vector<const char*> words{
        "+set", "pt_num_bounce_rays", "0",  "+set", "gr_enable", "1",
        "+set", "viewsize",           "50", "+map", "mine"};
    const CommandLine line = parse_command_line(words);
    ASSERT_EQ(line.early_sets.size(), 2u);
    EXPECT_EQ(line.early_sets[0].first, "pt_bounces");
    EXPECT_EQ(line.early_sets[1].first, "vid_scale");
    EXPECT_EQ(line.commands.size(), 2u); // what has no counterpart is said when commands run
}

} // namespace
} // namespace vigil
