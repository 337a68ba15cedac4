// SPDX-License-Identifier: GPL-2.0-or-later
// What the experiments measure when nothing else is said. Intervals need four views and six runs;
// sizes and repeats are such that all experiments together take less than six hours on two cores
// without a GPU, and each --quick one less than two minutes.
#include "bench/plan.h"

#include "bench/quality_estimate.h"
#include "common/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

namespace vigil::bench {

namespace {

/// Small pictures of one level.
QualityOptions quick(QualityOptions options) {
    options.levels = {"warehouse"};
    options.views = std::min(options.views, 2);
    options.seeds = std::min(options.seeds, 3);
    options.warmup = 8;
    options.size = {160, 90};
    options.reference_paths = 128;
    return options;
}

/// Parts named after their levels.
std::vector<Part> level_parts(const QualityOptions& options) {
    std::vector<Part> parts;
    for (const std::string& level : options.levels)
        parts.push_back({level, level, options, "", 0.0});
    return parts;
}

} // namespace

std::vector<std::string> measured_level_names() {
    std::vector<std::string> names;
    for (const MeasuredLevel& level : measured_levels)
        names.emplace_back(level.name);
    return names;
}

bool is_named(std::span<const std::string> arguments, std::string_view option) {
    return std::ranges::find(arguments, option) != arguments.end();
}

QualityOptions least(QualityOptions options) {
    options.views = 1;
    options.seeds = 1;
    options.warmup = 4;
    options.size = {96, 54};
    options.reference_paths = 64;
    return options;
}

void warm_up_quadtrees(Plan& plan, std::span<const std::string> arguments) {
    if (is_named(arguments, "--warmup") || is_named(arguments, "--quick")) return;
    for (Part& part : plan.parts)
        for (const MeasuredLevel& level : measured_levels)
            if (part.level == level.name && std::ranges::any_of(part.options.rows, is_guided))
                part.options.warmup = std::max(part.options.warmup, level.quadtree_frames);
}

void select_parts(Plan& plan) {
    if (plan.options.parts.empty()) return;
    std::string names;
    for (const Part& part : plan.parts)
        names += (names.empty() ? "" : ", ") + part.name;
    std::erase_if(plan.parts, [&](const Part& part) {
        return std::ranges::none_of(plan.options.parts, [&](const std::string& wanted) {
            return part.name.starts_with(wanted);
        });
    });
    if (plan.parts.empty()) fail("--part: there is no such part; there are {}", names);
}

Plan quality_plan(std::span<const std::string> arguments) {
    QualityOptions options;
    options.levels = measured_level_names();
    options.seeds = 4;
    options.rows = technique_rows();
    // The paper's figure 8 has these with both kinds of rays.
    std::ranges::move(technique_rows({"sll+cdq", "lh+cdq", "vlc+cdq"}),
                      std::back_inserter(options.rows));
    options.rows.push_back(preset_row("paper"));
    Plan plan{"quality", parse_quality_options(arguments, {options, quick(options)}), {}};
    plan.parts = level_parts(plan.options);
    warm_up_quadtrees(plan, arguments);
    return plan;
}

Plan adapt_plan(std::span<const std::string> arguments) {
    QualityOptions options;
    options.measured = Measured::Curve;
    options.levels = measured_level_names();
    options.rows = technique_rows({"sll", "vlc", "vlc+cdq"});
    options.seeds = 4;
    options.frames = 24;
    Plan plan{"adapt", parse_quality_options(arguments, {options, quick(options)}), {}};
    plan.parts = level_parts(plan.options);
    if (plan.options.changing != Changing::Nothing)
        for (Part& part : plan.parts)
            part.name = fmt::format("{} {}", part.level, changing_name(plan.options.changing));
    return plan;
}

Plan ring_plan(std::span<const std::string> arguments) {
    QualityOptions options;
    options.measured = Measured::Turn;
    options.turns = {9, 36}; // these and the sizes are the paper's
    options.bits = {32, 64, 96, 128};
    options.baseline = "brdf";
    options.size = {240, 136};
    options.views = 1;
    options.seeds = 6;
    options.warmup = 0;
    options.settle = 100;
    options.frames = 60;
    options.reference_paths = 512;
    QualityOptions small = options;
    small.turns = {36};
    small.bits = {64};
    small.size = {96, 54};
    small.seeds = 2;
    small.settle = 40;
    small.frames = 2 * ring_tail;
    small.reference_paths = 128;
    Plan plan{"ring", parse_quality_options(arguments, {options, small}), {}};
    plan.options.reference = ring_rows(std::array{64}).front();
    for (const int degrees : plan.options.turns) {
        Part& part = plan.parts.emplace_back(
            Part{fmt::format("{} degrees", degrees), "ring", plan.options, "", 0.0});
        part.options.turns = {degrees};
        part.options.settings.insert(part.options.settings.begin(),
                                     {"fov", "50"}); // the floor and nothing else
    }
    plan.about = {{"turns", plan.options.turns},
                  {"bits", plan.options.bits},
                  {"settle", plan.options.settle},
                  {"frames", plan.options.frames},
                  {"settled_tail", ring_tail},
                  {"settled_factor", ring_factor},
                  {"reference_paths", plan.options.reference_paths}};
    return plan;
}

Plan timing_plan(std::span<const std::string> arguments) {
    QualityOptions options;
    options.measured = Measured::Times;
    options.levels = measured_level_names();
    options.rows = technique_rows({"lh", "sll", "vlc", "vlc+cdq"});
    options.views = 1;
    options.seeds = 6; // flights: as few as have an interval
    options.warmup = 80;
    QualityOptions small = quick(options);
    small.warmup = 20;
    Plan plan{"timing", parse_quality_options(arguments, {options, small}), {}};
    plan.parts = level_parts(plan.options);
    return plan;
}

Plan scale_plan(std::span<const std::string> arguments) {
    QualityOptions options;
    options.levels = {"warehouse"}; // of resolutions and triangles
    options.rows = technique_rows({"sll", "lh", "ris", "vlc"});
    options.seeds = 2;
    options.reference_paths = 256;
    QualityOptions small = quick(options);
    small.views = 1;
    small.reference_paths = 64;
    Plan plan{"scale", parse_quality_options(arguments, {options, small}), {}};
    const bool is_quick = is_named(arguments, "--quick");
    const auto add = [&](const std::string& level, std::string_view axis, double value) -> Part& {
        return plan.parts.emplace_back(Part{fmt::format("{} {} {}", axis, level, value), level,
                                            plan.options, std::string(axis), value});
    };
    for (const int lights : {10, 100, 1000, 10000, 100000}) {
        if (is_quick && lights != 10 && lights != 1000) continue;
        add(fmt::format("many_{}", lights), "lights", lights);
    }
    for (const std::string& level : plan.options.levels) {
        for (const int height : {90, 180, 360, 720, 1080}) {
            if (is_quick && height > 180) continue;
            Part& part = add(level, "resolution", height);
            part.options.size = {height * 16 / 9, height};
            // All sizes see the same places after as many frames. What large pictures have more of
            // pixels they need less of repeats; with one seed they have no intervals.
            const auto unless_named = [&](std::string_view option, int& value, int usual) {
                if (!is_quick && !is_named(arguments, option)) value = usual;
            };
            unless_named("--seeds", part.options.seeds, height < 720 ? 2 : 1);
            if (height >= 720) unless_named("--reference-paths", part.options.reference_paths, 64);
        }
        for (const int halvings : {0, 1, 2}) {
            if (is_quick && halvings == 1) continue;
            Part& part = add(level, "triangles", 1 << 2 * halvings);
            part.options.settings.push_back({"pt_subdivide", std::to_string(halvings)});
        }
    }
    return plan;
}

} // namespace vigil::bench
