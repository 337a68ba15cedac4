// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/post/resolution.h"

#include <algorithm>
#include <cmath>

namespace vigil::vkpt {

namespace {

constexpr float least_scale = 0.25f;
/// Of what one frame says: noise of times is smoothed, and a change takes about ten frames.
constexpr float new_part = 0.15f;
/// Smaller changes are not worth another sharpness.
constexpr float step = 0.02f;
/// Part of a frame's time that its passes may take: the host and the display need the rest.
constexpr double usable = 0.92;

} // namespace

void Resolution::follow(int percent, float frames_per_second) {
    const float most = static_cast<float>(percent) / 100.0f;
    if (most == most_ && frames_per_second == frames_per_second_) return;
    most_ = most;
    frames_per_second_ = frames_per_second;
    wanted_ = scale_ = most;
}

void Resolution::learn(double milliseconds, float scale) {
    if (frames_per_second_ <= 0.0f || !(milliseconds > 0.0)) return;
    // Time goes with the number of pixels: a frame that is late says the same as the next.
    const double aim = usable * 1000.0 / static_cast<double>(frames_per_second_);
    const auto fitting = scale * static_cast<float>(std::sqrt(aim / milliseconds));
    const float least = std::min(least_scale, most_);
    wanted_ += new_part * (std::clamp(fitting, least, most_) - wanted_);
    if (wanted_ > most_ - 0.5f * step)
        scale_ = most_;
    else if (wanted_ < least + 0.5f * step)
        scale_ = least;
    else if (std::abs(wanted_ - scale_) > step)
        scale_ = std::round(wanted_ / step) * step;
}

glm::uvec2 Resolution::size_of(glm::uvec2 picture, float scale) {
    const auto part = [&](uint32_t edge) {
        return std::max(static_cast<uint32_t>(std::lround(scale * static_cast<float>(edge))), 1u);
    };
    return {part(picture.x), part(picture.y)};
}

} // namespace vigil::vkpt
