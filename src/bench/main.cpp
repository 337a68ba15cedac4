// SPDX-License-Identifier: GPL-2.0-or-later
// The program `vigil_bench`: measurements by name. A benchmark is a row of the table; everything
// else about it is in its own file.
#include "bench/hierarchy_bench.h"
#include "bench/quality_bench.h"
#include "bench/ring_bench.h"
#include "bench/trace_bench.h"
#include "common/error.h"

#include <fmt/format.h>

#include <cstdio>
#include <string_view>
#include <vector>

namespace {

struct Bench {
    std::string_view name;
    std::string_view what;
    int (*run)(std::span<const std::string> arguments);
};

constexpr Bench benches[] = {
    {"hierarchy", "time to build the light hierarchy, by number of lights",
     vigil::bench::run_hierarchy_bench},
    {"quality", "error of every technique at one sample per pixel, and its cost",
     vigil::bench::run_quality_bench},
    {"ring", "how fast directional quadtrees follow a light that turns",
     vigil::bench::run_ring_bench},
    {"trace", "rays per second, next to Embree on the same rays", vigil::bench::run_trace_bench},
};

void list_benches() {
    for (const Bench& bench : benches)
        fmt::print("  {:<11}{}\n", bench.name, bench.what);
}

} // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    if (arguments.empty()) {
        fmt::print("vigil_bench NAME [OPTIONS]\n");
        list_benches();
        return 0;
    }
    try {
        for (const Bench& bench : benches) {
            if (arguments[0] == bench.name) return bench.run(std::span(arguments).subspan(1));
        }
        fmt::print(stderr, "{}: no such benchmark\n", arguments[0]);
        list_benches();
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
    }
    return 2;
}
