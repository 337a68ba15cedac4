// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/shader_size.h"

#ifdef VIGIL_HAVE_SPIRV_TOOLS
#include <spirv-tools/optimizer.hpp>

#include <string>
#include <unordered_map>
#include <vector>
#endif

namespace vigil::bench {

#ifdef VIGIL_HAVE_SPIRV_TOOLS

std::optional<double> specialized_bytes(const gpu::PipelineSource& source) {
    std::unordered_map<uint32_t, std::vector<uint32_t>> values;
    for (const gpu::Specialization& constant : source.constants)
        values[constant.id] = {constant.value};
    // As little as shows which code is left: nothing is inlined, reordered or made faster.
    spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_2);
    optimizer.RegisterPass(spvtools::CreateSetSpecConstantDefaultValuePass(values))
        .RegisterPass(spvtools::CreateFreezeSpecConstantValuePass())
        .RegisterPass(spvtools::CreateFoldSpecConstantOpAndCompositePass())
        .RegisterPass(spvtools::CreateCCPPass())
        .RegisterPass(spvtools::CreateDeadBranchElimPass())
        .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass())
        .RegisterPass(spvtools::CreateAggressiveDCEPass());
    spvtools::OptimizerOptions options;
    options.set_run_validator(false);
    std::vector<uint32_t> left;
    if (!optimizer.Run(source.spirv.data(), source.spirv.size(), &left, options))
        return std::nullopt;
    return static_cast<double>(left.size() * sizeof(uint32_t));
}

#else

std::optional<double> specialized_bytes(const gpu::PipelineSource&) {
    return std::nullopt;
}

#endif

} // namespace vigil::bench
