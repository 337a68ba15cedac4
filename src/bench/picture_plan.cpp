// SPDX-License-Identifier: GPL-2.0-or-later
// What `picture` measures when nothing else is said: sizes and repeats are such that it takes some
// two hours on two cores without a GPU, half of which are references that later runs find in the
// cache.
#include "bench/plan.h"

#include "common/file_system.h"
#include "formats/bsp.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

namespace vigil::bench {

namespace {

/// A situation: what is measured in it, at how many views at most, and in which levels.
struct Situation {
    std::string_view name;
    Measured measured;
    int views;
    Changing changing = Changing::Lamp;
    bool needs_door = false;
    bool all_techniques = false;
};
const Situation situations[] = {
    {"route", Measured::Route, 1000, Changing::Lamp, false, true},
    {"still", Measured::Still, 1000},
    {"cut", Measured::Cut, 1000},
    {changing_name(Changing::Lamp), Measured::Change, 1, Changing::Lamp},
    {changing_name(Changing::Door), Measured::Change, 1, Changing::Door, true},
    {changing_name(Changing::Strobe), Measured::Change, 1, Changing::Strobe},
};

/// Whether a level, which the folders need not have, has doors.
bool has_door(std::span<const std::filesystem::path> basedirs, const std::string& level) {
    const std::filesystem::path folder = folder_with(basedirs, level);
    if (folder.empty()) return false;
    FileSystem files;
    files.mount_game(folder, "baseq2");
    const std::string path = "maps/" + level + ".bsp";
    return std::ranges::any_of(
        parse_bsp(path, files.read(path)).entities,
        [](const Entity& entity) { return entity.classname() == "func_door"; });
}

} // namespace

Plan picture_plan(std::span<const std::string> arguments) {
    QualityOptions options;
    options.measured = Measured::Route;
    options.levels = measured_level_names();
    for (const char* level : {"e1m1", "e3m6"}) // where they are
        options.levels.emplace_back(level);
    options.rows = picture_rows("vlc+cdq");
    options.views = 2;
    options.seeds = 2;
    options.reference_paths = 512;
    QualityOptions small = options;
    small.levels = {"warehouse"};
    small.views = 1;
    small.seeds = 1;
    small.warmup = 8;
    small.size = {96, 54};
    small.reference_paths = 64;
    Plan plan{"picture", parse_quality_options(arguments, {options, small, picture_rows}), {}};

    // How much better sampling still shows after filtering.
    std::vector<QualityRow> all = plan.options.rows;
    if (!is_named(arguments, "--technique") && !is_named(arguments, "--quick"))
        for (const QualityRow& technique : technique_rows())
            for (QualityRow& row : picture_rows(technique.label))
                if (row.label.starts_with("raw") || row.label.starts_with("full"))
                    all.push_back(std::move(row));
    // Of levels that come with nothing but a folder beside the sources, those that are there.
    if (!is_named(arguments, "--level"))
        std::erase_if(plan.options.levels, [&](const std::string& level) {
            return folder_with(plan.options.basedirs, level).empty();
        });
    for (const std::string& level : plan.options.levels)
        for (const Situation& situation : situations) {
            if (situation.needs_door && !has_door(plan.options.basedirs, level)) continue;
            Part& part = plan.parts.emplace_back(
                Part{level + ' ' + std::string(situation.name), level, plan.options, "", 0.0});
            part.options.measured = situation.measured;
            part.options.changing = situation.changing;
            part.options.views = std::min(plan.options.views, situation.views);
            if (situation.all_techniques) part.options.rows = all;
        }
    warm_up_quadtrees(plan, arguments);
    return plan;
}

} // namespace vigil::bench
