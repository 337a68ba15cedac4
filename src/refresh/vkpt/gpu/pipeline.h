// SPDX-License-Identifier: GPL-2.0-or-later
// Compute pipelines, their descriptor sets and the pipeline cache on disk. All passes share one
// layout per set: a set is a row of buffers, of which BindingKind says how shaders read them (one
// binding may be an acceleration structure), so a pass needs no set-up code of its own.
#pragma once

#include "refresh/vkpt/gpu/buffer.h"

#include <glm/glm.hpp>

#include <filesystem>
#include <initializer_list>
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

/// What a binding of a set is.
enum class BindingKind {
    Storage, ///< a storage buffer
    Uniform, ///< a uniform buffer
    Records, ///< a buffer that is only read, as texels of 16 bytes (utextureBuffer)
    Words,   ///< the same, as texels of 4 bytes
    Traced,  ///< an acceleration structure
};

/// A descriptor set whose bindings 0 .. n-1 are of the given kinds, with a layout and memory of its
/// own.
class DescriptorSet {
public:
    DescriptorSet() = default;
    /// `unused` stands in at bindings that were not set, so that every set is complete.
    DescriptorSet(const Device& device, std::span<const BindingKind> kinds, const Buffer& unused,
                  const char* name);

    VkDescriptorSetLayout layout() const { return layout_.get(); }
    VkDescriptorSet handle() const { return set_; }
    const std::vector<BindingKind>& kinds() const { return kinds_; }

    /// Points a binding at a buffer; the GPU must not be using the set.
    void bind(uint32_t binding, const Buffer& buffer);
    void bind(uint32_t binding, VkAccelerationStructureKHR traced);

private:
    /// With what `write` says of the resource.
    void bind(uint32_t binding, VkWriteDescriptorSet write);

    const Device* device_ = nullptr;
    std::vector<BindingKind> kinds_;
    Handle<VkDescriptorSetLayout> layout_;
    Handle<VkDescriptorPool> pool_;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
};

/// What pipelines see: sets like some, and 128 bytes of push constants.
class PipelineLayout {
public:
    PipelineLayout() = default;
    /// `sets` in the order of their numbers.
    PipelineLayout(const Device& device, std::initializer_list<const DescriptorSet*> sets);
    VkPipelineLayout handle() const { return layout_.get(); }
    /// What the bindings of each set are.
    const std::vector<std::vector<BindingKind>>& sets() const { return sets_; }

private:
    std::vector<std::vector<BindingKind>> sets_;
    Handle<VkPipelineLayout> layout_;
};

/// One specialisation constant (booleans are 0 or 1; floats go in by their bits).
struct Specialization {
    uint32_t id;
    uint32_t value;
    bool operator==(const Specialization&) const = default;
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
    std::string name;         ///< of the pass, for labels and messages
    bool ray_queries = false; ///< it traces acceleration structures
};

/// What a dispatch reads: a set for each of its layout, and push constants.
struct Inputs {
    std::span<const VkDescriptorSet> sets;
    std::span<const std::byte> push{};
};

/// How many work groups: so many, or what the GPU has counted (a VkDispatchIndirectCommand).
struct WorkGroups {
    glm::uvec3 count{1, 1, 1};
    VkBuffer counted = VK_NULL_HANDLE;
    VkDeviceSize offset = 0;
};

class PipelineCompiler;
struct PipelineJob;

class ComputePipeline {
public:
    ComputePipeline() = default;
    /// Makes it now. `layout` outlives it; `spirv` is the embedded shader, `name` the pass, for
    /// labels and messages.
    ComputePipeline(const Device& device, const PipelineLayout& layout, const PipelineCache* cache,
                    std::span<const uint32_t> spirv, std::span<const Specialization> constants,
                    const char* name);
    /// Has it made by the compiler's threads.
    ComputePipeline(PipelineCompiler& compiler, const PipelineLayout& layout,
                    PipelineSource source);
    ~ComputePipeline();
    ComputePipeline(ComputePipeline&&) noexcept;
    ComputePipeline& operator=(ComputePipeline&&) noexcept;

    explicit operator bool() const { return pipeline_ || job_; }
    /// Records work groups. Waits while the pipeline is made; throws Error when that failed.
    void dispatch(VkCommandBuffer commands, const Inputs& inputs, const WorkGroups& groups) const;

private:
    void drop_job();

    const PipelineLayout* layout_ = nullptr;
    Handle<VkPipeline> pipeline_;
    std::shared_ptr<PipelineJob> job_; // null where it was made at once
};

} // namespace vigil::gpu
