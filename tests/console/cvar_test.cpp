// SPDX-License-Identifier: GPL-2.0-or-later
// The variable registry: every row of the table behaves as its type and range say.
#include "console/cvar.h"

#include "common/error.h"
#include "common/scratch_folder.h"
#include "common/sentence_fault.h"
#include "console/builtin_commands.h"
#include "console/preset.h"

#include <cmath>
#include <limits>
#include <set>

namespace vigil {

// Names the parameter in test output by its variable instead of by its bytes.
void PrintTo(const CvarInfo& info, std::ostream* stream) {
    *stream << info.name;
}

namespace {

using test::error_of;
using test::LogCapture;

class EveryCvar : public testing::TestWithParam<CvarInfo> {};

TEST_P(EveryCvar, DefaultTextIsAcceptedAndChangesNothing) {
    CvarRegistry registry;
    const std::string text = registry.get_text(GetParam().name);
    const LogCapture log;
    registry.set(GetParam().name, text);
    EXPECT_EQ(registry.get_text(GetParam().name), text);
    EXPECT_EQ(registry.changes(), 0u);
    EXPECT_TRUE(log.lines.empty()) << log.all();
}

TEST_P(EveryCvar, RefusesWhatItsTypeCannotHoldAndKeepsItsValue) {
    CvarRegistry registry;
    const CvarInfo& info = GetParam();
    const std::string before = registry.get_text(info.name);
    if (info.type == CvarType::String) {
        for (const char* text : {"a\"b", "a\nb", "\x01", "\x7f"})
            EXPECT_THROW(registry.set(info.name, text), Error);
    } else {
        for (const char* text : {"", " ", "nan", "-nan", "NaN", "x", "1x", "1 2", "0x10", "+-1",
                                 "--1", "1e999", "1,5", "none|"})
            EXPECT_THROW(registry.set(info.name, text), Error) << info.name << " = " << text;
    }
    EXPECT_EQ(registry.get_text(info.name), before);
    EXPECT_EQ(registry.changes(info.name), 0u);
}

TEST_P(EveryCvar, ClampsNumbersOutOfRangeWithOneWarning) {
    const CvarInfo& info = GetParam();
    if (info.type != CvarType::Integer && info.type != CvarType::Real) GTEST_SKIP() << "no range";
    for (const bool high : {false, true}) {
        CvarRegistry registry;
        const LogCapture log;
        const double end = high ? info.maximum : info.minimum;
        registry.set(info.name, high ? "1e30" : "-1e30");
        EXPECT_FLOAT_EQ(std::stof(registry.get_text(info.name)), static_cast<float>(end));
        EXPECT_EQ(log.count(Severity::Warning), 1u);
        EXPECT_TRUE(log.contains(info.name));

        // The end of the range itself is in it, however it is rounded.
        registry.set(info.name, registry.get_text(info.name));
        EXPECT_EQ(log.lines.size(), 1u) << log.all();
    }
}

TEST_P(EveryCvar, HasHelpAndAUniqueNameInLowerCase) {
    const CvarInfo& info = GetParam();
    EXPECT_FALSE(info.help.empty());
    EXPECT_EQ(info.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"),
              std::string_view::npos);
    EXPECT_EQ(find_cvar(info.name)->help, info.help);
    if (info.type == CvarType::Choice) {
        std::set<std::string_view> names;
        for (int i = 0; i < choice_count(info.choices); ++i)
            names.insert(choice_name(info.choices, i));
        EXPECT_EQ(names.size(), static_cast<std::size_t>(choice_count(info.choices)));
    }
}

INSTANTIATE_TEST_SUITE_P(Table, EveryCvar, testing::ValuesIn(cvar_infos),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(Cvar, ChoicesAreSetByNameInAnyCaseAndByIndex) {
    CvarRegistry registry;
    registry.set("pt_nee", "POWER");
    EXPECT_EQ(registry->pt_nee, cvar_choice("pt_nee", "power"));
    EXPECT_EQ(registry->pt_nee, static_cast<int>(Technique::power));
    registry.set("pt_nee", "1");
    EXPECT_EQ(registry.get_text("pt_nee"), technique_infos[1].name);
    const std::string too_large = std::to_string(std::size(technique_infos));
    for (const char* text :
         {too_large.c_str(), "-1", "1.0", "sl", "sll|uniform", "99999999999999999999"})
        EXPECT_NE(error_of([&] { registry.set("pt_nee", text); }).find(technique_choices),
                  std::string::npos);
    EXPECT_EQ(registry->pt_nee, 1);
}

TEST(Cvar, IntegersRefuseFractionsAndTakeWholeNumbersInAnySpelling) {
    CvarRegistry registry;
    EXPECT_THROW(registry.set("pt_spp", "1.5"), Error);
    registry.set("pt_spp", " +4e1 ");
    EXPECT_EQ(registry->pt_spp, 40);
    registry.set("pt_seed", "2147483647");
    EXPECT_EQ(registry->pt_seed, 2147483647);
}

TEST(Cvar, RealsSurviveTheWayThroughText) {
    CvarRegistry registry;
    for (const float value : {0.1f, 1.0f / 3.0f, 123456.78f, 1e-30f}) {
        registry.set(&CvarValues::pt_exposure, value);
        const std::string text = registry.get_text("pt_exposure");
        registry.reset("pt_exposure");
        registry.set("pt_exposure", text);
        EXPECT_EQ(registry->pt_exposure, value) << text;
    }
}

TEST(Cvar, TypedSetFollowsTheSameRules) {
    CvarRegistry registry;
    const LogCapture log;
    registry.set(&CvarValues::pt_sun_size, -1.0f);
    registry.set(&CvarValues::pt_sun_size, 180.0f);
    EXPECT_TRUE(log.lines.empty()) << log.all();
    registry.set(&CvarValues::pt_spp, 1 << 30);
    EXPECT_EQ(registry->pt_spp, 4096);
    EXPECT_EQ(log.count(Severity::Warning), 1u);
    EXPECT_THROW(registry.set(&CvarValues::pt_exposure, std::nanf("")), Error);
    EXPECT_THROW(registry.set(&CvarValues::pt_view, 99), Error);
    EXPECT_THROW(registry.set(&CvarValues::outdir, "a\nb"), Error);
    registry.set(&CvarValues::outdir, "pictures");
    EXPECT_EQ(registry->outdir, "pictures");
}

TEST(Cvar, CountsChangesOnlyWhenTheValueBecomesAnother) {
    CvarRegistry registry;
    registry.set("pt_seed", "4");
    registry.set("pt_seed", "4");
    registry.set("fov", "100");
    EXPECT_EQ(registry.changes("pt_seed"), 1u);
    EXPECT_EQ(registry.changes(&CvarValues::fov), 1u);
    EXPECT_EQ(registry.changes(), 2u);
    registry.reset("pt_seed");
    EXPECT_EQ(registry.changes("pt_seed"), 2u);
    EXPECT_EQ(registry->pt_seed, 0);
}

TEST(Cvar, UnknownNamesAreErrors) {
    CvarRegistry registry;
    EXPECT_NE(error_of([&] { registry.set("no_such", "1"); }).find("no_such"), std::string::npos);
    EXPECT_THROW(registry.get_text("no_such"), Error);
    EXPECT_THROW(registry.reset(""), Error);
    EXPECT_THROW(registry.changes("no_such"), Error);
}

TEST(Cvar, ArchiveHoldsWhatAPersonChangedAndNotTheCommandLine) {
    CvarRegistry registry;
    registry.set("fov", "110");
    registry.set("pt_seed", "8"); // lasts for the session only
    registry.set_for_this_run("vid_width", "64");
    registry.set("vid_height", "480");
    registry.set_for_this_run("vid_height", "32");
    EXPECT_EQ(registry->vid_width, 64);
    EXPECT_EQ(registry->vid_height, 32);
    EXPECT_EQ(registry.archive_text(), "set fov \"110\"\nset vid_height \"480\"\n");
    registry.set("vid_width", "128");
    registry.reset("fov");
    EXPECT_EQ(registry.archive_text(), "set vid_height \"480\"\nset vid_width \"128\"\n");
}

TEST(Cvar, ThePresetSetsItsVariablesAndFollowsThem) {
    ASSERT_EQ(std::size(presets()) + 1, choice_names(*find_cvar("pt_preset")).size());
    for (std::size_t i = 0; i < presets().size(); ++i)
        EXPECT_EQ(choice_names(*find_cvar("pt_preset"))[i], presets()[i].name);
    EXPECT_EQ(choice_names(*find_cvar("pt_preset")).back(), custom_preset);
    for (const PresetSetting& setting : presets()[0].settings)
        EXPECT_EQ(find_cvar(setting.variable)->life, CvarLife::Archived) << setting.variable;

    CvarRegistry registry;
    for (const Preset& preset : presets()) {
        registry.set("pt_preset", preset.name);
        EXPECT_EQ(registry.get_text("pt_preset"), preset.name);
        for (const PresetSetting& setting : preset.settings)
            EXPECT_EQ(registry.get_text(setting.variable), setting.value) << preset.name;
    }
    registry.set("pt_preset", "fast");
    registry.set("pt_light_points", "5");
    EXPECT_EQ(registry.get_text("pt_preset"), "custom");
    registry.set("pt_preset", "custom"); // changes nothing
    EXPECT_EQ(registry->pt_light_points, 5);
    EXPECT_EQ(registry.get_text("pt_guide"), "brdf");
    registry.set("pt_light_points", "4");
    EXPECT_EQ(registry.get_text("pt_preset"), "fast");
    registry.set("pt_seed", "3"); // none of its settings
    EXPECT_EQ(registry.get_text("pt_preset"), "fast");
    registry.set("pt_preset", "custom");
    EXPECT_EQ(registry.get_text("pt_preset"), "fast");
    registry.reset("pt_preset");
    EXPECT_EQ(registry->pt_light_points, 8);
    EXPECT_EQ(registry.get_text("pt_preset"), "balanced");
    registry.set(&CvarValues::pt_preset, cvar_choice("pt_preset", "paper"));
    EXPECT_EQ(registry->pt_env_nee, 0);
    registry.reset("pt_env_nee");
    EXPECT_EQ(registry.get_text("pt_preset"), "custom");
}

// What the configuration file keeps brings the same state back, and a preset is one line of it.
TEST(Cvar, QualitySurvivesQuitting) {
    const std::string rest = "set vid_width \"800\"\n";
    struct Case {
        std::vector<std::pair<std::string, std::string>> set, set_for_this_run;
        std::string kept, preset;
    };
    const Case cases[] = {
        {{}, {}, "", "balanced"},
        {{{"pt_preset", "fast"}}, {}, "set pt_preset \"fast\"\n", "fast"},
        {{{"pt_guide", "brdf"},
          {"pt_light_points", "4"},
          {"pt_vlc_bucket", "16"},
          {"pt_vlc_adapt", "0"},
          {"pt_vlc_explore", "0.03"},
          {"pt_indirect_rate", "half"}},
         {},
         "set pt_preset \"fast\"\n",
         "fast"},
        {{{"pt_preset", "fast"}, {"pt_spp", "2"}},
         {},
         "set pt_guide \"brdf\"\nset pt_indirect_rate \"half\"\nset pt_light_points \"4\"\n"
         "set pt_preset \"custom\"\nset pt_spp \"2\"\nset pt_vlc_adapt \"0\"\nset pt_vlc_bucket "
         "\"16\"\n"
         "set pt_vlc_explore \"0.03\"\n",
         "custom"},
        {{{"pt_preset", "fast"}, {"pt_preset", "balanced"}}, {}, "", "balanced"},
        {{{"pt_preset", "paper"}, {"pt_env_nee", "1"}, {"pt_env_nee", "0"}},
         {},
         "set pt_preset \"paper\"\n",
         "paper"},
        // The command line's are not kept, whatever they make of the preset.
        {{{"pt_preset", "fast"}}, {{"pt_spp", "3"}}, "set pt_preset \"fast\"\n", "fast"},
        {{{"pt_preset", "fast"}}, {{"pt_preset", "paper"}}, "set pt_preset \"fast\"\n", "fast"},
        {{}, {{"pt_preset", "accurate"}}, "", "balanced"},
    };
    for (const Case& one : cases) {
        CvarRegistry registry;
        for (const auto& [name, value] : one.set)
            registry.set(name, value);
        for (const auto& [name, value] : one.set_for_this_run)
            registry.set_for_this_run(name, value);
        registry.set("vid_width", "800");
        EXPECT_EQ(registry.archive_text(), one.kept + rest);

        CvarRegistry next; // the next start
        CommandRegistry commands(next);
        add_builtin_commands(commands, {});
        commands.execute_text(registry.archive_text());
        EXPECT_EQ(commands.failures(), 0);
        EXPECT_EQ(next.get_text("pt_preset"), one.preset) << one.kept;
        EXPECT_EQ(next.archive_text(), registry.archive_text());
        if (!one.set_for_this_run.empty()) continue;
        for (const CvarInfo& info : cvar_infos)
            EXPECT_EQ(next.get_text(info.name), registry.get_text(info.name)) << info.name;
    }
}

// Sentences of at most 25 words, each with a capital letter or a value in front.
TEST(Cvar, HelpIsPlainEnglish) {
    for (const CvarInfo& info : cvar_infos)
        EXPECT_EQ(test::sentence_fault(info.help), "") << info.name << ": " << info.help;
    for (const TechniqueInfo& info : technique_infos)
        EXPECT_EQ(test::sentence_fault(info.help), "") << info.name;
    for (const GuiderInfo& info : guider_infos)
        EXPECT_EQ(test::sentence_fault(info.help), "") << info.name;
    for (const ViewInfo& info : view_infos)
        EXPECT_EQ(test::sentence_fault(info.help), "") << info.name;
    for (const Preset& preset : presets())
        EXPECT_EQ(test::sentence_fault(preset.purpose), "") << preset.name;
}

TEST(Cvar, GpuValuesFollow) {
    CvarRegistry registry;
    registry.set("pt_sky_scale", "2.5");
    registry.set("pt_view", "depth");
    const GpuSettings gpu = gpu_settings(registry.values());
    EXPECT_EQ(gpu.pt_sky_scale, 2.5f);
    EXPECT_EQ(gpu.pt_view, cvar_choice("pt_view", "depth"));
    EXPECT_EQ(gpu.pt_sll_max, 32);
}

TEST(Cvar, RadianceDependsOnWhatTheTableSays) {
    for (const CvarInfo& info : cvar_infos) {
        if (info.type == CvarType::String || info.name == "pt_preset") continue;
        CvarRegistry registry;
        const refresh::Settings before = registry.values();
        registry.set(info.name, "1");
        if (registry.get_text(info.name) == cvar_default_text(info))
            registry.set(info.name, info.maximum > 1.0 ? "2" : "0");
        ASSERT_NE(registry.get_text(info.name), cvar_default_text(info)) << info.name;
        const bool is_renderers = info.name != "pt_light_styles" &&
                                  (info.name.starts_with("pt_") || info.name.starts_with("vid_") ||
                                   info.name.starts_with("flt_"));
        const bool same = !is_renderers || info.affects < Affects::Picture;
        EXPECT_EQ(same_radiance(registry.values(), before), same) << info.name;
    }
}

TEST(Cvar, ListsByPrefixInOrder) {
    const auto rows = list_cvars("VID_");
    ASSERT_FALSE(rows.empty());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_TRUE(rows[i]->name.starts_with("vid_"));
        if (i > 0) {
            EXPECT_LT(rows[i - 1]->name, rows[i]->name);
        }
    }
    EXPECT_EQ(list_cvars().size(), std::size(cvar_infos));
    EXPECT_TRUE(list_cvars("zzz").empty());
}

} // namespace

} // namespace vigil
