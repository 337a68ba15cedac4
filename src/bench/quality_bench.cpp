// SPDX-License-Identifier: GPL-2.0-or-later
// The order of events: for every view all frames of all rows, then a reference that is good enough
// for the best of them, then the errors.
#include "bench/quality_bench.h"

#include "bench/quality_progress.h"
#include "bench/quality_renderer.h"
#include "bench/quality_report.h"
#include "client/picture_file.h"
#include "common/cvar.h"
#include "common/error.h"
#include "common/log.h"
#include "common/output.h"
#include "refresh/vkpt/passes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace vigil::bench {

namespace {

/// Before this many batches a reference's own variance is not believed.
constexpr int least_batches = 6;

using Run = std::vector<std::vector<float>>;    // a picture per frame
using Pictures = std::vector<std::vector<Run>>; // [row][seed]

/// Clamped settings and missing textures must be seen; what levels contain need not.
class WarningLog {
public:
    WarningLog()
        : sink_(add_log_sink([](Severity severity, std::string_view line) {
              if (severity != Severity::Info) fmt::print(stderr, "{}\n", line);
          })) {}
    ~WarningLog() { remove_log_sink(sink_); }
    WarningLog(const WarningLog&) = delete;
    WarningLog& operator=(const WarningLog&) = delete;

private:
    int sink_;
};

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

/// The reference of a place, from the cache and with more batches until it is good enough for the
/// pictures, or has the most paths.
ViewResult make_reference(const QualityOptions& options, QualityRenderer& renderer,
                          const Place& place, Progress& progress, Reference& reference,
                          const Pictures& pictures) {
    const Pose& pose = place.measured();
    const int most = std::max(least_batches, options.reference_paths / reference_batch_paths);
    const auto good = [&] {
        return reference.batches() >= least_batches &&
               reference.mean_variance() <=
                   options.reference_share * smallest_mse(pictures, reference);
    };
    renderer.complete(reference, pose,
                      {options.reference, options.warmup, options.fresh,
                       [&] { return good() || reference.batches() >= most; },
                       [&] {
                           progress.note(fmt::format("reference, {} paths",
                                                     reference.batches() * reference_batch_paths));
                       }});
    return {place,
            options.reference.label,
            reference.batches() * reference_batch_paths,
            good(),
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

double sum_of_passes(const Measurement& measured, vkpt::Pass first, vkpt::Pass last) {
    double sum = 0.0;
    for (auto pass = static_cast<std::size_t>(first); pass <= static_cast<std::size_t>(last);
         ++pass)
        sum += measured.pass_ms[pass];
    return sum;
}

void add_measurement(RowResult& row, const Measurement& measured) {
    row.unlit.back().push_back(measured.unlit);
    row.explored.back().push_back(measured.explored);
    row.frame_ms.back().push_back(measured.frame_ms);
    for (std::size_t pass = 0; pass < measured.pass_ms.size(); ++pass)
        row.pass_ms[pass].back().push_back(measured.pass_ms[pass]);
    // Between the copies to the device and the camera rays lie the passes of guiding.
    const auto after_upload = static_cast<vkpt::Pass>(static_cast<int>(vkpt::Pass::Upload) + 1);
    const auto before_rays = static_cast<vkpt::Pass>(static_cast<int>(vkpt::Pass::Primary) - 1);
    row.prepare_ms.back().push_back(sum_of_passes(measured, after_upload, before_rays));
    row.path_ms.back().push_back(
        sum_of_passes(measured, vkpt::Pass::Primary, vkpt::Pass::Indirect));
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

LevelResult measure_level(const QualityOptions& options, QualityRenderer& renderer,
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
        result.rows.push_back({row, std::vector<Strata>(options.curve_frames),
                               std::vector<Strata>(options.curve_frames)});
    for (const Place& place : renderer.places()) {
        Pictures pictures(options.rows.size());
        for (int seed = 0; seed < options.seeds; ++seed) {
            for (std::size_t row = 0; row < options.rows.size(); ++row) {
                renderer.begin_run(options.rows[row], options.first_seed + seed);
                pictures[row].push_back(
                    renderer.stand_still(place.measured(), options.curve_frames));
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
            for (int frame = 0; frame < options.curve_frames; ++frame) {
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

} // namespace

int run_quality_bench(std::span<const std::string> arguments) {
    const WarningLog warnings;
    cvars().set("pt_jitter", "0"); // references show the pixels that single frames show
    const QualityOptions options = parse_quality_options(arguments);
    for (const Setting& setting : options.settings)
        cvars().set(setting.name, setting.value);
    const std::filesystem::path path =
        options.json.empty() ? output_path(options.curve ? "quality_curve.json" : "quality.json")
                             : std::filesystem::path(options.json);

    nlohmann::ordered_json report;
    Progress progress(options);
    int failures = 0;
    for (const std::string& level : options.levels) {
        try {
            progress.begin(level);
            QualityRenderer renderer(options, level);
            if (report.empty()) {
                report = settings_json(options, renderer.device());
                fmt::print("{}\n", renderer.device());
            }
            if (options.curve) {
                const CurveResult result = measure_curve(options, renderer, level, progress);
                fmt::print("{}", curve_text(options, result));
                report["levels"].push_back(curve_json(result));
            } else {
                const LevelResult result = measure_level(options, renderer, level, progress);
                fmt::print("{}", quality_text(options, result));
                report["levels"].push_back(quality_json(options, result));
            }
        } catch (const Error& error) {
            fmt::print(stderr, "{}: {}\n", level, error.what());
            progress.skip_level();
            ++failures;
        }
        // After every level, so that an interrupted run leaves what it has.
        std::fflush(stdout);
        if (report.contains("levels")) write_file(path, report.dump(1) + "\n");
    }
    if (report.contains("levels")) fmt::print("\nreport: {}\n", path.string());
    return failures == 0 ? 0 : 1;
}

} // namespace vigil::bench
