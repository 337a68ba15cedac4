// SPDX-License-Identifier: GPL-2.0-or-later
// The commands that every console has: set, reset, toggle, cvarlist, help, alias, exec, wait, echo.
// They work on a CommandRegistry and its variables; those of the game are added by the client.
#pragma once

#include "console/command.h"

#include <functional>
#include <string>
#include <string_view>

namespace vigil {

/// Gives the cfg file `name` (as typed after `exec`); throws Error when there is none.
using ScriptReader = std::function<ScriptText(std::string_view name)>;

/// Adds them. `exec` takes its files from `read_script`.
void add_builtin_commands(CommandRegistry& commands, ScriptReader read_script);

} // namespace vigil
