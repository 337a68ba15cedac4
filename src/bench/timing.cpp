// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/timing.h"

#include "bench/quality_report.h"
#include "common/error.h"
#include "refresh/vkpt/gpu/passes.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

namespace vigil::bench {

using nlohmann::ordered_json;

namespace {

double group_ms(std::span<const double> pass_ms, refresh::PassGroup group) {
    double sum = 0.0;
    for (std::size_t pass = 0; pass < pass_ms.size(); ++pass)
        if (vkpt::pass_groups[pass] == group) sum += pass_ms[pass];
    return sum;
}

/// The row's medians as the client's tables take them.
client::PassStatistics statistics_of(const TimingRow& row) {
    client::PassStatistics statistics;
    for (const std::vector<double>& frame : row.pass_ms) {
        std::vector<refresh::PassTime> passes;
        for (std::size_t pass = 0; pass < frame.size(); ++pass)
            if (frame[pass] > 0.0)
                passes.push_back(
                    {std::string(vkpt::pass_names[pass]), frame[pass], vkpt::pass_groups[pass]});
        statistics.add_frame(passes);
    }
    return statistics;
}

const std::vector<client::PassSum> sums = {{refresh::PassGroup::Preparation, "= preparation"},
                                           {refresh::PassGroup::PathTracing, "= path tracing"}};

const TimingRow& baseline_of(const QualityOptions& options, const TimingResult& result) {
    for (const TimingRow& row : result.rows)
        if (row.row.label == options.baseline) return row;
    fail("--baseline {}: no such row", options.baseline);
}

/// Median of each frame over its repeats.
std::vector<double> medians(const Strata& frames) {
    std::vector<double> result;
    for (const std::vector<double>& repeats : frames)
        result.push_back(median(repeats));
    return result;
}

} // namespace

TimingResult measure_times(const QualityOptions& options, QualityRenderer& renderer,
                           const std::string& level, Progress& progress) {
    TimingResult result{level, {}};
    const Place& place = renderer.places().front();
    std::vector<std::vector<std::vector<FrameCost>>> costs(options.rows.size()); // [row][seed]
    for (int seed = 0; seed < options.seeds; ++seed) {
        for (std::size_t row = 0; row < options.rows.size(); ++row) {
            costs[row].push_back(renderer.fly(place, options.rows[row], options.first_seed + seed));
            progress.advance(fmt::format("flight {} of {}", seed + 1, options.seeds));
        }
    }
    for (std::size_t row = 0; row < options.rows.size(); ++row) {
        TimingRow& timing = result.rows.emplace_back();
        timing.row = options.rows[row];
        for (std::size_t frame = 0; frame < place.frames.size(); ++frame) {
            std::vector<double>& medians = timing.pass_ms.emplace_back();
            for (std::size_t pass = 0; pass < std::size(vkpt::pass_names); ++pass) {
                std::vector<double> repeats;
                for (const std::vector<FrameCost>& flight : costs[row])
                    repeats.push_back(flight[frame].pass_ms[pass]);
                medians.push_back(median(std::move(repeats)));
            }
            timing.prepare_ms.emplace_back();
            timing.path_ms.emplace_back();
            timing.frame_ms.emplace_back();
            for (const std::vector<FrameCost>& flight : costs[row]) {
                const FrameCost& cost = flight[frame];
                timing.prepare_ms.back().push_back(
                    group_ms(cost.pass_ms, refresh::PassGroup::Preparation));
                timing.path_ms.back().push_back(
                    group_ms(cost.pass_ms, refresh::PassGroup::PathTracing));
                timing.frame_ms.back().push_back(cost.frame_ms);
            }
        }
    }
    return result;
}

std::string timing_text(const QualityOptions& options, const TimingResult& result) {
    std::string text = fmt::format(
        "\n{}: {} x {} pixels, {} frames of a moving camera, medians of {} flights\n", result.level,
        options.size.x, options.size.y, result.rows.front().pass_ms.size(), options.seeds);
    for (const TimingRow& row : result.rows)
        text += fmt::format("\n{}: {}\n", row.row.label, statistics_of(row).table(sums));
    const TimingRow& baseline = baseline_of(options, result);
    text += fmt::format("\n{:<14}{:>14}  {:<22}{:>16}  {:<22}\n", "  row",
                        "path / " + options.baseline, "95%", "guiding / path", "95%");
    for (const TimingRow& row : result.rows) {
        const Interval path = ratio_over_flights(row.path_ms, baseline.path_ms);
        const Interval prepare = ratio_over_flights(row.prepare_ms, row.path_ms);
        text +=
            fmt::format("  {:<12}{:>14.3g}  {:<22}{:>16.3g}  {:<22}\n", row.row.label, path.value,
                        fmt::format("[{:.3g}, {:.3g}]", path.low, path.high), prepare.value,
                        fmt::format("[{:.3g}, {:.3g}]", prepare.low, prepare.high));
    }
    return text;
}

ordered_json timing_json(const QualityOptions& options, const TimingResult& result) {
    const TimingRow& baseline = baseline_of(options, result);
    ordered_json rows = ordered_json::array();
    for (const TimingRow& row : result.rows) {
        ordered_json json = to_json(row.row);
        const client::PassStatistics statistics = statistics_of(row);
        json["passes"] = ordered_json::array();
        for (const client::PassSummary& pass : statistics.summarize())
            json["passes"].push_back({{"name", pass.name},
                                      {"min_ms", pass.minimum},
                                      {"median_ms", pass.median},
                                      {"mean_ms", pass.mean},
                                      {"p99_ms", pass.p99},
                                      {"share", pass.share}});
        json["path_ms"] = {{"ratio", to_json(ratio_over_flights(row.path_ms, baseline.path_ms))},
                           {"frames", medians(row.path_ms)}};
        json["prepare_ms"] = {
            {"share_of_path", to_json(ratio_over_flights(row.prepare_ms, row.path_ms))},
            {"frames", medians(row.prepare_ms)}};
        json["frame_ms"] = {{"ratio", to_json(ratio_over_flights(row.frame_ms, baseline.frame_ms))},
                            {"frames", medians(row.frame_ms)}};
        ordered_json frames = ordered_json::object(); // of the passes of preparation
        for (std::size_t pass = 0; pass < std::size(vkpt::pass_names); ++pass) {
            if (vkpt::pass_groups[pass] != refresh::PassGroup::Preparation) continue;
            std::vector<double> times;
            for (const std::vector<double>& frame : row.pass_ms)
                times.push_back(frame[pass]);
            if (std::ranges::any_of(times, [](double time) { return time > 0.0; }))
                frames[std::string(vkpt::pass_names[pass])] = std::move(times);
        }
        json["pass_frames_ms"] = std::move(frames);
        rows.push_back(std::move(json));
    }
    return {{"rows", std::move(rows)}};
}

} // namespace vigil::bench
