// SPDX-License-Identifier: GPL-2.0-or-later
// The wrapping of cache files: a name of what is inside, its length and its checksum, so that a
// file that was cut short, damaged or written by another version is noticed before anyone trusts
// it. It guards against accidents, not against forgery.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace vigil {

/// `content` with its wrapping. `kind` tells what it is and in which version ("vigil pipelines 1");
/// it may be any text.
std::string seal(std::string_view kind, std::span<const std::byte> content);

/// The content of what seal() made for the same kind, as a part of `file`; nothing where it is not
/// exactly that.
std::optional<std::span<const std::byte>> unseal(std::string_view kind,
                                                 std::span<const std::byte> file);

} // namespace vigil
