// SPDX-License-Identifier: GPL-2.0-or-later
// A disk that fills up: while it lives, no file of this process grows past a limit, and write()
// fails half-way as it does on a full disk. For tests only.
#pragma once

#include <csignal>
#include <sys/resource.h>

namespace vigil::test {

class FullDisk {
public:
    explicit FullDisk(rlim_t bytes) {
        std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit small = {bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
    }
    ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    rlimit before_ = {};
};

} // namespace vigil::test
