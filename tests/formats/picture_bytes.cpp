// SPDX-License-Identifier: GPL-2.0-or-later
// Picture writers for the tests; see picture_bytes.h.
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

#include "picture_bytes.h"

#include <algorithm>

namespace vigil {

namespace {

/// Colour bytes of one texel as TGA stores them: grey, or blue green red [alpha].
Bytes tga_texel(const Image& image, size_t x, size_t y, const TgaKind& kind) {
    const uint8_t* rgba = image.rgba.data() + 4 * (y * image.width + x);
    if (kind.bits == 8) return {rgba[0]};
    Bytes texel = {rgba[2], rgba[1], rgba[0]};
    if (kind.bits == 32) texel.push_back(rgba[3]);
    return texel;
}

/// Packets of equal texels become runs, the others raw packets of one texel.
void append_packets(Bytes& file, const std::vector<Bytes>& texels) {
    for (size_t i = 0; i < texels.size();) {
        size_t run = 1;
        while (i + run < texels.size() && run < 128 && texels[i + run] == texels[i])
            ++run;
        append(file, static_cast<uint8_t>(run > 1 ? 0x80 + run - 1 : 0));
        append_bytes(file, texels[i]);
        i += run;
    }
}

void collect(void* context, void* data, int size) {
    const auto* bytes = static_cast<const uint8_t*>(data);
    static_cast<Bytes*>(context)->insert(static_cast<Bytes*>(context)->end(), bytes, bytes + size);
}

uint8_t test_index(uint32_t x, uint32_t y) {
    return static_cast<uint8_t>(x + 16 * y);
}

} // namespace

Image test_picture(uint32_t width, uint32_t height) {
    Image image{width, height, {}};
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x)
            for (const uint32_t value : {x * 20, y * 20, x * 7 + y * 13, 255 - x - y})
                image.rgba.push_back(static_cast<uint8_t>(value));
    return image;
}

Bytes write_tga(const Image& image, const TgaKind& kind) {
    Bytes file = {3, 0, kind.type};
    file.resize(12, 0);
    append(file, static_cast<uint16_t>(image.width));
    append(file, static_cast<uint16_t>(image.height));
    append(file, kind.bits);
    append(file, kind.descriptor);
    append_text(file, "id!", 3);
    std::vector<Bytes> texels;
    for (size_t row = 0; row < image.height; ++row)
        for (size_t column = 0; column < image.width; ++column) {
            const size_t y = kind.descriptor & 0x20 ? row : image.height - 1 - row;
            const size_t x = kind.descriptor & 0x10 ? image.width - 1 - column : column;
            texels.push_back(tga_texel(image, x, y, kind));
        }
    if (kind.type >= 8)
        append_packets(file, texels);
    else
        for (const Bytes& texel : texels)
            append_bytes(file, texel);
    return file;
}

Bytes write_png(const Image& image) {
    Bytes file;
    stbi_write_png_to_func(collect, &file, static_cast<int>(image.width),
                           static_cast<int>(image.height), 4, image.rgba.data(), 0);
    return file;
}

Bytes write_jpg(const Image& image, int quality) {
    Bytes file;
    stbi_write_jpg_to_func(collect, &file, static_cast<int>(image.width),
                           static_cast<int>(image.height), 4, image.rgba.data(), quality);
    return file;
}

Palette test_palette() {
    Palette palette;
    for (size_t i = 0; i < 256; ++i)
        palette[i] = {static_cast<uint8_t>(i), static_cast<uint8_t>(255 - i),
                      static_cast<uint8_t>(i / 2)};
    return palette;
}

Bytes write_pcx(uint32_t width, uint32_t height) {
    Bytes file = {0x0a, 5, 1, 8};
    for (const uint32_t value : {0u, 0u, width - 1, height - 1})
        append(file, static_cast<uint16_t>(value));
    file.resize(65, 0);
    append<uint8_t>(file, 1);
    const uint32_t bytes_per_line = width + width % 2; // rows are padded to even lengths
    append(file, static_cast<uint16_t>(bytes_per_line));
    file.resize(128, 0);
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < bytes_per_line; ++x) {
            const uint8_t index = x < width ? test_index(x, y) : uint8_t{0};
            if (index >= 0xc0) append<uint8_t>(file, 0xc1);
            append(file, index);
        }
    append<uint8_t>(file, 12);
    for (const auto& color : test_palette())
        file.insert(file.end(), color.begin(), color.end());
    return file;
}

Bytes write_wal(uint32_t width, uint32_t height, uint32_t flags) {
    Bytes file;
    append_text(file, "e1u1/wall", 32);
    append(file, width);
    append(file, height);
    for (uint32_t mip = 0, offset = 100; mip < 4; offset += (width >> mip) * (height >> mip), ++mip)
        append(file, offset);
    append_text(file, "e1u1/wall2", 32);
    append(file, flags);
    append<uint32_t>(file, 1);
    append<int32_t>(file, 77);
    for (uint32_t mip = 0; mip < 4; ++mip)
        for (uint32_t y = 0; y < height >> mip; ++y)
            for (uint32_t x = 0; x < width >> mip; ++x)
                append(file, test_index(x, y));
    return file;
}

} // namespace vigil
