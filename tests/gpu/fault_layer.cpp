// SPDX-License-Identifier: GPL-2.0-or-later
// A Vulkan layer that makes one call fail, for tests of what the programs do then: lost devices,
// exhausted memory, windows without a surface. VIGIL_FAULT is "CALL RESULT FIRST [TIMES]", for
// example "vkQueueSubmit -4 20": from its twentieth call on, vkQueueSubmit does nothing and returns
// -4 (VK_ERROR_DEVICE_LOST); TIMES ends that after so many calls. FIRST may also be "@FILE": calls
// fail as soon as that file exists. VIGIL_FAULT_COUNTS names a file for "CALL NUMBER" lines: how
// often each was called. Lines on stderr that begin with "fault layer:" tell what the program left
// undone: objects that were not destroyed, and copies to the host without a barrier. One instance
// and one device at a time are supported.
#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <set>
#include <sstream>
#include <string>
#include <type_traits>
#include <unistd.h>

namespace {

std::mutex guard; // of what follows, but for the pointers that are set once

class Fault {
public:
    Fault() {
        const char* const text = std::getenv("VIGIL_FAULT");
        std::istringstream words(text != nullptr ? text : "");
        int result = 0;
        std::string first;
        words >> call_ >> result >> first;
        if (!(words >> times_)) times_ = -1;
        result_ = static_cast<VkResult>(result);
        if (first.starts_with('@'))
            file_ = first.substr(1);
        else
            first_ = std::atol(first.c_str());
    }
    /// Counts a call of `name`; whether it is to fail.
    bool due(const char* name) {
        const std::lock_guard lock(guard);
        const long number = ++calls_[name];
        if (call_ != name) return false;
        if (!file_.empty()) return access(file_.c_str(), F_OK) == 0;
        return number >= first_ && (times_ < 0 || number < first_ + times_);
    }
    VkResult result() const { return result_; }

    void write_counts() const {
        const char* const path = std::getenv("VIGIL_FAULT_COUNTS");
        std::FILE* const file = path != nullptr ? std::fopen(path, "w") : nullptr;
        if (file == nullptr) return;
        for (const auto& [name, number] : calls_)
            std::fprintf(file, "%s %ld\n", name.c_str(), number);
        std::fclose(file);
    }

private:
    std::string call_, file_;
    VkResult result_ = VK_SUCCESS;
    long first_ = 1, times_ = -1;
    std::map<std::string, long> calls_;
};

Fault fault;
std::map<std::string, long> alive; // objects by their kind
PFN_vkGetInstanceProcAddr next_instance_proc = nullptr;
PFN_vkGetDeviceProcAddr next_device_proc = nullptr;
VkInstance the_instance = VK_NULL_HANDLE;
VkDevice the_device = VK_NULL_HANDLE;
/// Asked for while the instance is made: later the loader would answer with this layer's own.
std::map<std::string, PFN_vkVoidFunction> next_of_instance;

void complain(const std::string& what) {
    std::fprintf(stderr, "fault layer: %s\n", what.c_str());
}

/// What the next layer or the driver has under this name.
template <typename Function> Function next_of(const char* name) {
    PFN_vkVoidFunction next =
        the_device != VK_NULL_HANDLE ? next_device_proc(the_device, name) : nullptr;
    if (next == nullptr) next = next_of_instance[name];
    return reinterpret_cast<Function>(next);
}

/// Copies to memory that the host sees, until the barrier behind which it may read them.
class HostCopies {
public:
    void bound(VkBuffer buffer, VkDeviceMemory memory) { memory_of_[buffer] = memory; }
    void mapped(VkDeviceMemory memory) { mapped_.insert(memory); }
    void freed(VkDeviceMemory memory) { mapped_.erase(memory); }
    void began(VkCommandBuffer commands) { open_.erase(commands); }
    void copied(VkCommandBuffer commands, VkBuffer target) {
        const auto memory = memory_of_.find(target);
        if (memory != memory_of_.end() && mapped_.contains(memory->second)) open_.insert(commands);
    }
    void barrier(VkCommandBuffer commands, VkPipelineStageFlags from, VkPipelineStageFlags to,
                 const VkMemoryBarrier& barrier) {
        constexpr VkPipelineStageFlags copies =
            VK_PIPELINE_STAGE_TRANSFER_BIT | VK_PIPELINE_STAGE_ALL_COMMANDS_BIT;
        constexpr VkAccessFlags writes = VK_ACCESS_TRANSFER_WRITE_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
        if ((from & copies) != 0 && (barrier.srcAccessMask & writes) != 0 &&
            (to & VK_PIPELINE_STAGE_HOST_BIT) != 0 &&
            (barrier.dstAccessMask & VK_ACCESS_HOST_READ_BIT) != 0)
            open_.erase(commands);
    }
    void ended(VkCommandBuffer commands) {
        if (open_.contains(commands)) complain("a copy to the host without a barrier");
    }

private:
    std::map<VkBuffer, VkDeviceMemory> memory_of_;
    std::set<VkDeviceMemory> mapped_;
    std::set<VkCommandBuffer> open_;
};
HostCopies host_copies;

// What the layer notes of calls that worked.
template <typename... Arguments> void note(const char* /*name*/, Arguments... /*arguments*/) {}
void note(const char*, VkDevice, VkBuffer buffer, VkDeviceMemory memory, VkDeviceSize) {
    host_copies.bound(buffer, memory);
}
void note(const char*, VkDevice, VkDeviceMemory memory, VkDeviceSize, VkDeviceSize,
          VkMemoryMapFlags, void**) {
    host_copies.mapped(memory);
}
void note(const char*, VkCommandBuffer commands, const VkCommandBufferBeginInfo*) {
    host_copies.began(commands);
}
void note(const char*, VkCommandBuffer commands) {
    host_copies.ended(commands);
}

/// Whether a call that fails is made all the same: what follows may count on the device's rest.
bool waits(const char* name) {
    return std::strcmp(name, "vkDeviceWaitIdle") == 0;
}

/// Stands in front of a call that returns a VkResult: one per name, made by the macros below.
/// `Kind`: of the objects that it makes, or none.
template <const char* const& Name, const char* const& Kind, typename Function> struct Gate;
template <const char* const& Name, const char* const& Kind, typename... Arguments>
struct Gate<Name, Kind, VkResult(VKAPI_PTR*)(Arguments...)> {
    static VKAPI_ATTR VkResult VKAPI_CALL pass(Arguments... arguments) {
        const bool fails = fault.due(Name);
        if (fails && !waits(Name)) return fault.result();
        const auto next = next_of<VkResult(VKAPI_PTR*)(Arguments...)>(Name);
        const VkResult result = next(arguments...);
        if (fails) return fault.result();
        const std::lock_guard lock(guard);
        if (result == VK_SUCCESS) note(Name, arguments...);
        if (result == VK_SUCCESS && *Kind != '\0') ++alive[Kind];
        return result;
    }
};

/// Stands in front of a call that destroys an object.
template <const char* const& Name, const char* const& Kind, typename Function> struct DestroyGate;
template <const char* const& Name, const char* const& Kind, typename Handle>
struct DestroyGate<Name, Kind, void(VKAPI_PTR*)(VkDevice, Handle, const VkAllocationCallbacks*)> {
    static VKAPI_ATTR void VKAPI_CALL pass(VkDevice device, Handle handle,
                                           const VkAllocationCallbacks* allocator) {
        if (handle != VK_NULL_HANDLE) {
            const std::lock_guard lock(guard);
            --alive[Kind];
            if constexpr (std::is_same_v<Handle, VkDeviceMemory>) host_copies.freed(handle);
        }
        next_of<void(VKAPI_PTR*)(VkDevice, Handle, const VkAllocationCallbacks*)>(Name)(
            device, handle, allocator);
    }
};

// Whatever the window system: what describes its window is a pointer here.
using CreateSurface = VkResult(VKAPI_PTR*)(VkInstance, const void*, const VkAllocationCallbacks*,
                                           VkSurfaceKHR*);
using PFN_vkCreateXlibSurfaceKHR = CreateSurface;
using PFN_vkCreateXcbSurfaceKHR = CreateSurface;
using PFN_vkCreateWaylandSurfaceKHR = CreateSurface;

// Every call of the programs that can fail, and the kind of object that it makes.
#define CALLS(ROW)                                                                                 \
    ROW(vkAcquireNextImageKHR, "")                                                                 \
    ROW(vkAllocateCommandBuffers, "")                                                              \
    ROW(vkAllocateDescriptorSets, "")                                                              \
    ROW(vkAllocateMemory, "memory")                                                                \
    ROW(vkBeginCommandBuffer, "")                                                                  \
    ROW(vkBindBufferMemory, "")                                                                    \
    ROW(vkBindImageMemory, "")                                                                     \
    ROW(vkCreateAccelerationStructureKHR, "acceleration structure")                                \
    ROW(vkCreateBuffer, "buffer")                                                                  \
    ROW(vkCreateBufferView, "buffer view")                                                         \
    ROW(vkCreateCommandPool, "command pool")                                                       \
    ROW(vkCreateComputePipelines, "pipeline")                                                      \
    ROW(vkCreateDescriptorPool, "descriptor pool")                                                 \
    ROW(vkCreateDescriptorSetLayout, "descriptor set layout")                                      \
    ROW(vkCreateFence, "fence")                                                                    \
    ROW(vkCreateFramebuffer, "framebuffer")                                                        \
    ROW(vkCreateGraphicsPipelines, "pipeline")                                                     \
    ROW(vkCreateImage, "image")                                                                    \
    ROW(vkCreateImageView, "image view")                                                           \
    ROW(vkCreatePipelineCache, "pipeline cache")                                                   \
    ROW(vkCreatePipelineLayout, "pipeline layout")                                                 \
    ROW(vkCreateQueryPool, "query pool")                                                           \
    ROW(vkCreateRenderPass, "render pass")                                                         \
    ROW(vkCreateSampler, "sampler")                                                                \
    ROW(vkCreateSemaphore, "semaphore")                                                            \
    ROW(vkCreateShaderModule, "shader module")                                                     \
    ROW(vkCreateSwapchainKHR, "swapchain")                                                         \
    ROW(vkCreateWaylandSurfaceKHR, "")                                                             \
    ROW(vkCreateXcbSurfaceKHR, "")                                                                 \
    ROW(vkCreateXlibSurfaceKHR, "")                                                                \
    ROW(vkDeviceWaitIdle, "")                                                                      \
    ROW(vkEndCommandBuffer, "")                                                                    \
    ROW(vkEnumeratePhysicalDevices, "")                                                            \
    ROW(vkGetPhysicalDeviceSurfaceCapabilitiesKHR, "")                                             \
    ROW(vkGetPhysicalDeviceSurfaceFormatsKHR, "")                                                  \
    ROW(vkGetPhysicalDeviceSurfacePresentModesKHR, "")                                             \
    ROW(vkGetPhysicalDeviceSurfaceSupportKHR, "")                                                  \
    ROW(vkGetPipelineCacheData, "")                                                                \
    ROW(vkGetQueryPoolResults, "")                                                                 \
    ROW(vkGetSwapchainImagesKHR, "")                                                               \
    ROW(vkMapMemory, "")                                                                           \
    ROW(vkQueuePresentKHR, "")                                                                     \
    ROW(vkQueueSubmit, "")                                                                         \
    ROW(vkResetCommandPool, "")                                                                    \
    ROW(vkResetFences, "")                                                                         \
    ROW(vkWaitForFences, "")

#define DESTROYS(ROW)                                                                              \
    ROW(vkDestroyAccelerationStructureKHR, "acceleration structure")                               \
    ROW(vkDestroyBuffer, "buffer")                                                                 \
    ROW(vkDestroyBufferView, "buffer view")                                                        \
    ROW(vkDestroyCommandPool, "command pool")                                                      \
    ROW(vkDestroyDescriptorPool, "descriptor pool")                                                \
    ROW(vkDestroyDescriptorSetLayout, "descriptor set layout")                                     \
    ROW(vkDestroyFence, "fence")                                                                   \
    ROW(vkDestroyFramebuffer, "framebuffer")                                                       \
    ROW(vkDestroyImage, "image")                                                                   \
    ROW(vkDestroyImageView, "image view")                                                          \
    ROW(vkDestroyPipeline, "pipeline")                                                             \
    ROW(vkDestroyPipelineCache, "pipeline cache")                                                  \
    ROW(vkDestroyPipelineLayout, "pipeline layout")                                                \
    ROW(vkDestroyQueryPool, "query pool")                                                          \
    ROW(vkDestroyRenderPass, "render pass")                                                        \
    ROW(vkDestroySampler, "sampler")                                                               \
    ROW(vkDestroySemaphore, "semaphore")                                                           \
    ROW(vkDestroyShaderModule, "shader module")                                                    \
    ROW(vkDestroySwapchainKHR, "swapchain")                                                        \
    ROW(vkFreeMemory, "memory")

#define NAME(call, kind)                                                                           \
    constexpr const char* name_##call = #call;                                                     \
    constexpr const char* kind_##call = kind;
CALLS(NAME)
DESTROYS(NAME)
#undef NAME

VKAPI_ATTR void VKAPI_CALL copy_buffer(VkCommandBuffer commands, VkBuffer source, VkBuffer target,
                                       uint32_t count, const VkBufferCopy* regions) {
    {
        const std::lock_guard lock(guard);
        host_copies.copied(commands, target);
    }
    next_of<PFN_vkCmdCopyBuffer>("vkCmdCopyBuffer")(commands, source, target, count, regions);
}

VKAPI_ATTR void VKAPI_CALL copy_image_to_buffer(VkCommandBuffer commands, VkImage image,
                                                VkImageLayout layout, VkBuffer target,
                                                uint32_t count, const VkBufferImageCopy* regions) {
    {
        const std::lock_guard lock(guard);
        host_copies.copied(commands, target);
    }
    next_of<PFN_vkCmdCopyImageToBuffer>("vkCmdCopyImageToBuffer")(commands, image, layout, target,
                                                                  count, regions);
}

VKAPI_ATTR void VKAPI_CALL pipeline_barrier(VkCommandBuffer commands, VkPipelineStageFlags from,
                                            VkPipelineStageFlags to, VkDependencyFlags flags,
                                            uint32_t memory_count, const VkMemoryBarrier* memory,
                                            uint32_t buffer_count,
                                            const VkBufferMemoryBarrier* buffers,
                                            uint32_t image_count,
                                            const VkImageMemoryBarrier* images) {
    {
        const std::lock_guard lock(guard);
        for (uint32_t i = 0; i < memory_count; ++i)
            host_copies.barrier(commands, from, to, memory[i]);
    }
    next_of<PFN_vkCmdPipelineBarrier>("vkCmdPipelineBarrier")(commands, from, to, flags,
                                                              memory_count, memory, buffer_count,
                                                              buffers, image_count, images);
}

VKAPI_ATTR void VKAPI_CALL destroy_device(VkDevice device, const VkAllocationCallbacks* allocator) {
    for (const auto& [kind, count] : alive)
        if (count != 0) complain(kind + ": " + std::to_string(count) + " not destroyed");
    alive.clear();
    next_of<PFN_vkDestroyDevice>("vkDestroyDevice")(device, allocator);
    the_device = VK_NULL_HANDLE;
}

VKAPI_ATTR void VKAPI_CALL destroy_instance(VkInstance instance,
                                            const VkAllocationCallbacks* allocator) {
    if (the_device != VK_NULL_HANDLE) complain("the device was not destroyed");
    fault.write_counts();
    next_of<PFN_vkDestroyInstance>("vkDestroyInstance")(instance, allocator);
    the_instance = VK_NULL_HANDLE;
}

/// At the end of the program.
struct LastWord {
    ~LastWord() {
        if (the_instance != VK_NULL_HANDLE) complain("the instance was not destroyed");
    }
} last_word;

struct Entry {
    const char* name;
    PFN_vkVoidFunction function;
};

#define ENTRY(call, kind)                                                                          \
    {#call, reinterpret_cast<PFN_vkVoidFunction>(Gate<name_##call, kind_##call, PFN_##call>::pass)},
#define DESTROY_ENTRY(call, kind)                                                                  \
    {#call, reinterpret_cast<PFN_vkVoidFunction>(                                                  \
                DestroyGate<name_##call, kind_##call, PFN_##call>::pass)},
const Entry gates[] = {
    CALLS(ENTRY) DESTROYS(DESTROY_ENTRY){"vkCmdCopyBuffer",
                                         reinterpret_cast<PFN_vkVoidFunction>(copy_buffer)},
    {"vkCmdCopyImageToBuffer", reinterpret_cast<PFN_vkVoidFunction>(copy_image_to_buffer)},
    {"vkCmdPipelineBarrier", reinterpret_cast<PFN_vkVoidFunction>(pipeline_barrier)},
    {"vkDestroyDevice", reinterpret_cast<PFN_vkVoidFunction>(destroy_device)},
    {"vkDestroyInstance", reinterpret_cast<PFN_vkVoidFunction>(destroy_instance)},
};
#undef ENTRY
#undef DESTROY_ENTRY

PFN_vkVoidFunction gate(const char* name) {
    for (const Entry& entry : gates)
        if (std::strcmp(entry.name, name) == 0) return entry.function;
    return nullptr;
}

/// The link of the chain of layers that `info` brings, moved on for the next layer.
template <typename LinkInfo> auto take_link(const void* chain, VkStructureType type) {
    auto* info = static_cast<LinkInfo*>(const_cast<void*>(chain));
    while (info->sType != type || info->function != VK_LAYER_LINK_INFO)
        info = static_cast<LinkInfo*>(const_cast<void*>(info->pNext));
    const auto* const link = info->u.pLayerInfo;
    info->u.pLayerInfo = link->pNext;
    return link;
}

VKAPI_ATTR VkResult VKAPI_CALL create_instance(const VkInstanceCreateInfo* info,
                                               const VkAllocationCallbacks* allocator,
                                               VkInstance* instance) {
    if (fault.due("vkCreateInstance")) return fault.result();
    const auto* link = take_link<VkLayerInstanceCreateInfo>(
        info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    next_instance_proc = link->pfnNextGetInstanceProcAddr;
    const auto create = reinterpret_cast<PFN_vkCreateInstance>(
        next_instance_proc(VK_NULL_HANDLE, "vkCreateInstance"));
    const VkResult result = create(info, allocator, instance);
    if (result != VK_SUCCESS) return result;
    the_instance = *instance;
    for (const Entry& entry : gates)
        next_of_instance[entry.name] = next_instance_proc(*instance, entry.name);
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL create_device(VkPhysicalDevice physical,
                                             const VkDeviceCreateInfo* info,
                                             const VkAllocationCallbacks* allocator,
                                             VkDevice* device) {
    if (fault.due("vkCreateDevice")) return fault.result();
    const auto* link = take_link<VkLayerDeviceCreateInfo>(
        info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    next_device_proc = link->pfnNextGetDeviceProcAddr;
    const auto create = reinterpret_cast<PFN_vkCreateDevice>(
        link->pfnNextGetInstanceProcAddr(the_instance, "vkCreateDevice"));
    const VkResult result = create(physical, info, allocator, device);
    if (result == VK_SUCCESS) the_device = *device;
    return result;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL device_proc(VkDevice device, const char* name) {
    if (std::strcmp(name, "vkGetDeviceProcAddr") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(device_proc);
    if (const PFN_vkVoidFunction function = gate(name)) {
        // What the driver does not have, the layer does not have either.
        return next_device_proc(device, name) != nullptr ? function : nullptr;
    }
    return next_device_proc(device, name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL instance_proc(VkInstance instance, const char* name) {
    if (std::strcmp(name, "vkGetInstanceProcAddr") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(instance_proc);
    if (std::strcmp(name, "vkGetDeviceProcAddr") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(device_proc);
    if (std::strcmp(name, "vkCreateInstance") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(create_instance);
    if (std::strcmp(name, "vkCreateDevice") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(create_device);
    if (next_instance_proc == nullptr) return nullptr;
    const PFN_vkVoidFunction next = next_instance_proc(instance, name);
    const PFN_vkVoidFunction function = gate(name);
    return next != nullptr && function != nullptr ? function : next;
}

} // namespace

extern "C" __attribute__((visibility("default"))) VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* versions) {
    if (versions->sType != LAYER_NEGOTIATE_INTERFACE_STRUCT) return VK_ERROR_INITIALIZATION_FAILED;
    versions->loaderLayerInterfaceVersion = 2;
    versions->pfnGetInstanceProcAddr = instance_proc;
    versions->pfnGetDeviceProcAddr = device_proc;
    versions->pfnGetPhysicalDeviceProcAddr = nullptr;
    return VK_SUCCESS;
}
