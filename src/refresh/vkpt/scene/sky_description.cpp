// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/scene/sky_description.h"

namespace vigil::vkpt {

Sun SkyDescription::sun(const refresh::Settings& settings) const {
    const float degrees = settings.pt_sun_size < 0.0f ? sun_degrees : settings.pt_sun_size;
    return {sun_direction, sun_irradiance * settings.pt_sun_scale, 0.5f * glm::radians(degrees)};
}

} // namespace vigil::vkpt
