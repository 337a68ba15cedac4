// SPDX-License-Identifier: GPL-2.0-or-later
// The compute shaders of tests/vkpt, run on the renderer's scene.
#pragma once

#include "refresh/vkpt/side_pass.h"

#include <string_view>

namespace vigil::test {

/// The shader of that name, for scenes that have at most these features.
vkpt::SidePass test_pass(vkpt::VkptRenderer& renderer, std::string_view name,
                         const vkpt::SceneFeatures& features);

} // namespace vigil::test
