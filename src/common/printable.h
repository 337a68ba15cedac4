// SPDX-License-Identifier: GPL-2.0-or-later
// Text from files and from other libraries, made fit to stand in a message: one line, not too long.
// It knows no encoding: bytes above 127 stay as they are.
#pragma once

#include <string>
#include <string_view>

namespace vigil {

inline bool is_control(char c) {
    return static_cast<unsigned char>(c) < 32 || c == 127;
}

/// `text` with control characters (NUL, line feeds, ...) shown as '?'. What is longer than `most`
/// bytes is cut and ends in "...".
std::string printable(std::string_view text, std::size_t most = 300);

} // namespace vigil
