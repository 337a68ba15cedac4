// SPDX-License-Identifier: GPL-2.0-or-later
// Guider `brdf`: none.
#include "refresh/vkpt/guiding/guider.h"

namespace vigil::vkpt {

const Guider* guider_brdf() {
    return nullptr;
}

} // namespace vigil::vkpt
