// SPDX-License-Identifier: GPL-2.0-or-later
// TGA by stb_image; see image_decoders.h. stb_image reads zeros past the end of its input, so
// truncated files would pass as pictures with black areas: they are measured here first.
#include "common/error.h"
#include "common/printable.h"
#include "formats/byte_reader.h"
#include "formats/image_decoders.h"

#include <stb/stb_image.h>

#include <algorithm>
#include <climits>
#include <memory>

namespace vigil {

namespace {

struct TgaHeader {
    uint32_t id_size = 0, palette_type = 0, type = 0;
    uint32_t palette_length = 0, palette_bits = 0;
    uint32_t width = 0, height = 0, bits = 0, descriptor = 0;

    bool run_length() const { return type >= 8; }
    uint32_t pixel_bytes() const { return (bits + 7) / 8; }
    bool right_to_left() const { return (descriptor & 0x10) != 0; }
    uint32_t alpha_bits() const { return descriptor & 0xf; }
};

TgaHeader read_tga_header(ByteReader& reader) {
    TgaHeader header;
    reader.get_as<uint8_t>(header.id_size, header.palette_type, header.type);
    reader.skip(2); // first palette entry
    reader.get_as<uint16_t>(header.palette_length);
    reader.get_as<uint8_t>(header.palette_bits);
    reader.skip(4); // position on a screen
    reader.get_as<uint16_t>(header.width, header.height);
    reader.get_as<uint8_t>(header.bits, header.descriptor);
    return header;
}

/// Walks over all pixel data; the reader throws where the file ends too early.
void check_tga_pixels(const TgaHeader& header, ByteReader& reader) {
    reader.skip(header.id_size);
    if (header.palette_type != 0)
        reader.skip(size_t{header.palette_length} * ((header.palette_bits + 7) / 8));
    uint64_t pixels = uint64_t{header.width} * header.height;
    if (!header.run_length()) {
        reader.skip(pixels * header.pixel_bytes());
        return;
    }
    while (pixels > 0) {
        const uint8_t packet = reader.u8();
        const uint64_t run = (packet & 127u) + 1u;
        reader.skip((packet & 128u) != 0 ? header.pixel_bytes() : run * header.pixel_bytes());
        pixels -= std::min(pixels, run);
    }
}

void mirror_rows(Image& image) {
    for (size_t y = 0; y < image.height; ++y)
        for (size_t left = 0, right = image.width - 1; left < right; ++left, --right) {
            uint8_t* row = image.rgba.data() + y * image.width * 4;
            std::swap_ranges(row + left * 4, row + left * 4 + 4, row + right * 4);
        }
}

/// Some 32-bit files carry a zero fourth byte everywhere and say so (0 alpha bits): opaque.
void drop_unused_alpha(Image& image) {
    for (size_t i = 3; i < image.rgba.size(); i += 4)
        if (image.rgba[i] != 0) return;
    for (size_t i = 3; i < image.rgba.size(); i += 4)
        image.rgba[i] = 255;
}

} // namespace

Image decode_tga(std::string_view name, std::span<const uint8_t> bytes) {
    const std::string what = fmt::format("{}: TGA", name);
    ByteReader reader(what, bytes);
    const TgaHeader header = read_tga_header(reader);
    constexpr std::array<uint32_t, 6> known_types = {1, 2, 3, 9, 10, 11};
    if (std::find(known_types.begin(), known_types.end(), header.type) == known_types.end())
        fail("{}: TGA of type {}; types 1, 2, 3, 9, 10 and 11 are known", name, header.type);
    check_image_size(name, header.width, header.height);
    check_tga_pixels(header, reader);

    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(bytes.data(),
                              static_cast<int>(std::min<size_t>(bytes.size(), INT_MAX)), &width,
                              &height, &channels, 4),
        stbi_image_free);
    if (!pixels) fail("{}: cannot decode the picture: {}", name, printable(stbi_failure_reason()));
    if (static_cast<uint32_t>(width) != header.width ||
        static_cast<uint32_t>(height) != header.height)
        fail("{}: the TGA header contradicts itself", name);
    Image image{header.width, header.height, {}};
    image.rgba.assign(pixels.get(), pixels.get() + size_t{4} * image.width * image.height);
    if (header.right_to_left()) mirror_rows(image);
    if (header.bits == 32 && header.alpha_bits() == 0) drop_unused_alpha(image);
    return image;
}

} // namespace vigil
