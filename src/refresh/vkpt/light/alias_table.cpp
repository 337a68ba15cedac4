// SPDX-License-Identifier: GPL-2.0-or-later
// Vose's construction in double precision, quantised to 32-bit thresholds, with densities
// recomputed from what the quantisation made of them.
#include "refresh/vkpt/light/alias_table.h"

#include "common/error.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace vigil {
namespace {

constexpr double column_size = 4294967296.0; // thresholds count in units of 1 / 2^32

/// Sum of the weights; checks them.
double checked_total(std::span<const float> weights) {
    double total = 0.0;
    for (size_t i = 0; i < weights.size(); ++i) {
        if (!(weights[i] >= 0.0f) || !std::isfinite(weights[i]))
            fail("alias table: weight {} is {}, not a finite number >= 0", i, weights[i]);
        total += weights[i];
    }
    return total;
}

/// A column's own share as a threshold. A positive share stays drawable; a full column is one whose
/// alias is itself, so 2^32 need not be representable.
uint32_t quantise(double share) {
    const double scaled = std::floor(share * column_size + 0.5);
    return static_cast<uint32_t>(std::clamp(scaled, share > 0.0 ? 1.0 : 0.0, column_size - 1.0));
}

/// Sets each pdf to the probability with which the finished table yields that index.
void compute_densities(std::vector<shader::AliasEntry>& table) {
    // Whole numbers of 2^-32 columns: exact in a double for every column, and summed in a fixed
    // order.
    std::vector<double> mass(table.size(), 0.0);
    for (size_t i = 0; i < table.size(); ++i) {
        mass[i] += table[i].threshold;
        mass[table[i].alias] += column_size - table[i].threshold;
    }
    const double unit = 1.0 / (column_size * static_cast<double>(table.size()));
    for (size_t i = 0; i < table.size(); ++i)
        table[i].pdf = static_cast<float>(mass[i] * unit);
}

} // namespace

std::vector<shader::AliasEntry> build_alias_table(std::span<const float> weights) {
    const double total = checked_total(weights);
    if (!(total > 0.0)) return {};
    const auto count = static_cast<uint32_t>(weights.size());

    // Shares of a column: their mean is 1. Sort indices into those below and those at or above it.
    std::vector<double> share(count);
    std::vector<uint32_t> small, large;
    for (uint32_t i = 0; i < count; ++i) {
        share[i] = weights[i] / total * static_cast<double>(count);
        (share[i] < 1.0 ? small : large).push_back(i);
    }
    const auto heaviest =
        static_cast<uint32_t>(std::max_element(weights.begin(), weights.end()) - weights.begin());

    // Fill each small column up from a large one, which may become small itself.
    std::vector<shader::AliasEntry> table(count);
    while (!small.empty() && !large.empty()) {
        const uint32_t s = small.back(), l = large.back();
        small.pop_back();
        table[s] = {quantise(share[s]), l, 0.0f};
        share[l] -= 1.0 - share[s];
        if (share[l] < 1.0) {
            large.pop_back();
            small.push_back(l);
        }
    }
    // What is left is a full column but for rounding. After a long sum the rounding may also strand
    // an entry with next to no share, or none: the heaviest one takes the rest of its column.
    small.insert(small.end(), large.begin(), large.end());
    for (const uint32_t i : small) {
        if (share[i] < 0.5)
            table[i] = {quantise(share[i]), heaviest, 0.0f};
        else
            table[i] = {UINT32_MAX, i, 0.0f};
    }
    compute_densities(table);
    return table;
}

std::vector<std::byte> alias_table_bytes(std::span<const float> weights) {
    const std::vector<shader::AliasEntry> entries = build_alias_table(weights);
    const auto count = static_cast<uint32_t>(entries.size());
    const auto head = std::as_bytes(std::span(&count, 1)), rest = std::as_bytes(std::span(entries));
    std::vector<std::byte> bytes(head.size() + rest.size());
    std::ranges::copy(rest, std::ranges::copy(head, bytes.begin()).out);
    return bytes;
}

} // namespace vigil
