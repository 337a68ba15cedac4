// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/gpu/pipeline_compiler.h"

#include "common/error.h"

#include <algorithm>
#include <utility>

namespace vigil::gpu {

namespace {

/// More threads gain little: one shader takes half of the time of all.
constexpr unsigned most_threads = 4;

} // namespace

PipelineCompiler::PipelineCompiler(const Device& device, std::filesystem::path cache_file)
    : device_(device), cache_(device, std::move(cache_file)) {
    const unsigned count = std::clamp(std::thread::hardware_concurrency(), 1u, most_threads);
    threads_.reserve(count);
    try {
        for (unsigned i = 0; i < count; ++i)
            threads_.emplace_back([this] { work(); });
    } catch (const std::exception& error) { // fewer do
        if (threads_.empty()) fail("there is no thread to compile shaders: {}", error.what());
    }
}

PipelineCompiler::~PipelineCompiler() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
        queued_.clear();
    }
    changed_.notify_all();
    for (std::thread& thread : threads_)
        thread.join();
}

std::shared_ptr<PipelineJob> PipelineCompiler::add(const PipelineLayout& layout,
                                                   PipelineSource source) {
    auto job = std::make_shared<PipelineJob>();
    job->compiler = this;
    job->layout = &layout;
    job->source = std::move(source);
    {
        const std::lock_guard lock(mutex_);
        if (queued_.empty() && under_way_.empty() && undispatched_.empty()) {
            done_ = 0;
            done_bytes_ = 0;
        }
        queued_.push_back(job);
    }
    changed_.notify_all();
    return job;
}

VkPipeline PipelineCompiler::wait(const PipelineJob& job) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return job.state == PipelineJob::State::Finished; });
    if (!job.fault.empty()) fail("{}", job.fault);
    return job.pipeline.get();
}

void PipelineCompiler::drop(PipelineJob& job) {
    std::unique_lock lock(mutex_);
    for (auto* jobs : {&queued_, &undispatched_})
        std::erase_if(*jobs, [&](const auto& other) { return other.get() == &job; });
    changed_.wait(lock, [&] { return job.state != PipelineJob::State::UnderWay; });
    job.pipeline.reset();
}

bool PipelineCompiler::wait_for(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, time, [&] { return queued_.empty() && under_way_.empty(); });
}

std::shared_ptr<PipelineJob> PipelineCompiler::begin_first_dispatch() {
    const std::lock_guard lock(mutex_);
    const auto found = std::ranges::min_element(
        undispatched_, {}, [](const auto& job) { return job->source.spirv.size(); });
    if (found == undispatched_.end()) return nullptr;
    dispatched_ = *found;
    dispatch_watch_ = {};
    undispatched_.erase(found);
    return dispatched_;
}

void PipelineCompiler::finish_first_dispatch(const std::shared_ptr<PipelineJob>& job) {
    const std::lock_guard lock(mutex_);
    dispatched_.reset();
    job->seconds += dispatch_watch_.seconds();
    count_done(*job);
}

void PipelineCompiler::count_done(const PipelineJob& job) {
    ++done_;
    done_bytes_ += job.source.spirv.size_bytes();
    if (job.fault.empty()) compiled_.push_back({job.source, job.seconds});
}

std::vector<CompiledPipeline> PipelineCompiler::take_compiled() {
    const std::lock_guard lock(mutex_);
    return std::exchange(compiled_, {});
}

bool PipelineCompiler::idle() const {
    const std::lock_guard lock(mutex_);
    return queued_.empty() && under_way_.empty();
}

refresh::Compilation PipelineCompiler::state() const {
    const std::lock_guard lock(mutex_);
    refresh::Compilation state;
    uint64_t bytes = done_bytes_;
    std::vector<std::shared_ptr<PipelineJob>> now = under_way_;
    if (dispatched_) now.push_back(dispatched_);
    for (const auto* jobs : {&queued_, &std::as_const(now), &undispatched_})
        for (const auto& job : *jobs)
            bytes += job->source.spirv.size_bytes();
    for (const auto& job : now)
        state.passes.push_back(job->source.name);
    state.done = done_;
    state.total = done_ + static_cast<int>(queued_.size() + now.size() + undispatched_.size());
    state.share =
        static_cast<float>(done_bytes_) / static_cast<float>(std::max(bytes, uint64_t{1}));
    return state;
}

std::shared_ptr<PipelineJob> PipelineCompiler::largest_queued() {
    const auto found = std::ranges::max_element(
        queued_, {}, [](const auto& job) { return job->source.spirv.size(); });
    std::shared_ptr<PipelineJob> job = *found;
    queued_.erase(found);
    return job;
}

void PipelineCompiler::work() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [&] { return ending_ || !queued_.empty(); });
        if (ending_) return;
        const std::shared_ptr<PipelineJob> job = largest_queued();
        under_way_.push_back(job);
        job->state = PipelineJob::State::UnderWay;
        lock.unlock();
        Handle<VkPipeline> pipeline;
        std::string fault;
        const PipelineSource& source = job->source;
        const Stopwatch watch;
        try {
            pipeline = make_compute_pipeline(device_, job->layout->handle(), &cache_, source.spirv,
                                             source.constants, source.name.c_str());
        } catch (const std::exception& error) {
            fault = error.what();
        }
        const double seconds = watch.seconds();
        lock.lock();
        job->seconds = seconds;
        job->pipeline = std::move(pipeline);
        job->fault = std::move(fault);
        job->state = PipelineJob::State::Finished;
        std::erase(under_way_, job);
        if (device_.features().llvmpipe_mesa > 0 && job->fault.empty() && !source.ray_queries) {
            undispatched_.push_back(job);
        } else {
            count_done(*job);
        }
        changed_.notify_all();
    }
}

ComputePipeline::ComputePipeline(PipelineCompiler& compiler, const PipelineLayout& layout,
                                 PipelineSource source)
    : layout_(&layout), job_(compiler.add(layout, std::move(source))) {}

ComputePipeline::~ComputePipeline() {
    drop_job();
}

ComputePipeline::ComputePipeline(ComputePipeline&&) noexcept = default;

ComputePipeline& ComputePipeline::operator=(ComputePipeline&& other) noexcept {
    if (this == &other) return *this;
    drop_job();
    layout_ = other.layout_;
    pipeline_ = std::move(other.pipeline_);
    job_ = std::move(other.job_);
    return *this;
}

void ComputePipeline::drop_job() {
    if (job_) job_->compiler->drop(*job_);
    job_.reset();
}

void ComputePipeline::dispatch(VkCommandBuffer commands, const Inputs& inputs,
                               const WorkGroups& groups) const {
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE,
                      job_ ? job_->compiler->wait(*job_) : pipeline_.get());
    if (!inputs.sets.empty())
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_->handle(), 0,
                                static_cast<uint32_t>(inputs.sets.size()), inputs.sets.data(), 0,
                                nullptr);
    if (!inputs.push.empty())
        vkCmdPushConstants(commands, layout_->handle(), VK_SHADER_STAGE_COMPUTE_BIT, 0,
                           static_cast<uint32_t>(inputs.push.size()), inputs.push.data());
    if (groups.counted != VK_NULL_HANDLE)
        vkCmdDispatchIndirect(commands, groups.counted, groups.offset);
    else
        vkCmdDispatch(commands, groups.count.x, groups.count.y, groups.count.z);
}

} // namespace vigil::gpu
