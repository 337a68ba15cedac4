// SPDX-License-Identifier: GPL-2.0-or-later
// Archives: opened, listed, and every file in them read. They are opened by name, so the bytes lie
// in a file of memory that has one.
#include "common/error.h"
#include "common/file_source.h"
#include "common/game_path.h"
#include "target.h"

#include <sys/mman.h>
#include <unistd.h>

namespace vigil::fuzz {

namespace {

/// A file without a folder; it disappears with the object.
class MemoryFile {
public:
    explicit MemoryFile(Input bytes) : descriptor_(memfd_create("fuzz", MFD_CLOEXEC)) {
        require(descriptor_ >= 0, "no file in memory could be made");
        while (!bytes.empty()) {
            const ssize_t count = write(descriptor_, bytes.data(), bytes.size());
            require(count > 0, "a file in memory could not be written");
            bytes = bytes.subspan(static_cast<std::size_t>(count));
        }
    }
    ~MemoryFile() { close(descriptor_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    std::string path() const { return fmt::format("/proc/self/fd/{}", descriptor_); }

private:
    int descriptor_;
};

template <typename Open> void open_and_read(Input bytes, Open open) {
    const MemoryFile file(bytes);
    parse_or_refuse(file.path(), [&] {
        const auto source = open(file.path());
        for (const std::string& path : source->list("", "")) {
            require(game_path_fault(path).empty(), "an unsafe path was listed");
            parse_or_refuse(file.path(), [&] {
                require(source->read(path).value().size() == source->find(path).value().bytes,
                        "a file has not its listed size");
            });
        }
    });
}

} // namespace

void fuzz_pak(Input bytes) {
    open_and_read(bytes, open_pak);
}

void fuzz_pkz(Input bytes) {
    open_and_read(bytes, open_zip);
}

} // namespace vigil::fuzz
