// SPDX-License-Identifier: GPL-2.0-or-later
// The tables that people read.
#include "bench/quality_report.h"

#include "common/error.h"
#include "refresh/vkpt/gpu/passes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <string_view>
#include <utility>

namespace vigil::bench {

namespace {

const RowResult& baseline_of(const QualityOptions& options, const LevelResult& result) {
    for (const RowResult& row : result.rows)
        if (row.row.label == options.baseline) return row;
    fail("--baseline {}: no such row", options.baseline);
}

std::string number(double value) {
    return std::isfinite(value) ? fmt::format("{:.3g}", value) : "?";
}

std::string range(const Interval& interval) {
    return fmt::format("[{}, {}]", number(interval.low), number(interval.high));
}

std::string percent(double share) {
    return std::isfinite(share) ? fmt::format("{:.2f}%", 100.0 * share) : "-";
}

std::string percent_range(const Interval& interval) {
    return fmt::format("{} [{}, {}]", percent(interval.value), percent(interval.low),
                       percent(interval.high));
}

double mean_of(const std::vector<ViewResult>& views, double ViewResult::*member) {
    double sum = 0.0;
    for (const ViewResult& view : views)
        sum += view.*member;
    return sum / static_cast<double>(views.size());
}

/// What is wrong with a view's reference, if anything.
std::string_view reference_warning(const ViewResult& view) {
    // Rare paths, such as those that meet the sun: batches met them, the frames did not.
    if (!(view.variance < view.smallest_mse))
        return "  noisier than the frames: what decides the MSE is in none of them";
    return view.reached ? "" : "  more than wanted: see --reference-paths";
}

std::string views_text(const std::vector<ViewResult>& views) {
    std::string text = fmt::format("{:<22}{:>8}{:>14}{:>14}{:>14}\n", "  view", "paths", "mean",
                                   "variance", "/ least MSE");
    for (const ViewResult& view : views)
        text += fmt::format("  {:<20}{:>8}{:>14}{:>14}{:>14}{}\n", view.place.name, view.paths,
                            number(view.mean), number(view.variance),
                            percent(view.variance / view.smallest_mse), reference_warning(view));
    return text;
}

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Which rows a table marks, by what it compares.
std::vector<bool> marked_rows(const LevelResult& result, const RowResult& baseline,
                              const std::function<Comparison(const RowResult&)>& compare) {
    std::vector<double> chances;
    for (const RowResult& row : result.rows)
        chances.push_back(&row == &baseline ? unknown : compare(row).p);
    return stands_out(chances);
}

std::string marked(double value, bool is_marked) {
    return number(value) + (is_marked ? "*" : " ");
}

/// One table of errors: values, ratios to the baseline, and the reference's share.
std::string error_table(const QualityOptions& options, const LevelResult& result,
                        Strata RowResult::*member, const char* name,
                        const std::function<double(const RowResult&)>& reference_variance) {
    const RowResult& baseline = baseline_of(options, result);
    const std::vector<bool> marks = marked_rows(result, baseline, [&](const RowResult& row) {
        return error_ratios(row, baseline, member).typical;
    });
    std::string text = fmt::format("{:<14}{:>10}{:>12}{:>14} {:<20}{:>9}  {:<20}{:>10}\n", "  row",
                                   name, "/ " + options.baseline, "typical run ", "95% these views",
                                   "by view", "95% other views", "reference");
    for (std::size_t i = 0; i < result.rows.size(); ++i) {
        const RowResult& row = result.rows[i];
        const double value = mean_over_views(row.*member);
        const ErrorRatios ratios = error_ratios(row, baseline, member);
        text += fmt::format("  {:<12}{:>10}{:>12}{:>14} {:<20}{:>9}  {:<20}{:>10}\n", row.row.label,
                            number(value), number(ratios.means),
                            marked(ratios.typical.ratio.value, marks[i]),
                            range(ratios.typical.ratio), number(ratios.over_views.value),
                            range(ratios.over_views), percent(reference_variance(row) / value));
    }
    return text;
}

std::string ratios_by_view(const QualityOptions& options, const LevelResult& result) {
    const RowResult& baseline = baseline_of(options, result);
    std::string text;
    for (const auto& [member, name] :
         {std::pair(&RowResult::mse, "MSE"), std::pair(&RowResult::trimmed_mse, "trimmed MSE")}) {
        text += fmt::format("  {} / {} in the typical run, view by view\n", name, options.baseline);
        for (const RowResult& row : result.rows) {
            text += fmt::format("  {:<12}", row.row.label);
            for (std::size_t view = 0; view < result.views.size(); ++view) {
                const bool told = !misses_light({row.mean_ratio[view]}) &&
                                  !misses_light({baseline.mean_ratio[view]});
                const Comparison seen =
                    typical_ratio({(row.*member)[view]}, {(baseline.*member)[view]});
                text += fmt::format("{:>10}", number(told ? seen.ratio.value : unknown));
            }
            text += '\n';
        }
    }
    return text;
}

/// Why rows have no ratios, if some have none.
std::string light_warning(const LevelResult& result) {
    std::string names;
    for (const RowResult& row : result.rows)
        if (misses_light(row.mean_ratio))
            names += fmt::format("{}{}", names.empty() ? "" : ", ", row.row.label);
    if (names.empty()) return {};
    return fmt::format(
        "  {}: at some place these frames miss light of the reference, which comes in "
        "few, bright frames: no ratios\n",
        names);
}

std::string sample_table(const LevelResult& result) {
    std::string text =
        fmt::format("{:<14}{:<18}{:<30}{:<30}{:<30}\n", "  row", "mean - reference", "typical run",
                    "samples with no contribution", "samples that explore");
    for (const RowResult& row : result.rows) {
        Interval mean = typical_run(row.mean_ratio);
        for (double* value : {&mean.value, &mean.low, &mean.high})
            *value -= 1.0;
        text += fmt::format("  {:<12}{:<18}{:<30}{:<30}{:<30}\n", row.row.label,
                            percent(mean_over_views(row.mean_ratio) - 1.0), percent_range(mean),
                            percent_range(typical_run(row.unlit)),
                            percent_range(typical_run(row.explored)));
    }
    return text;
}

double median_of(const Strata& values) {
    std::vector<double> all;
    for (const std::vector<double>& view : values)
        all.insert(all.end(), view.begin(), view.end());
    return median(std::move(all));
}

std::string time_table(const QualityOptions& options, const LevelResult& result) {
    const RowResult& baseline = baseline_of(options, result);
    std::vector<std::size_t> shown; // passes that ran in some row
    for (std::size_t pass = 0; pass < std::size(vkpt::pass_names); ++pass)
        if (std::ranges::any_of(result.rows, [pass](const RowResult& row) {
                return median_of(row.pass_ms[pass]) > 0.0;
            }))
            shown.push_back(pass);
    if (shown.empty()) return "  the device has no timestamps\n";
    std::string text = "  ms          ";
    for (const std::size_t pass : shown)
        text += fmt::format("{:>{}}", vkpt::pass_names[pass],
                            std::max<std::size_t>(9, vkpt::pass_names[pass].size() + 1));
    text += '\n';
    for (const RowResult& row : result.rows) {
        text += fmt::format("  {:<12}", row.row.label);
        for (const std::size_t pass : shown)
            text += fmt::format("{:>{}.2f}", median_of(row.pass_ms[pass]),
                                std::max<std::size_t>(9, vkpt::pass_names[pass].size() + 1));
        text += '\n';
    }
    text += fmt::format("{:<14}{:>12}{:>8}  {:<20}{:>12}{:>8}  {:<20}\n", "  row", "path trace",
                        "/ " + options.baseline, "95%", "guiding", "/ path", "95%");
    for (const RowResult& row : result.rows) {
        const Interval path = typical_ratio(row.path_ms, baseline.path_ms).ratio;
        const Interval prepare = typical_ratio(row.prepare_ms, row.path_ms).ratio;
        text += fmt::format("  {:<12}{:>12.2f}{:>8}  {:<20}{:>12.2f}{:>8}  {:<20}\n", row.row.label,
                            median_of(row.path_ms), number(path.value), range(path),
                            median_of(row.prepare_ms), number(prepare.value), range(prepare));
    }
    return text;
}

std::string equal_time_table(const QualityOptions& options, const LevelResult& result) {
    const RowResult& baseline = baseline_of(options, result);
    const auto marks_of = [&](Strata RowResult::*error) {
        return marked_rows(result, baseline, [&, error](const RowResult& row) {
            return at_equal_time(row, baseline, error).typical;
        });
    };
    const std::vector<bool> mse_marks = marks_of(&RowResult::mse);
    const std::vector<bool> trimmed_marks = marks_of(&RowResult::trimmed_mse);
    std::string text =
        fmt::format("{:<14}{:>10}{:>9}  {:<18}{:>10}{:>14} {:<18}{:>10}{:>14} {:<18}{:>12}\n",
                    "  equal time", "frame, ms", "/ " + options.baseline, "95%", "MSE",
                    "typical run ", "95%", "trimmed", "typical run ", "95%", "1/(MSE s)");
    for (std::size_t i = 0; i < result.rows.size(); ++i) {
        const RowResult& row = result.rows[i];
        const Interval time = typical_ratio(row.frame_ms, baseline.frame_ms).ratio;
        const ErrorRatios mse = at_equal_time(row, baseline, &RowResult::mse);
        const ErrorRatios trimmed = at_equal_time(row, baseline, &RowResult::trimmed_mse);
        text += fmt::format(
            "  {:<12}{:>10.2f}{:>9}  {:<18}{:>10}{:>14} {:<18}{:>10}{:>14} {:<18}{:>12}\n",
            row.row.label, median_of(row.frame_ms), number(time.value), range(time),
            number(mse.means), marked(mse.typical.ratio.value, mse_marks[i]),
            range(mse.typical.ratio), number(trimmed.means),
            marked(trimmed.typical.ratio.value, trimmed_marks[i]), range(trimmed.typical.ratio),
            number(efficiency(row, &RowResult::mse)));
    }
    return text;
}

std::string floor_table(const LevelResult& result) {
    std::string text = "  floor: the error that the best choice of one light leaves\n";
    for (const ViewResult& view : result.views)
        text += fmt::format("  {:<20}{:>14} (by either half of {} pixels {} and {})\n",
                            view.place.name, number(view.floor.variance), view.floor.pixels,
                            number(view.floor.halves[0]), number(view.floor.halves[1]));
    text += fmt::format("{:<14}{:>12}\n", "  row", "floor / MSE");
    for (const RowResult& row : result.rows)
        text += fmt::format("  {:<12}{:>12}\n", row.row.label,
                            number(share_of_floor(result.views, row)));
    return text;
}

std::string settled_text(const std::string& label, const Settled& settled, int frames) {
    const std::string when = settled.frame > frames
                                 ? "never stays"
                                 : fmt::format("from frame {} on stays", settled.frame);
    return fmt::format("  {}: settled at {}; {} within {} times that\n", label,
                       number(settled.level), when, settled_factor);
}

std::string heading(const QualityOptions& options, const std::string& level,
                    const std::vector<ViewResult>& views) {
    return fmt::format("\n{}: {} x {} pixels, {} views, {} seeds; reference by {}\n", level,
                       options.size.x, options.size.y, views.size(), options.seeds,
                       views.front().technique);
}

bool comparable(const RowResult& row, const RowResult& baseline) {
    return !misses_light(row.mean_ratio) && !misses_light(baseline.mean_ratio);
}

} // namespace

ErrorRatios error_ratios(const RowResult& row, const RowResult& baseline,
                         Strata RowResult::*error) {
    constexpr Interval nothing = {unknown, unknown, unknown};
    if (!comparable(row, baseline)) return {unknown, {nothing, unknown}, nothing};
    return {ratio_of_means(row.*error, baseline.*error), typical_ratio(row.*error, baseline.*error),
            ratio_over_views(row.*error, baseline.*error)};
}

ErrorRatios at_equal_time(const RowResult& row, const RowResult& baseline,
                          Strata RowResult::*error) {
    ErrorRatios ratios = error_ratios(row, baseline, error);
    ratios.over_views = {unknown, unknown, unknown};
    if (!comparable(row, baseline)) return ratios;
    ratios.means *= typical_ratio(row.frame_ms, baseline.frame_ms).ratio.value;
    ratios.typical =
        typical_ratio(times(row.*error, row.frame_ms), times(baseline.*error, baseline.frame_ms));
    return ratios;
}

double share_of_floor(const std::vector<ViewResult>& views, const RowResult& row) {
    if (misses_light(row.mean_ratio)) return unknown;
    double sum = 0.0;
    for (const ViewResult& view : views)
        sum += view.floor.variance;
    return sum / static_cast<double>(views.size()) / mean_over_views(row.mse);
}

double efficiency(const RowResult& row, Strata RowResult::*error) {
    return 1.0 / (mean_over_views(row.*error) * 1e-3 * median_of(row.frame_ms));
}

std::string quality_text(const QualityOptions& options, const LevelResult& result) {
    std::string text = heading(options, result.level, result.views);
    text += views_text(result.views) + '\n';
    text += error_table(options, result, &RowResult::mse, "MSE", [&](const RowResult&) {
        return mean_of(result.views, &ViewResult::variance);
    });
    text += '\n';
    text += error_table(options, result, &RowResult::trimmed_mse, "trimmed",
                        [](const RowResult& row) { return mean_over_views(row.trimmed_variance); });
    text += '\n';
    text +=
        error_table(options, result, &RowResult::relative_mse, "rel. MSE", [&](const RowResult&) {
            return mean_of(result.views, &ViewResult::relative_variance);
        });
    if (!result.rows.front().bright_mse.empty()) {
        text += '\n';
        text +=
            error_table(options, result, &RowResult::bright_mse, "bright",
                        [](const RowResult& row) { return mean_over_views(row.bright_variance); });
    }
    text += fmt::format(
        "  *: differs from {} in the typical run. In at most 5% of such tables a mark is chance.\n",
        options.baseline);
    text += light_warning(result);
    text += '\n' + ratios_by_view(options, result) + '\n' + sample_table(result) + '\n' +
            time_table(options, result) + '\n' + equal_time_table(options, result);
    if (options.floor) text += '\n' + floor_table(result);
    if (result.nonfinite > 0)
        text +=
            fmt::format("  {} radiance values were not finite and count as 0\n", result.nonfinite);
    return text;
}

std::string curve_text(const QualityOptions& options, const CurveResult& result) {
    std::string text = heading(options, result.level, result.views) + views_text(result.views);
    for (const auto& [member, name] :
         {std::pair(&CurveRow::mse, "MSE"), std::pair(&CurveRow::trimmed_mse, "trimmed MSE")}) {
        text += fmt::format("\n  {}\n  frame", name);
        for (const CurveRow& row : result.rows)
            text += fmt::format("{:>12}{:>14}  {:<20}", row.row.label, "typical run", "95%");
        text += '\n';
        for (std::size_t frame = 0; frame < (result.rows.front().*member).size(); ++frame) {
            text += fmt::format("  {:<5}", frame + 1);
            for (const CurveRow& row : result.rows) {
                const Strata& values = (row.*member)[frame];
                const Interval typical = typical_run(values);
                text += fmt::format("{:>12}{:>14}  {:<20}", number(mean_over_views(values)),
                                    number(typical.value), range(typical));
            }
            text += '\n';
        }
        for (const CurveRow& row : result.rows)
            text += settled_text(row.row.label, settled_of(row.*member),
                                 static_cast<int>((row.*member).size()));
    }
    return text;
}

} // namespace vigil::bench
