// SPDX-License-Identifier: GPL-2.0-or-later
// What ray queries run on (VK_KHR_acceleration_structure): a bottom level per model that is in use,
// built again when the model deforms, and a top level over this frame's instances. The shader's
// side is shaders/trace/trace_query.glsl. Structures are not compacted: levels are small,
// and a copy more would lengthen loading.
#pragma once

#include "refresh/vkpt/gpu/commands.h"
#include "shared/scene_types.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vigil::vkpt {

/// A model's geometry: `triangles` are its slice of BvhTriangle[], which tells their coverage, and
/// `corners` their three corners each, in object space, as they were before edges were rounded:
/// neighbours must share them exactly to be watertight.
struct QueryModel {
    std::span<const glm::vec3> corners;
    std::span<const shader::BvhTriangle> triangles;
    uint32_t first_triangle = 0; // in BvhTriangle[]; at most 2^24 - 1
    uint64_t revision = 1;       // differs after every change; never 0
    bool deforms = false; // will change often: quick to build counts more than quick to trace
};

class AccelerationStructures {
public:
    /// The device must offer ray queries.
    explicit AccelerationStructures(const gpu::Device& device);

    /// Prepares the structures for `instances`, of which number i shows models[instance_models[i]].
    /// Models keep their index from frame to frame. Builds what is new and waits for it; what has
    /// changed is left to record. Returns true if top() is another structure than before; the GPU
    /// is idle then. Throws Error if the device cannot hold the structures; then this object is
    /// good for destruction only.
    bool prepare(std::span<const QueryModel> models, std::span<const size_t> instance_models,
                 std::span<const shader::Instance> instances);
    /// Records the builds that are due, between barriers: no pass's own barrier waits for builds.
    void record(gpu::FrameCommands& commands);

    VkAccelerationStructureKHR top() const { return top_.handle.get(); }
    /// Memory of everything that stays.
    uint64_t bytes() const;

private:
    struct Structure {
        gpu::Buffer storage; // freed after handle (declared before it)
        gpu::Handle<VkAccelerationStructureKHR> handle;
    };
    struct Bottom {
        Structure structure;
        VkDeviceAddress address = 0;
        uint64_t revision = 0; // of the model when it was built
    };
    /// One bottom level to build: up to two geometries, each of all triangles.
    struct Build {
        size_t model = 0;
        uint64_t revision = 0;
        uint32_t triangle_count = 0;
        VkBuildAccelerationStructureFlagsKHR flags = 0;
        std::vector<VkGeometryFlagsKHR> geometries; // their flags; corners follow one another
        uint64_t first_corner = 0;                  // in Plan::corners
        uint64_t scratch_offset = 0;
        uint64_t structure_bytes = 0, scratch_bytes = 0;
    };
    struct Plan {
        std::vector<Build> builds;
        std::vector<glm::vec3> corners;
        uint64_t scratch_bytes = 0;
    };
    struct Functions {
        PFN_vkGetAccelerationStructureBuildSizesKHR sizes;
        PFN_vkCreateAccelerationStructureKHR create;
        PFN_vkDestroyAccelerationStructureKHR destroy;
        PFN_vkGetAccelerationStructureDeviceAddressKHR address;
        PFN_vkCmdBuildAccelerationStructuresKHR build;
    };

    VkAccelerationStructureBuildSizesInfoKHR
    build_sizes(const VkAccelerationStructureBuildGeometryInfoKHR& info,
                std::span<const uint32_t> counts) const;
    Build describe_build(size_t model_index, const QueryModel& model) const;
    static void add_build(Plan& plan, Build build, const QueryModel& model);
    void build_now(const Plan& plan);
    void record_bottoms(VkCommandBuffer commands, const Plan& plan, const gpu::Buffer& corners,
                        const gpu::Buffer& scratch);
    void record_top(VkCommandBuffer commands) const;
    bool prepare_top(std::span<const QueryModel> models, std::span<const size_t> instance_models,
                     std::span<const shader::Instance> instances);
    Structure make_structure(VkAccelerationStructureTypeKHR type, uint64_t bytes,
                             const char* name) const;
    VkDeviceAddress scratch_address(const gpu::Buffer& scratch) const;

    const gpu::Device& device_;
    Functions vk_{};
    uint64_t scratch_alignment_ = 1;
    std::vector<Bottom> bottoms_; // same order as the models
    Plan rebuilds_;               // for record
    Structure top_;
    uint32_t top_capacity_ = 0; // instances
    uint64_t top_scratch_bytes_ = 0;
    bool top_dirty_ = true;
    std::vector<VkAccelerationStructureInstanceKHR> top_instances_;
    gpu::Buffer instances_buffer_, corners_buffer_, scratch_buffer_;
};

} // namespace vigil::vkpt
