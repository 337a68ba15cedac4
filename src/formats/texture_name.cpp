// SPDX-License-Identifier: GPL-2.0-or-later
// Texture names to file names; see texture_name.h.
#include "formats/texture_name.h"

#include <fmt/format.h>

#include <algorithm>

namespace vigil {

namespace {

/// Position of the frame character behind '+' in the last part of the name, npos: not animated.
size_t frame_position(std::string_view name) {
    const size_t slash = name.find_last_of("/\\");
    const size_t start = slash == std::string_view::npos ? 0 : slash + 1;
    if (name.size() < start + 3 || name[start] != '+') return std::string_view::npos;
    const char c = name[start + 1];
    const bool is_frame =
        (c >= '0' && c <= '9') || (c >= 'a' && c <= 'j') || (c >= 'A' && c <= 'J');
    return is_frame ? start + 1 : std::string_view::npos;
}

} // namespace

std::vector<std::string> texture_candidates(std::string_view name) {
    std::string path(name);
    std::replace(path.begin(), path.end(), '\\', '/');
    std::vector<std::string> names;
    for (const char* extension : {"png", "jpg", "tga", "wal"})
        names.push_back(fmt::format("textures/{}.{}", path, extension));
    return names;
}

std::vector<std::string> animation_names(std::string_view name,
                                         const std::function<bool(const std::string&)>& exists) {
    constexpr int max_frames = 10;
    const size_t position = frame_position(name);
    std::vector<std::string> frames;
    if (position != std::string_view::npos) {
        const char c = name[position];
        const char first = c <= '9' ? '0' : c <= 'J' ? 'A' : 'a';
        std::string frame(name);
        for (int i = 0; i < max_frames; ++i) {
            frame[position] = static_cast<char>(first + i);
            if (!exists(frame)) break;
            frames.push_back(frame);
        }
    }
    if (frames.empty()) frames.emplace_back(name);
    return frames;
}

} // namespace vigil
