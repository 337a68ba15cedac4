// SPDX-License-Identifier: GPL-2.0-or-later
// The tables that people read, from the report that programs read. Every number has the
// reference's error beside it, and an interval where there is one.
#include "bench/measure.h"

#include "common/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

namespace vigil::bench {

using nlohmann::ordered_json;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double value_of(const ordered_json& json) {
    return json.at("value").get<double>();
}

Interval interval_of(const ordered_json& json) {
    return {value_of(json), json.at("low").get<double>(), json.at("high").get<double>()};
}

std::string label_of(const ordered_json& row) {
    return row.at("label").get<std::string>();
}

Strata strata_of(const ordered_json& row, const char* quantity) {
    return row.at(quantity).at("by_view_and_seed").get<Strata>();
}

const ordered_json& baseline_of(const QualityOptions& options, const ordered_json& rows) {
    return *std::ranges::find(rows, options.baseline, label_of);
}

std::string percent(double share) {
    return std::isfinite(share) ? fmt::format("{:.2f}%", 100.0 * share) : "-";
}

std::string percent_range(const Interval& interval) {
    return fmt::format("{} [{}, {}]", percent(interval.value), percent(interval.low),
                       percent(interval.high));
}

double mean_of_references(const ordered_json& views, const char* name) {
    double sum = 0.0;
    for (const ordered_json& view : views)
        sum += view.at("reference").at(name).get<double>();
    return sum / static_cast<double>(views.size());
}

/// What is wrong with a view's reference, if anything.
std::string_view reference_warning(const ordered_json& reference) {
    // Rare paths, such as those that meet the sun: batches met them, the frames did not.
    if (!(reference.at("variance").get<double>() < reference.at("smallest_mse").get<double>()))
        return "  noisier than the frames: what decides the MSE is in none of them";
    return reference.at("reached").get<bool>() ? "" : "  more than wanted: see --reference-paths";
}

std::string heading(const QualityOptions& options, const std::string& level,
                    const ordered_json& views) {
    std::string text =
        fmt::format("\n{}: {} x {} pixels, {} views, {} seeds; reference by "
                    "{}\n{:<22}{:>8}{:>14}{:>14}{:>14}\n",
                    level, options.size.x, options.size.y, views.size(), options.seeds,
                    options.reference.label, "  view", "paths", "mean", "variance", "/ least MSE");
    for (const ordered_json& view : views) {
        const ordered_json& reference = view.at("reference");
        const auto variance = reference.at("variance").get<double>();
        text += fmt::format("  {:<20}{:>8}{:>14}{:>14}{:>14}{}\n",
                            view.at("name").get<std::string>(), reference.at("paths").get<int>(),
                            number_text(reference.at("mean").get<double>()), number_text(variance),
                            percent(variance / reference.at("smallest_mse").get<double>()),
                            reference_warning(reference));
    }
    return text;
}

/// Values of a comparison, by row; those that stand out among the rows are marked.
std::vector<std::string> marked(const QualityOptions& options, const ordered_json& rows,
                                const char* quantity, const char* comparison) {
    std::vector<double> chances;
    for (const ordered_json& row : rows)
        chances.push_back(label_of(row) == options.baseline
                              ? unknown
                              : row.at(quantity).at(comparison).at("p").get<double>());
    const std::vector<bool> marks = stands_out(chances);
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < rows.size(); ++i)
        texts.push_back(number_text(value_of(rows[i].at(quantity).at(comparison))) +
                        (marks[i] ? "*" : " "));
    return texts;
}

/// One table of errors: values, ratios to the baseline, and the reference's share.
std::string error_table(const QualityOptions& options, const ordered_json& rows,
                        const char* quantity, const char* name,
                        const std::function<double(const ordered_json&)>& reference_variance) {
    const std::vector<std::string> typical = marked(options, rows, quantity, "typical");
    std::string text = fmt::format("{:<14}{:>10}{:>12}{:>14} {:<20}{:>9}  {:<20}{:>10}\n", "  row",
                                   name, "/ " + options.baseline, "typical run ", "95% these views",
                                   "by view", "95% other views", "reference");
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const ordered_json& error = rows[i].at(quantity);
        const Interval over_views = interval_of(error.at("ratio_over_views"));
        text += fmt::format(
            "  {:<12}{:>10}{:>12}{:>14} {:<20}{:>9}  {:<20}{:>10}\n", label_of(rows[i]),
            number_text(value_of(error)), number_text(value_of(error.at("ratio"))), typical[i],
            range_text(interval_of(error.at("typical"))), number_text(over_views.value),
            range_text(over_views), percent(reference_variance(rows[i]) / value_of(error)));
    }
    return text;
}

std::string error_tables(const QualityOptions& options, const ordered_json& report) {
    const ordered_json& rows = report.at("rows");
    // The reference's variance: of all pixels by view, or of some pixels by row.
    const auto of_views = [&](const char* name) {
        return
            [&, name](const ordered_json&) { return mean_of_references(report.at("views"), name); };
    };
    const auto of_row = [](const char* name) {
        return [name](const ordered_json& row) { return value_of(row.at(name)); };
    };
    std::string text = error_table(options, rows, "mse", "MSE", of_views("variance"));
    text += '\n' + error_table(options, rows, "trimmed_mse", "trimmed", of_row("trimmed_variance"));
    text += '\n' +
            error_table(options, rows, "relative_mse", "rel. MSE", of_views("relative_variance"));
    if (rows[0].contains("bright_mse"))
        text +=
            '\n' + error_table(options, rows, "bright_mse", "bright", of_row("bright_variance"));
    return text;
}

std::string ratios_by_view(const QualityOptions& options, const ordered_json& rows) {
    const ordered_json& baseline = baseline_of(options, rows);
    const Strata baseline_light = strata_of(baseline, "mean_ratio");
    std::string text;
    for (const auto& [quantity, name] :
         {std::pair("mse", "MSE"), std::pair("trimmed_mse", "trimmed MSE")}) {
        text += fmt::format("  {} / {} in the typical run, view by view\n", name, options.baseline);
        const Strata baseline_errors = strata_of(baseline, quantity);
        for (const ordered_json& row : rows) {
            text += fmt::format("  {:<12}", label_of(row));
            const Strata light = strata_of(row, "mean_ratio"), errors = strata_of(row, quantity);
            for (std::size_t view = 0; view < errors.size(); ++view) {
                const bool is_known =
                    !misses_light({light[view]}) && !misses_light({baseline_light[view]});
                const Comparison seen = typical_ratio({errors[view]}, {baseline_errors[view]});
                text += fmt::format("{:>10}", number_text(is_known ? seen.ratio.value : unknown));
            }
            text += '\n';
        }
    }
    return text;
}

/// Why rows have no ratios, if some have none.
std::string light_warning(const ordered_json& rows) {
    std::string names;
    for (const ordered_json& row : rows)
        if (row.at("misses_light").get<bool>())
            names += fmt::format("{}{}", names.empty() ? "" : ", ", label_of(row));
    if (names.empty()) return {};
    return fmt::format(
        "  {}: at some place these frames miss light of the reference, which comes in "
        "few, bright frames: no ratios\n",
        names);
}

std::string sample_table(const ordered_json& rows) {
    std::string text =
        fmt::format("{:<14}{:<18}{:<30}{:<30}{:<30}\n", "  row", "mean - reference", "typical run",
                    "samples with no contribution", "samples that explore");
    for (const ordered_json& row : rows) {
        const auto typical = [&](const char* quantity) {
            return interval_of(row.at(quantity).at("median"));
        };
        Interval mean = typical("mean_ratio");
        for (double* value : {&mean.value, &mean.low, &mean.high})
            *value -= 1.0;
        text += fmt::format("  {:<12}{:<18}{:<30}{:<30}{:<30}\n", label_of(row),
                            percent(value_of(row.at("mean_ratio")) - 1.0), percent_range(mean),
                            percent_range(typical("unlit")), percent_range(typical("explored")));
    }
    return text;
}

std::string time_table(const QualityOptions& options, const ordered_json& rows) {
    std::vector<std::pair<std::string, std::size_t>> shown; // passes that ran in some row; widths
    for (const auto& item : rows[0].at("pass_ms").items())
        if (const std::string& pass = item.key();
            std::ranges::any_of(rows, [&](const ordered_json& row) {
                return median_of(row.at("pass_ms").at(pass).get<Strata>()) > 0.0;
            }))
            shown.emplace_back(pass, std::max<std::size_t>(9, pass.size() + 1));
    if (shown.empty()) return "  the device has no timestamps\n";
    std::string text = "  ms          ";
    for (const auto& [pass, width] : shown)
        text += fmt::format("{:>{}}", pass, width);
    text += '\n';
    for (const ordered_json& row : rows) {
        text += fmt::format("  {:<12}", label_of(row));
        for (const auto& [pass, width] : shown)
            text += fmt::format("{:>{}.2f}", median_of(row.at("pass_ms").at(pass).get<Strata>()),
                                width);
        text += '\n';
    }
    text += fmt::format("{:<14}{:>12}{:>8}  {:<20}{:>12}{:>8}  {:<20}\n", "  row", "path trace",
                        "/ " + options.baseline, "95%", "guiding", "/ path", "95%");
    for (const ordered_json& row : rows) {
        const Interval path = interval_of(row.at("path_ms").at("ratio"));
        const Interval prepare = interval_of(row.at("prepare_ms").at("share_of_path"));
        text += fmt::format("  {:<12}{:>12.2f}{:>8}  {:<20}{:>12.2f}{:>8}  {:<20}\n", label_of(row),
                            median_of(strata_of(row, "path_ms")), number_text(path.value),
                            range_text(path), median_of(strata_of(row, "prepare_ms")),
                            number_text(prepare.value), range_text(prepare));
    }
    return text;
}

std::string equal_time_table(const QualityOptions& options, const ordered_json& rows) {
    const char* comparison = "typical_at_equal_time";
    const std::vector<std::string> typical_mse = marked(options, rows, "mse", comparison);
    const std::vector<std::string> typical_trimmed =
        marked(options, rows, "trimmed_mse", comparison);
    std::string text =
        fmt::format("{:<14}{:>10}{:>9}  {:<18}{:>10}{:>14} {:<18}{:>10}{:>14} {:<18}{:>12}\n",
                    "  equal time", "frame, ms", "/ " + options.baseline, "95%", "MSE",
                    "typical run ", "95%", "trimmed", "typical run ", "95%", "1/(MSE s)");
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const ordered_json& row = rows[i];
        const Interval time = interval_of(row.at("frame_ms").at("ratio"));
        const ordered_json &mse = row.at("mse"), &trimmed = row.at("trimmed_mse");
        text += fmt::format(
            "  {:<12}{:>10.2f}{:>9}  {:<18}{:>10}{:>14} {:<18}{:>10}{:>14} {:<18}{:>12}\n",
            label_of(row), median_of(strata_of(row, "frame_ms")), number_text(time.value),
            range_text(time), number_text(value_of(mse.at("ratio_at_equal_time"))), typical_mse[i],
            range_text(interval_of(mse.at(comparison))),
            number_text(value_of(trimmed.at("ratio_at_equal_time"))), typical_trimmed[i],
            range_text(interval_of(trimmed.at(comparison))),
            number_text(value_of(row.at("efficiency"))));
    }
    return text;
}

std::string floor_table(const ordered_json& report) {
    std::string text = "  floor: the error that the best choice of one light leaves\n";
    for (const ordered_json& view : report.at("views")) {
        if (!view.contains("floor")) continue;
        const ordered_json& floor = view.at("floor");
        text += fmt::format(
            "  {:<20}{:>14} (by either half of {} pixels {} and {})\n",
            view.at("name").get<std::string>(), number_text(floor.at("variance").get<double>()),
            floor.at("pixels").get<int>(), number_text(floor.at("halves")[0].get<double>()),
            number_text(floor.at("halves")[1].get<double>()));
    }
    text += fmt::format("{:<14}{:>12}\n", "  row", "floor / MSE");
    for (const ordered_json& row : report.at("rows"))
        text += fmt::format("  {:<12}{:>12}\n", label_of(row),
                            number_text(value_of(row.at("floor_over_mse"))));
    return text;
}

} // namespace

std::string number_text(double value) {
    return std::isfinite(value) ? fmt::format("{:.3g}", value) : "?";
}

std::string range_text(const Interval& interval) {
    return fmt::format("[{}, {}]", number_text(interval.low), number_text(interval.high));
}

std::string errors_text(const QualityOptions& options, const std::string& level,
                        const ordered_json& report) {
    const ordered_json& rows = report.at("rows");
    std::string text =
        heading(options, level, report.at("views")) + '\n' + error_tables(options, report);
    text += fmt::format(
        "  *: differs from {} in the typical run. In at most 5% of such tables a mark is chance.\n",
        options.baseline);
    text += light_warning(rows) + '\n' + ratios_by_view(options, rows) + '\n' + sample_table(rows) +
            '\n' + time_table(options, rows) + '\n' + equal_time_table(options, rows);
    if (options.floor) text += '\n' + floor_table(report);
    if (const auto nonfinite = report.at("nonfinite").get<std::uint32_t>(); nonfinite > 0)
        text += fmt::format("  {} radiance values were not finite and count as 0\n", nonfinite);
    return text;
}

std::string curve_text(const QualityOptions& options, const std::string& level,
                       const ordered_json& report) {
    const ordered_json& rows = report.at("rows");
    std::string text = heading(options, level, report.at("views"));
    for (const auto& [quantity, name] :
         {std::pair("mse", "MSE"), std::pair("trimmed_mse", "trimmed MSE")}) {
        text += fmt::format("\n  {}\n  frame", name);
        for (const ordered_json& row : rows)
            text += fmt::format("{:>12}{:>14}  {:<20}", label_of(row), "typical run", "95%");
        text += '\n';
        for (int frame = 0; frame < options.frames; ++frame) {
            text += fmt::format("  {:<5}", frame + 1);
            for (const ordered_json& row : rows) {
                const ordered_json& values = row.at(quantity).at("frames")[frame];
                const Interval typical = interval_of(values.at("median"));
                text += fmt::format("{:>12}{:>14}  {:<20}", number_text(value_of(values)),
                                    number_text(typical.value), range_text(typical));
            }
            text += '\n';
        }
        for (const ordered_json& row : rows) {
            const ordered_json& curve = row.at(quantity);
            const int frame = curve.at("settled_frame").get<int>();
            text +=
                fmt::format("  {}: settled at {}; {} within {} times that\n", label_of(row),
                            number_text(curve.at("settled").get<double>()),
                            frame > options.frames ? "never stays"
                                                   : fmt::format("from frame {} on stays", frame),
                            settled_factor);
        }
    }
    return text;
}

} // namespace vigil::bench
