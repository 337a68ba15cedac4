// SPDX-License-Identifier: GPL-2.0-or-later
// Keys and their names, the same for every window system. A key is a place on the keyboard, named
// by what a US layout prints there, so WASD stays one hand's shape on any keyboard; typed
// characters come separately as text events. Names are Quake's (ENTER, UPARROW, MWHEELUP, a).
// Buttons of game controllers are keys too, named as on an Xbox controller (PAD_A is the lower
// one).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace vigil::platform {

/// Left and right Shift, Ctrl and Alt are one key each, as in Quake.
// clang-format off
enum class Key : uint8_t {
    None,
    A, B, C, D, E, F, G, H, I, J, K, L, M, N, O, P, Q, R, S, T, U, V, W, X, Y, Z,
    Digit0, Digit1, Digit2, Digit3, Digit4, Digit5, Digit6, Digit7, Digit8, Digit9,
    F1, F2, F3, F4, F5, F6, F7, F8, F9, F10, F11, F12,
    Tab, Enter, Escape, Space, Backspace, CapsLock, Pause,
    Shift, Ctrl, Alt, Super,
    Up, Down, Left, Right,
    Insert, Delete, PageUp, PageDown, Home, End,
    Grave, Minus, Equals, LeftBracket, RightBracket, Backslash, Semicolon, Apostrophe, Comma,
    Period, Slash,
    Keypad0, Keypad1, Keypad2, Keypad3, Keypad4, Keypad5, Keypad6, Keypad7, Keypad8, Keypad9,
    KeypadEnter, KeypadPlus, KeypadMinus, KeypadMultiply, KeypadDivide, KeypadPeriod,
    Mouse1, Mouse2, Mouse3, Mouse4, Mouse5, WheelUp, WheelDown,
    PadA, PadB, PadX, PadY, PadBack, PadGuide, PadStart, PadLeftStick, PadRightStick,
    PadLeftShoulder, PadRightShoulder, PadUp, PadDown, PadLeft, PadRight, PadLeftTrigger,
    PadRightTrigger,
    Count
};
// clang-format on

inline constexpr int key_count = static_cast<int>(Key::Count);

/// The name `bind` uses; "" for None.
std::string_view key_name(Key key);
/// The key of a name (case does not matter), or nothing. Semicolon is also SEMICOLON, since `;`
/// separates commands.
std::optional<Key> key_from_name(std::string_view name);
/// All names in the order of the enumeration, for completion.
std::vector<std::string_view> key_names();

/// Codes of a window system, from `low` to `high`, that stand for keys in a row from `first` on.
struct CodeRun {
    int low, high;
    Key first;
};
/// Codes in any order that stand for keys in a row from `first` on.
struct CodeList {
    std::span<const int> codes;
    Key first;
};
/// The key of a code; None where it is in neither.
Key key_of_code(int code, std::span<const CodeRun> runs, std::span<const CodeList> lists = {});

} // namespace vigil::platform
