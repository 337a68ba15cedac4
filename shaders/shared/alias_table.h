// SPDX-License-Identifier: GPL-2.0-or-later
// Drawing an index in proportion to its weight in constant time: the look-up half of an alias table
// (Walker 1977, Vose 1991). src/refresh/vkpt/light/alias_table.cpp builds the table; the caller
// loads its entries.
#ifndef VIGIL_SHARED_ALIAS_TABLE_H
#define VIGIL_SHARED_ALIAS_TABLE_H

#include "glsl.h"

SHADER_BEGIN

/// One column: it yields its own index with probability threshold / 2^32, and `alias` otherwise.
struct AliasEntry {
    uint threshold;
    uint alias;
    float pdf; // probability that the whole table yields this column's own index; rounded once, 2^-24
};

/// Where 64 random bits fall in a table.
struct AliasSlot {
    uint column;   // in [0, count)
    uint fraction; // where in the column, in units of 2^-32
};

/// Reads `bits` as one number u = (x + y / 2^32) / 2^32 in [0, 1); column and fraction are the
/// integer and fractional part of u * count. A 24-bit float could not serve both: at a million
/// columns it reaches each of them 16 or 17 times. Precondition: count > 0.
SHADER_FN AliasSlot alias_slot(uvec2 bits, uint count) {
    uint high_integer, high_fraction, low_integer, low_fraction;
    umulExtended(bits.x, count, high_integer, high_fraction);
    umulExtended(bits.y, count, low_integer, low_fraction);
    uint carry;
    AliasSlot slot;
    slot.fraction = uaddCarry(high_fraction, low_integer, carry);
    slot.column = high_integer + carry;
    return slot;
}

/// The index drawn: `entry` is the table's entry at slot.column. Its probability is the `pdf` of
/// the entry at the returned index.
SHADER_FN uint alias_choose(AliasEntry entry, AliasSlot slot) { return slot.fraction < entry.threshold ? slot.column : entry.alias; }

SHADER_END
#endif
