// SPDX-License-Identifier: GPL-2.0-or-later
// Guider `lobe`: four sums per leaf, which begin at 0 (shaders/guiding/lobe.glsl).
#include "refresh/vkpt/guiding/guider.h"

namespace vigil::vkpt {

const Guider* guider_lobe() {
    static const Guider lobe;
    return &lobe;
}

} // namespace vigil::vkpt
