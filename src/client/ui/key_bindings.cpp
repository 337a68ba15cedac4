// SPDX-License-Identifier: GPL-2.0-or-later
// Key bindings and the keys a new player finds.
#include "client/ui/key_bindings.h"

#include "console/command_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace vigil::client {

using platform::Key;
using platform::key_count;
using platform::key_name;

namespace {

/// They are built in because the folder the levels come from may be anyone's (a Quake II
/// installation binds its keys to commands of its game).
constexpr std::pair<Key, std::string_view> defaults[] = {
    {Key::W, "+forward"},
    {Key::S, "+back"},
    {Key::A, "+moveleft"},
    {Key::D, "+moveright"},
    {Key::Space, "+moveup"},
    {Key::E, "+moveup"},
    {Key::Ctrl, "+movedown"},
    {Key::Q, "+movedown"},
    {Key::C, "+movedown"},
    {Key::Shift, "+speed"},
    {Key::Up, "+forward"},
    {Key::Down, "+back"},
    {Key::Left, "+left"},
    {Key::Right, "+right"},
    {Key::PageUp, "+lookup"},
    {Key::PageDown, "+lookdown"},
    {Key::Mouse1, "+attack"},
    {Key::F, "flashlight"},
    {Key::WheelUp, "flyfaster"},
    {Key::WheelDown, "flyslower"},
    {Key::F1, "toggleconsole"},
    {Key::F2, "viewpos"},
    {Key::F3, "scene"},
    {Key::F4, "passes"},
    {Key::F5, "viewnext"},
    {Key::F6, "viewprev"},
    {Key::F7, "view none"},
    {Key::F8, "vlcinfo"},
    {Key::F9, "guiding"},
    {Key::X, "compare"},
    {Key::F10, "menu_quit"},
    {Key::End, "centerview"},
    {Key::LeftBracket, "comparemove -0.05"},
    {Key::RightBracket, "comparemove 0.05"},
    {Key::Mouse2, "+comparedrag"},
    {Key::Tab, "toggle scr_stats"},
    {Key::T, "toggle pt_nee"},
    {Key::G, "toggle pt_guide brdf cdq"},
    {Key::F11, "toggle vid_fullscreen"},
    {Key::F12, "screenshot"},
    {Key::PadStart, "togglemenu"},
    {Key::PadBack, "toggle scr_stats"},
    {Key::PadA, "+moveup"},
    {Key::PadB, "+movedown"},
    {Key::PadX, "compare"},
    {Key::PadY, "toggle pt_guide brdf cdq"},
    {Key::PadRightShoulder, "toggle pt_nee"},
    {Key::PadLeftShoulder, "viewnext"},
    {Key::PadRightTrigger, "+attack"},
    {Key::PadLeftTrigger, "+speed"},
    {Key::PadLeftStick, "noclip"},
    {Key::PadRightStick, "view none"},
    {Key::PadUp, "flyfaster"},
    {Key::PadDown, "flyslower"},
    {Key::PadLeft, "comparemove -0.05"},
    {Key::PadRight, "comparemove 0.05"},
};

size_t index_of(Key key) {
    return static_cast<size_t>(key);
}

std::string release_text(std::string_view held, Key key) {
    return fmt::format("-{} {}", held.substr(1), quote_word(key_name(key)));
}

} // namespace

KeyBindings::KeyBindings() {
    for (const auto& [key, command] : defaults)
        bind(key, command);
}

void KeyBindings::bind(Key key, std::string_view command, Trust trust) {
    commands_.at(index_of(key)) = {std::string(command), trust};
    if (trust == Trust::Person) kept_.at(index_of(key)) = commands_.at(index_of(key));
}

void KeyBindings::unbind_all(Trust trust) {
    for (int i = 0; i < key_count; ++i)
        bind(static_cast<Key>(i), "", trust);
}

const std::string& KeyBindings::command(Key key) const {
    return commands_.at(index_of(key)).text;
}

ScriptText KeyBindings::press(Key key) {
    const ScriptText& command = commands_.at(index_of(key));
    if (!command.text.starts_with('+')) return command;
    held_.at(index_of(key)) = command;
    return {fmt::format("{} {}", command.text, quote_word(key_name(key))), command.trust};
}

ScriptText KeyBindings::release(Key key) {
    const ScriptText held = std::exchange(held_.at(index_of(key)), {});
    if (held.text.empty()) return {};
    return {release_text(held.text, key), held.trust};
}

ScriptText KeyBindings::release_all() {
    ScriptText all;
    for (int i = 0; i < key_count; ++i) {
        const ScriptText line = release(static_cast<Key>(i));
        if (line.text.empty()) continue;
        all.text += line.text + "\n";
        all.trust = std::min(all.trust, line.trust);
    }
    return all;
}

std::string KeyBindings::list_text() const {
    std::string text;
    for (int i = 0; i < key_count; ++i) {
        const Key key = static_cast<Key>(i);
        if (command(key).empty()) continue;
        text += fmt::format("bind {} \"{}\"\n", quote_word(key_name(key)), command(key));
    }
    return text;
}

std::string KeyBindings::archive_text() const {
    const KeyBindings untouched;
    std::string text;
    for (int i = 0; i < key_count; ++i) {
        const Key key = static_cast<Key>(i);
        const std::string& kept = kept_.at(index_of(key)).text;
        if (kept == untouched.command(key)) continue;
        text += kept.empty() ? fmt::format("unbind {}\n", quote_word(key_name(key)))
                             : fmt::format("bind {} \"{}\"\n", quote_word(key_name(key)), kept);
    }
    return text;
}

} // namespace vigil::client
