// SPDX-License-Identifier: GPL-2.0-or-later
// Instance and logical device: picks a physical device (discrete, integrated, virtual, CPU; or by
// name), checks the features Vigil needs, counts validation messages and names objects for
// debuggers. One queue does everything: graphics, compute, transfer and presentation.
#pragma once

#include "refresh/vkpt/gpu/handle.h"
#include "refresh/vkpt/gpu/usage.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace vigil::refresh {
class SurfaceProvider;
}

namespace vigil::gpu {

/// Throws Error naming the call and the result unless `result` is VK_SUCCESS. A lost device and
/// exhausted memory say what a person can do.
void check(VkResult result, std::string_view call);

/// All that one of Vulkan's enumerations (`call`) lists for these arguments. Throws Error.
template <typename T, typename Function, typename... Arguments>
std::vector<T> enumerate(std::string_view call, Function function, Arguments... arguments) {
    uint32_t count = 0;
    check(function(arguments..., &count, nullptr), call);
    std::vector<T> list(count);
    check(function(arguments..., &count, list.data()), call);
    return list;
}

struct DeviceOptions {
    std::string name;         // part of the device's name, or its index; empty: the best one
    int validation = 0;       // 0 off, 1 core, 2 core and synchronisation, 3 core and GPU-assisted
    bool debug_names = false; // object names and labels for debuggers (always on with validation)
    bool cache = true;        // false: the driver compiles all shaders anew in this process
    bool allow_ray_query = true;
};

/// What the device offers beyond the required minimum.
struct DeviceFeatures {
    bool ray_query = false;
    bool is_cpu = false;
    int llvmpipe_mesa = 0; // Mesa's version where this is its software driver, else 0
    uint32_t subgroup_size = 0;
    uint64_t max_storage_buffer_bytes = 0;
    float timestamp_period_ns = 0.0f; // 0: no timestamps on this queue
    uint32_t timestamp_bits = 0;
};

class Device {
public:
    /// Creates instance, surface (if a provider is given) and device. Throws Error; a missing
    /// driver names the package.
    Device(const DeviceOptions& options, refresh::SurfaceProvider* surface);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    VkInstance instance() const { return instance_; }
    VkPhysicalDevice physical() const { return physical_; }
    VkDevice handle() const { return device_; }
    VkQueue queue() const { return queue_; }
    uint32_t queue_family() const { return queue_family_; }
    VkSurfaceKHR surface() const { return surface_.get(); }
    const DeviceFeatures& features() const { return features_; }
    const VkPhysicalDeviceProperties& properties() const { return properties_; }

    /// "llvmpipe (LLVM 15.0.6, 256 bits), Mesa 22.3.6, Vulkan 1.3.230".
    std::string description() const;

    /// Validation messages (warnings and errors) so far; 0 when validation is off.
    int validation_messages() const { return validation_messages_.load(); }

    /// Counted by the device's buffers and images.
    Usage& usage() const { return usage_; }

    /// Memory type index for `type_bits` with all of `wanted` and, if possible, `preferred`. Throws
    /// Error.
    uint32_t memory_type(uint32_t type_bits, VkMemoryPropertyFlags wanted,
                         VkMemoryPropertyFlags preferred = 0) const;

    void wait_idle() const;

    /// An object of the device as `create` (`call`, vkCreateX or the like) makes it from `info`;
    /// `destroy` is what ends it; `type` and `name` are for debuggers. Throws Error.
    template <typename T, typename Info>
    Handle<T> make(VkResult(VKAPI_PTR* create)(VkDevice, const Info*, const VkAllocationCallbacks*,
                                               T*),
                   typename Handle<T>::Destroy destroy, const Info& info, std::string_view call,
                   VkObjectType type = VK_OBJECT_TYPE_UNKNOWN, std::string_view name = {}) const {
        T handle = VK_NULL_HANDLE;
        check(create(device_, &info, nullptr, &handle), call);
        if (!name.empty()) set_name(type, handle, name);
        return {device_, handle, destroy};
    }

    template <typename T> void set_name(VkObjectType type, T handle, std::string_view name) const {
        set_name_raw(type, reinterpret_cast<uint64_t>(handle), name);
    }
    void begin_label(VkCommandBuffer commands, const char* name) const;
    void end_label(VkCommandBuffer commands) const;

private:
    Device() = default;
    void create_instance(const DeviceOptions& options, refresh::SurfaceProvider* surface);
    void pick_physical_device(const DeviceOptions& options);
    void create_device(const DeviceOptions& options);
    void set_name_raw(VkObjectType type, uint64_t handle, std::string_view name) const;
    static VKAPI_ATTR VkBool32 VKAPI_CALL on_message(
        VkDebugUtilsMessageSeverityFlagBitsEXT severity, VkDebugUtilsMessageTypeFlagsEXT type,
        const VkDebugUtilsMessengerCallbackDataEXT* data, void* user);

    VkInstance instance_ = VK_NULL_HANDLE;
    InstanceHandle<VkDebugUtilsMessengerEXT> messenger_;
    InstanceHandle<VkSurfaceKHR> surface_;
    VkPhysicalDevice physical_ = VK_NULL_HANDLE;
    VkDevice device_ = VK_NULL_HANDLE;
    VkQueue queue_ = VK_NULL_HANDLE;
    uint32_t queue_family_ = 0;
    VkPhysicalDeviceProperties properties_{};
    VkPhysicalDeviceMemoryProperties memory_{};
    std::string driver_info_;
    DeviceFeatures features_;
    std::atomic<int> validation_messages_{0};
    mutable Usage usage_;
    bool debug_utils_ = false;
    PFN_vkSetDebugUtilsObjectNameEXT set_object_name_ = nullptr;
    PFN_vkCmdBeginDebugUtilsLabelEXT begin_label_ = nullptr;
    PFN_vkCmdEndDebugUtilsLabelEXT end_label_ = nullptr;
};

} // namespace vigil::gpu
