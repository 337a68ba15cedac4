// SPDX-License-Identifier: GPL-2.0-or-later
// The one judge of means. It demands that two sets of batches agree, that a bias of a stated size
// could not hide in their noise, and that such biases, planted, are found: in all of the picture,
// in each quadrant, and in five neighbouring blocks at many places. Nothing here knows a GPU.
#pragma once

#include "picture_comparison.h"

#include <span>
#include <string_view>

namespace vigil::test {

/// Relative biases that must not hide. The noise that a test leaves must be small enough for them.
struct Bounds {
    double everywhere;         // score_limit standard errors of any channel are less
    double quadrant = 0.05;    // in any one quadrant of the picture
    double five_blocks = 0.10; // in five neighbouring blocks, wherever they are
    std::size_t blocks = 3;    // at least so many are judged in each channel
};

/// Says in one line per channel what was seen, and records bias and standard_error as
/// measured/LABEL R (G, B).
void judge(std::string_view label, const PictureBatches& seen, const PictureBatches& reference,
           const Bounds& bounds);

/// The same against known values, in the order 3 * block + channel.
void judge(std::string_view label, const PictureBatches& seen, std::span<const double> expected,
           const Bounds& bounds);

/// The same for numbers: the mean of independent differences must be 0, and a mean of
/// `bound` * `level` must not hide.
void judge_differences(std::string_view label, std::span<const double> differences, double level,
                       double bound);

} // namespace vigil::test
