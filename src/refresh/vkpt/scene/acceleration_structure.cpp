// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/scene/acceleration_structure.h"

#include "common/error.h"
#include "shared/bvh.h"

#include <algorithm>
#include <cstring>

namespace vigil::vkpt {

namespace {

constexpr uint64_t structure_alignment = 256; // of structures in their buffers, by the extension
constexpr uint32_t max_custom_index = (1u << 24) - 1;
constexpr VkBufferUsageFlags build_input_usage =
    VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_BIT_KHR |
    VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT;
// Corners that one submission of new structures may take; a bigger model goes alone.
constexpr size_t corners_per_submission = (32u << 20) / sizeof(glm::vec3);

uint64_t align(uint64_t value, uint64_t alignment) {
    return (value + alignment - 1) / alignment * alignment;
}

VkDeviceAddress address_of(const gpu::Device& device, const gpu::Buffer& buffer) {
    auto info =
        gpu::structure<VkBufferDeviceAddressInfo>(VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO);
    info.buffer = buffer.handle();
    return vkGetBufferDeviceAddress(device.handle(), &info);
}

bool is_opaque(const shader::BvhTriangle& triangle) {
    return (triangle.flags & shader::TRIANGLE_COVERAGE_MASK) == shader::TRIANGLE_COVERAGE_MASK;
}

VkAccelerationStructureGeometryKHR
triangle_geometry(VkDeviceAddress corners, uint32_t triangle_count, VkGeometryFlagsKHR flags) {
    auto geometry = gpu::structure<VkAccelerationStructureGeometryKHR>(
        VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR);
    geometry.geometryType = VK_GEOMETRY_TYPE_TRIANGLES_KHR;
    geometry.flags = flags;
    VkAccelerationStructureGeometryTrianglesDataKHR& triangles = geometry.geometry.triangles;
    triangles.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_TRIANGLES_DATA_KHR;
    triangles.vertexFormat = VK_FORMAT_R32G32B32_SFLOAT;
    triangles.vertexData.deviceAddress = corners;
    triangles.vertexStride = sizeof(glm::vec3);
    triangles.maxVertex = 3 * triangle_count - 1;
    triangles.indexType = VK_INDEX_TYPE_NONE_KHR;
    return geometry;
}

VkAccelerationStructureGeometryKHR instance_geometry(VkDeviceAddress instances) {
    auto geometry = gpu::structure<VkAccelerationStructureGeometryKHR>(
        VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR);
    geometry.geometryType = VK_GEOMETRY_TYPE_INSTANCES_KHR;
    geometry.geometry.instances.sType =
        VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_INSTANCES_DATA_KHR;
    geometry.geometry.instances.data.deviceAddress = instances;
    return geometry;
}

VkAccelerationStructureBuildGeometryInfoKHR
build_info(VkAccelerationStructureTypeKHR type, VkBuildAccelerationStructureFlagsKHR flags,
           std::span<const VkAccelerationStructureGeometryKHR> geometries) {
    auto info = gpu::structure<VkAccelerationStructureBuildGeometryInfoKHR>(
        VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_GEOMETRY_INFO_KHR);
    info.type = type;
    info.flags = flags;
    info.mode = VK_BUILD_ACCELERATION_STRUCTURE_MODE_BUILD_KHR;
    info.geometryCount = static_cast<uint32_t>(geometries.size());
    info.pGeometries = geometries.data();
    return info;
}

/// All triangles of a model as one of its geometries. Those that belong to the other one shrink to
/// a point, which nothing hits, so that primitive indices are the same in both. (Corners that are
/// NaN would leave them out, but Mesa 25.0's lavapipe then loses their neighbours too.)
void append_corners(const QueryModel& model, bool opaque, std::vector<glm::vec3>& corners) {
    for (size_t i = 0; i < model.triangles.size(); ++i) {
        const bool own = is_opaque(model.triangles[i]) == opaque;
        for (size_t corner = 0; corner < 3; ++corner)
            corners.push_back(model.corners[3 * i + (own ? corner : 0)]);
    }
}

VkTransformMatrixKHR row_major(const glm::mat4x3& transform) {
    VkTransformMatrixKHR matrix;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            matrix.matrix[row][column] = transform[column][row];
    return matrix;
}

template <typename F> F load(const gpu::Device& device, const char* name) {
    return reinterpret_cast<F>(vkGetDeviceProcAddr(device.handle(), name));
}

} // namespace

AccelerationStructures::AccelerationStructures(const gpu::Device& device) : device_(device) {
    vk_.sizes = load<PFN_vkGetAccelerationStructureBuildSizesKHR>(
        device, "vkGetAccelerationStructureBuildSizesKHR");
    vk_.create =
        load<PFN_vkCreateAccelerationStructureKHR>(device, "vkCreateAccelerationStructureKHR");
    vk_.destroy =
        load<PFN_vkDestroyAccelerationStructureKHR>(device, "vkDestroyAccelerationStructureKHR");
    vk_.address = load<PFN_vkGetAccelerationStructureDeviceAddressKHR>(
        device, "vkGetAccelerationStructureDeviceAddressKHR");
    vk_.build = load<PFN_vkCmdBuildAccelerationStructuresKHR>(
        device, "vkCmdBuildAccelerationStructuresKHR");
    auto limits = gpu::structure<VkPhysicalDeviceAccelerationStructurePropertiesKHR>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_PROPERTIES_KHR);
    auto properties = gpu::structure<VkPhysicalDeviceProperties2>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &limits);
    vkGetPhysicalDeviceProperties2(device.physical(), &properties);
    scratch_alignment_ =
        std::max<uint64_t>(limits.minAccelerationStructureScratchOffsetAlignment, 1);
}

AccelerationStructures::Structure
AccelerationStructures::make_structure(VkAccelerationStructureTypeKHR type, uint64_t bytes,
                                       const char* name) const {
    Structure structure;
    structure.storage =
        gpu::Buffer(device_, align(bytes, structure_alignment), gpu::MemoryUse::Device, name,
                    VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_STORAGE_BIT_KHR |
                        VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT);
    auto info = gpu::structure<VkAccelerationStructureCreateInfoKHR>(
        VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_CREATE_INFO_KHR);
    info.buffer = structure.storage.handle();
    info.size = bytes;
    info.type = type;
    structure.handle =
        device_.make(vk_.create, vk_.destroy, info, "vkCreateAccelerationStructureKHR",
                     VK_OBJECT_TYPE_ACCELERATION_STRUCTURE_KHR, name);
    return structure;
}

VkDeviceAddress AccelerationStructures::scratch_address(const gpu::Buffer& scratch) const {
    return align(address_of(device_, scratch), scratch_alignment_);
}

AccelerationStructures::Build
AccelerationStructures::describe_build(size_t model_index, const QueryModel& model) const {
    Build build;
    build.model = model_index;
    build.revision = model.revision;
    build.triangle_count = static_cast<uint32_t>(std::max<size_t>(model.triangles.size(), 1));
    build.flags = model.deforms ? VK_BUILD_ACCELERATION_STRUCTURE_PREFER_FAST_BUILD_BIT_KHR
                                : VK_BUILD_ACCELERATION_STRUCTURE_PREFER_FAST_TRACE_BIT_KHR;
    const auto opaque = std::count_if(model.triangles.begin(), model.triangles.end(), is_opaque);
    if (opaque > 0 || model.triangles.empty())
        build.geometries.push_back(VK_GEOMETRY_OPAQUE_BIT_KHR);
    if (opaque < std::ssize(model.triangles)) build.geometries.push_back(0);

    std::vector<VkAccelerationStructureGeometryKHR> geometries;
    for (const VkGeometryFlagsKHR flags : build.geometries)
        geometries.push_back(triangle_geometry(0, build.triangle_count, flags));
    const std::vector<uint32_t> counts(geometries.size(), build.triangle_count);
    const VkAccelerationStructureBuildGeometryInfoKHR info =
        build_info(VK_ACCELERATION_STRUCTURE_TYPE_BOTTOM_LEVEL_KHR, build.flags, geometries);
    const VkAccelerationStructureBuildSizesInfoKHR sizes = build_sizes(info, counts);
    build.structure_bytes = align(sizes.accelerationStructureSize, structure_alignment);
    build.scratch_bytes = align(sizes.buildScratchSize, scratch_alignment_);
    return build;
}

VkAccelerationStructureBuildSizesInfoKHR
AccelerationStructures::build_sizes(const VkAccelerationStructureBuildGeometryInfoKHR& info,
                                    std::span<const uint32_t> counts) const {
    auto sizes = gpu::structure<VkAccelerationStructureBuildSizesInfoKHR>(
        VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_SIZES_INFO_KHR);
    vk_.sizes(device_.handle(), VK_ACCELERATION_STRUCTURE_BUILD_TYPE_DEVICE_KHR, &info,
              counts.data(), &sizes);
    return sizes;
}

void AccelerationStructures::add_build(Plan& plan, Build build, const QueryModel& model) {
    build.first_corner = plan.corners.size();
    build.scratch_offset = plan.scratch_bytes;
    plan.scratch_bytes += build.scratch_bytes;
    for (const VkGeometryFlagsKHR flags : build.geometries)
        append_corners(model, (flags & VK_GEOMETRY_OPAQUE_BIT_KHR) != 0, plan.corners);
    // A model of nothing is built as one point: drivers have had faults with empty structures.
    if (model.triangles.empty()) plan.corners.resize(plan.corners.size() + 3, glm::vec3(0.0f));
    plan.builds.push_back(std::move(build));
}

void AccelerationStructures::record_bottoms(VkCommandBuffer commands, const Plan& plan,
                                            const gpu::Buffer& corners,
                                            const gpu::Buffer& scratch) {
    const VkDeviceAddress corners_address = address_of(device_, corners);
    const VkDeviceAddress first_scratch = scratch_address(scratch);
    const size_t count = plan.builds.size();
    std::vector<std::vector<VkAccelerationStructureGeometryKHR>> geometries(count);
    std::vector<std::vector<VkAccelerationStructureBuildRangeInfoKHR>> ranges(count);
    std::vector<VkAccelerationStructureBuildGeometryInfoKHR> infos;
    std::vector<const VkAccelerationStructureBuildRangeInfoKHR*> range_pointers;
    for (size_t i = 0; i < count; ++i) {
        const Build& build = plan.builds[i];
        VkDeviceAddress address = corners_address + build.first_corner * sizeof(glm::vec3);
        for (const VkGeometryFlagsKHR flags : build.geometries) {
            geometries[i].push_back(triangle_geometry(address, build.triangle_count, flags));
            ranges[i].push_back({build.triangle_count, 0, 0, 0});
            address += uint64_t{3} * build.triangle_count * sizeof(glm::vec3);
        }
        VkAccelerationStructureBuildGeometryInfoKHR info =
            build_info(VK_ACCELERATION_STRUCTURE_TYPE_BOTTOM_LEVEL_KHR, build.flags, geometries[i]);
        info.dstAccelerationStructure = bottoms_[build.model].structure.handle.get();
        info.scratchData.deviceAddress = first_scratch + build.scratch_offset;
        infos.push_back(info);
        range_pointers.push_back(ranges[i].data());
        bottoms_[build.model].revision = build.revision;
    }
    vk_.build(commands, static_cast<uint32_t>(count), infos.data(), range_pointers.data());
}

void AccelerationStructures::build_now(const Plan& plan) {
    if (plan.builds.empty()) return;
    for (const Build& build : plan.builds) {
        Bottom& bottom = bottoms_[build.model];
        if (bottom.structure.handle) device_.wait_idle(); // too small for what it became
        bottom.structure.handle.reset();
        bottom.structure = make_structure(VK_ACCELERATION_STRUCTURE_TYPE_BOTTOM_LEVEL_KHR,
                                          build.structure_bytes, "bottom level");
        auto info = gpu::structure<VkAccelerationStructureDeviceAddressInfoKHR>(
            VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_DEVICE_ADDRESS_INFO_KHR);
        info.accelerationStructure = bottom.structure.handle.get();
        bottom.address = vk_.address(device_.handle(), &info);
    }
    const gpu::Buffer corners =
        gpu::make_buffer(device_, gpu::bytes_of(plan.corners), "corners", build_input_usage);
    const gpu::Buffer scratch(device_, plan.scratch_bytes + scratch_alignment_,
                              gpu::MemoryUse::Device, "build scratch",
                              VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT);
    gpu::run_now(device_, [&](VkCommandBuffer commands) {
        record_bottoms(commands, plan, corners, scratch);
    });
}

bool AccelerationStructures::prepare(std::span<const QueryModel> models,
                                     std::span<const size_t> instance_models,
                                     std::span<const shader::Instance> instances) {
    // Build what is new, and plan what has changed since it was built.
    bottoms_.resize(std::max(bottoms_.size(), models.size()));
    rebuilds_ = {};
    Plan fresh;
    std::vector<bool> seen(models.size());
    for (const size_t index : instance_models) {
        if (seen[index]) continue;
        seen[index] = true;
        const QueryModel& model = models[index];
        if (bottoms_[index].revision == model.revision) continue;
        Build build = describe_build(index, model);
        const Structure& known = bottoms_[index].structure;
        if (known.handle && known.storage.bytes() >= build.structure_bytes) {
            add_build(rebuilds_, std::move(build), model);
            continue;
        }
        add_build(fresh, std::move(build), model);
        if (fresh.corners.size() >= corners_per_submission) {
            build_now(fresh);
            fresh = {};
        }
    }
    build_now(fresh);
    top_dirty_ |= !rebuilds_.builds.empty();
    const bool renewed = prepare_top(models, instance_models, instances);
    gpu::grow(device_, corners_buffer_, gpu::bytes_of(rebuilds_.corners).size(), "corners",
              build_input_usage);
    gpu::grow(device_, scratch_buffer_,
              std::max(rebuilds_.scratch_bytes, top_scratch_bytes_) + scratch_alignment_,
              "build scratch", VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT);
    return renewed;
}

bool AccelerationStructures::prepare_top(std::span<const QueryModel> models,
                                         std::span<const size_t> instance_models,
                                         std::span<const shader::Instance> instances) {
    std::vector<VkAccelerationStructureInstanceKHR> placed;
    placed.reserve(instances.size());
    for (size_t i = 0; i < instances.size(); ++i) {
        const QueryModel& model = models[instance_models[i]];
        if (model.first_triangle > max_custom_index)
            fail("ray queries number {} triangles at most", max_custom_index + 1);
        VkAccelerationStructureInstanceKHR instance{};
        instance.transform = row_major(instances[i].world_from_object);
        instance.instanceCustomIndex = model.first_triangle & max_custom_index;
        instance.mask = instances[i].flags & 0xff;
        const uint32_t opacity = shader::bvh_opacity(instances[i].flags);
        instance.instanceShaderBindingTableRecordOffset = opacity & 0xff;
        if (opacity < 255) instance.flags = VK_GEOMETRY_INSTANCE_FORCE_NO_OPAQUE_BIT_KHR;
        instance.accelerationStructureReference = bottoms_[instance_models[i]].address;
        placed.push_back(instance);
    }
    const auto same = [](const VkAccelerationStructureInstanceKHR& a,
                         const VkAccelerationStructureInstanceKHR& b) {
        return std::memcmp(&a, &b, sizeof(a)) == 0;
    };
    top_dirty_ |= !std::equal(placed.begin(), placed.end(), top_instances_.begin(),
                              top_instances_.end(), same);
    top_instances_ = std::move(placed);
    if (top_.handle && top_instances_.size() <= top_capacity_) return false;

    // Make a structure with room for some more.
    const auto count = static_cast<uint32_t>(top_instances_.size());
    top_capacity_ = count == 1 ? 1 : std::max(count + count / 2, 16u);
    const VkAccelerationStructureGeometryKHR geometry = instance_geometry(0);
    const VkAccelerationStructureBuildGeometryInfoKHR info =
        build_info(VK_ACCELERATION_STRUCTURE_TYPE_TOP_LEVEL_KHR,
                   VK_BUILD_ACCELERATION_STRUCTURE_PREFER_FAST_TRACE_BIT_KHR, {&geometry, 1});
    const VkAccelerationStructureBuildSizesInfoKHR sizes = build_sizes(info, {&top_capacity_, 1});
    device_.wait_idle();
    top_.handle.reset();
    top_ = make_structure(VK_ACCELERATION_STRUCTURE_TYPE_TOP_LEVEL_KHR,
                          sizes.accelerationStructureSize, "top level");
    top_scratch_bytes_ = sizes.buildScratchSize;
    instances_buffer_ =
        gpu::Buffer(device_, top_capacity_ * sizeof(VkAccelerationStructureInstanceKHR),
                    gpu::MemoryUse::Device, "top-level instances", build_input_usage);
    top_dirty_ = true;
    return true;
}

void AccelerationStructures::record_top(VkCommandBuffer commands) const {
    const VkAccelerationStructureGeometryKHR geometry =
        instance_geometry(address_of(device_, instances_buffer_));
    VkAccelerationStructureBuildGeometryInfoKHR info =
        build_info(VK_ACCELERATION_STRUCTURE_TYPE_TOP_LEVEL_KHR,
                   VK_BUILD_ACCELERATION_STRUCTURE_PREFER_FAST_TRACE_BIT_KHR, {&geometry, 1});
    info.dstAccelerationStructure = top_.handle.get();
    info.scratchData.deviceAddress = scratch_address(scratch_buffer_);
    const VkAccelerationStructureBuildRangeInfoKHR range{
        static_cast<uint32_t>(top_instances_.size()), 0, 0, 0};
    const VkAccelerationStructureBuildRangeInfoKHR* const ranges = &range;
    vk_.build(commands, 1, &info, &ranges);
}

void AccelerationStructures::record(gpu::FrameCommands& commands) {
    if (!top_dirty_) return;
    const VkCommandBuffer buffer = commands.commands();
    commands.upload(instances_buffer_, 0, gpu::bytes_of(top_instances_));
    if (!rebuilds_.builds.empty()) {
        commands.upload(corners_buffer_, 0, gpu::bytes_of(rebuilds_.corners));
        gpu::full_barrier(buffer);
        record_bottoms(buffer, rebuilds_, corners_buffer_, scratch_buffer_);
        rebuilds_ = {};
    }
    gpu::full_barrier(buffer);
    record_top(buffer);
    gpu::full_barrier(buffer);
    top_dirty_ = false;
}

uint64_t AccelerationStructures::bytes() const {
    uint64_t sum = top_.storage.bytes() + instances_buffer_.bytes() + corners_buffer_.bytes() +
                   scratch_buffer_.bytes();
    for (const Bottom& bottom : bottoms_)
        sum += bottom.structure.storage.bytes();
    return sum;
}

} // namespace vigil::vkpt
