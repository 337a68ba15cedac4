// SPDX-License-Identifier: GPL-2.0-or-later
// The tables that people read.
#include "bench/quality_report.h"

#include "common/error.h"
#include "refresh/vkpt/passes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

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

double mean_over_views(const std::vector<ViewResult>& views, double ViewResult::*member) {
    double sum = 0.0;
    for (const ViewResult& view : views)
        sum += view.*member;
    return sum / static_cast<double>(views.size());
}

/// Standard error of mean_ratio's mean that comes from the references.
double reference_mean_error(const std::vector<ViewResult>& views) {
    double sum = 0.0;
    for (const ViewResult& view : views)
        sum += std::pow(view.mean_error / view.mean, 2.0);
    return std::sqrt(sum) / static_cast<double>(views.size());
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

/// A ratio, or nothing where the data do not tell it.
Interval ratio_if(bool told, const Interval& ratio) {
    return told ? ratio : Interval{unknown, unknown, unknown};
}

/// One table of errors: values, ratios to the baseline, and the reference's share.
std::string error_table(const QualityOptions& options, const LevelResult& result,
                        Strata RowResult::*member, const char* name,
                        const std::function<double(const RowResult&)>& reference_variance) {
    const RowResult& baseline = baseline_of(options, result);
    std::string text = fmt::format("{:<14}{:>10}  {:<22}{:>8}  {:<20}{:>8}  {:<20}{:>10}\n",
                                   "  row", name, "95%", "/ " + options.baseline, "95% these views",
                                   "by view", "95% other views", "reference");
    for (const RowResult& row : result.rows) {
        const Interval value = error_interval(row, member);
        const Interval ratio = error_ratio(row, baseline, member);
        const Interval over = error_ratio_over_views(row, baseline, member);
        text += fmt::format("  {:<12}{:>10}  {:<22}{:>8}  {:<20}{:>8}  {:<20}{:>10}\n",
                            row.row.label, number(value.value), range(value), number(ratio.value),
                            range(ratio), number(over.value), range(over),
                            percent(reference_variance(row) / value.value));
    }
    return text;
}

std::string ratios_by_view(const QualityOptions& options, const LevelResult& result) {
    const RowResult& baseline = baseline_of(options, result);
    std::string text;
    for (const auto& [member, name] :
         {std::pair(&RowResult::mse, "MSE"), std::pair(&RowResult::trimmed_mse, "trimmed MSE")}) {
        text += fmt::format("  {} / {} view by view\n", name, options.baseline);
        for (const RowResult& row : result.rows) {
            text += fmt::format("  {:<12}", row.row.label);
            for (std::size_t view = 0; view < result.views.size(); ++view) {
                const bool told = !misses_light({row.mean_ratio[view]}) &&
                                  !misses_light({baseline.mean_ratio[view]});
                const Interval ratio = ratio_if(
                    told, ratio_interval({(row.*member)[view]}, {(baseline.*member)[view]}));
                text += fmt::format("{:>8}  {:<18}", number(ratio.value), range(ratio));
            }
            text += '\n';
        }
    }
    return text;
}

/// Why rows have no intervals, if some have none.
std::string light_warning(const LevelResult& result) {
    std::string names;
    for (const RowResult& row : result.rows)
        if (misses_light(row.mean_ratio))
            names += fmt::format("{}{}", names.empty() ? "" : ", ", row.row.label);
    if (names.empty()) return {};
    return fmt::format(
        "  {}: at some place these frames miss light of the reference, which comes in "
        "few, bright frames: no intervals\n",
        names);
}

std::string sample_table(const LevelResult& result) {
    std::string text = fmt::format("{:<14}{:<30}{:<30}{:<30}\n", "  row", "mean - reference",
                                   "samples with no contribution", "samples that explore");
    const double error = reference_mean_error(result.views);
    for (const RowResult& row : result.rows) {
        Interval mean = widened(mean_interval(row.mean_ratio), error);
        for (double* value : {&mean.value, &mean.low, &mean.high})
            *value -= 1.0;
        text += fmt::format("  {:<12}{:<30}{:<30}{:<30}\n", row.row.label, percent_range(mean),
                            percent_range(mean_interval(row.unlit)),
                            percent_range(mean_interval(row.explored)));
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
        const Interval path = median_ratio(row.path_ms, baseline.path_ms);
        const Interval prepare = median_ratio(row.prepare_ms, row.path_ms);
        text += fmt::format("  {:<12}{:>12.2f}{:>8}  {:<20}{:>12.2f}{:>8}  {:<20}\n", row.row.label,
                            median_of(row.path_ms), number(path.value), range(path),
                            median_of(row.prepare_ms), number(prepare.value), range(prepare));
    }
    return text;
}

std::string equal_time_table(const QualityOptions& options, const LevelResult& result) {
    const RowResult& baseline = baseline_of(options, result);
    std::string text = fmt::format("{:<14}{:>12}{:>8}  {:<20}{:>10}  {:<20}{:>10}  {:<20}{:>12}\n",
                                   "  equal time", "frame, ms", "/ " + options.baseline, "95%",
                                   "MSE", "95%", "trimmed", "95%", "1/(MSE s)");
    for (const RowResult& row : result.rows) {
        const Interval time = median_ratio(row.frame_ms, baseline.frame_ms);
        const Interval mse = equal_time(row, baseline, &RowResult::mse);
        const Interval trimmed = equal_time(row, baseline, &RowResult::trimmed_mse);
        text += fmt::format("  {:<12}{:>12.2f}{:>8}  {:<20}{:>10}  {:<20}{:>10}  {:<20}{:>12}\n",
                            row.row.label, median_of(row.frame_ms), number(time.value), range(time),
                            number(mse.value), range(mse), number(trimmed.value), range(trimmed),
                            number(efficiency(row, &RowResult::mse)));
    }
    return text;
}

std::string floor_table(const LevelResult& result) {
    std::string text = "  floor: the error that the best choice of one light leaves\n";
    for (const ViewResult& view : result.views)
        text +=
            fmt::format("  {:<20}{:>14} +- {} ({} pixels)\n", view.place.name,
                        number(view.floor.variance), number(view.floor.error), view.floor.pixels);
    text += fmt::format("{:<14}{:>12}  {:<20}\n", "  row", "floor / MSE", "95%");
    for (const RowResult& row : result.rows) {
        const Interval share = share_of_floor(result.views, row);
        text += fmt::format("  {:<12}{:>12}  {:<20}\n", row.row.label, number(share.value),
                            range(share));
    }
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

Interval error_interval(const RowResult& row, Strata RowResult::*error) {
    Interval interval = mean_interval(row.*error);
    if (misses_light(row.mean_ratio)) interval.low = interval.high = unknown;
    return interval;
}

Interval error_ratio(const RowResult& row, const RowResult& baseline, Strata RowResult::*error) {
    return ratio_if(comparable(row, baseline), ratio_interval(row.*error, baseline.*error));
}

Interval error_ratio_over_views(const RowResult& row, const RowResult& baseline,
                                Strata RowResult::*error) {
    return ratio_if(comparable(row, baseline), ratio_over_views(row.*error, baseline.*error));
}

Interval share_of_floor(const std::vector<ViewResult>& views, const RowResult& row) {
    Strata floors;
    double variance = 0.0, squared_error = 0.0;
    for (std::size_t view = 0; view < views.size(); ++view) {
        const LightFloor& floor = views[view].floor;
        floors.emplace_back(row.mse[view].size(), floor.variance);
        variance += floor.variance;
        squared_error += floor.error * floor.error;
    }
    const double share = std::sqrt(squared_error) / variance;
    return ratio_if(!misses_light(row.mean_ratio),
                    product(ratio_interval(floors, row.mse), widened({1.0, 1.0, 1.0}, share)));
}

Interval equal_time(const RowResult& row, const RowResult& baseline, Strata RowResult::*error) {
    return product(error_ratio(row, baseline, error),
                   median_ratio(row.frame_ms, baseline.frame_ms));
}

double efficiency(const RowResult& row, Strata RowResult::*error) {
    return 1.0 / (mean_interval(row.*error).value * 1e-3 * median_of(row.frame_ms));
}

std::string quality_text(const QualityOptions& options, const LevelResult& result) {
    std::string text = heading(options, result.level, result.views);
    text += views_text(result.views) + '\n';
    text += error_table(options, result, &RowResult::mse, "MSE", [&](const RowResult&) {
        return mean_over_views(result.views, &ViewResult::variance);
    });
    text += '\n';
    text +=
        error_table(options, result, &RowResult::trimmed_mse, "trimmed",
                    [](const RowResult& row) { return mean_interval(row.trimmed_variance).value; });
    text += '\n';
    text +=
        error_table(options, result, &RowResult::relative_mse, "rel. MSE", [&](const RowResult&) {
            return mean_over_views(result.views, &ViewResult::relative_variance);
        });
    if (!result.rows.front().bright_mse.empty()) {
        text += '\n';
        text += error_table(
            options, result, &RowResult::bright_mse, "bright",
            [](const RowResult& row) { return mean_interval(row.bright_variance).value; });
    }
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
            text += fmt::format("{:>12}  {:<20}", row.row.label, "95%");
        text += '\n';
        for (std::size_t frame = 0; frame < (result.rows.front().*member).size(); ++frame) {
            text += fmt::format("  {:<5}", frame + 1);
            for (const CurveRow& row : result.rows) {
                const Interval value = mean_interval((row.*member)[frame]);
                text += fmt::format("{:>12}  {:<20}", number(value.value), range(value));
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
