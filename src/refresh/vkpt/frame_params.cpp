// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/frame_params.h"

#include "refresh/vkpt/scene/scene.h"
#include "refresh/vkpt/scene/transform.h"
#include "shared/sampling.h"

namespace vigil::vkpt {

void set_camera(FrameDescription& params, const refresh::View& view, glm::uvec2 size) {
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
    params.pixel_point = glm::vec2(0.5f);
    params.pixel_angle = 2.0f * tan_vertical / static_cast<float>(size.y);
}

void set_scene(FrameDescription& params, const Scene& scene, const refresh::Settings& settings,
               double time_s) {
    const SkyDescription& sky = scene.sky();
    params.time_s = static_cast<float>(std::fmod(time_s, 4096.0)); // keeps its digits for days
    params.light_count = static_cast<uint32_t>(scene.lights().lights().size());
    params.sky_texture = sky.texture.value_or(shader::NONE);
    const double turned = std::fmod(time_s * static_cast<double>(sky.degrees_per_second), 360.0);
    params.sky_from_world = rotation_about(sky.axis, -static_cast<float>(turned));
    params.sky_radiance = sky.radiance * settings.pt_sky_scale;
    const Sun sun = sky.sun(settings);
    params.sun_direction = sun.direction;
    params.sun_size = scene.has_sun() ? shader::cone_size(sun.half_angle) : -1.0f;
    params.sun_radiance = sun.radiance();
    params.sun_flux = sun.flux();
    params.sun_light = scene.lights().sun();
}

} // namespace vigil::vkpt
