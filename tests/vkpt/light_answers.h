// SPDX-License-Identifier: GPL-2.0-or-later
// What a light-sampling technique claims and what it does on the GPU, at every primary hit of the
// frame that was rendered last (light_technique.comp).
#pragma once

#include "shared/scene_types.h"
#include "test_pass.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace vigil::test {

struct LightAnswer {
    float probability; // claimed
    uint32_t draws;
};

struct LightAnswers {
    size_t lights = 0;
    // Draws that each light may come from: each is tried by as large a part of all. 0:
    // probabilities are not exact.
    uint32_t draws = 0;
    std::vector<LightAnswer> answers; // rows of lights + 1; the last one stands for "no light"
    // By pixel: largest relative difference between the probability that came with a draw and the
    // claimed one.
    std::vector<float> errors;
    std::vector<shader::PrimaryHit> hits;

    std::span<const LightAnswer> row(size_t pixel) const {
        return std::span(answers).subspan(pixel * (lights + 1), lights + 1);
    }
    bool has_surface(size_t pixel) const { return hits[pixel].primitive != shader::NONE; }
    /// Sum of the claimed probabilities of all lights, at most 1 for each draw.
    double sum(size_t pixel) const;
    /// Draws of all pixels that found a light.
    double found() const;
};

/// light_technique.comp with a technique, for scenes of all features that lights can have.
vkpt::SidePass light_technique_pass(vkpt::VkptRenderer& renderer, std::string_view technique,
                                    bool caches = true);

/// Its buffers, for so many batches of radiance; those of before are forgotten.
void add_light_buffers(vkpt::SidePass& pass, vkpt::VkptRenderer& renderer, uint32_t batches);

/// Runs it at all pixels, `depth` invocations each, with two push constants.
void run_at_pixels(vkpt::SidePass& pass, vkpt::VkptRenderer& renderer, uint32_t depth,
                   glm::uvec2 push);

/// Asks for the probability of every light, and how often each is drawn.
LightAnswers ask_lights(vkpt::SidePass& pass, vkpt::VkptRenderer& renderer,
                        uint32_t draws_per_pixel);

/// Bins for a chi-square: at least ten expected draws each, what is rarer together.
class SelectionBins {
public:
    explicit SelectionBins(double draws) : draws_(draws) {}

    void add(double share, uint64_t count);
    /// Standard normal, unless there are too few bins. Ends the counting.
    std::optional<double> score();

private:
    double draws_;
    std::vector<uint64_t> counts_{0};
    std::vector<double> shares_{0.0};
};

} // namespace vigil::test
