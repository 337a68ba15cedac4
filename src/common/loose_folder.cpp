// SPDX-License-Identifier: GPL-2.0-or-later
// The files of a folder on disk. The tree is listed once: levels look for textures under several
// names, and a case-insensitive search on disk would list the same folders again each time.
#include "common/binary_file.h"
#include "common/error.h"
#include "common/file_source.h"
#include "common/file_system.h"
#include "common/log.h"

#include <algorithm>
#include <system_error>

namespace vigil {

namespace {

namespace fs = std::filesystem;

// A game folder has some ten thousand files; more than this is somebody's whole disk.
constexpr std::size_t max_entries = 500'000;

class LooseFolder : public ListedSource {
public:
    explicit LooseFolder(const fs::path& folder)
        : ListedSource(folder.string(), false), folder_(folder) {
        std::vector<fs::path> above;
        walk(folder_, "", above);
        if (entries_ > max_entries)
            log_warning("{}: more than {} files. The others are left out.", name(), max_entries);
        report_skipped();
    }

private:
    std::vector<std::uint8_t> read_file(std::size_t index) const override {
        const BinaryFile file(folder_ / files()[index].path);
        if (file.size() > max_file_bytes)
            fail("{}: has {} bytes; the limit is {}", file.name(), file.size(), max_file_bytes);
        return file.read(0, file.size());
    }

    // `above`: the folders from the root to here, to notice links that lead back up.
    void walk(const fs::path& folder, const std::string& prefix, std::vector<fs::path>& above) {
        std::error_code fault;
        const auto is_here = [&](const fs::path& other) {
            return fs::equivalent(other, folder, fault);
        };
        if (std::ranges::any_of(above, is_here)) return;
        above.push_back(folder);

        // In the order of names, so that of two names that differ in case the same one wins
        // everywhere.
        std::vector<fs::path> entries;
        for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
             entry.increment(fault))
            entries.push_back(entry->path());
        if (fault) log_warning("{}: cannot list: {}", folder.string(), fault.message());
        std::sort(entries.begin(), entries.end());

        for (const fs::path& entry : entries) {
            if (++entries_ > max_entries) break;
            std::error_code ignored; // a dangling link or a file that just vanished is not there
            const fs::file_status kind = fs::status(entry, ignored);
            const std::string path = prefix + entry.filename().string();
            if (fs::is_directory(kind)) {
                walk(entry, path + '/', above);
            } else if (fs::is_regular_file(kind) && path.find('\\') == std::string::npos) {
                const std::uintmax_t bytes = fs::file_size(entry, ignored);
                if (!ignored) add(path, bytes);
            }
        }
        above.pop_back();
    }

    fs::path folder_;
    std::size_t entries_ = 0;
};

} // namespace

std::unique_ptr<FileSource> open_loose_folder(const fs::path& folder) {
    return std::make_unique<LooseFolder>(folder);
}

} // namespace vigil
