// SPDX-License-Identifier: GPL-2.0-or-later
// SP2 decoder; see sp2.h. Signature, version and count, then per frame four 32-bit numbers (width,
// height, origin) and a name of 64 bytes.
#include "formats/sp2.h"

#include "formats/byte_reader.h"

namespace vigil {

namespace {

constexpr uint32_t sp2_magic = 0x32534449; // "IDS2"
constexpr uint32_t sp2_version = 2;
constexpr size_t sp2_frame_bytes = 80;
constexpr int32_t max_sp2_units = 65536;

} // namespace

std::vector<Sp2Frame> parse_sp2(std::string_view name, std::span<const uint8_t> bytes) {
    const std::string what = fmt::format("{}: SP2 sprite", name);
    ByteReader reader(what, bytes);
    if (reader.u32() != sp2_magic) fail("{}: not a sprite (no IDS2 signature)", name);
    if (const uint32_t version = reader.u32(); version != sp2_version)
        fail("{}: SP2 version {}, Quake II sprites have version {}", name, version, sp2_version);
    const uint32_t count = reader.u32();
    if (count == 0) fail("{}: the sprite has no frames", name);
    if (count > reader.remaining() / sp2_frame_bytes)
        fail("{}: {} frames do not fit into a file of {} bytes", name, count, bytes.size());
    std::vector<Sp2Frame> frames(count);
    for (size_t i = 0; i < frames.size(); ++i) {
        Sp2Frame& frame = frames[i];
        for (int32_t* number : {&frame.size.x, &frame.size.y, &frame.origin.x, &frame.origin.y})
            *number = reader.i32();
        frame.picture = reader.text(64);
        for (const int axis : {0, 1}) {
            if (frame.size[axis] < 1 || frame.size[axis] > max_sp2_units)
                fail("{}: frame {} is {} x {} units", name, i, frame.size.x, frame.size.y);
            if (frame.origin[axis] < -max_sp2_units || frame.origin[axis] > max_sp2_units)
                fail("{}: frame {} has its origin at {} {}", name, i, frame.origin.x,
                     frame.origin.y);
        }
    }
    return frames;
}

} // namespace vigil
