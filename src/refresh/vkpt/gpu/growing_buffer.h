// SPDX-License-Identifier: GPL-2.0-or-later
// A device buffer whose contents the host replaces now and then: grows when needed, and copies
// inside the frame that follows.
#pragma once

#include "refresh/vkpt/gpu/commands.h"

#include <vector>

namespace vigil::gpu {

class GrowingBuffer {
public:
    GrowingBuffer(const Device& device, const char* name) : device_(&device), name_(name) {}

    /// Sets what the next upload() copies. Returns true if the buffer was made anew.
    bool set(std::span<const std::byte> bytes) {
        pending_.assign(bytes.begin(), bytes.end());
        return grow(*device_, buffer_, bytes.size(), name_);
    }
    /// Records the copy, if there is something new.
    void upload(FrameCommands& commands) {
        commands.upload(buffer_, 0, pending_);
        pending_.clear();
    }
    const Buffer& buffer() const { return buffer_; }

private:
    const Device* device_;
    const char* name_;
    Buffer buffer_;
    std::vector<std::byte> pending_;
};

} // namespace vigil::gpu
