// SPDX-License-Identifier: GPL-2.0-or-later
// The game's files: folders, .pak and .pkz archives, and sources that a front end brings, laid over
// each other and looked up without regard to case, as Quake II engines do. It only reads; what the
// program writes goes through output.h.
// Reading and looking up are safe from several threads once everything is mounted.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vigil {

class FileSource;

/// Largest file that read() returns; more is refused as hostile.
inline constexpr std::uint64_t max_file_bytes = 512ull << 20;

class FileSystem {
public:
    /// Where a file was found.
    struct Location {
        std::string path;    ///< in the spelling of its source
        std::string source;  ///< the folder or archive, for messages
        std::uint64_t bytes; ///< unpacked, as declared by the source
        bool in_archive;     ///< the source is an archive
    };

    FileSystem();
    ~FileSystem();
    FileSystem(FileSystem&&) noexcept;
    FileSystem& operator=(FileSystem&&) noexcept;

    /// Mounts baseq2 below `basedir` and then, if it is another folder, `game`. A missing folder or
    /// a broken archive gives one logged message and is skipped. Throws Error when `game` is not a
    /// folder name.
    void mount_game(const std::filesystem::path& basedir, std::string_view game);

    /// Mounts one folder over everything mounted before: its loose files, over them pak0.pak to
    /// pak9.pak, over them its *.pkz in alphabetical order. So archives hide loose files, as in
    /// Quake II and q2pro.
    void mount_folder(const std::filesystem::path& folder);

    /// Mounts a source over everything mounted before: a front end's own files.
    void mount(std::unique_ptr<FileSource> source);

    /// The whole file. `path` has forward slashes and is relative: "maps/mine.bsp", in any case.
    /// Throws Error, naming the file and the fault: no such file, not a safe path, damaged archive.
    std::vector<std::uint8_t> read(std::string_view path) const;

    /// The same as text, for cfg files; refuses files with NUL bytes and more than 1 MiB.
    std::string read_text(std::string_view path) const;

    /// Where read() would find it; nothing when there is no such file or the path is not a safe
    /// one.
    std::optional<Location> find(std::string_view path) const;
    bool exists(std::string_view path) const { return find(path).has_value(); }

    /// Paths that begin with `prefix` and end in `extension` (".bsp"), in any case; sorted, each
    /// once.
    std::vector<std::string> list(std::string_view prefix, std::string_view extension) const;

private:
    std::vector<std::unique_ptr<FileSource>> sources_; ///< lowest priority first
};

/// The folder that holds baseq2: `basedir` where it is not empty; else the first that has a folder
/// baseq2 of: the program's own folder, the one above it, the source folder it was built from, the
/// installed data folder. Throws Error, naming where it looked, when there is none.
std::filesystem::path find_basedir(std::string_view basedir);

} // namespace vigil
