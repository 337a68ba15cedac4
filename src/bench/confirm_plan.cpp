// SPDX-License-Identifier: GPL-2.0-or-later
// What `trade` found, put to the test: the best of many values looks better than it is, so those
// that look better than the default are measured again with seeds that had no part in choosing
// them.
#include "bench/checkpoint.h"
#include "bench/plan.h"

#include "common/error.h"
#include "console/outdir.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vigil::bench {

namespace {

using nlohmann::ordered_json;

/// A value of a variable, by what its row and baseline set.
struct Candidate {
    std::string variable;
    std::string baseline;
    QualityRow row;
    std::vector<std::string> levels; // where errors tell something
};

std::optional<double> ratio_at_equal_time(const ordered_json& row, const char* error) {
    const ordered_json& value = row.at(error).at("ratio_at_equal_time").at("value");
    if (!value.is_number()) return std::nullopt;
    return value.get<double>();
}

ordered_json read_trade(const std::filesystem::path& path) {
    ordered_json report = read_report(path);
    if (!report.is_object() || report.value("measured", std::string()) != "trade")
        fail("{}: not a report of `run bench trade`", path.string());
    if (!report.value("finished", false))
        fail("{}: not finished; `run bench trade` goes on with it", path.string());
    return report;
}

/// Values whose error at equal time is below the default's: geometric means over the levels that
/// have one, with all pixels and without the worst. Chance is among them, which is why they are
/// measured again.
std::vector<Candidate> candidates_of(const ordered_json& report) {
    struct Seen {
        Candidate candidate;
        double trimmed = 0.0, all = 0.0; // sums of logarithms
    };
    std::map<std::string, Seen> seen;
    std::vector<std::string> order;
    for (const ordered_json& part : report.at("parts")) {
        const auto level = part.at("level").get<std::string>();
        const auto baseline = part.at("baseline").get<std::string>();
        for (const ordered_json& row : part.at("rows")) {
            const auto label = row.at("label").get<std::string>();
            const std::size_t equals = label.find('=');
            const std::optional<double> trimmed = ratio_at_equal_time(row, "trimmed_mse");
            const std::optional<double> all = ratio_at_equal_time(row, "mse");
            if (equals == std::string::npos || !trimmed || !all) continue;
            const auto [place, is_new] = seen.try_emplace(label);
            Seen& value = place->second;
            if (is_new) {
                order.push_back(label);
                value.candidate = {label.substr(0, equals), baseline, {label, {}}, {}};
                for (const auto& [name, text] : row.at("variables").items())
                    value.candidate.row.settings.push_back({name, text.get<std::string>()});
            }
            value.candidate.levels.push_back(level);
            value.trimmed += std::log(*trimmed);
            value.all += std::log(*all);
        }
    }
    std::vector<Candidate> found;
    for (const std::string& label : order)
        if (seen[label].trimmed < 0.0 && seen[label].all < 0.0)
            found.push_back(seen[label].candidate);
    return found;
}

} // namespace

Plan confirm_plan(std::span<const std::string> arguments) {
    QualityOptions options;
    options.levels = measured_level_names();
    options.rows = {technique_row("vlc")};
    options.seeds = 6;
    options.first_seed = 1001;
    options.reference_paths = 512;
    options.trade = output_path("trade.json").string();
    Plan plan{"confirm", parse_quality_options(arguments, {options, least(options)}), {}};
    const ordered_json report = read_trade(plan.options.trade);
    const int first = report.at("first_seed").get<int>();
    const int seeds = report.at("seeds").get<int>();
    if (plan.options.first_seed < first + seeds &&
        first < plan.options.first_seed + plan.options.seeds)
        fail("{}: measured with some of the same seeds; see --first-seed", plan.options.trade);
    for (const Candidate& candidate : candidates_of(report)) {
        for (const std::string& level : candidate.levels) {
            if (std::ranges::find(plan.options.levels, level) == plan.options.levels.end())
                continue;
            const std::string name = fmt::format("{} {}", level, candidate.variable);
            auto part = std::ranges::find(plan.parts, name, &Part::name);
            if (part == plan.parts.end()) {
                plan.parts.push_back({name, level, plan.options, "", 0.0});
                part = std::prev(plan.parts.end());
                part->options.baseline = candidate.baseline;
                part->options.rows = {technique_row(candidate.baseline)};
            }
            part->options.rows.push_back(candidate.row);
        }
    }
    warm_up_quadtrees(plan, arguments);
    plan.about = {{"trade", {{"key", report.at("key")}, {"commit", report.at("commit")}}}};
    return plan;
}

} // namespace vigil::bench
