// SPDX-License-Identifier: GPL-2.0-or-later
// Makes pipelines on threads of its own, the largest shader first, and tells how far it is, so that
// who waits can show it. Mesa's llvmpipe compiles a shader when it is first dispatched: there a
// pipeline counts as done after that (first_dispatch.h).
#pragma once

#include "common/stopwatch.h"
#include "refresh/refresh.h"
#include "refresh/vkpt/gpu/pipeline.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace vigil::gpu {

/// A pipeline on its way. All but `layout` and `source` under the compiler's mutex.
struct PipelineJob {
    enum class State { Queued, UnderWay, Finished };

    PipelineCompiler* compiler = nullptr;
    const PipelineLayout* layout = nullptr;
    PipelineSource source;
    State state = State::Queued;
    Handle<VkPipeline> pipeline;
    std::string fault;    ///< why it could not be made
    double seconds = 0.0; ///< that the driver has worked on it
};

/// A pipeline that can be used, and how long the driver took for it, its first dispatch included
/// where that compiles.
struct CompiledPipeline {
    PipelineSource source;
    double seconds = 0.0;
};

class PipelineCompiler {
public:
    PipelineCompiler(const Device& device, std::filesystem::path cache_file);
    ~PipelineCompiler(); // waits for what is under way, drops the rest
    PipelineCompiler(const PipelineCompiler&) = delete;
    PipelineCompiler& operator=(const PipelineCompiler&) = delete;

    /// Waits at most so long until nothing is left to make. True if nothing is.
    bool wait_for(std::chrono::milliseconds time);
    /// Of the pipelines that the driver compiles at their first dispatch, the one with the smallest
    /// shader; null: none is left. It is under way until `finish_first_dispatch`.
    std::shared_ptr<PipelineJob> begin_first_dispatch();
    void finish_first_dispatch(const std::shared_ptr<PipelineJob>& job);
    /// What is left, and what was done since nothing was left.
    refresh::Compilation state() const;
    bool idle() const;
    /// Those that were done since the last call.
    std::vector<CompiledPipeline> take_compiled();

private:
    friend class ComputePipeline;
    std::shared_ptr<PipelineJob> add(const PipelineLayout& layout, PipelineSource source);
    /// The pipeline, once it can be used. Throws Error when it could not be made.
    VkPipeline wait(const PipelineJob& job);
    void count_done(const PipelineJob& job);
    /// Nobody wants it any more; waits while the device is at work on it.
    void drop(PipelineJob& job);

    void work();
    std::shared_ptr<PipelineJob> largest_queued();

    const Device& device_;
    PipelineCache cache_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<std::shared_ptr<PipelineJob>> queued_, under_way_;
    /// Made, and not compiled yet.
    std::vector<std::shared_ptr<PipelineJob>> undispatched_;
    std::shared_ptr<PipelineJob> dispatched_; // for the first time, now
    Stopwatch dispatch_watch_;                // since that began
    std::vector<CompiledPipeline> compiled_;
    int done_ = 0;
    uint64_t done_bytes_ = 0; // of SPIR-V
    bool ending_ = false;
    std::vector<std::thread> threads_;
};

} // namespace vigil::gpu
