// SPDX-License-Identifier: GPL-2.0-or-later
// Which command a key runs. A binding that starts with + is held: it runs `+NAME KEY` when the key
// goes down and `-NAME KEY` when it comes up, so that two keys may hold the same thing (as in
// Quake).
#pragma once

#include "platform/key.h"

#include <array>
#include <string>
#include <string_view>

namespace vigil::client {

class KeyBindings {
public:
    /// Starts with the keys of default_text().
    KeyBindings();

    /// Empty text removes the binding.
    void bind(platform::Key key, std::string_view command);
    void unbind_all();
    const std::string& command(platform::Key key) const;

    /// Console text to run when the key goes down or comes up; "" for nothing. The key that
    /// released a held command is the one that pressed it, even when it was bound anew in between.
    std::string press(platform::Key key);
    std::string release(platform::Key key);
    /// Text that releases everything held (the window lost the keyboard).
    std::string release_all();

    /// Lines `bind KEY "COMMAND"` of every bound key.
    std::string list_text() const;
    /// Lines that turn the default keys into these; "" when nothing was changed.
    std::string archive_text() const;

private:
    using Commands = std::array<std::string, platform::key_count>;

    std::string& at(platform::Key key);

    Commands commands_;
    Commands held_; // the command a pressed key must release
};

} // namespace vigil::client
