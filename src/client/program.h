// SPDX-License-Identifier: GPL-2.0-or-later
// The program from its command line to its exit status: files, configuration, window, renderer,
// client. The renderer comes from outside, so that tests run all of this with one that draws
// nothing.
#pragma once

#include "refresh/refresh.h"

#include <functional>
#include <memory>
#include <span>

namespace vigil::client {

class Client;

/// Makes the renderer; `surface` is null when headless. Throws Error.
using MakeRenderer = std::function<std::unique_ptr<refresh::Renderer>(
    FileSystem&, refresh::SurfaceProvider* surface, const refresh::Settings& settings)>;

/// Runs with the words after the program's name. In order: variables set first on the command line;
/// config.cfg of the user (not when headless, so that pictures and times do not depend on what was
/// played before); autoexec.cfg of the game; the other commands of the command line; frames.
/// Returns 0; or 1 with a message when the program cannot start or go on, and, headless, when a
/// command failed.
/// `add_commands` adds more commands than the client has.
int run_program(std::span<const char* const> words, const MakeRenderer& make_renderer,
                const std::function<void(Client&)>& add_commands = {});

} // namespace vigil::client
