// SPDX-License-Identifier: GPL-2.0-or-later
// How the GPU tests' devices are validated: as the environment variable VIGIL_VALIDATION says, a
// value of vk_validation. Without it core and synchronisation together. For tests only.
#pragma once

#include "refresh/vkpt/gpu/device.h"

#include <cstdlib>

namespace vigil::test {

inline int validation() {
    const char* const asked = std::getenv("VIGIL_VALIDATION");
    return asked != nullptr ? std::atoi(asked) : 2;
}

inline gpu::DeviceOptions validated() {
    gpu::DeviceOptions options;
    options.validation = validation();
    return options;
}

} // namespace vigil::test
