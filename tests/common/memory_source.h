// SPDX-License-Identifier: GPL-2.0-or-later
// Files that lie on no disk, as a front end with a file system of its own brings them. For tests.
#pragma once

#include "common/ascii_case.h"
#include "common/file_source.h"

#include <map>

namespace vigil::test {

class MemorySource : public FileSource {
public:
    using Files = std::map<std::string, std::vector<std::uint8_t>>;

    /// Paths in lower case.
    explicit MemorySource(Files files) : FileSource("memory", true), files_(std::move(files)) {}

    std::optional<File> find(std::string_view path) const override {
        const auto found = files_.find(ascii_lower(path));
        if (found == files_.end()) return std::nullopt;
        return File{found->first, found->second.size()};
    }
    std::optional<std::vector<std::uint8_t>> read(std::string_view path) const override {
        const auto found = files_.find(ascii_lower(path));
        return found == files_.end() ? std::nullopt : std::optional(found->second);
    }

private:
    Files files_;
};

} // namespace vigil::test
