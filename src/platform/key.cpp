// SPDX-License-Identifier: GPL-2.0-or-later
// The one table of key names, in the order of the enumeration. Names follow Quake II's key list.
#include "platform/key.h"

#include "common/ascii_case.h"

#include <algorithm>
#include <array>

namespace vigil::platform {

namespace {

// clang-format off
constexpr std::array<std::string_view, key_count> names{
    "",
    "a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "m", "n", "o", "p", "q", "r", "s",
    "t", "u", "v", "w", "x", "y", "z",
    "0", "1", "2", "3", "4", "5", "6", "7", "8", "9",
    "F1", "F2", "F3", "F4", "F5", "F6", "F7", "F8", "F9", "F10", "F11", "F12",
    "TAB", "ENTER", "ESCAPE", "SPACE", "BACKSPACE", "CAPSLOCK", "PAUSE",
    "SHIFT", "CTRL", "ALT", "SUPER",
    "UPARROW", "DOWNARROW", "LEFTARROW", "RIGHTARROW",
    "INS", "DEL", "PGUP", "PGDN", "HOME", "END",
    "`", "-", "=", "[", "]", "\\", "SEMICOLON", "'", ",",
    ".", "/",
    "KP_0", "KP_1", "KP_2", "KP_3", "KP_4", "KP_5", "KP_6", "KP_7", "KP_8", "KP_9",
    "KP_ENTER", "KP_PLUS", "KP_MINUS", "KP_STAR", "KP_SLASH", "KP_DEL",
    "MOUSE1", "MOUSE2", "MOUSE3", "MOUSE4", "MOUSE5", "MWHEELUP", "MWHEELDOWN",
    "PAD_A", "PAD_B", "PAD_X", "PAD_Y", "PAD_BACK", "PAD_GUIDE", "PAD_START", "PAD_LSTICK", "PAD_RSTICK",
    "PAD_LB", "PAD_RB", "PAD_UP", "PAD_DOWN", "PAD_LEFT", "PAD_RIGHT", "PAD_LT",
    "PAD_RT",
};
// clang-format on
static_assert(!names.back().empty(), "a key has no name");

} // namespace

std::string_view key_name(Key key) {
    const size_t index = static_cast<size_t>(key);
    return index < names.size() ? names[index] : std::string_view{};
}

std::optional<Key> key_from_name(std::string_view name) {
    if (name.empty()) return std::nullopt;
    if (name == ";") return Key::Semicolon;
    for (size_t i = 1; i < names.size(); ++i) {
        if (equal_nocase(names[i], name)) return static_cast<Key>(i);
    }
    return std::nullopt;
}

std::vector<std::string_view> key_names() {
    return {names.begin() + 1, names.end()};
}

Key key_of_code(int code, std::span<const CodeRun> runs, std::span<const CodeList> lists) {
    const auto after = [](Key first, std::ptrdiff_t steps) {
        return static_cast<Key>(static_cast<std::ptrdiff_t>(first) + steps);
    };
    for (const CodeRun& run : runs)
        if (code >= run.low && code <= run.high) return after(run.first, code - run.low);
    for (const CodeList& list : lists)
        if (const auto found = std::ranges::find(list.codes, code); found != list.codes.end())
            return after(list.first, found - list.codes.begin());
    return Key::None;
}

} // namespace vigil::platform
