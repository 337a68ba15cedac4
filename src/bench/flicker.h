// SPDX-License-Identifier: GPL-2.0-or-later
// How much pictures change from frame to frame although nothing in them does. No GPU, no files.
#pragma once

#include "shared/frame_params.h"
#include "shared/scene_types.h"

#include <cstddef>
#include <span>
#include <vector>

namespace vigil::bench {

/// Luminances of RGB, 3 values per pixel.
std::vector<double> luminances(std::span<const float> rgb);

/// Of a view that stands still: mean over the pixels of the variance of luminance over the frames.
class Flicker {
public:
    /// One frame, RGB; all of the same size.
    void add(std::span<const float> rgb);
    /// From the second frame on.
    double variance() const;

private:
    int frames_ = 0;
    std::vector<double> means_, squares_; // Welford's recurrence
};

/// A frame of a moving view: its luminance divided by that of the surfaces' colours, what is seen,
/// and the camera.
struct SeenFrame {
    std::vector<double> light; // NaN where there is nothing to light
    std::vector<shader::PrimaryHit> hits;
    shader::FrameParams camera; // its camera_ members and size
};
SeenFrame seen_frame(std::span<const float> rgb, std::vector<shader::PrimaryHit> hits,
                     const shader::FrameParams& camera);

/// Half the mean squared difference of light between points of this frame and the same points in
/// the frame before, where that saw them; for independent noise it is the variance. Nothing in the
/// scene may have moved. NaN where the frames share no point.
double moving_flicker(const SeenFrame& before, const SeenFrame& now);

} // namespace vigil::bench
