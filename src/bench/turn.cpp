// SPDX-License-Identifier: GPL-2.0-or-later
// The order of events: references of both positions of the lamp; then, seed by seed and row by row,
// frames until the trees have settled, the turn, and the frames after it.
#include "bench/measure.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace vigil::bench {

using nlohmann::ordered_json;

namespace {

constexpr const char* lamp = "lamp"; // targetname of what turns

/// The reference with the lamp at an angle, by rays that know where the light comes from.
Reference turned_reference(const QualityOptions& options, QualityRenderer& renderer,
                           const Pose& pose, int degrees, Progress& progress) {
    renderer.turn(lamp, static_cast<float>(degrees));
    Reference reference(std::size_t{3} * options.size.x * options.size.y);
    renderer.complete(reference, pose,
                      {options.reference,
                       options.settle,
                       options.fresh,
                       {},
                       options.reference_paths / reference_batch_paths,
                       [&](int batches) {
                           progress.note(fmt::format("reference at {} degrees, {} paths of {}",
                                                     degrees, batches * reference_batch_paths,
                                                     options.reference_paths));
                       }});
    return reference;
}

/// Errors of one row.
struct TurnRow {
    std::vector<double> before; // [seed]: mean over the last ring_tail frames
    Strata after;               // [frame][seed]
};

/// The mean over the seeds and the median with its interval, about other seeds at this one place.
ordered_json seeds_json(const std::vector<double>& seeds) {
    return {{"value", mean_over_views({seeds})},
            {"median", to_json(median_interval(seeds))},
            {"by_seed", seeds}};
}

ordered_json turn_row_json(const QualityRow& row, const TurnRow& errors) {
    ordered_json json = to_json(row);
    json["before"] = seeds_json(errors.before);
    std::vector<double> curve;
    ordered_json frames = ordered_json::array();
    for (const std::vector<double>& seeds : errors.after) {
        curve.push_back(mean_over_views({seeds}));
        frames.push_back(seeds_json(seeds));
    }
    // From which frame after the turn on the error is that before the turn again.
    json["readapted_frame"] = stays_below(curve, ring_factor * mean_over_views({errors.before}));
    const Settled settled = settle(curve, ring_tail, ring_factor);
    json["settled"] = settled.level;
    json["settled_frame"] = settled.frame;
    json["frames"] = std::move(frames);
    return json;
}

/// Ratios are to the error that the last row, rays by the BRDF, settles at.
std::string turn_text(const ordered_json& report) {
    const ordered_json& rows = report.at("rows");
    const auto baseline = rows.back().at("settled").get<double>();
    std::string text =
        fmt::format("\nturned by {} degrees; reference variance {:.3g}\n"
                    "  {:<10}{:>12}{:>12}{:>12}{:>12}{:>12}{:>14}{:>14}\n",
                    report.at("degrees").get<int>(), report.at("reference_variance").get<double>(),
                    "row", "MSE before", "frame 1", "back from", "settled", "from frame",
                    "frame 1/brdf", "settled/brdf");
    for (const ordered_json& row : rows) {
        const auto first = row.at("frames")[0].at("value").get<double>();
        const auto settled = row.at("settled").get<double>();
        const auto back = row.at("readapted_frame").get<std::size_t>();
        text += fmt::format(
            "  {:<10}{:>12.3g}{:>12.3g}{:>12}{:>12.3g}{:>12}{:>14.3g}{:>14.3g}\n",
            row.at("label").get<std::string>(), row.at("before").at("value").get<double>(), first,
            back <= row.at("frames").size() ? std::to_string(back) : "never", settled,
            row.at("settled_frame").get<int>(), first / baseline, settled / baseline);
    }
    return text;
}

} // namespace

PartReport measure_turn(const QualityOptions& options, QualityRenderer& renderer,
                        const std::string&, Progress& progress) {
    const Pose pose = renderer.places().front().measured();
    const int degrees = options.turns.front();
    const Reference straight = turned_reference(options, renderer, pose, 0, progress);
    const Reference turned = turned_reference(options, renderer, pose, degrees, progress);
    std::vector<TurnRow> errors(options.rows.size(), {{}, Strata(options.frames)});
    take_turns(options, progress, "seed", [&](std::size_t row, int seed) {
        renderer.turn(lamp, 0.0f);
        renderer.begin_run(options.rows[row], seed);
        renderer.stand_still(pose, options.settle);
        errors[row].before.push_back(
            mean_error(renderer.stand_still(pose, ring_tail), straight).mse);
        renderer.turn(lamp, static_cast<float>(degrees));
        const std::vector<std::vector<float>> pictures = renderer.stand_still(pose, options.frames);
        for (int frame = 0; frame < options.frames; ++frame)
            errors[row].after[frame].push_back(picture_error(pictures[frame], turned).mse);
    });
    ordered_json report = {{"degrees", degrees},
                           {"reference_variance", turned.mean_variance()},
                           {"rows", ordered_json::array()}};
    for (std::size_t row = 0; row < errors.size(); ++row)
        report["rows"].push_back(turn_row_json(options.rows[row], errors[row]));
    std::string text = turn_text(report);
    return {std::move(report), std::move(text)};
}

} // namespace vigil::bench
