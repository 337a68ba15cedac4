// SPDX-License-Identifier: GPL-2.0-or-later
// A fuzz target: a function that takes any bytes and must come back. Refusing them with one clear
// Error is right; any other exception, a crash, a hang or a huge allocation is a finding.
#pragma once

#include "target_table.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

namespace vigil::fuzz {

using Input = std::span<const std::uint8_t>;

struct Target {
    std::string_view name;
    std::string_view extension; ///< of real files that serve as seeds; may be empty
    std::size_t max_bytes;      ///< largest input worth trying
    void (*run)(Input bytes);
};

/// The rows of target_table.h.
std::span<const Target> targets();

/// Runs `parse` on a file called `name`. Ends the program, with the reason on stderr, where it
/// throws an Error that does not name the file or is not one line of text; other exceptions pass.
void parse_or_refuse(std::string_view name, const std::function<void()>& parse);

/// Ends the program, with `what` on stderr, where a promise of the parser is not kept.
void require(bool kept, std::string_view what);

/// The bytes as text.
std::string_view text_of(Input bytes);

#define VIGIL_FUZZ_DECLARE(name, extension, max_bytes, runs, what) void fuzz_##name(Input bytes);
VIGIL_FUZZ_TARGETS(VIGIL_FUZZ_DECLARE)
#undef VIGIL_FUZZ_DECLARE

} // namespace vigil::fuzz
