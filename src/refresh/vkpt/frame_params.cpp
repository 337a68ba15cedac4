// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/frame_params.h"

#include "refresh/vkpt/scene/scene.h"
#include "refresh/vkpt/scene/transform.h"
#include "shared/sampling.h"

namespace vigil::vkpt {

void set_camera(shader::FrameParams& params, const refresh::View& view, glm::uvec2 size) {
    const glm::mat3 axes = rotation_from_angles(view.angles);
    const float tan_vertical = view.fov_y > 0.0f
                                   ? std::tan(0.5f * glm::radians(view.fov_y))
                                   : std::tan(0.5f * glm::radians(view.fov)) * (3.0f / 4.0f);
    const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
    params.camera_origin = view.origin;
    params.camera_forward = axes[0];
    params.camera_right = -axes[1] * (tan_vertical * aspect);
    params.camera_up = axes[2] * tan_vertical;
    params.size = size;
    params.pixel_angle = 2.0f * tan_vertical / static_cast<float>(size.y);
}

void set_scene(shader::FrameParams& params, const Scene& scene, double time_s) {
    const GpuSettings& settings = params.settings;
    const SkyDescription& sky = scene.sky();
    params.time_s = static_cast<float>(std::fmod(time_s, 4096.0)); // keeps its digits for days
    params.light_count = static_cast<uint32_t>(scene.lights().lights().size());
    params.sky_texture = sky.texture.value_or(shader::NONE);
    const double turned = std::fmod(time_s * static_cast<double>(sky.degrees_per_second), 360.0);
    params.sky_from_world = rotation_about(sky.axis, -static_cast<float>(turned));
    params.sky_radiance = sky.radiance * settings.pt_sky_scale;
    params.sun_direction = sky.sun_direction;
    params.sun_size = shader::cone_size(0.5f * glm::radians(settings.pt_sun_size));
    // A disc of radiance L and half angle a lights a surface that faces it with L * pi * sin(a)^2.
    const float half_sine = std::sin(0.5f * glm::radians(settings.pt_sun_size));
    params.sun_radiance =
        sky.sun_irradiance * (settings.pt_sun_scale / (shader::PI * half_sine * half_sine));
}

} // namespace vigil::vkpt
