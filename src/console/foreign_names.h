// SPDX-License-Identifier: GPL-2.0-or-later
// Names of Quake II RTX that its players type here too: which variable or command is meant, how
// values convert, or that there is nothing like it. One row each; the names and what their values
// mean are those of its manual and of its console.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace vigil {

struct ForeignName {
    std::string_view name;
    std::string_view target; ///< a variable or command here; empty: there is nothing like it
    /// How values convert: "same", "A|B" (0 is A, everything above it B), "*F" (times F), "exp2" (2
    /// to the power of it), "up" (the next whole number). Empty for commands.
    std::string_view convert;
    /// What to know about it: a sentence, without the conversion's.
    std::string_view about;
};

/// All rows, in the order of their names.
std::span<const ForeignName> foreign_names();

/// The row of this name (in lower case), or null.
const ForeignName* find_foreign_name(std::string_view name);

/// The value here for `text` there, which may be out of the variable's range. Throws Error when the
/// text is no number.
std::string converted_value(const ForeignName& foreign, std::string_view text);

/// What it is here, as `help` prints it: "tm_enable is an alias for pt_tonemap, ...".
std::string describe_foreign_name(const ForeignName& foreign);

} // namespace vigil
