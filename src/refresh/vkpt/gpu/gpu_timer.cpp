// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/gpu/gpu_timer.h"

namespace vigil::gpu {

namespace {
constexpr uint32_t max_marks = 256; // start/stop pairs per frame
} // namespace

GpuTimer::GpuTimer(const Device& device) : device_(&device) {
    if (device.features().timestamp_bits == 0) return;
    VkQueryPoolCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
    info.queryType = VK_QUERY_TYPE_TIMESTAMP;
    info.queryCount = 2 * max_marks;
    VkQueryPool pool = VK_NULL_HANDLE;
    check(vkCreateQueryPool(device.handle(), &info, nullptr, &pool), "vkCreateQueryPool");
    pool_ = {device.handle(), pool, vkDestroyQueryPool};
}

void GpuTimer::begin(VkCommandBuffer commands) {
    ids_.clear();
    open_ = false;
    if (pool_) vkCmdResetQueryPool(commands, pool_.get(), 0, 2 * max_marks);
}

void GpuTimer::start(VkCommandBuffer commands, uint32_t id) {
    open_ = pool_ && ids_.size() < max_marks;
    if (!open_) return;
    ids_.push_back(id);
    const uint32_t query = 2 * static_cast<uint32_t>(ids_.size() - 1);
    vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, pool_.get(), query);
}

void GpuTimer::stop(VkCommandBuffer commands) {
    if (!open_) return;
    const uint32_t query = 2 * static_cast<uint32_t>(ids_.size() - 1) + 1;
    vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, pool_.get(), query);
    open_ = false;
}

void GpuTimer::collect() {
    milliseconds_.clear();
    if (ids_.empty()) return;
    std::vector<uint64_t> stamps(2 * ids_.size());
    const VkResult result = vkGetQueryPoolResults(
        device_->handle(), pool_.get(), 0, static_cast<uint32_t>(stamps.size()),
        stamps.size() * sizeof(uint64_t), stamps.data(), sizeof(uint64_t), VK_QUERY_RESULT_64_BIT);
    if (result != VK_SUCCESS) return;
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
