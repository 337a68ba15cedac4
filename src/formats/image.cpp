// SPDX-License-Identifier: GPL-2.0-or-later
// Picks the decoder for a picture's bytes, and the small things every texture needs: the checker,
// the fallback palette, the limits of sizes.
#include "formats/image.h"

#include "common/ascii_case.h"
#include "common/error.h"
#include "formats/image_decoders.h"
#include "formats/pcx.h"
#include "formats/wal.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace vigil {

namespace {

bool starts_with(std::span<const uint8_t> bytes, std::initializer_list<uint8_t> signature) {
    return bytes.size() >= signature.size() &&
           std::equal(signature.begin(), signature.end(), bytes.begin());
}

/// The extension without its dot, in lower case.
std::string extension_of(std::string_view name) {
    const size_t dot = name.find_last_of("./");
    if (dot == std::string_view::npos || name[dot] == '/') return {};
    return ascii_lower(name.substr(dot + 1));
}

std::array<float, 256> make_linear_table() {
    std::array<float, 256> table{};
    for (size_t i = 0; i < table.size(); ++i) {
        const double s = static_cast<double>(i) / 255.0;
        table[i] =
            static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
    }
    return table;
}

} // namespace

Image decode_image(std::string_view name, std::span<const uint8_t> bytes, const Palette* palette) {
    if (bytes.empty()) fail("{}: the file is empty", name);
    if (starts_with(bytes, {0x89, 'P', 'N', 'G'})) return decode_png(name, bytes);
    if (starts_with(bytes, {0xff, 0xd8, 0xff})) return decode_jpg(name, bytes);
    if (starts_with(bytes, {0x0a, 5, 1, 8})) return to_image(decode_pcx(name, bytes));

    const std::string extension = extension_of(name);
    if (extension == "tga") return decode_tga(name, bytes);
    if (extension == "wal") return decode_wal(name, bytes, palette).image;
    if (extension == "pcx") return to_image(decode_pcx(name, bytes));
    if (extension == "png" || extension == "jpg" || extension == "jpeg")
        fail("{}: the bytes are neither PNG nor JPG", name);
    fail("{}: not a picture format Vigil reads (png, jpg, tga, wal, pcx)", name);
}

void check_image_size(std::string_view name, uint64_t width, uint64_t height) {
    if (width == 0 || height == 0) fail("{}: the picture is empty ({} x {})", name, width, height);
    if (width > image_max_size || height > image_max_size || width * height > image_max_pixels)
        fail("{}: {} x {} pixels are too many (limit {} per side, {} in all)", name, width, height,
             image_max_size, image_max_pixels);
}

void check_image_size(std::string_view name, uint64_t width, uint64_t height, uint64_t bytes,
                      uint64_t most) {
    check_image_size(name, width, height);
    if (width * height > bytes * most)
        fail("{}: {} bytes cannot hold {} x {} pixels", name, bytes, width, height);
}

Palette fallback_palette() {
    Palette palette;
    for (size_t i = 0; i < palette.size(); ++i)
        palette[i].fill(static_cast<uint8_t>(i % 16 * 17));
    return palette;
}

Image checker_image() {
    constexpr uint32_t size = 64, square = 8;
    constexpr std::array<std::array<uint8_t, 4>, 2> colors = {
        {{56, 56, 56, 255}, {200, 40, 200, 255}}};
    Image image{size, size, {}};
    image.rgba.reserve(size_t{4} * size * size);
    for (uint32_t y = 0; y < size; ++y)
        for (uint32_t x = 0; x < size; ++x) {
            const auto& color = colors[(x / square + y / square) % 2];
            image.rgba.insert(image.rgba.end(), color.begin(), color.end());
        }
    return image;
}

float srgb_to_linear(uint8_t value) {
    static const std::array<float, 256> table = make_linear_table();
    return table[value];
}

uint8_t linear_to_srgb(float linear) {
    const float x = linear > 0.0f ? std::min(linear, 1.0f) : 0.0f;
    const float encoded = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
    return static_cast<uint8_t>(std::lround(255.0f * encoded));
}

} // namespace vigil
