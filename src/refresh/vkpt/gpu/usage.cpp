// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/gpu/usage.h"

namespace vigil::gpu {

namespace {

void add(ByteCounts& counts, std::string_view name, uint64_t bytes) {
    const auto known = counts.find(name);
    if (known == counts.end())
        counts.emplace(name, bytes);
    else
        known->second += bytes;
}

} // namespace

void Usage::allocated(std::string_view name, uint64_t bytes) {
    const std::lock_guard lock(mutex_);
    add(memory_, name, bytes);
}

void Usage::freed(std::string_view name, uint64_t bytes) {
    const std::lock_guard lock(mutex_);
    const auto known = memory_.find(name);
    known->second -= bytes;
    if (known->second == 0) memory_.erase(known);
}

void Usage::uploaded(std::string_view name, uint64_t bytes) {
    const std::lock_guard lock(mutex_);
    if (bytes > 0) add(uploads_, name, bytes);
}

ByteCounts Usage::memory() const {
    const std::lock_guard lock(mutex_);
    return memory_;
}

ByteCounts Usage::take_uploads() {
    const std::lock_guard lock(mutex_);
    return std::exchange(uploads_, {});
}

MemoryShare::MemoryShare(Usage& usage, std::string name, uint64_t bytes)
    : usage_(&usage), name_(std::move(name)), bytes_(bytes) {
    usage_->allocated(name_, bytes_);
}

MemoryShare::~MemoryShare() {
    if (usage_ != nullptr) usage_->freed(name_, bytes_);
}

} // namespace vigil::gpu
