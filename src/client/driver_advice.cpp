// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/driver_advice.h"

#include <fmt/format.h>

#include <charconv>

namespace vigil::client {

std::string driver_advice(std::string_view device, const std::filesystem::path& fetched) {
    constexpr std::string_view mesa = ", Mesa ";
    constexpr int fast_since = 25;
    const size_t found = device.find(mesa);
    if (!device.starts_with("llvmpipe") || found == std::string_view::npos) return {};
    const std::string_view version = device.substr(found + mesa.size());
    int major = fast_since;
    std::from_chars(version.data(), version.data() + version.size(), major);
    if (major >= fast_since) return {};
    const std::string slow = fmt::format(
        "The software driver of Mesa {} is slow. It compiles shaders again while the camera moves.",
        version.substr(0, version.find_first_of(" ,")));
    std::error_code none;
    if (std::filesystem::exists(fetched, none))
        return fmt::format("{} A faster one is here: VK_DRIVER_FILES={}", slow, fetched.string());
    return slow + " `./run` fetches a faster one on Debian 12.";
}

} // namespace vigil::client
