// SPDX-License-Identifier: GPL-2.0-or-later
// Holds the committed table.
#include "refresh/vkpt/light/ltc_table.h"

namespace vigil {
namespace {

const shader::LtcEntry entries[] = {
#include "refresh/vkpt/light/ltc_table.inc"
};
static_assert(std::size(entries) == shader::LTC_TABLE_SIZE * shader::LTC_TABLE_SIZE);
static_assert(sizeof(shader::LtcEntry) == 6 * sizeof(float), "scalar block layout");

} // namespace

std::span<const shader::LtcEntry> ltc_table() {
    return entries;
}

shader::LtcEntry ltc_lookup(float alpha, float view_cosine) {
    const shader::LtcCell cell = shader::ltc_cell(alpha, view_cosine);
    const uint32_t first = cell.row * shader::LTC_TABLE_SIZE + cell.column;
    const uint32_t below = first + shader::LTC_TABLE_SIZE;
    return shader::ltc_mix(entries[first], entries[first + 1], entries[below], entries[below + 1],
                           cell.weight);
}

} // namespace vigil
