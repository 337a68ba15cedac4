// SPDX-License-Identifier: GPL-2.0-or-later
// The order of events: for every view all frames of all rows, then a reference that is good enough
// for the best of them, then the errors.
#include "bench/measure.h"

#include "bench/picture_folder.h"
#include "bench/picture_rows.h"
#include "bench/scene_changes.h"
#include "refresh/vkpt/gpu/passes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace vigil::bench {

using nlohmann::ordered_json;

namespace {

/// Fewer batches than these do not tell their own variance.
constexpr int least_batches = 6;

using Run = std::vector<std::vector<float>>;    // a picture per frame
using Pictures = std::vector<std::vector<Run>>; // [row][seed]

/// The smallest mean error of a row's pictures.
double smallest_mse(const Pictures& pictures, const Reference& reference) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const auto& row : pictures) {
        double sum = 0.0;
        for (const Run& run : row)
            sum += mean_error(run, reference).mse;
        smallest = std::min(smallest, sum / static_cast<double>(row.size()));
    }
    return smallest;
}

/// Completes the reference of a place, from the cache and with as many batches as make it good
/// enough for the pictures, by what a pilot says, or the most paths. Returns what the report says
/// of the place and its reference.
ordered_json make_reference(const QualityOptions& options, QualityRenderer& renderer,
                            const std::string& view, const Pose& pose, Progress& progress,
                            Reference& reference, const Pictures& pictures) {
    const int most = std::max(least_batches, options.reference_paths / reference_batch_paths);
    const auto wanted_variance = [&](const Reference& measured_against) {
        return options.reference_share * smallest_mse(pictures, measured_against);
    };
    renderer.complete(
        reference, pose,
        {options.reference, options.warmup, options.fresh,
         [&](const Reference& pilot) {
             return std::max(least_batches, batches_for(pilot, wanted_variance(pilot), most));
         },
         0,
         [&](int batches) {
             progress.note(fmt::format("reference, {} paths", batches * reference_batch_paths));
         }});
    return {{"name", view},
            {"origin", {pose.origin.x, pose.origin.y, pose.origin.z}},
            {"angles", {pose.angles.x, pose.angles.y, pose.angles.z}},
            {"time_s", pose.time_s},
            {"reference",
             {{"technique", options.reference.label},
              {"paths", reference.batches() * reference_batch_paths},
              {"reached", reference.mean_variance() <= wanted_variance(reference)},
              {"mean", reference.picture_mean()},
              {"mean_error", reference.picture_mean_error()},
              {"variance", reference.mean_variance()},
              {"relative_variance", relative_variance(reference)},
              {"smallest_mse", smallest_mse(pictures, reference)}}}};
}

/// Writes a view's reference and the first frame of every run as LEVEL/viewN/reference.exr and
/// LABEL_SEED.exr below the folder; returns where.
std::string write_pictures(const QualityOptions& options, const std::string& level,
                           std::size_t view, const Reference& reference, const Pictures& pictures) {
    const PictureFolder folder(options, level, view + 1);
    folder.write("reference", picture_of(reference));
    for (std::size_t row = 0; row < pictures.size(); ++row)
        for (std::size_t seed = 0; seed < pictures[row].size(); ++seed)
            folder.write(fmt::format("{}_{}", options.rows[row].label, seed + 1),
                         pictures[row][seed].front());
    return folder.path();
}

/// A number that is measured of every run, in the order of the report, and how it is compared.
struct Quantity {
    const char* name;
    bool is_error = false;
    bool at_equal_time = false;
};
constexpr Quantity quantities[] = {{"mse", true, true},  {"trimmed_mse", true, true},
                                   {"trimmed_variance"}, {"bright_mse", true},
                                   {"bright_variance"},  {"relative_mse", true},
                                   {"mean_ratio"},       {"unlit"}, // shares of primary hits
                                   {"explored"},         {"path_ms"},
                                   {"prepare_ms"},       {"frame_ms"}};

/// What a row's runs gave, by quantity and by pass; views without bright pixels are not among those
/// of bright errors.
struct RowResult {
    QualityRow row;
    std::map<std::string, Strata> values;
    std::vector<Strata> pass_ms;

    const Strata& operator[](const char* name) const { return values.at(name); }
};

void add_measurement(RowResult& row, const Measurement& measured) {
    const std::pair<const char*, double> values[] = {
        {"unlit", measured.unlit},
        {"explored", measured.explored},
        {"frame_ms", measured.frame_ms},
        {"prepare_ms", group_ms(measured.pass_ms, refresh::PassGroup::Preparation)},
        {"path_ms", group_ms(measured.pass_ms, refresh::PassGroup::PathTracing)}};
    for (const auto& [name, value] : values)
        row.values[name].back().push_back(value);
    for (std::size_t pass = 0; pass < measured.pass_ms.size(); ++pass)
        row.pass_ms[pass].back().push_back(measured.pass_ms[pass]);
}

/// Ratios of an error to the baseline's. They are unknown where one of the two misses
/// light.
void add_ratios(ordered_json& json, const Quantity& quantity, const RowResult& row,
                const RowResult& baseline) {
    const bool comparable =
        !misses_light(row["mean_ratio"]) && !misses_light(baseline["mean_ratio"]);
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    constexpr Interval nothing = {unknown, unknown, unknown};
    const auto typical = [&](const Strata& a, const Strata& b) {
        return to_json(comparable ? typical_ratio(a, b) : Comparison{nothing, unknown});
    };
    const Strata &own = row[quantity.name], &other = baseline[quantity.name];
    const double means = comparable ? ratio_of_means(own, other) : unknown;
    json["ratio"] = {{"value", means}};
    json["typical"] = typical(own, other);
    json["ratio_over_views"] = to_json(comparable ? ratio_over_views(own, other) : nothing);
    if (!quantity.at_equal_time) return;
    // Variance falls with the number of samples, so it is error times frame time that is compared,
    // run by run.
    const Strata &own_ms = row["frame_ms"], &other_ms = baseline["frame_ms"];
    json["ratio_at_equal_time"] = {{"value", means * typical_ratio(own_ms, other_ms).ratio.value}};
    json["typical_at_equal_time"] = typical(times(own, own_ms), times(other, other_ms));
}

ordered_json row_json(const RowResult& row, const RowResult& baseline) {
    ordered_json json = to_json(row.row);
    for (const Quantity& quantity : quantities) {
        if (!row.values.contains(quantity.name)) continue;
        ordered_json& value = json[quantity.name] = to_json(row[quantity.name]);
        if (quantity.is_error) add_ratios(value, quantity, row, baseline);
    }
    json["misses_light"] = misses_light(row["mean_ratio"]);
    json["path_ms"]["ratio"] = to_json(typical_ratio(row["path_ms"], baseline["path_ms"]));
    json["prepare_ms"]["share_of_path"] =
        to_json(typical_ratio(row["prepare_ms"], row["path_ms"]).ratio);
    json["frame_ms"]["ratio"] = to_json(typical_ratio(row["frame_ms"], baseline["frame_ms"]));
    // 1 / (error x seconds of a frame).
    const auto efficiency = [&](const char* error) {
        return 1.0 / (mean_over_views(row[error]) * 1e-3 * median_of(row["frame_ms"]));
    };
    json["efficiency"] = {{"value", efficiency("mse")}, {"trimmed", efficiency("trimmed_mse")}};
    for (std::size_t pass = 0; pass < row.pass_ms.size(); ++pass)
        json["pass_ms"][std::string(vkpt::pass_names[pass])] = row.pass_ms[pass];
    return json;
}

/// What a curve is measured of: the places, with what is new in them, if something changes.
std::vector<ChangingScene> curve_scenes(const QualityOptions& options, QualityRenderer& renderer) {
    if (options.changing != Changing::Nothing) {
        std::vector<ChangingScene> scenes = changing_scenes(options, renderer);
        for (ChangingScene& scene : scenes)
            scene.before.lamp.reset(); // it is switched on
        return scenes;
    }
    std::vector<ChangingScene> scenes;
    for (const Place& place : renderer.places())
        scenes.push_back({"nothing", place.name, place.measured(), {}, {}});
    return scenes;
}

} // namespace

PartReport measure_errors(const QualityOptions& options, QualityRenderer& renderer,
                          const std::string& level, Progress& progress) {
    ordered_json views = ordered_json::array();
    double floor_sum = 0.0;
    std::vector<RowResult> results;
    for (const QualityRow& row : options.rows)
        results.push_back({row, {}, std::vector<Strata>(std::size(vkpt::pass_names))});
    for (const Place& place : renderer.places()) {
        for (RowResult& row : results) {
            for (const Quantity& quantity : quantities)
                row.values[quantity.name].emplace_back();
            for (Strata& strata : row.pass_ms)
                strata.emplace_back();
        }
        Pictures pictures(options.rows.size());
        const std::string turns = fmt::format("view {}, seed", place.name);
        take_turns(options, progress, turns, [&](std::size_t row, int seed) {
            Measurement measured = renderer.measure(place, options.rows[row], seed, options.frames);
            add_measurement(results[row], measured);
            pictures[row].push_back(std::move(measured.pictures));
        });
        Reference reference(pictures[0][0][0].size());
        ordered_json view = make_reference(options, renderer, place.name, place.measured(),
                                           progress, reference, pictures);
        if (!options.pictures.empty())
            view["pictures"] = write_pictures(options, level, views.size(), reference, pictures);
        if (options.floor) {
            progress.note("the floor");
            const LightFloor floor = renderer.floor(place);
            floor_sum += floor.variance;
            if (floor.pixels > 0)
                view["floor"] = {{"variance", floor.variance},
                                 {"halves", floor.halves},
                                 {"pixels", floor.pixels}};
        }
        views.push_back(std::move(view));
        for (std::size_t row = 0; row < pictures.size(); ++row) {
            for (const Run& run : pictures[row]) {
                const PictureError error = mean_error(run, reference);
                for (const auto& [name, member] : picture_errors)
                    results[row].values[name].back().push_back(error.*member);
            }
        }
    }
    for (RowResult& row : results)
        for (const char* bright : {"bright_mse", "bright_variance"}) {
            std::erase_if(row.values[bright],
                          [](const auto& view) { return std::isnan(view.front()); });
            if (row.values[bright].empty()) row.values.erase(bright);
        }

    const RowResult& baseline = *std::ranges::find(
        results, options.baseline, [](const RowResult& row) { return row.row.label; });
    ordered_json rows = ordered_json::array();
    for (const RowResult& row : results) {
        rows.push_back(row_json(row, baseline));
        if (!options.floor) continue;
        // 1 is a perfect choice of lights.
        const double share =
            floor_sum / static_cast<double>(views.size()) / mean_over_views(row["mse"]);
        rows.back()["floor_over_mse"] = {
            {"value", misses_light(row["mean_ratio"]) ? std::nan("") : share}};
    }
    ordered_json report = {{"views", std::move(views)},
                           {"nonfinite", renderer.nonfinite_count()},
                           {"rows", std::move(rows)}};
    std::string text = errors_text(options, level, report);
    return {std::move(report), std::move(text)};
}

PartReport measure_curve(const QualityOptions& options, QualityRenderer& renderer,
                         const std::string& level, Progress& progress) {
    using Curve = std::vector<Strata>; // [frame]
    constexpr std::pair<const char*, double PictureError::*> errors[] = {
        {"mse", &PictureError::mse}, {"trimmed_mse", &PictureError::trimmed_mse}};
    ordered_json views = ordered_json::array();
    std::vector<std::map<std::string, Curve>> curves(options.rows.size());
    const bool changes = options.changing != Changing::Nothing;
    for (const ChangingScene& scene : curve_scenes(options, renderer)) {
        Pictures pictures(options.rows.size());
        const std::string turns = fmt::format("view {}, seed", scene.view);
        take_turns(options, progress, turns, [&](std::size_t row, int seed) {
            renderer.change(scene.before);
            renderer.begin_run(options.rows[row], seed);
            if (changes && options.warmup > 0) renderer.stand_still(scene.pose, options.warmup);
            renderer.change(scene.after);
            pictures[row].push_back(renderer.stand_still(scene.pose, options.frames));
        });
        // The last frames are the best ones.
        Pictures last(options.rows.size());
        for (std::size_t row = 0; row < pictures.size(); ++row)
            for (const Run& run : pictures[row])
                last[row].push_back({run.back()});
        Reference reference(last[0][0][0].size());
        views.push_back(
            make_reference(options, renderer, scene.view, scene.pose, progress, reference, last));
        for (std::size_t row = 0; row < options.rows.size(); ++row) {
            for (int frame = 0; frame < options.frames; ++frame) {
                for (const auto& [name, member] : errors) {
                    curves[row][name].resize(options.frames);
                    curves[row][name][frame].emplace_back();
                }
                for (const Run& run : pictures[row]) {
                    const PictureError error = picture_error(run[frame], reference);
                    for (const auto& [name, member] : errors)
                        curves[row][name][frame].back().push_back(error.*member);
                }
            }
        }
    }
    renderer.change({});
    ordered_json rows = ordered_json::array();
    for (std::size_t row = 0; row < options.rows.size(); ++row) {
        rows.push_back(to_json(options.rows[row]));
        for (const auto& [name, member] : errors) {
            std::vector<double> means;
            ordered_json frames = ordered_json::array();
            for (const Strata& frame : curves[row][name]) {
                means.push_back(mean_over_views(frame));
                frames.push_back(to_json(frame));
            }
            const Settled settled = settle(means, settled_tail, settled_factor);
            rows.back()[name] = {{"settled", settled.level},
                                 {"settled_tail", settled_tail},
                                 {"settled_factor", settled_factor},
                                 {"settled_frame", settled.frame},
                                 {"frames", std::move(frames)}};
        }
    }
    ordered_json report = {{"views", std::move(views)}, {"rows", std::move(rows)}};
    std::string text = curve_text(
        options, changes ? fmt::format("{}, {}", level, changing_name(options.changing)) : level,
        report);
    return {std::move(report), std::move(text)};
}

} // namespace vigil::bench
