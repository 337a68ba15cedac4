// SPDX-License-Identifier: GPL-2.0-or-later
// JPG by libjpeg-turbo's own interface; see image_decoders.h. (stb_image 2.27, which decodes TGA,
// reads outside its memory where a scan names a Huffman table that the file never gave.)
#include "common/error.h"
#include "common/printable.h"
#include "formats/image_decoders.h"

#include <algorithm>
#include <array>
#include <memory>
#include <turbojpeg.h>

namespace vigil {

namespace {

/// Each scan walks over the whole picture, however few bytes it has. Progressive pictures have
/// about ten; one for every bit of every coefficient would be some thousand.
constexpr size_t max_scans = 100;
/// A JPG spends at least one bit on each of its blocks of 8 x 8 pixels.
constexpr uint64_t max_jpg_pixels_per_byte = 512;

void check_scans(std::string_view name, std::span<const uint8_t> bytes) {
    size_t scans = 0;
    for (size_t i = 0; i + 1 < bytes.size(); ++i)
        if (bytes[i] == 0xff && bytes[i + 1] == 0xda) ++scans; // in pixel data a 0 follows 0xff
    if (scans > max_scans) fail("{}: a JPG with {} scans (limit {})", name, scans, max_scans);
}

} // namespace

Image decode_jpg(std::string_view name, std::span<const uint8_t> bytes) {
    // The library makes up what a truncated file lacks.
    constexpr std::array<uint8_t, 2> end_of_image = {0xff, 0xd9};
    if (std::search(bytes.begin(), bytes.end(), end_of_image.begin(), end_of_image.end()) ==
        bytes.end())
        fail("{}: the JPG is truncated (no end marker)", name);
    check_scans(name, bytes);

    const std::unique_ptr<void, int (*)(void*)> decoder(tjInitDecompress(), tjDestroy);
    const auto refuse = [&] {
        fail("{}: cannot decode the picture: {}", name, printable(tjGetErrorStr2(decoder.get())));
    };
    const auto size = static_cast<unsigned long>(bytes.size());
    int width = 0, height = 0, sampling = 0, colors = 0;
    // This also fails where it has no name for how colours are sampled, which decoding does not
    // need.
    if (tjDecompressHeader3(decoder.get(), bytes.data(), size, &width, &height, &sampling,
                            &colors) != 0 &&
        width <= 0)
        refuse();
    Image image{static_cast<uint32_t>(width), static_cast<uint32_t>(height), {}};
    check_image_size(name, image.width, image.height, bytes.size(), max_jpg_pixels_per_byte);
    image.rgba.resize(size_t{4} * image.width * image.height);
    if (tjDecompress2(decoder.get(), bytes.data(), size, image.rgba.data(), width, 0, height,
                      TJPF_RGBA, 0) != 0 &&
        tjGetErrorCode(decoder.get()) == TJERR_FATAL)
        refuse();
    return image;
}

} // namespace vigil
