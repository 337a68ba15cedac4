// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/export/export_files.h"

#include <cctype>
#include <cstring>
#include <fmt/format.h>
#include <system_error>
#include <unistd.h>

namespace vigil::vkpt {

namespace fs = std::filesystem;

StagedFiles::StagedFiles(const fs::path& target)
    : folder_(target.parent_path()),
      stage_(folder_ / fmt::format(".{}.{}.tmp", target.filename().string(), getpid())) {}

StagedFiles::~StagedFiles() {
    std::error_code ignored;
    fs::remove_all(stage_, ignored);
}

fs::path StagedFiles::add(const std::string& name) {
    fs::path path = stage_ / name;
    fs::create_directories(path.parent_path());
    names_.push_back(name);
    return path;
}

StagedFiles::Written StagedFiles::commit() {
    Written written;
    for (const std::string& name : names_) {
        const fs::path target = folder_ / name;
        fs::create_directories(target.parent_path());
        written.bytes += fs::file_size(stage_ / name);
        fs::rename(stage_ / name, target);
        ++written.files;
    }
    return written;
}

std::string plain_file_name(const std::string& name, std::set<std::string>& taken) {
    std::string plain;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        const bool kept = byte < 128 && (std::isalnum(byte) || c == '-' || c == '_');
        plain += kept ? static_cast<char>(std::tolower(byte)) : '_';
    }
    if (plain.empty()) plain = "unnamed";
    std::string unique = plain;
    for (int i = 2; !taken.insert(unique).second; ++i)
        unique = fmt::format("{}_{}", plain, i);
    return unique;
}

std::string uri_of(const std::string& path) {
    std::string uri;
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 128 && (std::isalnum(byte) || std::strchr("-._~/", c)))
            uri += c;
        else
            uri += fmt::format("%{:02X}", byte);
    }
    return uri;
}

} // namespace vigil::vkpt
