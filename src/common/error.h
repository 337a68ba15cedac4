// SPDX-License-Identifier: GPL-2.0-or-later
// The one error type. Anything that fails because of the outside world (a file, a device, a typed
// command) throws it with a message a person can act on; the command dispatcher is the one boundary
// that catches it and prints it to the console, so the program stays usable.
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
