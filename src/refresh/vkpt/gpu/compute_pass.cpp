// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/gpu/compute_pass.h"

#include "refresh/vkpt/gpu/shader_library.h"

#include <algorithm>

namespace vigil::vkpt {

void ComputePass::choose(const std::string& suffix, std::vector<gpu::Specialization> constants,
                         bool ray_queries) {
    const std::string name(pass_names[static_cast<size_t>(pass_)]);
    const std::string shader = name + suffix;
    const auto known = std::ranges::find_if(variants_, [&](const Variant& made) {
        return made.shader == shader && made.constants == constants;
    });
    if (known == variants_.end()) {
        gpu::PipelineSource source{shader_code(shader), constants, name, ray_queries};
        variants_.push_back(
            {shader, std::move(constants), {compiler_, layout_, std::move(source)}});
        chosen_ = &variants_.back();
    } else {
        chosen_ = &*known;
    }
}

} // namespace vigil::vkpt
