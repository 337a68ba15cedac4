// SPDX-License-Identifier: GPL-2.0-or-later
// Output folders and whole-file writes through POSIX.
#include "common/output.h"

#include "common/error.h"
#include "common/game_path.h"
#include "common/printable.h"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <system_error>
#include <unistd.h>

namespace vigil {

namespace {

namespace fs = std::filesystem;

std::string reason(int code) {
    return std::generic_category().message(code);
}

void create_folders(const fs::path& folder) {
    if (folder.empty()) return;
    std::error_code fault;
    fs::create_directories(folder, fault);
    if (fault) fail("{}: cannot create the folder: {}", folder.string(), fault.message());
}

fs::path xdg_dir(const char* variable, const char* below_home) {
    // The specification says to ignore paths that are not absolute.
    const char* folder = std::getenv(variable);
    if (folder && folder[0] == '/') return fs::path(folder) / "vigil";
    const char* home = std::getenv("HOME");
    if (!home || home[0] != '/') fail("neither {} nor HOME names a folder", variable);
    return fs::path(home) / below_home / "vigil";
}

/// A new file that disappears unless it is renamed over its target.
class TemporaryFile {
public:
    explicit TemporaryFile(const fs::path& target) : target_(target) {
        static std::atomic<unsigned> serial = 0;
        path_ = target.parent_path() /
                fmt::format(".{}.{}.{}.tmp", target.filename().string(), getpid(), serial++);
        descriptor_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ < 0) fail("{}: cannot create: {}", target.string(), reason(errno));
    }
    ~TemporaryFile() {
        if (descriptor_ >= 0) close(descriptor_);
        if (!renamed_) unlink(path_.c_str());
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    void write(std::span<const std::byte> bytes) {
        while (!bytes.empty()) {
            const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
            if (count < 0 && errno == EINTR) continue;
            if (count < 0) fail("{}: cannot write: {}", target_.string(), reason(errno));
            bytes = bytes.subspan(static_cast<std::size_t>(count));
        }
    }

    // A full disk or quota may show only when the file is closed.
    void commit() {
        const int closed = close(std::exchange(descriptor_, -1));
        if (closed != 0) fail("{}: cannot write: {}", target_.string(), reason(errno));
        if (std::rename(path_.c_str(), target_.c_str()) != 0)
            fail("{}: cannot replace: {}", target_.string(), reason(errno));
        renamed_ = true;
    }

private:
    fs::path target_;
    fs::path path_;
    int descriptor_ = -1;
    bool renamed_ = false;
};

} // namespace

fs::path output_path(std::string_view outdir, std::string_view name) {
    if (const auto fault = game_path_fault(name); !fault.empty())
        fail("\"{}\": not written, the name {}", printable(name), fault);
    if (outdir.empty()) fail("{}: not written, outdir is empty", name);
    fs::path path = fs::path(outdir) / name;
    create_folders(path.parent_path());
    return path;
}

void check_output(const fs::path& path) {
    std::error_code none;
    if (fs::is_directory(path, none)) fail("{}: cannot write: {}", path.string(), reason(EISDIR));
    if (access(path.parent_path().c_str(), W_OK | X_OK) != 0)
        fail("{}: cannot write: {}", path.string(), reason(errno));
}

fs::path config_dir() {
    return xdg_dir("XDG_CONFIG_HOME", ".config");
}
fs::path cache_dir() {
    return xdg_dir("XDG_CACHE_HOME", ".cache");
}

void write_file(const fs::path& path, std::span<const std::byte> bytes) {
    create_folders(path.parent_path());
    TemporaryFile file(path);
    file.write(bytes);
    file.commit();
}

void write_file(const fs::path& path, std::string_view text) {
    write_file(path, std::as_bytes(std::span(text)));
}

} // namespace vigil
