// SPDX-License-Identifier: GPL-2.0-or-later
// The program `vigil_bench`: measurements by name. A benchmark is a row of the table; everything
// else about it is in its own file.
#include "bench/benches.h"
#include "bench/plan.h"
#include "console/cvar.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <span>
#include <string>

namespace vigil::bench {

namespace {

struct Bench {
    const char* name;
    const char* what;
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
    {"economy", "what shaders for features that a level lacks cost, and uploads and memory",
     run_experiment<economy_plan>},
    {"hierarchy", "time to build the light hierarchy, by number of lights", run_hierarchy_bench},
    {"picture", "error, flicker, lag and detail of filtered pictures, and their cost",
     run_experiment<picture_plan>},
    {"quality", "error of every technique at one sample per pixel, and its cost (figure 8)",
     run_experiment<quality_plan>},
    {"ring", "how fast directional quadtrees follow a light that turns (figure 10)",
     run_experiment<ring_plan>},
    {"scale", "cost and error against lights, pixels and triangles", run_experiment<scale_plan>},
    {"timing", "time of every pass while the camera moves (figures 11, 12)",
     run_experiment<timing_plan>},
    {"trace", "rays per second, next to Embree on the same rays", run_trace_bench},
    {"trade", "what every variable buys and costs", run_experiment<trade_plan>},
};

} // namespace

} // namespace vigil::bench

int main(int argc, char** argv) {
    CLI::App app("Measurements. NAME --help lists the options of one.", "vigil_bench");
    int status = 0;
    for (const vigil::bench::Bench& bench : vigil::bench::benches) {
        CLI::App* command = app.add_subcommand(bench.name, bench.what);
        command->set_help_flag(); // one of the options that the benchmark parses itself
        command->prefix_command();
        command->callback([&, command] { status = bench.run(command->remaining()); });
    }
    try {
        // What is measured is raw, begins with the first frame and never rests, unless a row says
        // otherwise.
        vigil::cvars().set("flt_enable", "0");
        vigil::cvars().set("flt_first", "0");
        vigil::cvars().set("pt_rest_after", "0");
        app.parse(argc, argv);
        if (app.get_subcommands().empty()) fmt::print("{}", app.help());
        return status;
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2; // --help is no fault
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 2;
    }
}
