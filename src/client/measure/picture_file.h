// SPDX-License-Identifier: GPL-2.0-or-later
// Pictures as files: PNG (8-bit sRGB, by stb_image_write) and OpenEXR (linear 32-bit radiance, by
// tinyexr). Files appear whole or not at all.
#pragma once

#include "refresh/refresh.h"

#include <filesystem>

namespace vigil::client {

/// Writes RGB (a screen's picture has no meaningful alpha). Throws Error with the system's reason.
void write_png(const std::filesystem::path& path, const refresh::Picture& picture);

/// Writes channels R, G, B as 32-bit floats, compressed without loss. Throws Error likewise.
void write_exr(const std::filesystem::path& path, const refresh::RadiancePicture& picture);

} // namespace vigil::client
