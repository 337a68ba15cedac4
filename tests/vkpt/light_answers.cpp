// SPDX-License-Identifier: GPL-2.0-or-later
#include "light_answers.h"

#include "light/statistics.h"
#include "test_pass.h"

#include <fmt/format.h>

namespace vigil::test {

LightAnswers ask_lights(vkpt::VkptRenderer& renderer, std::string_view technique,
                        uint32_t draws_per_pixel) {
    const glm::uvec2 size = renderer.path_tracer().size();
    const size_t pixels = size_t{size.x} * size.y;
    LightAnswers answers;
    answers.draws_per_pixel = draws_per_pixel;
    answers.row = renderer.scene()->lights().lights().size() + 1;
    TestPass pass(renderer, fmt::format("light_probability.{}", technique));
    pass.add_buffer(pixels * answers.row * sizeof(float));
    pass.add_buffer(pixels * answers.row * sizeof(uint32_t));
    pass.add_buffer(pixels * sizeof(float));
    const glm::uvec2 tiles = (size + 7u) / 8u;
    pass.run({tiles, 1}, {0, 1});
    pass.run({tiles, draws_per_pixel}, {1, 1});
    answers.probabilities = pass.read<float>(0, pixels * answers.row);
    answers.draws = pass.read<uint32_t>(1, pixels * answers.row);
    answers.errors = pass.read<float>(2, pixels);
    answers.hits = gpu::download_now_as<shader::PrimaryHit>(
        renderer.device(), renderer.path_tracer().primary_hits(), 0, pixels);
    return answers;
}

std::optional<double> selection_score(std::span<const double> probabilities,
                                      std::span<const uint32_t> draws) {
    double total = 0.0;
    for (const uint32_t count : draws)
        total += count;
    std::vector<uint64_t> counts{0};
    std::vector<double> shares{0.0};
    for (size_t i = 0; i < probabilities.size(); ++i) {
        if (probabilities[i] * total >= 10.0) {
            shares.push_back(probabilities[i]);
            counts.push_back(draws[i]);
        } else {
            shares.front() += probabilities[i];
            counts.front() += draws[i];
        }
    }
    if (shares.front() * total < 3.0 && shares.size() > 1) { // too few for a bin of their own
        shares[1] += shares.front();
        counts[1] += counts.front();
        shares.erase(shares.begin());
        counts.erase(counts.begin());
    }
    if (counts.size() < 2) return std::nullopt;
    return chi_square_z(counts, shares);
}

} // namespace vigil::test
