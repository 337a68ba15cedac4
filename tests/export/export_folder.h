// SPDX-License-Identifier: GPL-2.0-or-later
// A folder of its own for each test, removed at its end.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace vigil::vkpt {

class ExportFolder {
public:
    ExportFolder() {
        std::string name =
            (std::filesystem::temp_directory_path() / "vigil-export-XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
        path_ = name;
    }
    ~ExportFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ExportFolder(const ExportFolder&) = delete;
    ExportFolder& operator=(const ExportFolder&) = delete;

    std::filesystem::path operator/(const char* name) const { return path_ / name; }

    /// Number of files (not folders) below it, hidden ones included.
    size_t files() const {
        size_t count = 0;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(path_))
            count += entry.is_regular_file();
        return count;
    }

private:
    std::filesystem::path path_;
};

} // namespace vigil::vkpt
