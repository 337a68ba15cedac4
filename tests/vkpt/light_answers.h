// SPDX-License-Identifier: GPL-2.0-or-later
// What a light-sampling technique claims and what it does on the GPU, at every primary hit of the
// frame that was rendered last (light_probability.comp).
#pragma once

#include "refresh/vkpt/renderer.h"
#include "shared/scene_types.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace vigil::test {

struct LightAnswers {
    uint32_t draws_per_pixel = 0;
    size_t row = 0; // lights + 1: numbers per pixel; the last one stands for "no light"
    std::vector<float> probabilities; // claimed
    std::vector<uint32_t> draws;
    // By pixel: largest relative difference between the probability that came with a draw and the
    // claimed one.
    std::vector<float> errors;
    std::vector<shader::PrimaryHit> hits;
};

/// `technique` is the one that the frame was rendered with.
LightAnswers ask_lights(vkpt::VkptRenderer& renderer, std::string_view technique,
                        uint32_t draws_per_pixel);

/// How well draws fit probabilities: chi-square as a standard normal score, over bins of at least
/// ten expected draws and one of all the rest. Both have one number for each light and a last one
/// for "no light"; nothing if there is but one bin.
std::optional<double> selection_score(std::span<const double> probabilities,
                                      std::span<const uint32_t> draws);

} // namespace vigil::test
