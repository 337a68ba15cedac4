// SPDX-License-Identifier: GPL-2.0-or-later
// Where the program writes: pictures and reports below one folder, configuration and caches in the
// XDG base directories (freedesktop.org, XDG Base Directory Specification 0.8). Files appear whole
// or not at all. Game data is never written.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

namespace vigil {

/// Path of the output file `name` ("shot.png", "demos/run.dm2") below the folder `outdir`; folders
/// are created when missing. Throws Error when the name would leave the folder or a folder cannot
/// be made.
std::filesystem::path output_path(std::string_view outdir, std::string_view name);

/// Throws Error now where write_file() could not write `path` later: it is a folder, or its folder
/// cannot be written to. For names whose file comes after long work.
void check_output(const std::filesystem::path& path);

/// $XDG_CONFIG_HOME/vigil or ~/.config/vigil; $XDG_CACHE_HOME/vigil or ~/.cache/vigil. Not created
/// here: write_file does. Throws Error when neither the variable nor HOME is set.
std::filesystem::path config_dir();
std::filesystem::path cache_dir();

/// Writes the whole file under a temporary name beside it, then renames it over `path`: others see
/// the old file or the new one. Creates missing folders. Throws Error with the system's reason
/// (disk full, ...) and leaves no temporary file behind.
void write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);
void write_file(const std::filesystem::path& path, std::string_view text);

} // namespace vigil
