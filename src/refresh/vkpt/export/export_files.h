// SPDX-License-Identifier: GPL-2.0-or-later
// The files of an exported scene: names for them, and a way to replace an earlier export as a whole
// or not at all. What is in the files is not known here.
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace vigil::vkpt {

/// Files made in a hidden folder beside their places and moved there together. What was not
/// committed is removed with this object.
class StagedFiles {
public:
    struct Written {
        uint64_t files = 0;
        uint64_t bytes = 0;
    };

    /// For files in the folder of `target`.
    explicit StagedFiles(const std::filesystem::path& target);
    ~StagedFiles();
    StagedFiles(const StagedFiles&) = delete;
    StagedFiles& operator=(const StagedFiles&) = delete;

    /// Where to write the file that becomes `name` (relative); its folder is made. Throws
    /// filesystem_error.
    std::filesystem::path add(const std::string& name);

    /// Moves all files to their places, in the order they were added. Throws filesystem_error.
    Written commit();

private:
    std::filesystem::path folder_;
    std::filesystem::path stage_;
    std::vector<std::string> names_;
};

/// `name` in lower-case letters, digits, - and _, made different from all `taken` and added to
/// them.
std::string plain_file_name(const std::string& name, std::set<std::string>& taken);

/// A relative path as a URI: all but RFC 3986's unreserved characters and / is percent-encoded.
std::string uri_of(const std::string& path);

} // namespace vigil::vkpt
