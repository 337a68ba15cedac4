// SPDX-License-Identifier: GPL-2.0-or-later
// One layer of the file system: where files come from. A front end with files of its own writes a
// FileSource; folders and archives are ListedSources, whose list is made once, when they are
// opened: later changes on disk are not seen, damage is reported when a file is read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace vigil {

/// Paths that it is asked for are safe ones (game_path.h), as the caller spells them; it should
/// answer without regard to case. Its functions may be called from several threads at once.
class FileSource {
public:
    struct File {
        std::string path; ///< safe, with forward slashes, in the spelling of the source
        std::uint64_t bytes;
    };

    virtual ~FileSource() = default;

    /// For messages.
    const std::string& name() const { return name_; }
    /// True where the files were packed by somebody; false where they lie loose in a folder.
    /// Scripts of the former may do less.
    bool is_archive() const { return is_archive_; }

    /// Nothing where it has no such file.
    virtual std::optional<File> find(std::string_view path) const = 0;

    /// The whole file, or nothing where find() finds none. Throws Error naming source, file and
    /// fault where it is damaged.
    virtual std::optional<std::vector<std::uint8_t>> read(std::string_view path) const = 0;

    /// Paths that begin with `prefix` and end in `extension`, in any case and order. A source that
    /// cannot tell lists none; its files are read all the same.
    virtual std::vector<std::string> list(std::string_view /*prefix*/,
                                          std::string_view /*extension*/) const {
        return {};
    }

protected:
    FileSource(std::string name, bool is_archive)
        : name_(std::move(name)), is_archive_(is_archive) {}

private:
    std::string name_;
    bool is_archive_;
};

/// A source whose files are known from the start.
class ListedSource : public FileSource {
public:
    std::optional<File> find(std::string_view path) const override;
    std::optional<std::vector<std::uint8_t>> read(std::string_view path) const override;
    std::vector<std::string> list(std::string_view prefix,
                                  std::string_view extension) const override;

protected:
    using FileSource::FileSource;

    const std::vector<File>& files() const { return files_; }

    /// The content of files()[index]. Throws Error naming source, file and fault.
    virtual std::vector<std::uint8_t> read_file(std::size_t index) const = 0;

    /// Adds a file, with backslashes turned round (archives packed on Windows). False, and counted
    /// as skipped, when the path is not a safe one; false when the name is there already: the first
    /// one stays.
    bool add(std::string path, std::uint64_t bytes);

    /// Logs one warning when paths were skipped; for the end of opening.
    void report_skipped() const;

private:
    std::optional<std::size_t> index_of(std::string_view path) const;

    std::vector<File> files_;
    std::unordered_map<std::string, std::size_t> by_lower_path_;
    std::size_t skipped_ = 0;
    std::string first_skipped_;
};

/// All regular files below a folder, through symbolic links too; links that lead back up are
/// ignored.
std::unique_ptr<FileSource> open_loose_folder(const std::filesystem::path& folder);

/// Quake's PACK archive: 12-byte header, then a directory of 64-byte entries (56 bytes of name,
/// 32-bit offset and length). Throws Error when the header or an entry is wrong.
std::unique_ptr<FileSource> open_pak(const std::filesystem::path& path);

/// A ZIP archive (PKWARE APPNOTE 6.3), stored and deflated entries, one disk, without ZIP64 and
/// encryption. Throws Error when the central directory is wrong; what is wrong with one file shows
/// when it is read.
std::unique_ptr<FileSource> open_zip(const std::filesystem::path& path);

} // namespace vigil
