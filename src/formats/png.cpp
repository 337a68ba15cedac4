// SPDX-License-Identifier: GPL-2.0-or-later
// PNG by libpng's functions for whole pictures (png_image); see image_decoders.h. Rows are unpacked
// one after another: data beyond those of the picture takes no memory.
#include "common/error.h"
#include "common/printable.h"
#include "formats/image_decoders.h"

#include <png.h>

namespace vigil {

namespace {

/// Deflate packs 1032 bytes into one at best, and a pixel takes a bit at least.
constexpr uint64_t max_png_pixels_per_byte = uint64_t{1032} * 8;

/// libpng's state of one picture; freed with it.
struct PngReader {
    png_image state{};
    explicit PngReader() { state.version = PNG_IMAGE_VERSION; }
    ~PngReader() { png_image_free(&state); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
};

} // namespace

Image decode_png(std::string_view name, std::span<const uint8_t> bytes) {
    PngReader png;
    const auto expect = [&](int done) {
        if (!done) fail("{}: cannot decode the picture: {}", name, printable(png.state.message));
    };
    expect(png_image_begin_read_from_memory(&png.state, bytes.data(), bytes.size()));
    Image image{png.state.width, png.state.height, {}};
    check_image_size(name, image.width, image.height, bytes.size(), max_png_pixels_per_byte);
    image.rgba.resize(size_t{4} * image.width * image.height);
    png.state.format = PNG_FORMAT_RGBA;
    png.state.flags |= PNG_IMAGE_FLAG_16BIT_sRGB; // not linear
    expect(png_image_finish_read(&png.state, nullptr, image.rgba.data(), 0, nullptr));
    return image;
}

} // namespace vigil
