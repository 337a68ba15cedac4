// SPDX-License-Identifier: GPL-2.0-or-later
// Decompression of Quake II's visibility rows: each row is a bit per cluster, byte by byte with the
// lowest bit first; a zero byte is followed by the number of zero bytes it stands for.
#include "level/pvs.h"

#include "formats/bsp.h"

#include <algorithm>

namespace vigil {

namespace {

void set_bit(std::span<uint64_t> row, size_t bit) {
    row[bit / 64] |= uint64_t{1} << (bit % 64);
}

/// Decodes one row into `row` (zeroed by the caller). False where the row is damaged.
bool decompress_row(std::span<const uint8_t> in, size_t row_bytes, std::span<uint64_t> row) {
    size_t out = 0;
    for (size_t at = 0; out < row_bytes; ++at) {
        if (at >= in.size()) return false;
        if (in[at] != 0) {
            row[out / 8] |= uint64_t{in[at]} << (out % 8 * 8);
            ++out;
            continue;
        }
        if (++at >= in.size()) return false;
        out += in[at];
    }
    return out == row_bytes;
}

} // namespace

Pvs::Pvs(const Bsp& bsp)
    : cluster_count_(bsp.cluster_count), words_((size_t{bsp.cluster_count} + 63) / 64),
      everything_(bsp.visibility_offsets.empty()) {
    rows_.assign(words_ * (everything_ ? 1 : size_t{cluster_count_} + 1), 0);
    if (words_ == 0) return;

    const std::span<uint64_t> rows(rows_);
    std::fill_n(rows_.begin(), words_, ~uint64_t{0});
    // Compilers leave bits past the last cluster undefined; rows here end in zeros.
    const uint64_t last_word = ~uint64_t{0} >> (words_ * 64 - cluster_count_);
    rows_[words_ - 1] = last_word;
    if (everything_) return;

    const std::span<const uint8_t> lump(bsp.visibility);
    const size_t row_bytes = (size_t{cluster_count_} + 7) / 8;
    for (size_t cluster = 0; cluster < cluster_count_; ++cluster) {
        const auto row = rows.subspan((cluster + 1) * words_, words_);
        const uint32_t offset = bsp.visibility_offsets[cluster][0];
        if (!decompress_row(lump.subspan(offset), row_bytes, row)) ++damaged_rows_;
        row.back() &= last_word;
        set_bit(row, cluster);
    }
}

} // namespace vigil
