// SPDX-License-Identifier: GPL-2.0-or-later
// What to say to people whose software driver is slower than it need be.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace vigil::client {

/// One line, or nothing: for Mesa's llvmpipe before version 25. `device` is as
/// Renderer::device_name() tells it; `fetched` is where `./run` puts a faster driver.
std::string driver_advice(std::string_view device, const std::filesystem::path& fetched);

} // namespace vigil::client
