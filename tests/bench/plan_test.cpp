// SPDX-License-Identifier: GPL-2.0-or-later
// What experiments consist of, and reports that go on after an interruption.
#include "bench/checkpoint.h"
#include "bench/plan.h"
#include "bench/plan_csv.h"
#include "common/error.h"
#include "common/output.h"
#include "common/scratch_folder.h"
#include "console/cvar.h"
#include "console/preset.h"
#include "shared/features.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace vigil::bench {

namespace {

using Words = std::vector<std::string>;

const auto plans = {&quality_plan, &adapt_plan, &ring_plan,    &timing_plan,
                    &scale_plan,   &trade_plan, &picture_plan, &economy_plan};

/// Sets and reads back: a name that exists, a value in its range.
void expect_value(const Setting& setting) {
    CvarRegistry variables;
    ASSERT_TRUE(find_cvar(setting.name)) << setting.name;
    variables.set(setting.name, setting.value);
    EXPECT_EQ(std::stod("0" + variables.get_text(setting.name)), std::stod("0" + setting.value))
        << setting.name;
}

} // namespace

TEST(Plan, PartsHaveNamesOfTheirOwnAndRowsThatExist) {
    for (const auto& make : plans) {
        for (const Words& words : {Words{}, Words{"--quick"}}) {
            const Plan plan = make(words);
            std::set<std::string> names;
            ASSERT_FALSE(plan.parts.empty()) << plan.name;
            for (const Part& part : plan.parts) {
                EXPECT_TRUE(names.insert(part.name).second) << plan.name << ' ' << part.name;
                std::set<std::string> labels;
                for (const QualityRow& row : part.options.rows) {
                    EXPECT_TRUE(labels.insert(row.label).second) << part.name << ' ' << row.label;
                    for (const Setting& setting : row.settings)
                        expect_value(setting);
                }
                EXPECT_TRUE(labels.contains(part.options.baseline)) << part.name;
            }
        }
    }
}

TEST(Plan, PartsAreChosenByTheBeginningsOfTheirNames) {
    Plan plan = scale_plan(Words{"--part", "lights", "--part", "triangles warehouse 1"});
    select_parts(plan);
    EXPECT_EQ(plan.parts.front().name, "lights many_10 10");
    EXPECT_EQ(plan.parts.back().name, "triangles warehouse 16");
    Plan none = quality_plan(Words{"--part", "cellar"});
    try {
        select_parts(none);
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("gallery"), std::string::npos);
    }
}

TEST(Plan, QuadtreesGetTheFramesTheyNeedWhereTheyLearnLate) {
    const auto warmups = [](const Words& words) {
        std::map<std::string, int> frames;
        for (const Part& part : trade_plan(words).parts)
            frames[part.name] = part.options.warmup;
        return frames;
    };
    auto usual = warmups({});
    EXPECT_EQ(usual["mine pt_cdq_bits"], 64);
    EXPECT_EQ(usual["mine techniques"], 64); // some of them guide rays
    EXPECT_EQ(usual["mine pt_sll_max"], usual["warehouse pt_sll_max"]);
    EXPECT_LT(usual["warehouse pt_cdq_bits"], 64);
    EXPECT_EQ(warmups({"--warmup", "3"})["mine pt_cdq_bits"], 3);
    EXPECT_LT(warmups({"--quick", "--level", "mine"})["mine pt_cdq_bits"], 64);
}

TEST(Plan, EveryShippedLevelIsMeasured) {
    for (const auto& make :
         {&quality_plan, &adapt_plan, &timing_plan, &trade_plan, &picture_plan, &economy_plan}) {
        const Plan plan = make({});
        std::set<std::string> levels;
        for (const Part& part : plan.parts)
            levels.insert(part.level);
        for (const MeasuredLevel& level : measured_levels)
            EXPECT_TRUE(levels.contains(std::string(level.name))) << plan.name << ' ' << level.name;
    }
    // Those that are compared in no table are in this one.
    std::set<std::string> levels;
    for (const Part& part : economy_plan({}).parts)
        levels.insert(part.level);
    const std::filesystem::path maps = std::filesystem::path(VIGIL_SOURCE_DIR) / "baseq2/maps";
    for (const auto& file : std::filesystem::directory_iterator(maps)) {
        if (file.path().extension() == ".bsp") {
            EXPECT_TRUE(levels.contains(file.path().stem().string())) << file.path();
        }
    }
}

TEST(Plan, EveryFeatureIsAddedAlone) {
    for (const Part& part : economy_plan(Words{"--level", "room"}).parts) {
        EXPECT_EQ(part.options.baseline, "auto");
        ASSERT_EQ(part.options.rows.size(), 2 + vkpt::scene_feature_rows.size());
        EXPECT_EQ(part.options.rows[1].label, "all");
        for (std::size_t i = 0; i < vkpt::scene_feature_rows.size(); ++i) {
            const QualityRow& row = part.options.rows[2 + i];
            EXPECT_EQ(row.label, vkpt::scene_feature_rows[i].name);
            EXPECT_EQ(row.settings.back().name, "pt_features");
            EXPECT_EQ(row.settings.back().value, row.label);
            EXPECT_TRUE(is_guided(row));
        }
    }
    for (const QualityRow& row : economy_plan(Words{"--technique", "sll"}).options.rows) {
        EXPECT_TRUE(row.label.ends_with(" sll")) << row.label;
        EXPECT_FALSE(is_guided(row)) << row.label;
    }
}

TEST(Plan, PicturesAreMeasuredInEverySituation) {
    const auto parts_of = [](const Words& words) {
        std::map<std::string, Part> parts;
        for (const Part& part : picture_plan(words).parts)
            parts.emplace(part.name, part);
        return parts;
    };
    const auto labels = [](const Part& part) {
        std::set<std::string> found;
        for (const QualityRow& row : part.options.rows)
            found.insert(row.label);
        return found;
    };
    const std::set<std::string> filters = {"raw", "temporal", "full", "svgf-like"};
    auto usual = parts_of({"--level", "warehouse", "--level", "gallery"});
    EXPECT_EQ(usual.size(), 11u); // gallery has no door
    EXPECT_TRUE(usual.contains("warehouse door"));
    EXPECT_EQ(labels(usual.at("gallery strobe")), filters);
    // Along routes every way of sampling, raw and filtered.
    const std::set<std::string> all = labels(usual.at("gallery route"));
    EXPECT_EQ(all.size(), filters.size() + 2 * technique_rows().size());
    EXPECT_TRUE(all.contains("full sll"));
    EXPECT_EQ(usual.at("gallery lamp").options.views, 1);
    // One technique in the place of the usual one, compared with its own raw pictures.
    const auto lists = parts_of({"--level", "warehouse", "--technique", "sll"});
    for (const auto& [name, part] : lists) {
        EXPECT_EQ(labels(part),
                  (std::set<std::string>{"raw sll", "temporal sll", "full sll", "svgf-like sll"}))
            << name;
        EXPECT_EQ(part.options.baseline, "raw sll");
    }
    EXPECT_THROW(picture_plan(Words{"--frames", "3"}), Error);
}

TEST(Plan, ResolutionsSeeTheSamePlaceAfterAsManyFrames) {
    for (const Words& words : {Words{}, Words{"--views", "3", "--seeds", "5"}}) {
        Plan plan = scale_plan(words);
        std::erase_if(plan.parts, [](const Part& part) { return part.axis != "resolution"; });
        ASSERT_EQ(plan.parts.size(), 5U);
        for (const Part& part : plan.parts) {
            EXPECT_EQ(part.options.views, plan.parts[0].options.views) << part.name;
            EXPECT_EQ(part.options.warmup, plan.parts[0].options.warmup) << part.name;
            if (!words.empty()) {
                EXPECT_EQ(part.options.seeds, 5) << part.name;
            }
        }
    }
}

TEST(Plan, TheDefaultIsAmongWhatIsTried) {
    // Each sweep has the row of its technique, whose variables are at their defaults.
    for (const Part& part : trade_plan({}).parts) {
        if (part.name.find(" pt_") == std::string::npos) continue;
        int defaults = 0;
        for (const QualityRow& row : part.options.rows)
            defaults += row.label.find('=') == std::string::npos;
        EXPECT_GE(defaults, 1) << part.name;
        for (const QualityRow& row : part.options.rows)
            for (const Setting& setting : row.settings) {
                if (row.label != setting.name + "=" + setting.value) continue;
                EXPECT_NE(cvar_default_text(*find_cvar(setting.name)), setting.value)
                    << row.label << " is the default";
            }
    }
}

TEST(Plan, ViewsAreEnoughForIntervals) {
    for (const auto& make : plans) {
        const Plan plan = make({});
        for (const Part& part : plan.parts) {
            const QualityOptions& options = part.options;
            if (options.measured == Measured::Times || options.measured == Measured::Turn ||
                options.measured == Measured::Economy) {
                EXPECT_GE(options.seeds, 6) << part.name; // flights, or runs at one place
                continue;
            }
            if (plan.name == "picture") continue; // no intervals
            EXPECT_GE(options.views, 4) << part.name;
            if (part.axis != "resolution") {
                EXPECT_GE(options.views * options.seeds, 6) << part.name;
            }
        }
    }
}

namespace {

using nlohmann::ordered_json;

/// A row of a report of `trade`: error times time over the default's, with the worst pixels and
/// without.
ordered_json trade_row(const std::string& label, const ordered_json& all,
                       const ordered_json& trimmed) {
    return {{"label", label},
            {"variables", {{"pt_nee", "lh"}, {label.substr(0, label.find('=')), "4"}}},
            {"mse", {{"ratio_at_equal_time", {{"value", all}}}}},
            {"trimmed_mse", {{"ratio_at_equal_time", {{"value", trimmed}}}}}};
}

ordered_json trade_part(const std::string& level, const std::vector<ordered_json>& rows) {
    return {{"part", level + " pt_lh_leaf"}, {"level", level}, {"baseline", "lh"}, {"rows", rows}};
}

ordered_json trade_report(const std::vector<ordered_json>& parts) {
    return {{"measured", "trade"}, {"commit", "abc"}, {"key", "123"},  {"finished", true},
            {"first_seed", 1},     {"seeds", 2},      {"parts", parts}};
}

} // namespace

TEST(Plan, WhatLooksBetterThanTheDefaultIsMeasuredAgain) {
    const test::ScratchFolder folder;
    const std::string path = (folder.path() / "trade.json").string();
    const auto confirm = [&](const ordered_json& report, const Words& more = {}) {
        write_file(path, report.dump());
        Words words = {"--trade", path};
        words.insert(words.end(), more.begin(), more.end());
        return confirm_plan(words);
    };
    // Better by the mean of both levels; where errors tell nothing there is nothing to measure.
    const ordered_json report = trade_report(
        {trade_part("warehouse", {trade_row("lh", 1.0, 1.0), trade_row("pt_lh_leaf=4", 1.1, 0.5),
                                  trade_row("pt_lh_leaf=1", 0.5, 1.2)}),
         trade_part("gallery",
                    {trade_row("pt_lh_leaf=4", 0.8, 1.5), trade_row("pt_lh_leaf=1", 0.5, 0.9)}),
         trade_part("mine", {trade_row("pt_lh_leaf=4", nullptr, nullptr)})});
    const Plan plan = confirm(report);
    ASSERT_EQ(plan.parts.size(), 2u);
    EXPECT_EQ(plan.parts[0].name, "warehouse pt_lh_leaf");
    EXPECT_EQ(plan.parts[1].level, "gallery");
    EXPECT_EQ(plan.about["trade"]["key"], "123");
    for (const Part& part : plan.parts) {
        const QualityOptions& options = part.options;
        ASSERT_EQ(options.rows.size(), 2u);
        EXPECT_EQ(options.baseline, "lh");
        EXPECT_EQ(options.rows[0].label, "lh");
        EXPECT_EQ(options.rows[1].label, "pt_lh_leaf=4");
        ASSERT_EQ(options.rows[1].settings.size(), 2u);
        EXPECT_EQ(options.rows[1].settings[1].name, "pt_lh_leaf");
        EXPECT_GE(options.views, 4);
        EXPECT_GE(options.seeds, 6);
        EXPECT_GT(options.first_seed, 2); // seeds 1 and 2 chose
    }
    EXPECT_THROW(confirm(report, {"--first-seed", "2"}), Error);
    EXPECT_NO_THROW(confirm(report, {"--first-seed", "3"}));

    EXPECT_TRUE(
        confirm(trade_report({trade_part("gallery", {trade_row("pt_lh_leaf=1", 1.1, 0.5)})}))
            .parts.empty());
    ordered_json unfinished = report;
    unfinished["finished"] = false;
    EXPECT_THROW(confirm(unfinished), Error);
    ordered_json other = report;
    other["measured"] = "quality";
    EXPECT_THROW(confirm(other), Error);
    EXPECT_THROW(confirm_plan(Words{"--trade", path + "x"}), Error);
    EXPECT_THROW(quality_plan(Words{"--trade", path}), Error);
}

TEST(Presets, TheDefaultsAreOneOfThem) {
    const Preset* preset = present_preset(CvarRegistry());
    ASSERT_NE(preset, nullptr);
    EXPECT_EQ(preset->name, "balanced");
}

TEST(Presets, SetTheSameVariablesAndAreTold) {
    std::set<std::string_view> variables;
    for (const PresetSetting& setting : presets().front().settings)
        variables.insert(setting.variable);
    for (const Preset& preset : presets()) {
        std::set<std::string_view> own;
        CvarRegistry values;
        for (const PresetSetting& setting : preset.settings) {
            own.insert(setting.variable);
            values.set(setting.variable, std::string(setting.value));
        }
        EXPECT_EQ(own, variables) << preset.name;
        EXPECT_EQ(present_preset(values), &preset);
        values.set("pt_spp", "7");
        EXPECT_EQ(present_preset(values), nullptr);
    }
}

TEST(Presets, PaperDepartsFromTheDefaultsAndOthersDoNot) {
    // What the paper says in numbers.
    const std::map<std::string, std::string, std::less<>> paper = {
        {"pt_nee", "vlc"},         {"pt_guide", "cdq"},          {"pt_spp", "1"},
        {"pt_env_nee", "0"},       {"pt_light_points", "1"},     {"pt_light_density", "area"},
        {"pt_vlc_explore", "0.1"}, {"pt_vlc_beside", "0"},       {"pt_vlc_adapt", "0"},
        {"pt_vlc_persist", "0"},   {"pt_explore_local", "0"},    {"pt_cdq_margin", "0.1"},
        {"pt_cdq_rays", "0"},      {"pt_cdq_migrations", "1"},   {"pt_vlc_weigh", "0"},
        {"pt_vlc_bucket", "32"},   {"pt_indirect_rate", "full"}, {"pt_cdq_adapt", "0"},
        {"pt_rest_after", "0"},    {"pt_learn_every", "1"},      {"pt_vlc_enough", "0"},
        {"pt_oct_start", "0"},     {"pt_guide_directions", "1"}, {"pt_guide_gain", "0"},
        {"pt_tail", "0"}};
    std::map<std::string, std::string, std::less<>> set;
    for (const PresetSetting& setting : find_preset("paper")->settings)
        set.emplace(setting.variable, setting.value);
    EXPECT_EQ(set, paper);
    for (const PresetSetting& setting : find_preset("balanced")->settings)
        EXPECT_EQ(setting.value, cvar_default_text(*find_cvar(setting.variable)))
            << setting.variable;
    EXPECT_EQ(find_preset("theirs"), nullptr);
}

TEST(Presets, AreRowsOfMeasurements) {
    const QualityRow row = preset_row("paper");
    EXPECT_EQ(row.label, "preset paper");
    EXPECT_TRUE(is_guided(row));
    EXPECT_EQ(row.settings.size(), find_preset("paper")->settings.size());
    EXPECT_THROW(preset_row("theirs"), Error);
    const auto labels = [](const Words& words) {
        std::set<std::string> result;
        for (const QualityRow& one : quality_plan(words).options.rows)
            result.insert(one.label);
        return result;
    };
    EXPECT_TRUE(labels({}).contains("preset paper"));
    EXPECT_EQ(labels({"--technique", "sll", "--preset", "fast", "--preset", "paper"}),
              (std::set<std::string>{"sll", "preset fast", "preset paper"}));
}

TEST(Checkpoint, GoesOnWithWhatAnInterruptionLeft) {
    const test::ScratchFolder folder;
    const std::filesystem::path path = folder.path() / "report.json";
    const nlohmann::ordered_json head = {{"measured", "x"}, {"seeds", 3}};
    {
        Checkpoint first(path, head, false);
        first.add("a", {{"value", 1}});
    }
    {
        Checkpoint second(path, head, false);
        ASSERT_NE(second.find("a"), nullptr);
        EXPECT_EQ((*second.find("a"))["value"], 1);
        EXPECT_EQ(second.find("b"), nullptr);
        second.add("b", {{"value", 2}});
        second.finish();
    }
    // Finished: another run measures anew, unless it is to be kept.
    EXPECT_EQ(Checkpoint(path, head, false).find("a"), nullptr);
    EXPECT_NE(Checkpoint(path, head, true).find("b"), nullptr);
    // Another measurement is another report.
    EXPECT_EQ(Checkpoint(path, {{"measured", "x"}, {"seeds", 4}}, true).find("a"), nullptr);
    // A damaged one is none.
    write_file(path, "{\"measured\": \"x\", ");
    EXPECT_EQ(Checkpoint(path, head, true).find("a"), nullptr);
}

TEST(Checkpoint, TakesOverThePartsOfAnotherPlan) {
    const test::ScratchFolder folder;
    const std::filesystem::path path = folder.path() / "report.json";
    using nlohmann::ordered_json;
    const auto head = [](const ordered_json& planned) {
        return ordered_json{{"measured", "x"}, {"seeds", 3}, {"planned", planned}};
    };
    {
        Checkpoint both(path, head({{"a", {{"views", 4}}}, {"b", {{"views", 4}}}}), false);
        both.add("a", {{"value", 1}});
        both.add("b", {{"value", 2}});
    }
    const auto key = read_report(path)["key"].get<std::string>();
    const std::filesystem::path aside = folder.path() / ("report." + key + ".json");
    {
        // One of its parts, another one measured otherwise, and a new one.
        const ordered_json planned = {
            {"a", {{"views", 4}}}, {"b", {{"views", 2}}}, {"c", {{"views", 4}}}};
        Checkpoint other(path, head(planned), false);
        ASSERT_NE(other.find("a"), nullptr);
        EXPECT_EQ((*other.find("a"))["value"], 1);
        EXPECT_EQ(other.find("b"), nullptr);
        // Nothing is lost, and nothing moves before there is something new.
        EXPECT_FALSE(std::filesystem::exists(aside));
        other.add("c", {{"value", 3}});
        EXPECT_EQ(read_report(aside)["parts"].size(), 2u);
        other.finish();
        EXPECT_EQ(read_report(aside)["parts"].size(), 2u);
    }
    // All parts are there, so nothing is renamed.
    Checkpoint(path, head({{"a", {{"views", 4}}}, {"c", {{"views", 4}}}}), true).finish();
    EXPECT_EQ(read_report(path)["parts"].size(), 2u);
    // Other measurements do not replace what was set aside.
    for (const int seeds : {4, 5})
        Checkpoint(path, {{"measured", "x"}, {"seeds", seeds}}, false).add("a", {{"value", 4}});
    EXPECT_EQ(read_report(aside)["parts"].size(), 2u);
    const auto files = std::filesystem::directory_iterator(folder.path());
    EXPECT_EQ(std::distance(begin(files), end(files)), 4); // of four measurements
}

TEST(PlanCsv, HasALineForEveryMeasureAndFrame) {
    const nlohmann::ordered_json report = {
        {"parts",
         {{{"part", "a, \"b\""},
           {"level", "warehouse"},
           {"width", 320},
           {"height", 180},
           {"rows",
            {{{"label", "sll"},
              {"mse",
               {{"value", 0.5},
                {"low", nullptr},
                {"high", 1.0},
                {"ratio", {{"value", 1.0}, {"low", 1.0}, {"high", 1.0}}}}},
              {"trimmed_mse",
               {{"frames",
                 {{{"value", 7.0}, {"median", {{"value", 6.0}, {"low", 5.0}, {"high", 8.0}}}}}}}},
              {"path_ms", {{"frames", {2.0, 3.0}}}},
              {"frames",
               {{{"value", 4.0},
                 {"median", {{"value", 4.0}, {"low", 3.0}, {"high", 5.0}}}}}}}}}}}}};
    EXPECT_EQ(plan_csv(report),
              "part,level,width,height,triangles,lights,row,measure,frame,value,low,high\n"
              "\"a, \"\"b\"\"\",warehouse,320,180,,,sll,mse,,0.5,,1\n"
              "\"a, \"\"b\"\"\",warehouse,320,180,,,sll,mse.ratio,,1,1,1\n"
              "\"a, \"\"b\"\"\",warehouse,320,180,,,sll,trimmed_mse,1,7,,\n"
              "\"a, \"\"b\"\"\",warehouse,320,180,,,sll,trimmed_mse.median,1,6,5,8\n"
              "\"a, \"\"b\"\"\",warehouse,320,180,,,sll,path_ms,1,2,,\n"
              "\"a, \"\"b\"\"\",warehouse,320,180,,,sll,path_ms,2,3,,\n"
              "\"a, \"\"b\"\"\",warehouse,320,180,,,sll,mse,1,4,,\n"
              "\"a, \"\"b\"\"\",warehouse,320,180,,,sll,mse.median,1,4,3,5\n");
}

} // namespace vigil::bench
