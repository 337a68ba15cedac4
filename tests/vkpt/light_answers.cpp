// SPDX-License-Identifier: GPL-2.0-or-later
#include "light_answers.h"

#include "light/statistics.h"

#include <algorithm>
#include <bit>
#include <fmt/format.h>

namespace vigil::test {
namespace {

size_t pixel_count(vkpt::VkptRenderer& renderer) {
    const glm::uvec2 size = renderer.buffers().size();
    return size_t{size.x} * size.y;
}

size_t light_count(vkpt::VkptRenderer& renderer) {
    return renderer.scene()->lights().lights().size();
}

} // namespace

double LightAnswers::sum(size_t pixel) const {
    double total = 0.0;
    for (const LightAnswer& answer : row(pixel).first(lights))
        total += static_cast<double>(answer.probability);
    return total;
}

double LightAnswers::found() const {
    double total = 0.0;
    for (size_t pixel = 0; pixel < hits.size(); ++pixel)
        for (const LightAnswer& answer : row(pixel).first(lights))
            total += answer.draws;
    return total;
}

vkpt::SidePass light_technique_pass(vkpt::VkptRenderer& renderer, std::string_view technique,
                                    bool caches) {
    vkpt::SceneFeatures features; // of any scene
    features.instances = features.translucent = features.lights = true;
    features.sky = features.environment = true;
    features.caches = caches;
    return test_pass(renderer, fmt::format("light_technique.{}", technique), features);
}

void add_light_buffers(vkpt::SidePass& pass, vkpt::VkptRenderer& renderer, uint32_t batches) {
    const size_t pixels = pixel_count(renderer);
    pass.clear_buffers();
    pass.add_buffer(pixels * (light_count(renderer) + 1) * sizeof(LightAnswer));
    pass.add_buffer(pixels * std::max(batches, 1u) * sizeof(glm::vec3));
    pass.add_buffer((1 + pixels) * sizeof(float));
}

void run_at_pixels(vkpt::SidePass& pass, vkpt::VkptRenderer& renderer, uint32_t depth,
                   glm::uvec2 push) {
    const glm::uvec2 tiles = (renderer.buffers().size() + 7u) / 8u;
    pass.run({tiles, depth}, push);
}

LightAnswers ask_lights(vkpt::SidePass& pass, vkpt::VkptRenderer& renderer,
                        uint32_t draws_per_pixel) {
    constexpr uint32_t lights_at_once = 128;
    const size_t pixels = pixel_count(renderer);
    LightAnswers answers;
    answers.lights = light_count(renderer);
    add_light_buffers(pass, renderer, 0);
    run_at_pixels(pass, renderer, static_cast<uint32_t>(answers.lights) / lights_at_once + 1,
                  {0, lights_at_once});
    run_at_pixels(pass, renderer, draws_per_pixel, {1, 1});
    answers.answers = pass.read<LightAnswer>(0, pixels * (answers.lights + 1));
    answers.errors = pass.read<float>(2, 1 + pixels);
    answers.draws = std::bit_cast<uint32_t>(answers.errors[0]);
    answers.errors.erase(answers.errors.begin());
    answers.hits = gpu::download_now_as<shader::PrimaryHit>(
        renderer.device(), renderer.buffers().primary_hits(), 0, pixels);
    return answers;
}

void SelectionBins::add(double share, uint64_t count) {
    if (share * draws_ >= 10.0) {
        shares_.push_back(share);
        counts_.push_back(count);
    } else {
        shares_.front() += share;
        counts_.front() += count;
    }
}

std::optional<double> SelectionBins::score() {
    if (shares_.size() > 1 && shares_.front() * draws_ < 3.0) { // too few for a bin of their own
        shares_[1] += shares_.front();
        counts_[1] += counts_.front();
        shares_.erase(shares_.begin());
        counts_.erase(counts_.begin());
    }
    if (counts_.size() < 2) return {};
    return chi_square_z(counts_, shares_);
}

} // namespace vigil::test
