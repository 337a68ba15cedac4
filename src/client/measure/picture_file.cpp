// SPDX-License-Identifier: GPL-2.0-or-later
// Encoding pictures in memory and writing them in one piece.
#include "client/measure/picture_file.h"

#include "common/error.h"
#include "common/output.h"

#include <stb/stb_image_write.h>
#include <tinyexr.h>

#include <cstddef>
#include <cstdlib>
#include <span>
#include <vector>

namespace vigil::client {

namespace {

void check_size(const std::filesystem::path& path, int width, int height, size_t values,
                size_t channels) {
    const auto pixels = static_cast<size_t>(width) * static_cast<size_t>(height);
    if (width <= 0 || height <= 0 || values != pixels * channels) {
        fail("{}: there is no picture to write", path.string());
    }
}

/// One channel of interleaved RGB.
std::vector<float> plane_of(const refresh::RadiancePicture& picture, size_t channel) {
    std::vector<float> plane(picture.rgb.size() / 3);
    for (size_t i = 0; i < plane.size(); ++i)
        plane[i] = picture.rgb[3 * i + channel];
    return plane;
}

} // namespace

void write_png(const std::filesystem::path& path, const refresh::Picture& picture) {
    check_size(path, picture.width, picture.height, picture.rgba.size(), 4);
    std::vector<uint8_t> rgb(picture.rgba.size() / 4 * 3);
    for (size_t i = 0; i < rgb.size() / 3; ++i) {
        for (size_t c = 0; c < 3; ++c)
            rgb[3 * i + c] = picture.rgba[4 * i + c];
    }
    std::vector<std::byte> bytes;
    const auto append = [](void* context, void* data, int size) {
        auto& out = *static_cast<std::vector<std::byte>*>(context);
        const auto* first = static_cast<const std::byte*>(data);
        out.insert(out.end(), first, first + size);
    };
    if (stbi_write_png_to_func(append, &bytes, picture.width, picture.height, 3, rgb.data(),
                               3 * picture.width) == 0) {
        fail("{}: the PNG encoder ran out of memory", path.string());
    }
    write_file(path, bytes);
}

void write_exr(const std::filesystem::path& path, const refresh::RadiancePicture& picture) {
    check_size(path, picture.width, picture.height, picture.rgb.size(), 3);
    // Channels stand in alphabetical order in an EXR file.
    static constexpr const char* names[] = {"B", "G", "R"};
    std::vector<float> planes[] = {plane_of(picture, 2), plane_of(picture, 1),
                                   plane_of(picture, 0)};
    unsigned char* images[3];
    EXRChannelInfo channels[3]{};
    int types[] = {TINYEXR_PIXELTYPE_FLOAT, TINYEXR_PIXELTYPE_FLOAT, TINYEXR_PIXELTYPE_FLOAT};
    for (size_t i = 0; i < 3; ++i) {
        images[i] = reinterpret_cast<unsigned char*>(planes[i].data());
        channels[i].name[0] = names[i][0];
    }

    EXRHeader header;
    InitEXRHeader(&header);
    header.num_channels = 3;
    header.channels = channels;
    header.pixel_types = types;
    header.requested_pixel_types = types;
    header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;
    EXRImage image;
    InitEXRImage(&image);
    image.num_channels = 3;
    image.images = images;
    image.width = picture.width;
    image.height = picture.height;

    unsigned char* encoded = nullptr;
    const char* reason = nullptr;
    const size_t size = SaveEXRImageToMemory(&image, &header, &encoded, &reason);
    const std::unique_ptr<unsigned char, decltype(&std::free)> owner(encoded, std::free);
    if (size == 0) {
        const std::string text = reason != nullptr ? reason : "unknown reason";
        FreeEXRErrorMessage(reason);
        fail("{}: the EXR encoder failed: {}", path.string(), text);
    }
    write_file(path, std::as_bytes(std::span(encoded, size)));
}

} // namespace vigil::client
