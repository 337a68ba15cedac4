// SPDX-License-Identifier: GPL-2.0-or-later
// Buffers, pipeline and dispatch of importance.comp.
#include "importance_gpu.h"

#include "refresh/vkpt/light/ltc_table.h"
#include "shared/bindings.h"
#include "shared/random.h"

#include <ctime>

namespace vigil::test {
namespace {

#include "importance.comp.h" // uint32_t importance_comp[]

using namespace shader;

} // namespace

ImportanceScene make_importance_scene(uint32_t queries, uint32_t lights, bool glossy) {
    Random random = random_begin(uvec2(0, 0), 0, 1);
    const vec3 hall(2048, 2048, 256);
    const auto direction = [&] { return normalize(sample_sphere(random_next2(random))); };
    ImportanceScene scene;
    for (uint32_t i = 0; i < lights; ++i) {
        const float size = 8.0f + 56.0f * random_next(random);
        scene.lights.push_back({hall * random_next3(random), size * direction(), size * direction(),
                                10.0f * random_next3(random), 0});
    }
    for (uint32_t i = 0; i < queries; ++i) {
        ImportanceQuery query;
        query.position = hall * random_next3(random);
        query.normal = direction();
        query.view =
            to_world(make_basis(query.normal), sample_cosine_hemisphere(random_next2(random)));
        query.albedo = 0.5f;
        query.f0 = glossy ? 0.04f + 0.9f * random_next(random) : 0.0f;
        query.alpha = 0.01f + 0.99f * random_next(random);
        query.first_light = random_next_words(random).x % lights;
        scene.queries.push_back(query);
    }
    return scene;
}

LtcSurface prepare_query(const ImportanceQuery& query, bool glossy) {
    if (!glossy || query.f0 == 0.0f)
        return ltc_prepare_diffuse(query.position, query.normal, query.albedo);
    Brdf brdf = brdf_lambert(vec3(query.albedo));
    brdf.f0 = query.f0;
    brdf.alpha = query.alpha;
    const float cosine = brdf_cosine(query.normal, brdf_view(query.normal, query.view));
    return ltc_prepare_glossy(query.position, query.normal, query.view, brdf,
                              ltc_lookup(query.alpha, cosine));
}

ImportanceGpu::ImportanceGpu(const gpu::Device& device, const ImportanceScene& scene)
    : device_(device), scene_(scene),
      queries_(gpu::make_buffer(device, gpu::bytes_of(scene.queries), "queries")),
      lights_(gpu::make_buffer(device, gpu::bytes_of(scene.lights), "lights")),
      results_(device, scene.queries.size() * scene.lights_per_query * sizeof(float),
               gpu::MemoryUse::Device, "results"),
      words_(device, scene.queries.size() * sizeof(glm::uvec3), gpu::MemoryUse::Device, "words"),
      table_(gpu::make_buffer(device, gpu::bytes_of(ltc_table()), "ltc")) {
    std::vector<gpu::BindingKind> types(BINDING_LTC + 1, gpu::BindingKind::Storage);
    types[BINDING_LTC] = gpu::BindingKind::Records;
    set_ = gpu::DescriptorSet(device, types, words_, "importance");
    set_.bind(0, queries_);
    set_.bind(1, lights_);
    set_.bind(2, results_);
    set_.bind(3, words_);
    set_.bind(BINDING_LTC, table_);
    layout_ = gpu::PipelineLayout(device, {&set_});
}

double ImportanceGpu::run(uint32_t mode, bool store_all) {
    const std::vector<gpu::Specialization> constants{{0, mode}, {1, store_all ? 1u : 0u}};
    const gpu::ComputePipeline pipeline(device_, layout_, nullptr, importance_comp, constants,
                                        "importance");
    const auto queries = static_cast<uint32_t>(scene_.queries.size());
    const uint32_t push[3] = {queries, static_cast<uint32_t>(scene_.lights.size()),
                              scene_.lights_per_query};
    const std::clock_t start = std::clock();
    gpu::run_now(device_, [&](VkCommandBuffer commands) {
        const VkDescriptorSet set = set_.handle();
        pipeline.dispatch(commands, {std::span(&set, 1), gpu::bytes_of(push)},
                          {{(queries + 63) / 64, 1, 1}});
    });
    return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

std::vector<float> ImportanceGpu::answers(uint32_t mode) {
    run(mode, true);
    return gpu::download_now_as<float>(device_, results_, 0,
                                       scene_.queries.size() * scene_.lights_per_query);
}

std::vector<glm::uvec3> ImportanceGpu::random_words() {
    run(IMPORTANCE_SHIPPED, true);
    return gpu::download_now_as<glm::uvec3>(device_, words_, 0, scene_.queries.size());
}

double ImportanceGpu::time_ms(uint32_t mode) {
    return run(mode, false);
}

} // namespace vigil::test
