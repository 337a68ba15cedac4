// SPDX-License-Identifier: GPL-2.0-or-later
// The overlay: which folders and archives are mounted, in which order, and the look-up through
// them.
#include "common/file_system.h"

#include "common/ascii_case.h"
#include "common/error.h"
#include "common/file_source.h"
#include "common/game_path.h"
#include "common/log.h"
#include "common/printable.h"

#include <algorithm>
#include <map>
#include <system_error>
#include <utility>

namespace vigil {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_text_bytes = 1 << 20;

/// Entries of one folder in the order of their names in lower case.
std::vector<fs::path> sorted_entries(const fs::path& folder) {
    std::vector<std::pair<std::string, fs::path>> entries;
    std::error_code fault;
    for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
         entry.increment(fault))
        entries.emplace_back(ascii_lower(entry->path().filename().string()), entry->path());
    if (fault) fail("{}: cannot list: {}", folder.string(), fault.message());
    std::sort(entries.begin(), entries.end());

    std::vector<fs::path> paths;
    for (auto& [lower, path] : entries)
        paths.push_back(std::move(path));
    return paths;
}

bool is_numbered_pak(std::string_view name) {
    return name.size() == 8 && starts_nocase(name, "pak") && name[3] >= '0' && name[3] <= '9' &&
           ends_nocase(name, ".pak");
}

/// The folder `name` below `basedir`, in whatever case it is spelled there.
fs::path game_folder(const fs::path& basedir, std::string_view name) {
    std::error_code ignored; // what cannot be looked at is no folder for us
    if (fs::path exact = basedir / name; fs::is_directory(exact, ignored)) return exact;
    for (const fs::path& entry : sorted_entries(basedir))
        if (equal_nocase(entry.filename().string(), name) && fs::is_directory(entry, ignored))
            return entry;
    fail("{}: has no folder {}. basedir and game say where game data is.", basedir.string(), name);
}

} // namespace

FileSystem::FileSystem() = default;
FileSystem::~FileSystem() = default;
FileSystem::FileSystem(FileSystem&&) noexcept = default;
FileSystem& FileSystem::operator=(FileSystem&&) noexcept = default;

void FileSystem::mount_game(const fs::path& basedir, std::string_view game) {
    if (const auto fault = game_path_fault(game); !fault.empty())
        fail("game \"{}\": the name {}", printable(game), fault);
    if (game.find('/') != std::string_view::npos) fail("game \"{}\": is not a folder's name", game);

    std::vector<std::string_view> folders = {"baseq2"};
    if (!equal_nocase(game, "baseq2")) folders.push_back(game);
    for (const std::string_view folder : folders) {
        try {
            mount_folder(game_folder(basedir, folder));
        } catch (const Error& error) {
            log_error("{}", error.what());
        }
    }
}

void FileSystem::mount_folder(const fs::path& folder) {
    std::vector<fs::path> paks;
    std::vector<fs::path> pkzs;
    for (const fs::path& entry : sorted_entries(folder)) {
        const std::string name = entry.filename().string();
        if (is_numbered_pak(name)) paks.push_back(entry);
        if (ends_nocase(name, ".pkz")) pkzs.push_back(entry);
    }

    mount(open_loose_folder(folder));
    const auto mount_archive = [&](auto open, const fs::path& archive) {
        try {
            mount(open(archive));
        } catch (const Error& error) {
            log_error("{}. The archive is skipped.", error.what());
        }
    };
    for (const fs::path& pak : paks)
        mount_archive(open_pak, pak);
    for (const fs::path& pkz : pkzs)
        mount_archive(open_zip, pkz);
}

void FileSystem::mount(std::unique_ptr<FileSource> source) {
    sources_.push_back(std::move(source));
}

std::vector<std::uint8_t> FileSystem::read(std::string_view path) const {
    if (const auto fault = game_path_fault(path); !fault.empty())
        fail("\"{}\": not read, the path {}", printable(path), fault);
    for (auto source = sources_.rbegin(); source != sources_.rend(); ++source)
        if (auto bytes = (*source)->read(path)) return std::move(*bytes);
    fail("{}: no such file in the game folders", path);
}

std::string FileSystem::read_text(std::string_view path) const {
    if (const auto place = find(path); place && place->bytes > max_text_bytes)
        fail("{}: too long for a text file", path);
    const auto bytes = read(path); // a loose file may have grown since it was listed
    if (bytes.size() > max_text_bytes) fail("{}: too long for a text file", path);
    if (std::find(bytes.begin(), bytes.end(), 0) != bytes.end())
        fail("{}: is not a text file", path);
    return std::string(bytes.begin(), bytes.end());
}

std::optional<FileSystem::Location> FileSystem::find(std::string_view path) const {
    if (!game_path_fault(path).empty()) return std::nullopt;
    for (auto source = sources_.rbegin(); source != sources_.rend(); ++source)
        if (auto file = (*source)->find(path))
            return Location{std::move(file->path), (*source)->name(), file->bytes,
                            (*source)->is_archive()};
    return std::nullopt;
}

std::vector<std::string> FileSystem::list(std::string_view prefix,
                                          std::string_view extension) const {
    // By path in lower case; the spelling of the highest source stays.
    std::map<std::string, std::string> found;
    for (auto source = sources_.rbegin(); source != sources_.rend(); ++source)
        for (std::string& path : (*source)->list(prefix, extension))
            found.try_emplace(ascii_lower(path), std::move(path));

    std::vector<std::string> paths;
    for (auto& [lower, path] : found)
        paths.push_back(std::move(path));
    return paths;
}

} // namespace vigil
