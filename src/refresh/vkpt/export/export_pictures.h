// SPDX-License-Identifier: GPL-2.0-or-later
// Pictures of an exported scene: colours as PNG (8-bit sRGB, stb_image_write), the sky as an
// equirectangular OpenEXR panorama (32-bit radiance, tinyexr). It chooses no names.
#pragma once

#include "refresh/vkpt/export/scene_export.h"

#include <cstddef>
#include <filesystem>
#include <vector>

namespace vigil::vkpt {

/// The texture as a PNG file. Throws Error.
std::vector<std::byte> encode_png(const ExportTexture& texture);

/// Radiance of the sky box from a unit direction (z up), filtered as the path tracer does it.
glm::vec3 sky_box_radiance(const std::array<ExportTexture, 6>& sides, glm::vec3 direction);

/// Direction that the panorama shows at (u, v), both 0..1 from the top left: the middle looks along
/// +x (yaw 0), u grows clockwise seen from above, v = 0 is up.
glm::vec3 panorama_direction(float u, float v);

/// Writes the sky, its factor included, as a panorama of twice the sides' resolution, but at least
/// 2048 and at most 4096 pixels around. Throws Error with the library's reason.
void write_sky_panorama(const ExportSky& sky, const std::filesystem::path& path);

} // namespace vigil::vkpt
