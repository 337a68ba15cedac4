// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/ring_report.h"

#include "bench/quality_report.h"

#include <fmt/format.h>

#include <utility>

namespace vigil::bench {

using nlohmann::ordered_json;

namespace {

/// The mean over the seeds and the median with its interval, about other seeds at this one place.
ordered_json seeds_json(const std::vector<double>& seeds) {
    return {{"value", mean_over_views({seeds})},
            {"median", to_json(median_interval(seeds))},
            {"by_seed", seeds}};
}

/// Mean error by frame after the turn.
std::vector<double> curve_of(const RingRow& row) {
    std::vector<double> means;
    for (std::size_t frame = 0; frame < row.frames.size(); ++frame)
        means.push_back(in_frame(row, frame));
    return means;
}

} // namespace

double before(const RingRow& row) {
    return mean_over_views({row.before});
}

double in_frame(const RingRow& row, std::size_t frame) {
    return mean_over_views({row.frames[frame]});
}

Settled settled_after(const RingRow& row) {
    return settle(curve_of(row), ring_tail, ring_factor);
}

int readapted_after(const RingRow& row) {
    return stays_below(curve_of(row), ring_factor * before(row));
}

std::string ring_text(const RingTurn& turn) {
    const RingRow& brdf = turn.rows.back();
    const double baseline = settled_after(brdf).level;
    std::string text =
        fmt::format("\nturned by {} degrees; reference variance {:.3g}\n"
                    "  {:<10}{:>12}{:>12}{:>12}{:>12}{:>12}{:>14}{:>14}\n",
                    turn.degrees, turn.reference_variance, "row", "MSE before", "frame 1",
                    "back from", "settled", "from frame", "frame 1/brdf", "settled/brdf");
    for (const RingRow& row : turn.rows) {
        const Settled settled = settled_after(row);
        const double first = in_frame(row, 0);
        const int back = readapted_after(row);
        const bool is_back = back <= static_cast<int>(row.frames.size());
        text +=
            fmt::format("  {:<10}{:>12.3g}{:>12.3g}{:>12}{:>12.3g}{:>12}{:>14.3g}{:>14.3g}\n",
                        row.row.label, before(row), first, is_back ? std::to_string(back) : "never",
                        settled.level, settled.frame, first / baseline, settled.level / baseline);
    }
    return text;
}

std::string ring_csv(const ordered_json& report) {
    std::string text = "degrees,row,frame,mse,median,low,high\n";
    for (const ordered_json& turn : report["parts"]) {
        for (const ordered_json& row : turn["rows"]) {
            const auto add = [&](std::size_t frame, const ordered_json& mse) {
                text += fmt::format("{},{},{}", turn["degrees"].get<int>(),
                                    row["label"].get<std::string>(), frame);
                const ordered_json& median = mse["median"];
                for (const ordered_json& number :
                     {mse["value"], median["value"], median["low"], median["high"]})
                    text += number.is_number() ? fmt::format(",{:.6g}", number.get<double>()) : ",";
                text += '\n';
            };
            add(0, row["before"]);
            for (std::size_t frame = 0; frame < row["frames"].size(); ++frame)
                add(frame + 1, row["frames"][frame]);
        }
    }
    return text;
}

ordered_json ring_json(const RingTurn& turn) {
    ordered_json rows = ordered_json::array();
    for (const RingRow& row : turn.rows) {
        ordered_json frames = ordered_json::array();
        for (const std::vector<double>& seeds : row.frames)
            frames.push_back(seeds_json(seeds));
        const Settled settled = settled_after(row);
        rows.push_back({{"label", row.row.label},
                        {"variables", variables_json(row.row.settings)},
                        {"before", seeds_json(row.before)},
                        {"readapted_frame", readapted_after(row)},
                        {"settled", settled.level},
                        {"settled_frame", settled.frame},
                        {"frames", std::move(frames)}});
    }
    return {{"degrees", turn.degrees},
            {"reference_variance", turn.reference_variance},
            {"rows", std::move(rows)}};
}

} // namespace vigil::bench
