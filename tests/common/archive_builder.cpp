// SPDX-License-Identifier: GPL-2.0-or-later
// Archive writers for tests, after the same format descriptions as the readers.
#include "archive_builder.h"

#include <zlib.h>

namespace vigil::test {

namespace {

void append_u16(Bytes& bytes, std::size_t value) {
    bytes.push_back(static_cast<std::uint8_t>(value));
    bytes.push_back(static_cast<std::uint8_t>(value >> 8));
}

void append_u32(Bytes& bytes, std::size_t value) {
    append_u16(bytes, value & 0xffff);
    append_u16(bytes, value >> 16);
}

void append(Bytes& bytes, const std::string& text) {
    bytes.insert(bytes.end(), text.begin(), text.end());
}

std::string deflate_raw(const std::string& content) {
    z_stream stream = {};
    deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
    std::string packed(deflateBound(&stream, content.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
    stream.avail_in = static_cast<uInt>(content.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

/// Method, checksum and sizes: what local headers and directory entries share.
void append_zip_fields(Bytes& bytes, const ArchiveFile& file, std::size_t packed_size) {
    append_u16(bytes, 20); // version needed
    append_u16(bytes, 0);  // flags
    append_u16(bytes, file.deflate ? 8 : 0);
    append_u32(bytes, 0); // time and date
    append_u32(bytes, crc32_z(0, reinterpret_cast<const Bytef*>(file.content.data()),
                              file.content.size()));
    append_u32(bytes, packed_size);
    append_u32(bytes, file.content.size());
    append_u16(bytes, file.path.size());
}

} // namespace

void poke_u16(Bytes& bytes, std::size_t offset, std::uint32_t value) {
    bytes.at(offset) = static_cast<std::uint8_t>(value);
    bytes.at(offset + 1) = static_cast<std::uint8_t>(value >> 8);
}

void poke_u32(Bytes& bytes, std::size_t offset, std::uint32_t value) {
    poke_u16(bytes, offset, value & 0xffff);
    poke_u16(bytes, offset + 2, value >> 16);
}

Bytes build_pak(const std::vector<ArchiveFile>& files) {
    Bytes bytes;
    append(bytes, "PACK");
    append_u32(bytes, 0);
    append_u32(bytes, files.size() * 64);
    Bytes directory;
    for (const ArchiveFile& file : files) {
        std::string name = file.path;
        name.resize(56, '\0');
        append(directory, name);
        append_u32(directory, bytes.size());
        append_u32(directory, file.content.size());
        append(bytes, file.content);
    }
    poke_u32(bytes, 4, static_cast<std::uint32_t>(bytes.size()));
    bytes.insert(bytes.end(), directory.begin(), directory.end());
    return bytes;
}

Bytes build_zip(const std::vector<ArchiveFile>& files, const std::string& comment) {
    Bytes bytes;
    Bytes directory;
    for (const ArchiveFile& file : files) {
        const std::string packed = file.deflate ? deflate_raw(file.content) : file.content;
        append_u32(directory, 0x02014b50);
        append_u16(directory, 20); // made by
        append_zip_fields(directory, file, packed.size());
        append_u16(directory, 0); // extra fields
        append_u16(directory, 0); // comment
        append_u16(directory, 0); // disk
        append_u16(directory, 0); // attributes
        append_u32(directory, 0);
        append_u32(directory, bytes.size());
        append(directory, file.path);

        append_u32(bytes, 0x04034b50);
        append_zip_fields(bytes, file, packed.size());
        append_u16(bytes, 4); // extra fields, which the directory does not repeat
        append(bytes, file.path);
        append_u32(bytes, 0);
        append(bytes, packed);
    }
    const std::size_t start = bytes.size();
    bytes.insert(bytes.end(), directory.begin(), directory.end());
    append_u32(bytes, 0x06054b50);
    append_u32(bytes, 0); // disks
    append_u16(bytes, files.size());
    append_u16(bytes, files.size());
    append_u32(bytes, directory.size());
    append_u32(bytes, start);
    append_u16(bytes, comment.size());
    append(bytes, comment);
    return bytes;
}

std::size_t zip_end(const Bytes& zip) {
    return zip.size() - 22;
}

std::size_t zip_directory(const Bytes& zip) {
    const std::size_t field = zip_end(zip) + 16;
    return zip[field] | zip[field + 1] << 8 | zip[field + 2] << 16;
}

} // namespace vigil::test
