// SPDX-License-Identifier: GPL-2.0-or-later
// Sources with a list of their files.
#include "common/file_source.h"

#include "common/ascii_case.h"
#include "common/game_path.h"
#include "common/log.h"
#include "common/printable.h"

#include <algorithm>

namespace vigil {

bool ListedSource::add(std::string path, std::uint64_t bytes) {
    std::replace(path.begin(), path.end(), '\\', '/');
    if (!game_path_fault(path).empty()) {
        if (skipped_++ == 0) first_skipped_ = std::move(path);
        return false;
    }
    const bool added = by_lower_path_.try_emplace(ascii_lower(path), files_.size()).second;
    if (added) files_.push_back({std::move(path), bytes});
    return added;
}

void ListedSource::report_skipped() const {
    if (skipped_ > 0)
        log_warning("{}: {} files skipped for unsafe names, the first is \"{}\", which {}", name(),
                    skipped_, printable(first_skipped_), game_path_fault(first_skipped_));
}

std::optional<std::size_t> ListedSource::index_of(std::string_view path) const {
    const auto found = by_lower_path_.find(ascii_lower(path));
    return found == by_lower_path_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<FileSource::File> ListedSource::find(std::string_view path) const {
    const auto index = index_of(path);
    return index ? std::optional(files_[*index]) : std::nullopt;
}

std::optional<std::vector<std::uint8_t>> ListedSource::read(std::string_view path) const {
    const auto index = index_of(path);
    return index ? std::optional(read_file(*index)) : std::nullopt;
}

std::vector<std::string> ListedSource::list(std::string_view prefix,
                                            std::string_view extension) const {
    std::vector<std::string> paths;
    for (const File& file : files_)
        if (starts_nocase(file.path, prefix) && ends_nocase(file.path, extension))
            paths.push_back(file.path);
    return paths;
}

} // namespace vigil
