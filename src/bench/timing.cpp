// SPDX-License-Identifier: GPL-2.0-or-later
// What a repeat loses to other work on the machine, the median over repeats of the same frame does
// not show.
#include "bench/measure.h"
#include "client/measure/pass_statistics.h"
#include "refresh/vkpt/gpu/passes.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace vigil::bench {

using nlohmann::ordered_json;

namespace {

using refresh::PassGroup;

/// A number of every frame of every flight, [frame][flight].
template <typename Cost>
Strata by_frame(const std::vector<std::vector<FrameCost>>& flights, const Cost& cost) {
    Strata frames(flights.front().size());
    for (std::size_t frame = 0; frame < frames.size(); ++frame)
        for (const std::vector<FrameCost>& flight : flights)
            frames[frame].push_back(cost(flight[frame]));
    return frames;
}

/// Median of each frame over its repeats.
std::vector<double> medians(const Strata& frames) {
    std::vector<double> result;
    for (const std::vector<double>& repeats : frames)
        result.push_back(median(repeats));
    return result;
}

/// What a row's flights gave, [frame][flight].
struct TimingRow {
    explicit TimingRow(const std::vector<std::vector<FrameCost>>& flights)
        : prepare_ms(by_frame(
              flights, [](const auto& c) { return group_ms(c.pass_ms, PassGroup::Preparation); })),
          path_ms(by_frame(
              flights, [](const auto& c) { return group_ms(c.pass_ms, PassGroup::PathTracing); })),
          frame_ms(by_frame(flights, [](const auto& c) { return c.frame_ms; })),
          upload_bytes(by_frame(
              flights, [](const auto& c) { return static_cast<double>(c.upload_bytes); })) {
        for (std::size_t pass = 0; pass < std::size(vkpt::pass_names); ++pass) {
            pass_runs.push_back(
                by_frame(flights, [pass](const auto& c) { return c.pass_ms[pass]; }));
            pass_ms.push_back(medians(pass_runs.back()));
        }
    }

    std::vector<Strata> pass_runs;            // [pass][frame][flight]
    std::vector<std::vector<double>> pass_ms; // [pass][frame], medians
    Strata prepare_ms, path_ms, frame_ms, upload_bytes;
};

/// A pass's times over the baseline's; NaN where one of them does not have it in all frames.
Interval pass_ratio(const TimingRow& row, const TimingRow& baseline, std::string_view name) {
    const auto pass = static_cast<std::size_t>(std::ranges::find(vkpt::pass_names, name) -
                                               std::begin(vkpt::pass_names));
    return ratio_over_flights(row.pass_runs[pass], baseline.pass_runs[pass]);
}

/// The row's medians as the client's tables take them.
client::PassStatistics statistics_of(const TimingRow& row) {
    client::PassStatistics statistics;
    for (std::size_t frame = 0; frame < row.frame_ms.size(); ++frame) {
        std::vector<refresh::PassTime> passes;
        for (std::size_t pass = 0; pass < row.pass_ms.size(); ++pass)
            if (const double time = row.pass_ms[pass][frame]; time > 0.0)
                passes.push_back(
                    {std::string(vkpt::pass_names[pass]), time, vkpt::pass_groups[pass]});
        statistics.add_frame(passes);
    }
    return statistics;
}

const std::vector<client::PassSum> sums = {{PassGroup::Preparation, "= preparation"},
                                           {PassGroup::PathTracing, "= path tracing"}};

} // namespace

PartReport measure_times(const QualityOptions& options, QualityRenderer& renderer,
                         const std::string& level, Progress& progress) {
    const Place& place = renderer.places().front();
    std::vector<std::vector<std::vector<FrameCost>>> costs(options.rows.size()); // [row][flight]
    take_turns(options, progress, "flight", [&](std::size_t row, int seed) {
        costs[row].push_back(renderer.fly(place, options.rows[row], seed));
    });
    const std::vector<TimingRow> timings(costs.begin(), costs.end());
    const auto baseline_row = std::ranges::find(options.rows, options.baseline, &QualityRow::label);
    const TimingRow& baseline = timings[baseline_row - options.rows.begin()];

    std::string text =
        fmt::format("\n{}: {} x {} pixels, {} frames of a moving camera, medians of {} flights\n",
                    level, options.size.x, options.size.y, place.frames.size(), options.seeds);
    std::string ratios = fmt::format("\n{:<14}{:>14}  {:<22}{:>16}  {:<22}\n", "  row",
                                     "path / " + options.baseline, "95%", "guiding / path", "95%");
    ordered_json rows = ordered_json::array();
    for (std::size_t i = 0; i < timings.size(); ++i) {
        const TimingRow& row = timings[i];
        ordered_json json = to_json(options.rows[i]);
        const client::PassStatistics statistics = statistics_of(row);
        text += fmt::format("\n{}: {}\n", options.rows[i].label, statistics.table(sums));
        json["passes"] = ordered_json::array();
        for (const client::PassSummary& pass : statistics.summarize())
            json["passes"].push_back({{"name", pass.name},
                                      {"min_ms", pass.minimum},
                                      {"median_ms", pass.median},
                                      {"mean_ms", pass.mean},
                                      {"p99_ms", pass.p99},
                                      {"share", pass.share},
                                      {"ratio", to_json(pass_ratio(row, baseline, pass.name))}});
        const Interval path = ratio_over_flights(row.path_ms, baseline.path_ms);
        const Interval prepare = ratio_over_flights(row.prepare_ms, row.path_ms);
        ratios += fmt::format("  {:<12}{:>14}  {:<22}{:>16}  {:<22}\n", options.rows[i].label,
                              number_text(path.value), range_text(path), number_text(prepare.value),
                              range_text(prepare));
        json["path_ms"] = {{"ratio", to_json(path)}, {"frames", medians(row.path_ms)}};
        json["prepare_ms"] = {{"share_of_path", to_json(prepare)},
                              {"frames", medians(row.prepare_ms)}};
        json["frame_ms"] = {{"ratio", to_json(ratio_over_flights(row.frame_ms, baseline.frame_ms))},
                            {"frames", medians(row.frame_ms)}};
        json["upload_bytes"] = {{"value", median_of(row.upload_bytes)}};
        ordered_json& frames = json["pass_frames_ms"] = ordered_json::object();
        for (std::size_t pass = 0; pass < row.pass_ms.size(); ++pass)
            if (vkpt::pass_groups[pass] == PassGroup::Preparation &&
                std::ranges::any_of(row.pass_ms[pass], [](double time) { return time > 0.0; }))
                frames[std::string(vkpt::pass_names[pass])] = row.pass_ms[pass];
        rows.push_back(std::move(json));
    }
    return {{{"rows", std::move(rows)}}, text + ratios};
}

} // namespace vigil::bench
