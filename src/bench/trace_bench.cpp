// SPDX-License-Identifier: GPL-2.0-or-later
// On a CPU device both sides are timed by the processor time they use, so that neither the number
// of threads nor other programs matter; a GPU is timed by the clock. The sides take turns and
// medians are compared.
#include "bench/benches.h"

#include "bench/options.h"
#include "bench/quality_estimate.h"
#include "bench/trace_level.h"
#include "bench/trace_rig.h"
#include "common/error.h"
#include "common/output.h"
#ifdef VIGIL_HAVE_EMBREE
#include "bench/trace_embree.h"
#endif

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace vigil::bench {

namespace {

std::optional<TraceLevel> find_level(const TraceOptions& options, const std::string& name) {
    if (name == "random") return random_trace_level(options.quick ? 10000 : 50000);
    const std::filesystem::path basedir = folder_with(options.basedirs, name);
    if (!basedir.empty()) return load_trace_level(basedir, name);
    fmt::print("{}: not there, skipped\n", name);
    return std::nullopt;
}

double seconds_of(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double measure(clockid_t clock, const std::function<void()>& work) {
    const double start = seconds_of(clock);
    work();
    return seconds_of(clock) - start;
}

struct Result {
    RayKind kind;
    std::size_t rays = 0;
    double rate = 0.0;        // million rays a second
    double embree_rate = 0.0; // 0: not measured
    std::size_t mismatches = 0;
};

/// Rays the two sides answer differently: distances that differ by more than a share of 1e-4, or
/// one side stopped and the other not. Rays along an edge may go either way.
std::size_t count_mismatches(const std::vector<shader::RayAnswer>& answers,
                             const std::vector<float>& distances) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const float nearer = std::min(answers[i].t, distances[i]);
        count += !(std::abs(answers[i].t - distances[i]) <= 1e-4f * std::max(nearer, 1.0f));
    }
    return count;
}

class LevelBench {
public:
    LevelBench(const gpu::Device& device, const TraceOptions& options, const TraceLevel& level)
        : quick_(options.quick),
          clock_(device.features().is_cpu ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC),
          rig_(device, options.texels ? TraceRig::Nodes::Texels : TraceRig::Nodes::Storage)
#ifdef VIGIL_HAVE_EMBREE
          ,
          embree_(level.triangles)
#endif
    {
        build_seconds_ =
            measure(CLOCK_PROCESS_CPUTIME_ID, [&] { rig_.add_model(level.triangles); });
        rig_.finish(false);
    }

    double build_seconds() const {
        return build_seconds_;
    }

    Result run(const RaySet& set) {
        const bool any_hit = set.kind == RayKind::Shadow;
        const TraceRig::Batch batch = rig_.make_batch(set.rays);
        std::vector<double> times, embree_times;
        std::vector<float> distances;
        std::vector<std::uint32_t> stopped;
        for (int round = -1; round < (quick_ ? 3 : 9); ++round) { // the first one warms up
            const double time = measure(clock_, [&] { rig_.trace(batch, any_hit); });
            if (round >= 0) times.push_back(time);
#ifdef VIGIL_HAVE_EMBREE
            const double embree_time = measure(CLOCK_THREAD_CPUTIME_ID, [&] {
                if (any_hit)
                    embree_.occluded(set.rays, stopped);
                else
                    embree_.closest(set.rays, distances);
            });
            if (round >= 0) embree_times.push_back(embree_time);
#endif
        }
        const double millions = 1e-6 * static_cast<double>(set.rays.size());
        Result result{set.kind, set.rays.size(), millions / median(times), 0.0, 0};
        if (embree_times.empty()) return result;
        result.embree_rate = millions / median(embree_times);
        if (any_hit) {
            const std::vector<std::uint32_t> occluded = rig_.occluded(batch);
            for (std::size_t i = 0; i < stopped.size(); ++i)
                result.mismatches += occluded[i] != stopped[i];
        } else {
            result.mismatches = count_mismatches(rig_.answers(batch), distances);
        }
        return result;
    }

private:
    bool quick_;
    clockid_t clock_;
    TraceRig rig_;
#ifdef VIGIL_HAVE_EMBREE
    EmbreeTracer embree_;
#endif
    double build_seconds_ = 0.0;
};

} // namespace

int run_trace_bench(std::span<const std::string> arguments) {
    const TraceOptions options = parse_trace_options(arguments);
    const gpu::Device device(gpu::DeviceOptions{}, nullptr);
    const bool per_core = device.features().is_cpu;
    fmt::print("{}\nnodes as {}; {}\n", device.description(),
               options.texels ? "texel buffer" : "storage buffer",
               per_core ? "million rays per second and core, by processor time"
                        : "million rays per second of the device");
#ifndef VIGIL_HAVE_EMBREE
    fmt::print("Embree 3 was not there when this was built (libembree-dev): no comparison\n");
#endif
    fmt::print("{:<12}{:>10}{:>9}  {:<9}{:>9}{:>9}{:>9}{:>7}{:>12}\n", "level", "triangles",
               "build ms", "rays", "count", "vigil", "embree", "ratio", "differences");
    nlohmann::json report = {{"device", device.description()},
                             {"nodes", options.texels ? "texels" : "storage"},
                             {"unit", per_core ? "Mray/s/core" : "Mray/s"},
                             {"levels", nlohmann::json::array()}};
    bool agree = true;
    for (const std::string& name : options.levels) {
        const std::optional<TraceLevel> level = find_level(options, name);
        if (!level) continue;
        LevelBench bench(device, options, *level);
        nlohmann::json rows = nlohmann::json::array();
        for (const RaySet& set : make_rays(*level, options.quick ? 128 : 320)) {
            const Result result = bench.run(set);
            const char* kind = ray_kind_names[static_cast<std::size_t>(set.kind)];
            fmt::print("{:<12}{:>10}{:>9.0f}  {:<9}{:>9}{:>9.2f}", level->name,
                       level->triangles.size(), 1e3 * bench.build_seconds(), kind, result.rays,
                       result.rate);
            nlohmann::json row = {{"rays", kind}, {"count", result.rays}, {"vigil", result.rate}};
            if (result.embree_rate > 0.0) {
                fmt::print("{:>9.2f}{:>7.2f}{:>12}", result.embree_rate,
                           result.rate / result.embree_rate, result.mismatches);
                row["embree"] = result.embree_rate;
                row["ratio"] = result.rate / result.embree_rate;
                row["differences"] = result.mismatches;
            }
            fmt::print("\n");
            std::fflush(stdout); // rows take seconds; show them through pipes too
            rows.push_back(std::move(row));
            // Edges explain a few rays in a million; a broken traversal loses far more.
            agree &= result.mismatches <= 10 + result.rays / 10000;
        }
        report["levels"].push_back({{"name", level->name},
                                    {"triangles", level->triangles.size()},
                                    {"build_ms", 1e3 * bench.build_seconds()},
                                    {"rows", std::move(rows)}});
    }
    if (!options.json.empty()) {
        write_file(options.json, report.dump(2) + "\n");
    }
    if (!agree) fmt::print("answers differ from Embree's by more than edges explain\n");
    return agree ? 0 : 1;
}

} // namespace vigil::bench
