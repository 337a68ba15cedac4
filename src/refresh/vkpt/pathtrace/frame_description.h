// SPDX-License-Identifier: GPL-2.0-or-later
// A frame, as its passes see it: what is copied to the device where it differs from the frame
// before, and what goes with each pass.
#pragma once

#include "shared/frame_params.h"

namespace vigil::vkpt {

struct FrameDescription : shader::FrameParams, shader::FrameTurn {};

} // namespace vigil::vkpt
