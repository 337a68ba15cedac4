// SPDX-License-Identifier: GPL-2.0-or-later
// The one error type. Anything that fails because of the outside world (a file, a device, a typed
// command) throws it with a message a person can act on. It stops where the client runs something:
// a command (CommandRegistry), a part of a frame (Client::attempt) or all of it (run_program).
// docs/internals/front-end.md says what else may catch it, and why.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace vigil {

class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Throws Error with a message made by fmt::format.
template <typename... Args>
[[noreturn]] void fail(fmt::format_string<Args...> text, Args&&... args) {
    throw Error(fmt::format(text, std::forward<Args>(args)...));
}

} // namespace vigil
