// SPDX-License-Identifier: GPL-2.0-or-later
// What `economy` measures when nothing else is said: every level that comes with the sources, and
// of those beside them the ones that are there.
#include "bench/plan.h"

#include "shared/features.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace vigil::bench {

namespace {

constexpr std::string_view usual_technique = "vlc+cdq"; // what players see

/// What the level has, everything, and what the level has with one feature more. Labels name the
/// technique unless it is the usual one.
std::vector<QualityRow> feature_rows(std::string_view technique) {
    std::vector<QualityRow> rows;
    const auto add = [&](std::string_view choice) {
        QualityRow& row = rows.emplace_back(technique_row(technique));
        row.label = choice;
        if (technique != usual_technique) row.label += fmt::format(" {}", technique);
        row.settings.push_back({"pt_features", std::string(choice)});
    };
    add("auto");
    add("all");
    for (const vkpt::SceneFeatureRow& feature : vkpt::scene_feature_rows)
        add(feature.name);
    return rows;
}

} // namespace

Plan economy_plan(std::span<const std::string> arguments) {
    QualityOptions options;
    options.measured = Measured::Economy;
    options.levels = measured_level_names();
    for (const char* level : {"ring", "many_10", "many_100", "many_1000", "many_10000",
                              "many_100000", "dm3", "e1m1", "e3m4", "e3m6", "end", "start"})
        options.levels.emplace_back(level);
    options.rows = feature_rows(usual_technique);
    options.settings = {{"vk_cache", "0"}};
    options.views = 1;
    options.seeds = 6; // flights: as few as have an interval
    options.warmup = 24;
    QualityOptions small = options;
    small.levels = {"warehouse"};
    small.seeds = 1;
    small.warmup = 4;
    small.size = {96, 54};
    Plan plan{"economy", parse_quality_options(arguments, {options, small, feature_rows}), {}};
    if (!is_named(arguments, "--level"))
        std::erase_if(plan.options.levels, [&](const std::string& level) {
            return folder_with(plan.options.basedirs, level).empty();
        });
    for (const std::string& level : plan.options.levels)
        plan.parts.push_back({level, level, plan.options, "", 0.0});
    return plan;
}

} // namespace vigil::bench
