// SPDX-License-Identifier: GPL-2.0-or-later
// The order of events: references of every position of the lamp; then, seed by seed and row by row,
// frames until the trees have settled, the turn, and the frames after it.
#include "bench/ring_bench.h"

#include "bench/option_values.h"
#include "bench/quality_renderer.h"
#include "bench/ring_report.h"
#include "common/cvar.h"
#include "common/output.h"

#include <array>
#include <cstdio>
#include <map>

namespace vigil::bench {

namespace {

constexpr const char* level = "ring";
constexpr const char* lamp = "lamp"; // targetname of what turns

/// The reference with the lamp at an angle, by rays that know where the light comes from.
Reference make_reference(const RingOptions& options, QualityRenderer& renderer, const Pose& pose,
                         int degrees) {
    renderer.turn(lamp, static_cast<float>(degrees));
    Reference reference(std::size_t{3} * options.size.x * options.size.y);
    const QualityRow row = ring_rows(std::array{64}).front();
    const int batches = options.reference_paths / reference_batch_paths;
    renderer.complete(
        reference, pose,
        {row, options.settle, options.fresh, [&] { return reference.batches() >= batches; },
         [&] {
             if (reference.batches() % 16 == 0)
                 fmt::print(stderr, "{} degrees: reference, {} paths of {}\n", degrees,
                            reference.batches() * reference_batch_paths, options.reference_paths);
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
                      int degrees, const std::map<int, Reference>& references) {
    RingTurn turn{degrees, references.at(degrees).mean_variance(), {}};
    for (const QualityRow& row : ring_rows(options.bits))
        turn.rows.push_back({row, {}, {}});
    for (int seed = 1; seed <= options.seeds; ++seed) {
        for (RingRow& row : turn.rows)
            measure(options, renderer, pose, seed, degrees, references, row);
        fmt::print(stderr, "{} degrees: seed {} of {}\n", degrees, seed, options.seeds);
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

    std::map<int, Reference> references;
    references.emplace(0, make_reference(options, renderer, pose, 0));
    for (const int degrees : options.turns)
        references.emplace(degrees, make_reference(options, renderer, pose, degrees));

    nlohmann::ordered_json report = {{"measured", "ring"},
                                     {"device", renderer.device()},
                                     {"width", options.size.x},
                                     {"height", options.size.y},
                                     {"seeds", options.seeds},
                                     {"settle", options.settle},
                                     {"settled_tail", ring_tail},
                                     {"settled_factor", ring_factor},
                                     {"reference_paths", options.reference_paths},
                                     {"turns", nlohmann::ordered_json::array()}};
    const std::filesystem::path path =
        options.json.empty() ? output_path("ring.json") : std::filesystem::path(options.json);
    std::vector<RingTurn> turns;
    for (const int degrees : options.turns) {
        turns.push_back(measure_turn(options, renderer, pose, degrees, references));
        fmt::print("{}", ring_text(turns.back()));
        std::fflush(stdout);
        // After every turn, so that an interrupted run leaves what it has.
        report["turns"].push_back(ring_json(turns.back()));
        write_file(path, report.dump(1) + "\n");
        write_file(std::filesystem::path(path).replace_extension(".csv"), ring_csv(turns));
    }
    fmt::print("\nreport: {}\n", path.string());
    return 0;
}

} // namespace vigil::bench
