// SPDX-License-Identifier: GPL-2.0-or-later
// How long the Light Hierarchy takes to build, and what becomes of it; its table is in
// docs/light-sampling.md. Run by hand.
#include "common/stopwatch.h"
#include "refresh/vkpt/light/light_hierarchy.h"
#include "shared/random.h"
#include "shared/sampling.h"

#include <algorithm>
#include <cstdio>

using namespace vigil;

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
        lights.push_back({at, e1, e2, 10.0f * shader::random_next3(random)});
    }
    return lights;
}

} // namespace

int main() {
    std::printf("%8s %9s %9s %8s %8s\n", "lights", "tree ms", "all ms", "nodes", "MB");
    for (const uint32_t count : {100u, 1000u, 10000u, 100000u}) {
        const std::vector<shader::Light> lights = lamps(count);
        LightTree tree;
        LightHierarchy hierarchy;
        double tree_ms = 1e30, all_ms = 1e30;
        for (int repeat = 0; repeat < 15; ++repeat) {
            Stopwatch watch;
            tree.build(lights, 2);
            tree_ms = std::min(tree_ms, watch.milliseconds());
            watch.restart();
            hierarchy.build(lights, {});
            all_ms = std::min(all_ms, watch.milliseconds());
        }
        const double bytes = 16.0 * static_cast<double>(hierarchy.nodes().size()) +
                             4.0 * static_cast<double>(hierarchy.leaf_lights().size() +
                                                       hierarchy.places().size() +
                                                       hierarchy.parents().size());
        std::printf("%8u %9.2f %9.2f %8u %8.2f\n", count, tree_ms, all_ms,
                    hierarchy.header().node_count, bytes / 1e6);
    }
    return 0;
}
