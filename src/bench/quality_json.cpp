// SPDX-License-Identifier: GPL-2.0-or-later
// The report that programs read: everything that was printed, and the single values behind it.
// Numbers that do not exist are null.
#include "bench/quality_report.h"

#include "console/cvar.h"
#include "refresh/vkpt/gpu/passes.h"

namespace vigil::bench {

using nlohmann::ordered_json;

namespace {

/// A curve, with the frame where it settles.
ordered_json to_json(const std::vector<Strata>& curve) {
    const Settled settled = settled_of(curve);
    ordered_json frames = ordered_json::array();
    for (const Strata& frame : curve) {
        frames.push_back(values_json(frame));
        frames.back()["by_view_and_seed"] = frame;
    }
    return {{"settled", settled.level},
            {"settled_tail", settled_tail},
            {"settled_factor", settled_factor},
            {"settled_frame", settled.frame},
            {"frames", std::move(frames)}};
}

ordered_json to_json(const std::vector<ViewResult>& views) {
    ordered_json list = ordered_json::array();
    for (const ViewResult& view : views) {
        const Pose& pose = view.place.measured();
        list.push_back({{"name", view.place.name},
                        {"origin", {pose.origin.x, pose.origin.y, pose.origin.z}},
                        {"angles", {pose.angles.x, pose.angles.y, pose.angles.z}},
                        {"time_s", pose.time_s},
                        {"reference",
                         {{"technique", view.technique},
                          {"paths", view.paths},
                          {"reached", view.reached},
                          {"mean", view.mean},
                          {"mean_error", view.mean_error},
                          {"variance", view.variance},
                          {"relative_variance", view.relative_variance},
                          {"smallest_mse", view.smallest_mse}}}});
        if (!view.pictures.empty()) list.back()["pictures"] = view.pictures;
        if (view.floor.pixels > 0)
            list.back()["floor"] = {{"variance", view.floor.variance},
                                    {"halves", view.floor.halves},
                                    {"pixels", view.floor.pixels}};
    }
    return list;
}

} // namespace

ordered_json to_json(const Interval& interval) {
    return {{"value", interval.value}, {"low", interval.low}, {"high", interval.high}};
}

ordered_json to_json(const Comparison& comparison) {
    ordered_json json = to_json(comparison.ratio);
    json["p"] = comparison.p;
    return json;
}

ordered_json values_json(const Strata& values) {
    return {{"value", mean_over_views(values)}, {"median", to_json(typical_run(values))}};
}

ordered_json to_json(const QualityRow& row) {
    return {{"label", row.label}, {"variables", variables_json(row.settings)}};
}

ordered_json variables_json(std::span<const Setting> settings) {
    ordered_json variables = ordered_json::object();
    for (const Setting& setting : settings)
        variables[setting.name] = setting.value;
    return variables;
}

Settled settled_of(const std::vector<Strata>& curve) {
    std::vector<double> means;
    for (const Strata& frame : curve)
        means.push_back(mean_over_views(frame));
    return settle(means, settled_tail, settled_factor);
}

ordered_json quality_json(const QualityOptions& options, const LevelResult& result) {
    const RowResult* baseline = &result.rows.front();
    for (const RowResult& row : result.rows)
        if (row.row.label == options.baseline) baseline = &row;
    ordered_json rows = ordered_json::array();
    for (const RowResult& row : result.rows) {
        ordered_json json = to_json(row.row);
        const auto add = [&](const std::string& name, Strata RowResult::*member) {
            json[name] = values_json(row.*member);
            json[name]["by_view_and_seed"] = row.*member;
        };
        const auto add_error = [&](const std::string& name, Strata RowResult::*member) {
            add(name, member);
            const ErrorRatios ratios = error_ratios(row, *baseline, member);
            json[name]["ratio"] = {{"value", ratios.means}};
            json[name]["typical"] = to_json(ratios.typical);
            json[name]["ratio_over_views"] = to_json(ratios.over_views);
        };
        const auto add_equal_time = [&](const std::string& name, Strata RowResult::*member) {
            const ErrorRatios ratios = at_equal_time(row, *baseline, member);
            json[name]["ratio_at_equal_time"] = {{"value", ratios.means}};
            json[name]["typical_at_equal_time"] = to_json(ratios.typical);
        };
        add_error("mse", &RowResult::mse);
        add_equal_time("mse", &RowResult::mse);
        add_error("trimmed_mse", &RowResult::trimmed_mse);
        add_equal_time("trimmed_mse", &RowResult::trimmed_mse);
        add("trimmed_variance", &RowResult::trimmed_variance);
        if (!row.bright_mse.empty()) {
            add_error("bright_mse", &RowResult::bright_mse);
            add("bright_variance", &RowResult::bright_variance);
        }
        add_error("relative_mse", &RowResult::relative_mse);
        add("mean_ratio", &RowResult::mean_ratio);
        json["misses_light"] = misses_light(row.mean_ratio);
        add("unlit", &RowResult::unlit);
        add("explored", &RowResult::explored);
        add("path_ms", &RowResult::path_ms);
        json["path_ms"]["ratio"] = to_json(typical_ratio(row.path_ms, baseline->path_ms));
        add("prepare_ms", &RowResult::prepare_ms);
        json["prepare_ms"]["share_of_path"] =
            to_json(typical_ratio(row.prepare_ms, row.path_ms).ratio);
        add("frame_ms", &RowResult::frame_ms);
        json["frame_ms"]["ratio"] = to_json(typical_ratio(row.frame_ms, baseline->frame_ms));
        json["efficiency"] = {{"value", efficiency(row, &RowResult::mse)},
                              {"trimmed", efficiency(row, &RowResult::trimmed_mse)}};
        if (options.floor) json["floor_over_mse"] = {{"value", share_of_floor(result.views, row)}};
        ordered_json passes = ordered_json::object();
        for (std::size_t pass = 0; pass < row.pass_ms.size(); ++pass)
            passes[std::string(vkpt::pass_names[pass])] = row.pass_ms[pass];
        json["pass_ms"] = std::move(passes);
        rows.push_back(std::move(json));
    }
    return {{"views", to_json(result.views)},
            {"nonfinite", result.nonfinite},
            {"rows", std::move(rows)}};
}

ordered_json curve_json(const CurveResult& result) {
    ordered_json rows = ordered_json::array();
    for (const CurveRow& row : result.rows) {
        ordered_json json = to_json(row.row);
        json["mse"] = to_json(row.mse);
        json["trimmed_mse"] = to_json(row.trimmed_mse);
        rows.push_back(std::move(json));
    }
    return {{"views", to_json(result.views)}, {"rows", std::move(rows)}};
}

} // namespace vigil::bench
