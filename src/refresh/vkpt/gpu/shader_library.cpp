// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/gpu/shader_library.h"

#include "shaders/vigil_vkpt_shaders.inc"

namespace vigil::vkpt {

namespace {

struct Row {
    std::string_view name;
    std::span<const uint32_t> code;
};

const Row rows[] = {
#include "shaders/vigil_vkpt_rows.inc"
};

} // namespace

std::span<const uint32_t> shader_code(std::string_view name) {
    for (const Row& row : rows)
        if (row.name == name) return row.code;
    return {};
}

} // namespace vigil::vkpt
