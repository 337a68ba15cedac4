// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/benches.h"

#include "bench/options.h"
#include "common/stopwatch.h"
#include "refresh/vkpt/light/light_hierarchy.h"
#include "shared/random.h"
#include "shared/sampling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <vector>

namespace vigil::bench {

namespace {

/// Lamps in a hall: half of them along the axes, half turned anyhow.
std::vector<shader::Light> lamps(uint32_t count) {
    shader::Random random = shader::random_begin({count, 0}, 0, 0);
    std::vector<shader::Light> lights;
    for (uint32_t i = 0; i < count; ++i) {
        const glm::vec3 at = glm::vec3(4096, 4096, 512) * shader::random_next3(random);
        glm::vec3 e1(16, 0, 0), e2(0, -16, 0);
        if (i % 2 == 1) {
            const shader::Basis basis =
                shader::make_basis(shader::sample_sphere(shader::random_next2(random)));
            e1 = 16.0f * basis.tangent;
            e2 = 16.0f * basis.bitangent;
        }
        lights.push_back({at, e1, e2, 10.0f * shader::random_next3(random), 0});
    }
    return lights;
}

double processor_ms() {
    return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

} // namespace

int run_hierarchy_bench(std::span<const std::string> arguments) {
    parse_no_options(arguments);
    fmt::print("{:>8} {:>9} {:>13} {:>13} {:>8} {:>8}\n", "lights", "ms", "processor ms",
               "of it, tree", "nodes", "MB");
    for (const uint32_t count : {100u, 1000u, 10000u, 100000u}) {
        const std::vector<shader::Light> lights = lamps(count);
        LightTree tree;
        LightHierarchy hierarchy;
        double wall = 1e30, all = 1e30, part = 1e30;
        for (int repeat = 0; repeat < 15; ++repeat) {
            double start = processor_ms();
            tree.build(lights, 2);
            part = std::min(part, processor_ms() - start);
            start = processor_ms();
            const Stopwatch watch;
            hierarchy.build(lights, {});
            wall = std::min(wall, watch.milliseconds());
            all = std::min(all, processor_ms() - start);
        }
        const double bytes =
            16.0 * static_cast<double>(hierarchy.nodes().size()) +
            4.0 * static_cast<double>(hierarchy.leaf_lights().size() + hierarchy.places().size() +
                                      hierarchy.parents().size());
        fmt::print("{:>8} {:>9.2f} {:>13.2f} {:>13.2f} {:>8} {:>8.2f}\n", count, wall, all, part,
                   hierarchy.header().node_count, bytes / 1e6);
        std::fflush(stdout);
    }
    return 0;
}

} // namespace vigil::bench
