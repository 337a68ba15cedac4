// SPDX-License-Identifier: GPL-2.0-or-later
// Positioned reads through POSIX.
#include "common/binary_file.h"

#include "common/error.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace vigil {

BinaryFile::BinaryFile(const std::filesystem::path& path) : name_(path.string()) {
    // Not blocking: opening a pipe that nobody writes to would wait for ever.
    descriptor_ = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor_ < 0) fail("{}: cannot open: {}", name_, std::generic_category().message(errno));

    struct stat status = {};
    if (fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) {
        close(descriptor_);
        fail("{}: not a regular file", name_);
    }
    size_ = static_cast<std::uint64_t>(status.st_size);
}

BinaryFile::~BinaryFile() {
    close(descriptor_);
}

std::vector<std::uint8_t> BinaryFile::read(std::uint64_t offset, std::uint64_t bytes) const {
    if (offset > size_ || bytes > size_ - offset)
        fail("{}: truncated: bytes {} to {} of {} are needed", name_, offset, offset + bytes,
             size_);

    std::vector<std::uint8_t> result(bytes);
    std::uint64_t done = 0;
    while (done < bytes) {
        const ssize_t count = pread(descriptor_, result.data() + done, bytes - done,
                                    static_cast<off_t>(offset + done));
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail("{}: cannot read: {}", name_, std::generic_category().message(errno));
        if (count == 0) fail("{}: became shorter while it was read", name_);
        done += static_cast<std::uint64_t>(count);
    }
    return result;
}

} // namespace vigil
