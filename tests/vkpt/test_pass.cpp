// SPDX-License-Identifier: GPL-2.0-or-later
#include "test_pass.h"

#include "common/error.h"
#include "shaders/vkpt_test_shaders_shaders.inc"

namespace vigil::test {

namespace {

struct Row {
    std::string_view name;
    std::span<const uint32_t> code;
};

const Row rows[] = {
#include "shaders/vkpt_test_shaders_rows.inc"
};

} // namespace

vkpt::SidePass test_pass(vkpt::VkptRenderer& renderer, std::string_view name,
                         const vkpt::SceneFeatures& features) {
    for (const Row& row : rows)
        if (row.name == name) return {renderer, row.code, std::string(name), features};
    fail("{}: no such shader of the tests", name);
}

} // namespace vigil::test
