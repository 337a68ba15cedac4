// SPDX-License-Identifier: GPL-2.0-or-later
// The potentially visible set of a level, decompressed: which clusters may be seen from which. Rows
// are bit sets of 64-bit words, so that callers can intersect and count them word by word. It
// answers for clusters only; formats/bsp_query.h maps points to clusters.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vigil {

struct Bsp;

/// Visibility is not assumed to be symmetric: compilers write it per row.
class Pvs {
public:
    /// No clusters; everything is visible.
    Pvs() = default;

    /// Decompresses every row. A level without a visibility lump sees everything. Rows that the
    /// lump cuts short are padded with "not visible" and counted in short_rows(); a row always sees
    /// its own cluster. Throws Error where a run writes past the end of its row.
    explicit Pvs(const Bsp& bsp);

    uint32_t cluster_count() const { return cluster_count_; }
    /// 64-bit words in a row: ceil(cluster_count / 64).
    size_t words_per_row() const { return words_; }
    /// True where the level has no visibility information.
    bool sees_everything() const { return everything_; }
    /// Rows that were cut short or ran past their end; worth a warning where it is not 0.
    uint32_t damaged_rows() const { return damaged_rows_; }

    /// True where cluster `to` may be seen from cluster `from`. A cluster of -1 sees, and is seen
    /// by, everything (Quake draws the whole level from inside a wall).
    bool visible(int32_t from, int32_t to) const {
        if (everything_ || from < 0 || to < 0) return true;
        return (row(from)[static_cast<size_t>(to) / 64] >> (to % 64) & 1) != 0;
    }

    /// The row of a cluster (-1: all ones): bit c of word c / 64 is set where cluster c may be
    /// seen. Bits past cluster_count are zero. `cluster` must be below cluster_count.
    std::span<const uint64_t> row(int32_t cluster) const {
        const size_t index = everything_ || cluster < 0 ? 0 : static_cast<size_t>(cluster) + 1;
        return std::span(rows_).subspan(index * words_, words_);
    }

private:
    uint32_t cluster_count_ = 0;
    uint32_t damaged_rows_ = 0;
    size_t words_ = 0;
    bool everything_ = true;
    std::vector<uint64_t> rows_; ///< row 0 is all ones, row c + 1 is cluster c
};

} // namespace vigil
