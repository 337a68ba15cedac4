// SPDX-License-Identifier: GPL-2.0-or-later
// The program `vigil_bench`: measurements by name. A benchmark is a row of the table; everything
// else about it is in its own file.
#include "bench/hierarchy_bench.h"
#include "bench/plan.h"
#include "bench/ring_bench.h"
#include "bench/trace_bench.h"
#include "common/error.h"

#include <fmt/format.h>

#include <cstdio>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vigil::bench {

namespace {

struct Bench {
    std::string_view name;
    std::string_view what;
    int (*run)(std::span<const std::string> arguments);
};

template <Plan (*make)(std::span<const std::string>)>
int run_experiment(std::span<const std::string> arguments) {
    Plan plan = make(arguments);
    select_parts(plan);
    return run_plan(plan);
}

constexpr Bench benches[] = {
    {"adapt", "error frame by frame from empty caches (figure 9)", run_experiment<adapt_plan>},
    {"confirm", "values that trade takes for better than the default, with fresh seeds",
     run_experiment<confirm_plan>},
    {"hierarchy", "time to build the light hierarchy, by number of lights", run_hierarchy_bench},
    {"quality", "error of every technique at one sample per pixel, and its cost (figure 8)",
     run_experiment<quality_plan>},
    {"ring", "how fast directional quadtrees follow a light that turns (figure 10)",
     run_ring_bench},
    {"scale", "cost and error against lights, pixels and triangles", run_experiment<scale_plan>},
    {"timing", "time of every pass while the camera moves (figures 11, 12)",
     run_experiment<timing_plan>},
    {"trace", "rays per second, next to Embree on the same rays", run_trace_bench},
    {"trade", "what every variable buys and costs", run_experiment<trade_plan>},
};

void list_benches() {
    for (const Bench& bench : benches)
        fmt::print("  {:<11}{}\n", bench.name, bench.what);
}

} // namespace

/// Runs the benchmark that the first word names; returns the exit status.
int run(std::span<const std::string> arguments) {
    if (arguments.empty()) {
        fmt::print("vigil_bench NAME [OPTIONS]\n");
        list_benches();
        return 0;
    }
    for (const Bench& bench : benches)
        if (arguments[0] == bench.name) return bench.run(arguments.subspan(1));
    fmt::print(stderr, "{}: no such benchmark\n", arguments[0]);
    list_benches();
    return 2;
}

} // namespace vigil::bench

int main(int argc, char** argv) {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    try {
        return vigil::bench::run(arguments);
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
    }
    return 2;
}
