// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/gpu/pipeline.h"

#include "common/error.h"
#include "common/log.h"
#include "common/output.h"
#include "common/sealed.h"

#include <cstring>
#include <fstream>
#include <sstream>

namespace vigil::gpu {

namespace {

constexpr std::string_view cache_kind = "vigil pipelines 1";

/// What can be read of it; nothing, where there is no such file.
std::string read_file(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return std::move(text).str();
}

/// Drivers must reject foreign data themselves, but none finds a damaged byte in its own: the seal
/// and this header keep broken files away from them.
bool belongs_to(std::span<const std::byte> data, const VkPhysicalDeviceProperties& device) {
    VkPipelineCacheHeaderVersionOne header;
    if (data.size() < sizeof(header)) return false;
    std::memcpy(&header, data.data(), sizeof(header));
    return header.headerSize >= sizeof(header) &&
           header.headerVersion == VK_PIPELINE_CACHE_HEADER_VERSION_ONE &&
           header.vendorID == device.vendorID && header.deviceID == device.deviceID &&
           std::memcmp(header.pipelineCacheUUID, device.pipelineCacheUUID, VK_UUID_SIZE) == 0;
}

} // namespace

PipelineCache::PipelineCache(const Device& device, std::filesystem::path file)
    : device_(&device), file_(std::move(file)) {
    const std::string file_text = read_file(file_);
    std::span<const std::byte> data;
    if (const auto content = unseal(cache_kind, std::as_bytes(std::span(file_text))))
        data = *content;
    if (!file_text.empty() && !belongs_to(data, device.properties())) {
        log_info("pipeline cache {}: from another device or driver, or damaged. A new one begins.",
                 file_.string());
        data = {};
    }
    loaded_bytes_ = data.size();
    auto info = structure<VkPipelineCacheCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO);
    info.initialDataSize = data.size();
    info.pInitialData = data.data();
    cache_ =
        device.make(vkCreatePipelineCache, vkDestroyPipelineCache, info, "vkCreatePipelineCache");
}

PipelineCache::~PipelineCache() {
    size_t bytes = 0;
    if (vkGetPipelineCacheData(device_->handle(), cache_.get(), &bytes, nullptr) != VK_SUCCESS)
        return;
    if (bytes == loaded_bytes_ || file_.empty()) return;
    std::vector<char> data(bytes);
    if (vkGetPipelineCacheData(device_->handle(), cache_.get(), &bytes, data.data()) != VK_SUCCESS)
        return;
    try {
        write_file(file_, seal(cache_kind, std::as_bytes(std::span(data))));
    } catch (const std::exception& error) {
        log_warning("the pipeline cache is not saved: {}", error.what());
    }
}

namespace {

VkDescriptorType descriptor_type(BindingKind kind) {
    switch (kind) {
    case BindingKind::Storage:
        return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    case BindingKind::Uniform:
        return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    case BindingKind::Records:
    case BindingKind::Words:
        return VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
    case BindingKind::Traced:
        break;
    }
    return VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR;
}

} // namespace

DescriptorSet::DescriptorSet(const Device& device, std::span<const BindingKind> kinds,
                             const Buffer& unused, const char* name)
    : device_(&device), kinds_(kinds.begin(), kinds.end()) {
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    std::vector<VkDescriptorPoolSize> sizes;
    for (uint32_t i = 0; i < kinds_.size(); ++i) {
        VkDescriptorSetLayoutBinding binding{};
        binding.binding = i;
        binding.descriptorType = descriptor_type(kinds_[i]);
        binding.descriptorCount = 1;
        binding.stageFlags = VK_SHADER_STAGE_COMPUTE_BIT;
        bindings.push_back(binding);
        sizes.push_back({binding.descriptorType, 1});
    }
    auto layout_info = structure<VkDescriptorSetLayoutCreateInfo>(
        VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
    layout_info.bindingCount = static_cast<uint32_t>(bindings.size());
    layout_info.pBindings = bindings.data();
    layout_ = device.make(vkCreateDescriptorSetLayout, vkDestroyDescriptorSetLayout, layout_info,
                          "vkCreateDescriptorSetLayout");

    auto pool_info =
        structure<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
    pool_info.maxSets = 1;
    pool_info.poolSizeCount = static_cast<uint32_t>(sizes.size());
    pool_info.pPoolSizes = sizes.data();
    pool_ = device.make(vkCreateDescriptorPool, vkDestroyDescriptorPool, pool_info,
                        "vkCreateDescriptorPool");

    const VkDescriptorSetLayout layout = layout_.get();
    auto allocate =
        structure<VkDescriptorSetAllocateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO);
    allocate.descriptorPool = pool_.get();
    allocate.descriptorSetCount = 1;
    allocate.pSetLayouts = &layout;
    check(vkAllocateDescriptorSets(device.handle(), &allocate, &set_), "vkAllocateDescriptorSets");
    device.set_name(VK_OBJECT_TYPE_DESCRIPTOR_SET, set_, name);
    for (uint32_t i = 0; i < kinds_.size(); ++i) {
        if (kinds_[i] != BindingKind::Uniform && kinds_[i] != BindingKind::Traced) bind(i, unused);
    }
}

void DescriptorSet::bind(uint32_t binding, const Buffer& buffer) {
    const VkDescriptorBufferInfo info{buffer.handle(), 0, VK_WHOLE_SIZE};
    VkBufferView view = VK_NULL_HANDLE;
    auto write = structure<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET);
    write.pBufferInfo = &info;
    write.pTexelBufferView = &view;
    if (kinds_[binding] == BindingKind::Records) view = buffer.texels(VK_FORMAT_R32G32B32A32_UINT);
    if (kinds_[binding] == BindingKind::Words) view = buffer.texels(VK_FORMAT_R32_UINT);
    bind(binding, write);
}

void DescriptorSet::bind(uint32_t binding, VkAccelerationStructureKHR traced) {
    auto info = structure<VkWriteDescriptorSetAccelerationStructureKHR>(
        VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET_ACCELERATION_STRUCTURE_KHR);
    info.accelerationStructureCount = 1;
    info.pAccelerationStructures = &traced;
    bind(binding, structure<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET, &info));
}

void DescriptorSet::bind(uint32_t binding, VkWriteDescriptorSet write) {
    write.dstSet = set_;
    write.dstBinding = binding;
    write.descriptorCount = 1;
    write.descriptorType = descriptor_type(kinds_[binding]);
    vkUpdateDescriptorSets(device_->handle(), 1, &write, 0, nullptr);
}

PipelineLayout::PipelineLayout(const Device& device,
                               std::initializer_list<const DescriptorSet*> sets) {
    std::vector<VkDescriptorSetLayout> layouts;
    for (const DescriptorSet* set : sets) {
        sets_.push_back(set->kinds());
        layouts.push_back(set->layout());
    }
    const VkPushConstantRange push{VK_SHADER_STAGE_COMPUTE_BIT, 0, 128};
    auto info =
        structure<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
    info.setLayoutCount = static_cast<uint32_t>(layouts.size());
    info.pSetLayouts = layouts.data();
    info.pushConstantRangeCount = 1;
    info.pPushConstantRanges = &push;
    layout_ = device.make(vkCreatePipelineLayout, vkDestroyPipelineLayout, info,
                          "vkCreatePipelineLayout");
}

Handle<VkPipeline> make_compute_pipeline(const Device& device, VkPipelineLayout layout,
                                         const PipelineCache* cache,
                                         std::span<const uint32_t> spirv,
                                         std::span<const Specialization> constants,
                                         const char* name) {
    auto module_info =
        structure<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
    module_info.codeSize = spirv.size_bytes();
    module_info.pCode = spirv.data();
    const Handle<VkShaderModule> shader = device.make(vkCreateShaderModule, vkDestroyShaderModule,
                                                      module_info, "vkCreateShaderModule");

    std::vector<VkSpecializationMapEntry> entries;
    std::vector<uint32_t> values;
    for (const Specialization& constant : constants) {
        entries.push_back({constant.id, static_cast<uint32_t>(values.size() * sizeof(uint32_t)),
                           sizeof(uint32_t)});
        values.push_back(constant.value);
    }
    VkSpecializationInfo specialization{};
    specialization.mapEntryCount = static_cast<uint32_t>(entries.size());
    specialization.pMapEntries = entries.data();
    specialization.dataSize = values.size() * sizeof(uint32_t);
    specialization.pData = values.data();

    auto info =
        structure<VkComputePipelineCreateInfo>(VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO);
    info.stage = structure<VkPipelineShaderStageCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO);
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = shader.get();
    info.stage.pName = "main";
    info.stage.pSpecializationInfo = &specialization;
    info.layout = layout;
    VkPipeline pipeline = VK_NULL_HANDLE;
    check(vkCreateComputePipelines(device.handle(), cache ? cache->handle() : VK_NULL_HANDLE, 1,
                                   &info, nullptr, &pipeline),
          fmt::format("pass {}: vkCreateComputePipelines", name));
    device.set_name(VK_OBJECT_TYPE_PIPELINE, pipeline, name);
    return {device.handle(), pipeline, vkDestroyPipeline};
}

ComputePipeline::ComputePipeline(const Device& device, const PipelineLayout& layout,
                                 const PipelineCache* cache, std::span<const uint32_t> spirv,
                                 std::span<const Specialization> constants, const char* name)
    : layout_(&layout),
      pipeline_(make_compute_pipeline(device, layout.handle(), cache, spirv, constants, name)) {}

} // namespace vigil::gpu
