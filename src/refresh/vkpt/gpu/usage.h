// SPDX-License-Identifier: GPL-2.0-or-later
// What buffers and images take of a device's memory, and what the host copies into buffers, each by
// the name that the buffer or image was made with. What drivers take for themselves (compiled
// shaders, descriptors) is not seen.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

namespace vigil::gpu {

/// Bytes by name.
using ByteCounts = std::map<std::string, uint64_t, std::less<>>;

/// Of one device. Any thread may count.
class Usage {
public:
    void allocated(std::string_view name, uint64_t bytes);
    void freed(std::string_view name, uint64_t bytes);
    void uploaded(std::string_view name, uint64_t bytes);

    /// That is allocated now.
    ByteCounts memory() const;
    /// Copied by the host since the last call.
    ByteCounts take_uploads();

private:
    mutable std::mutex mutex_;
    ByteCounts memory_, uploads_;
};

/// Counts memory as long as it lives.
class MemoryShare {
public:
    MemoryShare() = default;
    /// `usage` outlives it.
    MemoryShare(Usage& usage, std::string name, uint64_t bytes);
    MemoryShare(MemoryShare&& other) noexcept { swap(other); }
    MemoryShare& operator=(MemoryShare&& other) noexcept {
        MemoryShare taken(std::move(other));
        swap(taken);
        return *this;
    }
    MemoryShare(const MemoryShare&) = delete;
    MemoryShare& operator=(const MemoryShare&) = delete;
    ~MemoryShare();

    const std::string& name() const { return name_; }

private:
    void swap(MemoryShare& other) noexcept {
        std::swap(usage_, other.usage_);
        name_.swap(other.name_);
        std::swap(bytes_, other.bytes_);
    }

    Usage* usage_ = nullptr;
    std::string name_;
    uint64_t bytes_ = 0;
};

} // namespace vigil::gpu
