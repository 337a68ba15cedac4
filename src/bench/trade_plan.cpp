// SPDX-License-Identifier: GPL-2.0-or-later
// The sweep: one table of variables that trade time for error, and the values that are tried.
#include "bench/plan.h"

#include "console/cvar.h"
#include "console/preset.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace vigil::bench {

namespace {

/// A variable, the technique that it is tried with, and the values besides the default. Where one
/// value needs another variable to follow it, `also` is "NAME" and takes the value times `factor`.
struct Sweep {
    std::string_view variable;
    std::string_view technique;
    std::vector<std::string_view> values;
    std::string_view also = {};
    double factor = 1.0;
};

const std::vector<Sweep>& sweeps() {
    static const std::vector<Sweep> table = {
        {"pt_spp", "vlc", {"2", "4"}},
        {"pt_env_nee", "vlc+cdq", {"0"}},
        {"pt_sky_lights", "vlc", {"12", "64"}},
        {"pt_light_points", "vlc", {"1", "2", "4", "16"}},
        {"pt_light_density", "vlc", {"area", "solid_angle"}},
        {"pt_sll_max", "sll", {"8", "16", "64", "256"}},
        {"pt_sll_mass", "sll", {"solid_angle"}},
        {"pt_sll_stats", "sll", {"1"}},
        {"pt_ris_candidates", "ris", {"8", "16", "64"}},
        {"pt_lh_width", "lh", {"2", "4"}},
        {"pt_lh_leaf", "lh", {"1", "4"}},
        {"pt_cut_size", "cut", {"8", "24", "48"}},
        // What the paper calls threshold; nodes collapse at half of it.
        {"pt_oct_split", "vlc", {"256", "512", "1024", "2048", "8192"}, "pt_oct_collapse", 0.5},
        {"pt_vlc_bucket", "vlc", {"8", "16", "64"}},
        {"pt_learn_every", "vlc", {"1", "2", "8"}},
        {"pt_vlc_enough", "vlc", {"0"}},
        // Of itself, as the paper: pt_vlc_adapt 0.
        {"pt_vlc_explore", "vlc", {"0.01", "0.03", "0.2", "0.5"}},
        {"pt_vlc_beside", "vlc", {"0"}},
        {"pt_vlc_adapt", "vlc", {"0"}},
        {"pt_vlc_weigh", "vlc", {"0"}},
        {"pt_vlc_hysteresis", "vlc", {"0.5", "1"}},
        {"pt_vlc_merge", "vlc", {"0"}},
        {"pt_vlc_persist", "vlc", {"0", "4", "30"}},
        {"pt_explore_local", "vlc", {"0", "0.5", "1"}},
        {"pt_explore_energy", "vlc", {"0"}},
        {"pt_explore_change", "vlc", {"0"}},
        {"pt_explore_distance", "vlc", {"0"}},
        {"pt_guide_directions", "vlc+cdq", {"1", "4"}},
        {"pt_guide_gain", "vlc+cdq", {"0"}},
        {"pt_cdq_bits", "vlc+cdq", {"32", "64", "96"}},
        {"pt_cdq_adapt", "vlc+cdq", {"0"}},
        {"pt_cdq_brdf", "vlc+cdq", {"0.1", "0.25", "0.75"}},
        {"pt_cdq_margin", "vlc+cdq", {"0.1", "0.5"}},
        {"pt_cdq_rays", "vlc+cdq", {"0", "128", "2048"}},
        {"pt_cdq_migrations", "vlc+cdq", {"1", "16"}},
    };
    return table;
}

/// "NAME=VALUE" with the variables of its technique.
QualityRow sweep_row(const Sweep& sweep, std::string_view value) {
    QualityRow row = technique_row(sweep.technique);
    row.label = fmt::format("{}={}", sweep.variable, value);
    row.settings.push_back({std::string(sweep.variable), std::string(value)});
    if (!sweep.also.empty())
        row.settings.push_back({std::string(sweep.also),
                                fmt::format("{:g}", sweep.factor * std::stod(std::string(value)))});
    return row;
}

std::vector<QualityRow> preset_rows() {
    std::vector<QualityRow> rows;
    for (const Preset& preset : presets())
        rows.push_back(preset_row(preset.name));
    return rows;
}

} // namespace

Plan trade_plan(std::span<const std::string> arguments) {
    QualityOptions options;
    options.levels = measured_level_names();
    options.rows = {technique_row("vlc")}; // what techniques and presets are compared with
    options.seeds = 2;
    options.reference_paths = 512;
    QualityOptions quick = least(options);
    quick.levels = {"warehouse"};
    Plan plan{"trade", parse_quality_options(arguments, {options, quick}), {}};
    const auto add = [&](const std::string& level, std::string_view name, std::string_view baseline,
                         const std::vector<QualityRow>& rows) {
        Part part{fmt::format("{} {}", level, name), level, plan.options, "", 0.0};
        part.options.baseline = baseline;
        part.options.rows = {technique_row(baseline)};
        for (const QualityRow& row : rows)
            if (row.label != baseline) part.options.rows.push_back(row);
        plan.parts.push_back(std::move(part));
    };
    for (const std::string& level : plan.options.levels) {
        std::vector<QualityRow> techniques = technique_rows();
        std::ranges::move(technique_rows({"sll+cdq", "lh+cdq", "vlc+cdq"}),
                          std::back_inserter(techniques));
        add(level, "techniques", plan.options.baseline, techniques);
        add(level, "presets", plan.options.baseline, preset_rows());
        for (const Sweep& sweep : sweeps()) {
            std::vector<QualityRow> rows;
            for (const std::string_view value : sweep.values)
                rows.push_back(sweep_row(sweep, value));
            add(level, sweep.variable, sweep.technique, rows);
        }
    }
    warm_up_quadtrees(plan, arguments);
    return plan;
}

} // namespace vigil::bench
