// SPDX-License-Identifier: GPL-2.0-or-later
// FLIP for pictures of low dynamic range: how visible the difference of two pictures is to someone
// who flips between them. Andersson et al., "FLIP: A Difference Evaluator for Alternating Images",
// 2020; formulas and constants are the paper's. No GPU, no files.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace vigil::bench {

/// The paper's: 0.7 m from a display 0.7 m wide with 3840 pixels.
inline constexpr double flip_pixels_per_degree = 67.0;

/// FLIP of every pixel, 0 (the same) to 1, rows from the top. Both pictures are linear RGB of
/// display values (before sRGB's curve), as many as 3 per pixel; values outside of 0..1 are
/// clamped.
std::vector<float> flip_map(std::span<const float> reference, std::span<const float> test,
                            glm::ivec2 size, double pixels_per_degree = flip_pixels_per_degree);

/// Mean of flip_map().
double mean_flip(std::span<const float> reference, std::span<const float> test, glm::ivec2 size,
                 double pixels_per_degree = flip_pixels_per_degree);

} // namespace vigil::bench
