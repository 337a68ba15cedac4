// SPDX-License-Identifier: GPL-2.0-or-later
// Which command a key runs. A binding that starts with + is held: it runs `+NAME KEY` when the key
// goes down and `-NAME KEY` when it comes up, so that two keys may hold the same thing (as in
// Quake).
#pragma once

#include "console/command.h"
#include "platform/key.h"

#include <array>
#include <string>
#include <string_view>

namespace vigil::client {

class KeyBindings {
public:
    /// Starts with the keys of default_text().
    KeyBindings();

    /// Empty text removes the binding. What an archive's script binds runs as its own when the key
    /// is pressed, and is not kept.
    void bind(platform::Key key, std::string_view command, Trust trust = Trust::Person);
    void unbind_all(Trust trust = Trust::Person);
    const std::string& command(platform::Key key) const;

    /// What to run when the key goes down or comes up; empty text for nothing. The key that
    /// released a held command is the one that pressed it, even when it was bound anew in between.
    ScriptText press(platform::Key key);
    ScriptText release(platform::Key key);
    /// Releases everything held (the window lost the keyboard).
    ScriptText release_all();

    /// Lines `bind KEY "COMMAND"` of every bound key.
    std::string list_text() const;
    /// Lines that turn the default keys into these; "" when nothing was changed.
    std::string archive_text() const;

private:
    using Commands = std::array<ScriptText, platform::key_count>;

    Commands commands_;
    Commands held_; // the command a pressed key must release
    Commands kept_; // what the configuration file keeps
};

} // namespace vigil::client
