// SPDX-License-Identifier: GPL-2.0-or-later
// A device buffer whose contents the host replaces now and then: grows when needed, and copies
// inside the frame that follows.
#pragma once

#include "refresh/vkpt/gpu/commands.h"

#include <algorithm>
#include <vector>

namespace vigil::gpu {

class GrowingBuffer {
public:
    GrowingBuffer(const Device& device, const char* name) : device_(&device), name_(name) {}

    /// Sets what the next upload() copies; the first `kept` bytes are as they were. Returns true if
    /// the buffer was made anew.
    bool set(std::span<const std::byte> bytes, uint64_t kept = 0) {
        const bool renewed = grow(*device_, buffer_, bytes.size(), name_);
        first_ = renewed ? 0 : pending_.empty() ? kept : std::min(first_, kept);
        pending_.assign(bytes.begin() + static_cast<std::ptrdiff_t>(first_), bytes.end());
        return renewed;
    }
    /// Records the copy, if there is something new.
    void upload(FrameCommands& commands) {
        commands.upload(buffer_, first_, pending_);
        pending_.clear();
    }
    const Buffer& buffer() const { return buffer_; }

private:
    const Device* device_;
    const char* name_;
    Buffer buffer_;
    std::vector<std::byte> pending_; // what comes at first_
    uint64_t first_ = 0;
};

} // namespace vigil::gpu
