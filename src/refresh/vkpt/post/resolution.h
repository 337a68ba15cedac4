// SPDX-License-Identifier: GPL-2.0-or-later
// How many pixels of a picture are traced: a part that the player sets (vid_scale), or as many as
// a rate of frames allows (vid_fps_target). The rest is scaled up (shaders/post/upscale.comp).
#pragma once

#include <glm/vec2.hpp>

namespace vigil::vkpt {

class Resolution {
public:
    /// Takes the settings of a frame; begins anew where they have changed. `percent` is of width
    /// and height; `frames_per_second` may be 0.
    void follow(int percent, float frames_per_second);
    /// A frame took so many milliseconds at a scale.
    void learn(double milliseconds, float scale);

    /// Part of the picture's width and height that the next frame traces, at least 0.25.
    float scale() const { return scale_; }
    /// Whether a picture is scaled up, perhaps by nothing.
    bool scales() const { return most_ < 1.0f || frames_per_second_ > 0.0f; }
    /// Pixels that the next frame traces of a picture, and those that any frame does at most.
    glm::uvec2 traced(glm::uvec2 picture) const { return size_of(picture, scale_); }
    glm::uvec2 most_traced(glm::uvec2 picture) const { return size_of(picture, most_); }

private:
    static glm::uvec2 size_of(glm::uvec2 picture, float scale);

    float most_ = 1.0f;
    float frames_per_second_ = 0.0f;
    float wanted_ = 1.0f; // smooth
    float scale_ = 1.0f;  // what is used, in steps
};

} // namespace vigil::vkpt
