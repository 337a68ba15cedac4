// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/gpu/gpu_timer.h"

#include <algorithm>

namespace vigil::gpu {

namespace {
constexpr size_t marks_per_pool = 256; // start/stop pairs
} // namespace

GpuTimer::GpuTimer(const Device& device) : device_(&device) {
    if (device.features().timestamp_bits > 0) add_pool();
}

void GpuTimer::add_pool() {
    auto info = structure<VkQueryPoolCreateInfo>(VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO);
    info.queryType = VK_QUERY_TYPE_TIMESTAMP;
    info.queryCount = 2 * marks_per_pool;
    pools_.push_back(
        device_->make(vkCreateQueryPool, vkDestroyQueryPool, info, "vkCreateQueryPool"));
}

void GpuTimer::begin(VkCommandBuffer commands) {
    ids_.clear();
    open_ = false;
    for (const auto& pool : pools_)
        vkCmdResetQueryPool(commands, pool.get(), 0, 2 * marks_per_pool);
}

void GpuTimer::write(VkCommandBuffer commands, uint32_t end) {
    const size_t mark = ids_.size() - 1;
    vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT,
                        pools_[mark / marks_per_pool].get(),
                        2 * static_cast<uint32_t>(mark % marks_per_pool) + end);
}

void GpuTimer::start(VkCommandBuffer commands, uint32_t id) {
    if (pools_.empty()) return;
    if (ids_.size() == marks_per_pool * pools_.size()) {
        add_pool();
        vkCmdResetQueryPool(commands, pools_.back().get(), 0, 2 * marks_per_pool);
    }
    ids_.push_back(id);
    open_ = true;
    write(commands, 0);
}

void GpuTimer::stop(VkCommandBuffer commands) {
    if (open_) write(commands, 1);
    open_ = false;
}

void GpuTimer::collect() {
    milliseconds_.clear();
    std::vector<uint64_t> stamps;
    for (size_t pool = 0; stamps.size() < 2 * ids_.size(); ++pool) {
        const size_t first = stamps.size();
        const size_t count = std::min(2 * ids_.size() - first, 2 * marks_per_pool);
        stamps.resize(first + count);
        const VkResult result = vkGetQueryPoolResults(
            device_->handle(), pools_[pool].get(), 0, static_cast<uint32_t>(count),
            count * sizeof(uint64_t), &stamps[first], sizeof(uint64_t), VK_QUERY_RESULT_64_BIT);
        if (result != VK_SUCCESS) return;
    }
    const uint32_t bits = device_->features().timestamp_bits;
    const uint64_t mask = bits >= 64 ? ~uint64_t{0} : (uint64_t{1} << bits) - 1;
    for (size_t i = 0; i < ids_.size(); ++i) {
        const uint64_t ticks = (stamps[2 * i + 1] - stamps[2 * i]) & mask; // the counter may wrap
        if (milliseconds_.size() <= ids_[i]) milliseconds_.resize(ids_[i] + 1, 0.0);
        milliseconds_[ids_[i]] +=
            static_cast<double>(ticks) * double{device_->features().timestamp_period_ns} * 1e-6;
    }
}

double GpuTimer::milliseconds(uint32_t id) const {
    return id < milliseconds_.size() ? milliseconds_[id] : 0.0;
}

} // namespace vigil::gpu
