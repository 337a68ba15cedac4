// SPDX-License-Identifier: GPL-2.0-or-later
// Output folders and whole-file writes.
#include "common/output.h"

#include "common/error.h"
#include "common/game_path.h"
#include "common/printable.h"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
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
    static std::atomic<unsigned> serial = 0;
    const fs::path temporary =
        path.parent_path() /
        fmt::format(".{}.{}.{}.tmp", path.filename().string(), getpid(), serial++);
    std::FILE* const file = std::fopen(temporary.c_str(), "wxe"); // new, and not for children
    if (!file) fail("{}: cannot create: {}", path.string(), reason(errno));

    // A full disk or quota may show only when the file is closed.
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    int fault = written ? 0 : errno;
    if (std::fclose(file) != 0 && written) fault = errno;
    std::string_view step = "write";
    if (fault == 0 && std::rename(temporary.c_str(), path.c_str()) != 0) {
        fault = errno;
        step = "replace";
    }
    if (fault == 0) return;
    unlink(temporary.c_str());
    fail("{}: cannot {}: {}", path.string(), step, reason(fault));
}

void write_file(const fs::path& path, std::string_view text) {
    write_file(path, std::as_bytes(std::span(text)));
}

} // namespace vigil
