// SPDX-License-Identifier: GPL-2.0-or-later
// Compute pipelines, their descriptor sets and the pipeline cache on disk. All passes share one
// layout per set: a set is a row of storage buffers (binding 0 of the scene set is a uniform
// buffer, and one binding may be an acceleration structure), so a pass needs no set-up code of its
// own.
#pragma once

#include "refresh/vkpt/gpu/buffer.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace vigil::gpu {

/// The driver's pipeline cache, loaded from and saved to a file. A file that is damaged or from
/// another device or driver is ignored with a log line.
class PipelineCache {
public:
    PipelineCache(const Device& device, std::filesystem::path file);
    ~PipelineCache(); // saves
    PipelineCache(const PipelineCache&) = delete;
    PipelineCache& operator=(const PipelineCache&) = delete;
    VkPipelineCache handle() const { return cache_.get(); }

private:
    const Device* device_;
    std::filesystem::path file_;
    Handle<VkPipelineCache> cache_;
    size_t loaded_bytes_ = 0;
};

/// A descriptor set whose bindings 0 .. n-1 have the given types, with a layout and memory of its
/// own.
class DescriptorSet {
public:
    DescriptorSet() = default;
    /// `unused` stands in at bindings that were not set, so that every set is complete.
    DescriptorSet(const Device& device, std::span<const VkDescriptorType> types,
                  const Buffer& unused, const char* name);

    VkDescriptorSetLayout layout() const { return layout_.get(); }
    VkDescriptorSet handle() const { return set_; }
    const std::vector<VkDescriptorType>& types() const { return types_; }

    /// Points a binding at a buffer; the GPU must not be using the set.
    void bind(uint32_t binding, const Buffer& buffer);
    void bind(uint32_t binding, VkBufferView texels);
    void bind(uint32_t binding, VkAccelerationStructureKHR structure);

private:
    const Device* device_ = nullptr;
    std::vector<VkDescriptorType> types_;
    Handle<VkDescriptorSetLayout> layout_;
    Handle<VkDescriptorPool> pool_;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
};

/// The pipeline layout made of some sets and 128 bytes of push constants.
Handle<VkPipelineLayout> make_pipeline_layout(const Device& device,
                                              std::span<const VkDescriptorSetLayout> sets);

/// One specialisation constant (booleans are 0 or 1; floats go in by their bits).
struct Specialization {
    uint32_t id;
    uint32_t value;
};

/// `name` is that of the pass, for labels and messages.
Handle<VkPipeline> make_compute_pipeline(const Device& device, VkPipelineLayout layout,
                                         const PipelineCache* cache,
                                         std::span<const uint32_t> spirv,
                                         std::span<const Specialization> constants,
                                         const char* name);

/// What a pipeline is made of on any device.
struct PipelineSource {
    std::span<const uint32_t> spirv; ///< the embedded shader: it outlives all pipelines
    std::vector<Specialization> constants;
    std::string name;                                ///< of the pass, for labels and messages
    std::vector<std::vector<VkDescriptorType>> sets; ///< what the bindings of each set are
    bool ray_queries = false;                        ///< it traces acceleration structures
};

class PipelineCompiler;
struct PipelineJob;

class ComputePipeline {
public:
    ComputePipeline() = default;
    /// Makes it now. `spirv` is the embedded shader, `name` the pass, for labels and messages.
    ComputePipeline(const Device& device, VkPipelineLayout layout, const PipelineCache* cache,
                    std::span<const uint32_t> spirv, std::span<const Specialization> constants,
                    const char* name);
    /// Has it made by the compiler's threads. `layout` is that of the source's sets and outlives
    /// the pipeline.
    ComputePipeline(PipelineCompiler& compiler, VkPipelineLayout layout, PipelineSource source);
    ~ComputePipeline();
    ComputePipeline(ComputePipeline&&) noexcept;
    ComputePipeline& operator=(ComputePipeline&&) noexcept;

    explicit operator bool() const { return pipeline_ || job_; }
    /// Waits while it is made. Throws Error when that failed.
    void bind(VkCommandBuffer commands) const;

private:
    void drop_job();

    Handle<VkPipeline> pipeline_;
    std::shared_ptr<PipelineJob> job_; // null where it was made at once
};

} // namespace vigil::gpu
