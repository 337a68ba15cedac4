// SPDX-License-Identifier: GPL-2.0-or-later
// Runs importance.comp on the best device there is, and makes the scenes it is asked about.
#pragma once

#include "importance_query.h"
#include "refresh/vkpt/gpu/commands.h"
#include "refresh/vkpt/gpu/pipeline.h"

#include <vector>

namespace vigil::test {

/// Surfaces and lights of a large hall, 2048 x 2048 x 256 units: lamps of 8 to 64 units, in general
/// position.
struct ImportanceScene {
    std::vector<shader::ImportanceQuery> queries;
    std::vector<shader::Light> lights;
    uint32_t lights_per_query = 32;

    const shader::Light& light(size_t query, uint32_t k) const {
        return lights[(queries[query].first_light + 7 * k) % lights.size()];
    }
};

ImportanceScene make_importance_scene(uint32_t queries, uint32_t lights, bool glossy);

/// Host-side preparation of a query, as the shader does it.
shader::LtcSurface prepare_query(const shader::ImportanceQuery& query, bool glossy);

class ImportanceGpu {
public:
    ImportanceGpu(const gpu::Device& device, const ImportanceScene& scene);

    /// All answers, query by query.
    std::vector<float> answers(uint32_t mode);
    /// Milliseconds of processor time, over all cores, for all answers, summed up only. Meaningful
    /// on CPU devices, and independent there of what else the machine is doing.
    double time_ms(uint32_t mode);
    std::vector<glm::uvec3> random_words();

private:
    /// Returns the milliseconds of processor time from submission to completion.
    double run(uint32_t mode, bool store_all);

    const gpu::Device& device_;
    const ImportanceScene& scene_;
    gpu::Buffer queries_, lights_, results_, words_, table_;
    gpu::DescriptorSet set_;
    gpu::PipelineLayout layout_;
};

} // namespace vigil::test
