// SPDX-License-Identifier: GPL-2.0-or-later
// Around libjpeg-turbo; see jpg.h. The library reports errors by a jump to whoever called it: what
// lies between setjmp and its last call holds no C++ object that would have to be destroyed.
// (stb_image 2.27, which decodes the other formats, reads outside its memory where a scan names a
// Huffman table that the file never gave.)
#include "formats/jpg.h"

#include "common/error.h"
#include "common/printable.h"
#include "formats/image_stb.h"

#include <algorithm>
#include <csetjmp>
#include <cstdio> // jpeglib.h uses FILE
#include <jpeglib.h>

namespace vigil {

namespace {

/// Each scan walks over the whole picture, however few bytes it has. Progressive pictures have
/// about ten; one for every bit of every coefficient would be some thousand.
constexpr size_t max_scans = 100;
/// A JPG spends at least one bit on each of its blocks of 8 x 8 pixels.
constexpr uint64_t max_pixels_per_byte = 512;

struct Fault {
    jpeg_error_mgr manager; // first: the library knows only this part
    std::jmp_buf leave;
    char text[JMSG_LENGTH_MAX];
};

[[noreturn]] void on_error(j_common_ptr common) {
    Fault& fault = *reinterpret_cast<Fault*>(common->err);
    common->err->format_message(common, fault.text);
    std::longjmp(fault.leave, 1);
}

void on_warning(j_common_ptr, int) {}

/// A decompressor with the bytes as its source; released with the object.
struct Decoder {
    explicit Decoder(std::span<const uint8_t> bytes) {
        info.err = jpeg_std_error(&fault.manager);
        fault.manager.error_exit = on_error;
        fault.manager.emit_message = on_warning;
        if (setjmp(fault.leave) != 0) {
            failed = true;
            return;
        }
        jpeg_create_decompress(&info);
        jpeg_mem_src(&info, bytes.data(), static_cast<unsigned long>(bytes.size()));
    }
    ~Decoder() { jpeg_destroy_decompress(&info); }
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;

    bool read_header() {
        if (failed || setjmp(fault.leave) != 0) return false;
        return jpeg_read_header(&info, TRUE) == JPEG_HEADER_OK;
    }

    /// Into rows of RGBA; `rgba` holds the whole picture.
    bool read_rows(uint8_t* rgba) {
        if (setjmp(fault.leave) != 0) return false;
        info.out_color_space = JCS_EXT_RGBA;
        jpeg_start_decompress(&info);
        while (info.output_scanline < info.output_height) {
            JSAMPROW row = rgba + size_t{info.output_scanline} * info.output_width * 4;
            jpeg_read_scanlines(&info, &row, 1);
        }
        jpeg_finish_decompress(&info);
        return true;
    }

    jpeg_decompress_struct info{};
    Fault fault{};
    bool failed = false;
};

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

    Decoder decoder(bytes);
    const auto refuse = [&] {
        fail("{}: cannot decode the picture: {}", name, printable(decoder.fault.text));
    };
    if (!decoder.read_header()) refuse();
    const uint64_t width = decoder.info.image_width, height = decoder.info.image_height;
    check_image_size(name, width, height);
    if (width * height > bytes.size() * max_pixels_per_byte)
        fail("{}: {} bytes cannot hold {} x {} pixels", name, bytes.size(), width, height);

    Image image{static_cast<uint32_t>(width), static_cast<uint32_t>(height), {}};
    image.rgba.resize(4 * width * height);
    if (!decoder.read_rows(image.rgba.data())) refuse();
    return image;
}

} // namespace vigil
