// SPDX-License-Identifier: GPL-2.0-or-later
// A Vulkan layer that makes one call fail, for tests of what the programs do then: lost devices,
// exhausted memory, windows without a surface. VIGIL_FAULT is "CALL RESULT FIRST", for example
// "vkQueueSubmit -4 20": from its twentieth call on, vkQueueSubmit does nothing and returns -4
// (VK_ERROR_DEVICE_LOST). FIRST may also be "@FILE": calls fail as soon as that file exists. One
// instance and one device at a time are supported.
#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <map>
#include <sstream>
#include <string>
#include <unistd.h>

namespace {

class Fault {
public:
    Fault() {
        const char* const text = std::getenv("VIGIL_FAULT");
        std::istringstream words(text != nullptr ? text : "");
        int result = 0;
        std::string first;
        words >> call_ >> result >> first;
        result_ = static_cast<VkResult>(result);
        if (first.starts_with('@'))
            file_ = first.substr(1);
        else
            first_ = std::atol(first.c_str());
    }
    /// Whether this call of `name` is to fail.
    bool due(const char* name) {
        if (call_ != name) return false;
        if (!file_.empty()) return access(file_.c_str(), F_OK) == 0;
        return ++calls_ >= first_;
    }
    VkResult result() const { return result_; }

private:
    std::string call_, file_;
    VkResult result_ = VK_SUCCESS;
    long first_ = 1;
    std::atomic<long> calls_ = 0;
};

Fault fault;
PFN_vkGetInstanceProcAddr next_instance_proc = nullptr;
PFN_vkGetDeviceProcAddr next_device_proc = nullptr;
VkInstance the_instance = VK_NULL_HANDLE;
VkDevice the_device = VK_NULL_HANDLE;
/// Asked for while the instance is made: later the loader would answer with this layer's own.
std::map<std::string, PFN_vkVoidFunction> next_of_instance;

/// Stands in front of a call that returns a VkResult: one per name, made by the macros below.
template <const char* const& Name, typename Function> struct Gate;
template <const char* const& Name, typename... Arguments>
struct Gate<Name, VkResult(VKAPI_PTR*)(Arguments...)> {
    static VKAPI_ATTR VkResult VKAPI_CALL pass(Arguments... arguments) {
        if (fault.due(Name)) return fault.result();
        using Next = VkResult(VKAPI_PTR*)(Arguments...);
        PFN_vkVoidFunction next =
            the_device != VK_NULL_HANDLE ? next_device_proc(the_device, Name) : nullptr;
        if (next == nullptr) next = next_of_instance[Name];
        return reinterpret_cast<Next>(next)(arguments...);
    }
};

// Whatever the window system: what describes its window is a pointer here.
using CreateSurface = VkResult(VKAPI_PTR*)(VkInstance, const void*, const VkAllocationCallbacks*,
                                           VkSurfaceKHR*);
using PFN_vkCreateXlibSurfaceKHR = CreateSurface;
using PFN_vkCreateXcbSurfaceKHR = CreateSurface;
using PFN_vkCreateWaylandSurfaceKHR = CreateSurface;

#define CALLS(ROW)                                                                                 \
    ROW(vkAllocateMemory)                                                                          \
    ROW(vkBindBufferMemory)                                                                        \
    ROW(vkCreateBuffer)                                                                            \
    ROW(vkCreateImage)                                                                             \
    ROW(vkCreateComputePipelines)                                                                  \
    ROW(vkMapMemory)                                                                               \
    ROW(vkQueueSubmit)                                                                             \
    ROW(vkWaitForFences)                                                                           \
    ROW(vkAcquireNextImageKHR)                                                                     \
    ROW(vkQueuePresentKHR)                                                                         \
    ROW(vkCreateSwapchainKHR)                                                                      \
    ROW(vkCreateXlibSurfaceKHR)                                                                    \
    ROW(vkCreateXcbSurfaceKHR)                                                                     \
    ROW(vkCreateWaylandSurfaceKHR)

#define NAME(call) constexpr const char* name_##call = #call;
CALLS(NAME)
#undef NAME

struct Entry {
    const char* name;
    PFN_vkVoidFunction function;
};

#define ENTRY(call)                                                                                \
    {#call, reinterpret_cast<PFN_vkVoidFunction>(Gate<name_##call, PFN_##call>::pass)},
const Entry gates[] = {CALLS(ENTRY)};
#undef ENTRY

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
