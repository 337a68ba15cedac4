// SPDX-License-Identifier: GPL-2.0-or-later
// How much of a shader is left for a pipeline's specialisation constants.
#pragma once

#include "refresh/vkpt/gpu/pipeline.h"

#include <cstddef>
#include <optional>

namespace vigil::bench {

/// Bytes of SPIR-V after the constants have their values and what no invocation can reach is gone:
/// what a driver's compiler begins with, whoever made it. Nothing without SPIRV-Tools.
std::optional<double> specialized_bytes(const gpu::PipelineSource& source);

} // namespace vigil::bench
