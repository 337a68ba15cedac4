// SPDX-License-Identifier: GPL-2.0-or-later
// The SPIR-V of every shader, embedded in the program by cmake/Shaders.cmake.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace vigil::vkpt {

/// Code of the shader called `name` ("primary", "direct.sll", "direct.sll.query"); empty if there
/// is none.
std::span<const uint32_t> shader_code(std::string_view name);

} // namespace vigil::vkpt
