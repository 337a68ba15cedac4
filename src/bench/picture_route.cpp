// SPDX-License-Identifier: GPL-2.0-or-later
// Frames at the end of a camera movement: errors, FLIP, times.
#include "bench/display.h"
#include "bench/flip.h"
#include "bench/picture_folder.h"
#include "bench/picture_rows.h"
#include "refresh/vkpt/gpu/passes.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace vigil::bench {

using nlohmann::ordered_json;

namespace {

constexpr PictureColumn route_columns[] = {{"mse", "MSE", true},
                                           {"trimmed_mse", "trimmed", true},
                                           {"relative_mse", "rel. MSE", true},
                                           {"flip", "FLIP", true},
                                           {"mean_ratio", "mean / ref."},
                                           {"filter_ms", "filter ms"},
                                           {"filter_share", "of frame"},
                                           {"frame_ms", "frame ms", true}};

void add_times(PictureRows& rows, std::size_t row, const Measurement& measured) {
    const double all = std::accumulate(measured.pass_ms.begin(), measured.pass_ms.end(), 0.0);
    const double filter = group_ms(measured.pass_ms, refresh::PassGroup::Filter);
    rows.add(row, "frame_ms", measured.frame_ms);
    rows.add(row, "path_ms", group_ms(measured.pass_ms, refresh::PassGroup::PathTracing));
    rows.add(row, "filter_ms", filter);
    rows.add(row, "filter_share", filter / all);
    for (std::size_t pass = 0; pass < measured.pass_ms.size(); ++pass)
        if (vkpt::pass_groups[pass] == refresh::PassGroup::Filter)
            rows.add(row, fmt::format("{}_ms", vkpt::pass_names[pass]), measured.pass_ms[pass]);
}

void add_errors(PictureRows& rows, std::size_t row, const std::vector<float>& picture,
                const Reference& reference, const std::vector<float>& shown, double exposure,
                glm::ivec2 size) {
    const PictureError error = picture_error(picture, reference);
    rows.add(row, "mse", error.mse);
    rows.add(row, "trimmed_mse", error.trimmed_mse);
    rows.add(row, "relative_mse", error.relative_mse);
    rows.add(row, "mean_ratio", error.mean_ratio);
    rows.add(row, "flip", mean_flip(shown, displayed(picture, exposure), size));
}

} // namespace

PartReport measure_route(const QualityOptions& options, QualityRenderer& renderer,
                         const std::string& level, Progress& progress) {
    PictureRows rows(options.rows, options.baseline);
    ordered_json views = ordered_json::array();
    for (const Place& place : renderer.places()) {
        rows.begin_view();
        std::vector<std::vector<std::vector<float>>> pictures(options.rows.size()); // [row][seed]
        std::vector<shader::PrimaryHit> surfaces;
        take_turns(options, progress, fmt::format("view {}, seed", place.name),
                   [&](std::size_t row, int seed) {
                       Measurement measured = renderer.measure(place, options.rows[row], seed, 1);
                       add_times(rows, row, measured);
                       pictures[row].push_back(std::move(measured.pictures.front()));
                       if (surfaces.empty()) surfaces = renderer.surfaces();
                   });
        const Pose& pose = place.measured();
        const Reference reference = picture_reference(options, renderer, pose, progress);
        const std::vector<float> picture = picture_of(reference);
        const double exposure = exposure_of(picture, options.size);
        const std::vector<float> shown = displayed(picture, exposure);
        for (std::size_t row = 0; row < pictures.size(); ++row)
            for (const std::vector<float>& run : pictures[row])
                add_errors(rows, row, run, reference, shown, exposure, options.size);
        ordered_json& view = views.emplace_back(view_json(place.name, pose, reference));
        view["exposure"] = exposure;
        if (options.pictures.empty()) continue;

        const PictureFolder folder(options, level, views.size());
        folder.write("reference", picture);
        folder.write_surfaces(surfaces);
        for (std::size_t row = 0; row < pictures.size(); ++row)
            for (std::size_t seed = 0; seed < pictures[row].size(); ++seed)
                folder.write(fmt::format("{}_{}", options.rows[row].label, seed + 1),
                             std::move(pictures[row][seed]));
        view["pictures"] = folder.path();
    }
    ordered_json report = {{"views", std::move(views)},
                           {"columns", to_json(route_columns)},
                           {"nonfinite", renderer.nonfinite_count()},
                           {"rows", rows.json()}};
    std::string text =
        fmt::format("\n{}: {} x {} pixels, {} frames of a moving camera, typical runs\n{}", level,
                    options.size.x, options.size.y, options.warmup, rows.text(route_columns));
    return {std::move(report), std::move(text)};
}

} // namespace vigil::bench
