// SPDX-License-Identifier: GPL-2.0-or-later
// The order of events: for every view all frames of all rows, then a reference that is good enough
// for the best of them, then the errors.
#include "bench/quality_measure.h"

#include "client/measure/picture_file.h"
#include "common/error.h"
#include "refresh/vkpt/gpu/passes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace vigil::bench {

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

/// The reference of a place, from the cache and with as many batches as make it good enough for the
/// pictures, by what a pilot says, or the most paths.
ViewResult make_reference(const QualityOptions& options, QualityRenderer& renderer,
                          const Place& place, Progress& progress, Reference& reference,
                          const Pictures& pictures) {
    const int most = std::max(least_batches, options.reference_paths / reference_batch_paths);
    const auto wanted_variance = [&](const Reference& measured_against) {
        return options.reference_share * smallest_mse(pictures, measured_against);
    };
    renderer.complete(
        reference, place.measured(),
        {options.reference, options.warmup, options.fresh,
         [&](const Reference& pilot) {
             return std::max(least_batches, batches_for(pilot, wanted_variance(pilot), most));
         },
         0,
         [&](int batches) {
             progress.note(fmt::format("reference, {} paths", batches * reference_batch_paths));
         }});
    return {place,
            options.reference.label,
            reference.batches() * reference_batch_paths,
            reference.mean_variance() <= wanted_variance(reference),
            reference.picture_mean(),
            reference.picture_mean_error(),
            reference.mean_variance(),
            relative_variance(reference),
            smallest_mse(pictures, reference),
            {},
            {}};
}

/// Writes a view's reference and the first frame of every run as LEVEL/viewN/reference.exr and
/// LABEL_SEED.exr below the folder; returns where.
std::string write_pictures(const QualityOptions& options, const std::string& level,
                           std::size_t view, const Reference& reference, const Pictures& pictures) {
    const std::filesystem::path folder =
        std::filesystem::path(options.pictures) / level / fmt::format("view{}", view + 1);
    std::error_code fault;
    std::filesystem::create_directories(folder, fault);
    if (fault) fail("{}: {}", folder.string(), fault.message());
    refresh::RadiancePicture picture{options.size.x, options.size.y, 1, {}};
    for (std::size_t i = 0; i < reference.values(); ++i)
        picture.rgb.push_back(static_cast<float>(reference.mean(i)));
    client::write_exr(folder / "reference.exr", picture);
    for (std::size_t row = 0; row < pictures.size(); ++row) {
        std::string label = options.rows[row].label;
        std::ranges::replace(label, '/', '_');
        for (std::size_t seed = 0; seed < pictures[row].size(); ++seed) {
            picture.rgb = pictures[row][seed].front();
            client::write_exr(folder / fmt::format("{}_{}.exr", label, seed + 1), picture);
        }
    }
    return folder.string();
}

void add_measurement(RowResult& row, const Measurement& measured) {
    row.unlit.back().push_back(measured.unlit);
    row.explored.back().push_back(measured.explored);
    row.frame_ms.back().push_back(measured.frame_ms);
    double prepare_ms = 0.0, path_ms = 0.0;
    for (std::size_t pass = 0; pass < measured.pass_ms.size(); ++pass) {
        const double pass_ms = measured.pass_ms[pass];
        row.pass_ms[pass].back().push_back(pass_ms);
        if (vkpt::pass_groups[pass] == refresh::PassGroup::Preparation) prepare_ms += pass_ms;
        if (vkpt::pass_groups[pass] == refresh::PassGroup::PathTracing) path_ms += pass_ms;
    }
    row.prepare_ms.back().push_back(prepare_ms);
    row.path_ms.back().push_back(path_ms);
}

void begin_view(RowResult& row) {
    for (Strata* strata : {&row.mse, &row.trimmed_mse, &row.trimmed_variance, &row.bright_mse,
                           &row.bright_variance, &row.relative_mse, &row.mean_ratio, &row.unlit,
                           &row.explored, &row.prepare_ms, &row.path_ms, &row.frame_ms})
        strata->emplace_back();
    row.pass_ms.resize(std::size(vkpt::pass_names));
    for (Strata& strata : row.pass_ms)
        strata.emplace_back();
}

} // namespace

LevelResult measure_errors(const QualityOptions& options, QualityRenderer& renderer,
                           const std::string& level, Progress& progress) {
    LevelResult result{level, {}, {}, 0};
    for (const QualityRow& row : options.rows)
        result.rows.emplace_back().row = row;
    for (const Place& place : renderer.places()) {
        // All rows take turns, so that whatever else the machine does falls on all of them.
        Pictures pictures(options.rows.size());
        for (RowResult& row : result.rows)
            begin_view(row);
        for (int seed = 0; seed < options.seeds; ++seed) {
            for (std::size_t row = 0; row < options.rows.size(); ++row) {
                Measurement measured = renderer.measure(place, options.rows[row],
                                                        options.first_seed + seed, options.frames);
                add_measurement(result.rows[row], measured);
                pictures[row].push_back(std::move(measured.pictures));
                progress.advance(
                    fmt::format("view {}, seed {} of {}", place.name, seed + 1, options.seeds));
            }
        }
        Reference reference(pictures[0][0][0].size());
        result.views.push_back(
            make_reference(options, renderer, place, progress, reference, pictures));
        if (!options.pictures.empty())
            result.views.back().pictures =
                write_pictures(options, level, result.views.size() - 1, reference, pictures);
        if (options.floor) {
            progress.note("the floor");
            result.views.back().floor = renderer.floor(place);
        }
        for (std::size_t row = 0; row < pictures.size(); ++row) {
            for (const Run& run : pictures[row]) {
                const PictureError error = mean_error(run, reference);
                result.rows[row].mse.back().push_back(error.mse);
                result.rows[row].trimmed_mse.back().push_back(error.trimmed_mse);
                result.rows[row].trimmed_variance.back().push_back(error.trimmed_variance);
                if (!std::isnan(error.bright_mse)) {
                    result.rows[row].bright_mse.back().push_back(error.bright_mse);
                    result.rows[row].bright_variance.back().push_back(error.bright_variance);
                }
                result.rows[row].relative_mse.back().push_back(error.relative_mse);
                result.rows[row].mean_ratio.back().push_back(error.mean_ratio);
            }
        }
    }
    for (RowResult& row : result.rows)
        for (Strata* strata : {&row.bright_mse, &row.bright_variance})
            std::erase_if(*strata, [](const auto& view) { return view.empty(); });
    result.nonfinite = renderer.nonfinite_count();
    return result;
}

CurveResult measure_curve(const QualityOptions& options, QualityRenderer& renderer,
                          const std::string& level, Progress& progress) {
    CurveResult result{level, {}, {}};
    for (const QualityRow& row : options.rows)
        result.rows.push_back(
            {row, std::vector<Strata>(options.frames), std::vector<Strata>(options.frames)});
    for (const Place& place : renderer.places()) {
        Pictures pictures(options.rows.size());
        for (int seed = 0; seed < options.seeds; ++seed) {
            for (std::size_t row = 0; row < options.rows.size(); ++row) {
                renderer.begin_run(options.rows[row], options.first_seed + seed);
                pictures[row].push_back(renderer.stand_still(place.measured(), options.frames));
                progress.advance(
                    fmt::format("view {}, seed {} of {}", place.name, seed + 1, options.seeds));
            }
        }
        // The last frames are the best ones.
        Pictures last(options.rows.size());
        for (std::size_t row = 0; row < pictures.size(); ++row)
            for (const Run& run : pictures[row])
                last[row].push_back({run.back()});
        Reference reference(last[0][0][0].size());
        result.views.push_back(make_reference(options, renderer, place, progress, reference, last));
        for (std::size_t row = 0; row < options.rows.size(); ++row) {
            for (int frame = 0; frame < options.frames; ++frame) {
                std::vector<double>& mse = result.rows[row].mse[frame].emplace_back();
                std::vector<double>& trimmed = result.rows[row].trimmed_mse[frame].emplace_back();
                for (const Run& run : pictures[row]) {
                    const PictureError error = picture_error(run[frame], reference);
                    mse.push_back(error.mse);
                    trimmed.push_back(error.trimmed_mse);
                }
            }
        }
    }
    return result;
}

} // namespace vigil::bench
