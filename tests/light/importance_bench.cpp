// SPDX-License-Identifier: GPL-2.0-or-later
// What one light's importance costs, on the host and on the device, next to the alternatives that
// were not taken; and how far each is from the exact form factor. Its tables are in
// docs/internals/light-sampling.md. Run by hand.
#include "form_factor_reference.h"
#include "importance_gpu.h"

#include <algorithm>
#include <cstdio>
#include <ctime>

using namespace vigil;
using namespace vigil::shader;
using vigil::test::ImportanceGpu;
using vigil::test::ImportanceScene;

namespace {

constexpr const char* names[IMPORTANCE_MODES] = {"shipped, diffuse",    "shipped, with GGX",
                                                 "contour always",      "centroid always",
                                                 "three points always", "reading lights only"};

double host_ns(const ImportanceScene& scene, uint32_t mode) {
    volatile float sink = 0.0f;
    double best = 1e30;
    for (int repeat = 0; repeat < 5; ++repeat) {
        const std::clock_t start = std::clock();
        for (size_t i = 0; i < scene.queries.size(); ++i) {
            const LtcSurface surface =
                test::prepare_query(scene.queries[i], mode == IMPORTANCE_GLOSSY);
            for (uint32_t k = 0; k < scene.lights_per_query; ++k) {
                const Light& light = scene.light(i, k);
                sink = sink + (mode <= IMPORTANCE_GLOSSY
                                   ? ltc_importance(surface, light, mode == IMPORTANCE_GLOSSY)
                                   : alternative_importance(mode, surface, light));
            }
        }
        const double ns = 1e9 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        best =
            std::min(best, ns / static_cast<double>(scene.queries.size() * scene.lights_per_query));
    }
    return best;
}

/// Relative errors against double precision where at least 1e-9 arrives, sorted.
std::vector<double> errors(const ImportanceScene& scene, uint32_t mode) {
    std::vector<double> list;
    for (size_t i = 0; i < scene.queries.size(); ++i) {
        const LtcSurface surface = test::prepare_query(scene.queries[i], false);
        for (uint32_t k = 0; k < scene.lights_per_query; ++k) {
            const Light& light = scene.light(i, k);
            const glm::dvec3 v0 = glm::dvec3(light.v0) - glm::dvec3(surface.position);
            const double exact =
                test::reference_form_factor(glm::dvec3(surface.normal), v0,
                                            v0 + glm::dvec3(light.e1), v0 + glm::dvec3(light.e2));
            if (exact < 1e-9) continue;
            const float got = mode == IMPORTANCE_SHIPPED
                                  ? ltc_importance(surface, light, false)
                                  : alternative_importance(mode, surface, light);
            list.push_back(
                std::abs(got / (exact * surface.diffuse * luminance(light.radiance)) - 1.0));
        }
    }
    std::sort(list.begin(), list.end());
    return list;
}

} // namespace

int main() {
    const ImportanceScene host_scene = test::make_importance_scene(20000, 1000, true);
    const ImportanceScene scene = test::make_importance_scene(1 << 16, 1000, true);
    const gpu::Device device({}, nullptr);
    ImportanceGpu gpu(device, scene);
    std::printf("%s\n%-20s %9s %9s | relative error: %8s %8s %8s\n", device.description().c_str(),
                "importance", "host ns", "device ns", "median", "99%", "worst");
    std::vector<double> device_ms[IMPORTANCE_MODES];
    for (int repeat = 0; repeat < 25; ++repeat) // interleaved, so that other load hits all alike
        for (uint32_t mode = 0; mode < IMPORTANCE_MODES; ++mode)
            device_ms[mode].push_back(gpu.time_ms(mode));
    for (uint32_t mode = 0; mode < IMPORTANCE_MODES; ++mode) {
        std::sort(device_ms[mode].begin(), device_ms[mode].end());
        const double evaluations =
            static_cast<double>(scene.queries.size() * scene.lights_per_query);
        std::printf("%-20s %9.2f %9.2f |", names[mode], host_ns(host_scene, mode),
                    device_ms[mode].front() * 1e6 / evaluations);
        if (mode != IMPORTANCE_GLOSSY && mode != IMPORTANCE_LOAD) {
            const std::vector<double> list = errors(host_scene, mode);
            std::printf("%25.2e %8.2e %8.2e", list[list.size() / 2], list[list.size() * 99 / 100],
                        list.back());
        }
        std::printf("\n");
    }
    return 0;
}
