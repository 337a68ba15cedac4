// SPDX-License-Identifier: GPL-2.0-or-later
// The committed table, copied into the program by the assembler: its bytes are the GPU's.
#include "refresh/vkpt/light/ltc_table.h"

asm(R"(.pushsection .rodata
.balign 4
vigil_ltc_table: .incbin "refresh/vkpt/light/ltc_table.bin"
vigil_ltc_table_end:
.popsection)");
extern "C" const vigil::shader::LtcEntry vigil_ltc_table[], vigil_ltc_table_end[];

namespace vigil {

static_assert(sizeof(shader::LtcEntry) == 32 && shader::LTC_TABLE_SIZE == 32,
              "scalar block layout");

std::span<const shader::LtcEntry> ltc_table() {
    return {vigil_ltc_table, vigil_ltc_table_end};
}

shader::LtcEntry ltc_lookup(float alpha, float view_cosine) {
    const shader::LtcCell cell = shader::ltc_cell(alpha, view_cosine);
    const uint32_t first = cell.row * shader::LTC_TABLE_SIZE + cell.column;
    const uint32_t below = first + shader::LTC_TABLE_SIZE;
    return shader::ltc_mix(vigil_ltc_table[first], vigil_ltc_table[first + 1],
                           vigil_ltc_table[below], vigil_ltc_table[below + 1], cell.weight);
}

} // namespace vigil
