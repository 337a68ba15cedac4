// SPDX-License-Identifier: GPL-2.0-or-later
// The order of events: references of every position of the lamp; then, seed by seed and row by row,
// frames until the trees have settled, the turn, and the frames after it.
#include "bench/ring_bench.h"

#include "bench/checkpoint.h"
#include "bench/option_values.h"
#include "bench/quality_renderer.h"
#include "bench/quality_report.h"
#include "bench/ring_report.h"
#include "client/measure/commit.h"
#include "common/progress.h"
#include "console/cvar.h"
#include "console/outdir.h"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <map>
#include <vector>

namespace vigil::bench {

namespace {

constexpr const char* level = "ring";
constexpr const char* lamp = "lamp"; // targetname of what turns

/// The reference with the lamp at an angle, by rays that know where the light comes from.
Reference make_reference(const RingOptions& options, QualityRenderer& renderer, const Pose& pose,
                         int degrees, Progress& progress) {
    renderer.turn(lamp, static_cast<float>(degrees));
    Reference reference(std::size_t{3} * options.size.x * options.size.y);
    const QualityRow row = ring_rows(std::array{64}).front();
    renderer.complete(reference, pose,
                      {row,
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

double mse(const std::vector<float>& picture, const Reference& reference) {
    return picture_error(picture, reference).mse;
}

/// One seed of one row: adds the error before the turn and those of the frames after it.
void measure(const RingOptions& options, QualityRenderer& renderer, const Pose& pose, int seed,
             int degrees, const std::map<int, Reference>& references, RingRow& row) {
    renderer.turn(lamp, 0.0f);
    renderer.begin_run(row.row, seed);
    double sum = 0.0;
    renderer.stand_still(pose, options.settle);
    for (const std::vector<float>& picture : renderer.stand_still(pose, ring_tail))
        sum += mse(picture, references.at(0));
    row.before.push_back(sum / ring_tail);
    renderer.turn(lamp, static_cast<float>(degrees));
    const std::vector<std::vector<float>> pictures = renderer.stand_still(pose, options.frames);
    row.frames.resize(pictures.size());
    for (std::size_t frame = 0; frame < pictures.size(); ++frame)
        row.frames[frame].push_back(mse(pictures[frame], references.at(degrees)));
}

RingTurn measure_turn(const RingOptions& options, QualityRenderer& renderer, const Pose& pose,
                      int degrees, const std::map<int, Reference>& references, Progress& progress) {
    RingTurn turn{degrees, references.at(degrees).mean_variance(), {}};
    for (const QualityRow& row : ring_rows(options.bits))
        turn.rows.push_back({row, {}, {}});
    for (int seed = 1; seed <= options.seeds; ++seed) {
        for (RingRow& row : turn.rows) {
            measure(options, renderer, pose, seed, degrees, references, row);
            progress.advance(fmt::format("seed {} of {}", seed, options.seeds));
        }
    }
    return turn;
}

} // namespace

int run_ring_bench(std::span<const std::string> arguments) {
    cvars().set("pt_jitter", "0"); // references show the pixels that single frames show
    cvars().set("fov", "50");      // the floor and nothing else
    const RingOptions options = parse_ring_options(arguments);
    for (const Setting& setting : options.settings)
        cvars().set(setting.name, setting.value);
    QualityOptions place;
    place.basedirs = default_basedirs();
    place.rows = ring_rows(options.bits);
    place.views = 1;
    place.warmup = 0;
    place.size = options.size;
    QualityRenderer renderer(place, level);
    const Pose pose = renderer.places().front().measured();

    const std::filesystem::path path =
        options.json.empty() ? output_path("ring.json") : std::filesystem::path(options.json);
    Checkpoint checkpoint(path,
                          {{"measured", "ring"},
                           {"device", renderer.device()},
                           {"commit", client::commit()},
                           {"width", options.size.x},
                           {"height", options.size.y},
                           {"turns", options.turns},
                           {"bits", options.bits},
                           {"seeds", options.seeds},
                           {"settle", options.settle},
                           {"frames", options.frames},
                           {"settled_tail", ring_tail},
                           {"settled_factor", ring_factor},
                           {"intervals", "typical runs"},
                           {"reference_paths", options.reference_paths},
                           {"variables", variables_json(options.settings)}},
                          options.keep);
    const auto part_name = [](int degrees) { return fmt::format("{} degrees", degrees); };
    const int steps = options.seeds * static_cast<int>(place.rows.size());
    Progress progress(steps * static_cast<int>(options.turns.size()));
    std::map<int, Reference> references;
    const auto need_reference = [&](int degrees) {
        if (!references.contains(degrees))
            references.emplace(degrees, make_reference(options, renderer, pose, degrees, progress));
    };
    for (const int degrees : options.turns) {
        if (checkpoint.find(part_name(degrees)) != nullptr) {
            fmt::print("{}: measured before, kept\n", part_name(degrees));
            progress.skip(steps);
            continue;
        }
        progress.begin(part_name(degrees));
        need_reference(0);
        need_reference(degrees);
        const RingTurn turn = measure_turn(options, renderer, pose, degrees, references, progress);
        fmt::print("{}", ring_text(turn));
        std::fflush(stdout);
        checkpoint.add(part_name(degrees), ring_json(turn));
    }
    checkpoint.finish();
    const std::filesystem::path csv = std::filesystem::path(path).replace_extension(".csv");
    write_file(csv, ring_csv(checkpoint.report()));
    fmt::print("\nreport: {}, {}\n", path.string(), csv.string());
    return 0;
}

} // namespace vigil::bench
