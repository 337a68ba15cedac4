// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/gpu/device.h"

#include "common/error.h"
#include "common/log.h"
#include "refresh/refresh.h"

#include <algorithm>
#include <charconv>
#include <cstring>

namespace vigil::gpu {

namespace {

constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";
constexpr const char* query_extensions[] = {VK_KHR_RAY_QUERY_EXTENSION_NAME,
                                            VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME,
                                            VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME};

const char* result_name(VkResult result) {
    switch (result) {
    case VK_ERROR_OUT_OF_HOST_MEMORY:
        return "out of host memory";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
        return "out of device memory: lower vid_width and vid_height";
    case VK_ERROR_DEVICE_LOST:
        return "the device was lost: the driver reset it or it was removed";
    case VK_ERROR_INITIALIZATION_FAILED:
        return "initialisation failed";
    case VK_ERROR_LAYER_NOT_PRESENT:
        return "a layer is not installed";
    case VK_ERROR_EXTENSION_NOT_PRESENT:
        return "an extension is missing";
    case VK_ERROR_FEATURE_NOT_PRESENT:
        return "a feature is missing";
    case VK_ERROR_INCOMPATIBLE_DRIVER:
        return "no compatible Vulkan driver";
    case VK_ERROR_SURFACE_LOST_KHR:
        return "the window's surface was lost";
    default:
        return "error";
    }
}

bool has_layer(const char* name) {
    const auto layers = enumerate<VkLayerProperties>("vkEnumerateInstanceLayerProperties",
                                                     vkEnumerateInstanceLayerProperties);
    return std::any_of(layers.begin(), layers.end(), [&](const VkLayerProperties& layer) {
        return std::strcmp(layer.layerName, name) == 0;
    });
}

bool has_extension(const std::vector<VkExtensionProperties>& list, const char* name) {
    return std::any_of(list.begin(), list.end(), [&](const VkExtensionProperties& extension) {
        return std::strcmp(extension.extensionName, name) == 0;
    });
}

std::vector<VkExtensionProperties> instance_extensions() {
    const char* const layer = nullptr;
    return enumerate<VkExtensionProperties>("vkEnumerateInstanceExtensionProperties",
                                            vkEnumerateInstanceExtensionProperties, layer);
}

std::vector<VkExtensionProperties> device_extensions(VkPhysicalDevice device) {
    const char* const layer = nullptr;
    return enumerate<VkExtensionProperties>("vkEnumerateDeviceExtensionProperties",
                                            vkEnumerateDeviceExtensionProperties, device, layer);
}

int type_rank(VkPhysicalDeviceType type) {
    switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
        return 0;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
        return 1;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
        return 2;
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
        return 3;
    default:
        return 4;
    }
}

std::vector<VkQueueFamilyProperties> queue_families(VkPhysicalDevice device) {
    uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
    return families;
}

/// Index of a queue family that does graphics, compute and (with a surface) presentation; -1 if
/// none.
int find_queue_family(VkPhysicalDevice device, VkSurfaceKHR surface) {
    const std::vector<VkQueueFamilyProperties> families = queue_families(device);
    for (uint32_t i = 0; i < families.size(); ++i) {
        const VkQueueFlags wanted = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
        if ((families[i].queueFlags & wanted) != wanted) continue;
        VkBool32 present = VK_TRUE;
        if (surface != VK_NULL_HANDLE)
            vkGetPhysicalDeviceSurfaceSupportKHR(device, i, surface, &present);
        if (present) return static_cast<int>(i);
    }
    return -1;
}

/// Empty if `device` can run Vigil, else what it lacks.
std::string missing_from(VkPhysicalDevice device, VkSurfaceKHR surface) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(device, &properties);
    if (properties.apiVersion < VK_API_VERSION_1_2) return "Vulkan 1.2";
    auto features12 = structure<VkPhysicalDeviceVulkan12Features>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES);
    auto features = structure<VkPhysicalDeviceFeatures2>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &features12);
    vkGetPhysicalDeviceFeatures2(device, &features);
    if (!features12.scalarBlockLayout) return "scalarBlockLayout";
    if (find_queue_family(device, surface) < 0)
        return surface ? "a queue that computes and presents" : "a compute queue";
    if (surface && !has_extension(device_extensions(device), VK_KHR_SWAPCHAIN_EXTENSION_NAME))
        return VK_KHR_SWAPCHAIN_EXTENSION_NAME;
    return {};
}

} // namespace

void check(VkResult result, std::string_view call) {
    if (result == VK_SUCCESS) return;
    fail("{} failed ({}): {}", call, static_cast<int>(result), result_name(result));
}

Device::Device(const DeviceOptions& options, refresh::SurfaceProvider* surface) : Device() {
    // Where one of these throws, the destructor takes back what the others made.
    create_instance(options, surface);
    pick_physical_device(options);
    create_device(options);
}

Device::~Device() {
    if (device_) {
        vkDeviceWaitIdle(device_);
        vkDestroyDevice(device_, nullptr);
    }
    surface_.reset();
    messenger_.reset();
    if (instance_) vkDestroyInstance(instance_, nullptr);
}

void Device::create_instance(const DeviceOptions& options, refresh::SurfaceProvider* surface) {
    if (!options.cache) { // what Mesa and NVIDIA's driver look at
        setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
        setenv("__GL_SHADER_DISK_CACHE", "0", 1);
    }
    std::vector<const char*> layers;
    std::vector<std::string> names;
    if (surface) names = surface->instance_extensions();
    if (options.validation > 0) {
        if (has_layer(validation_layer))
            layers.push_back(validation_layer);
        else
            log_warning("vk_validation: the layer is not installed. Its package is "
                        "vulkan-validationlayers.");
    }
    debug_utils_ = (options.debug_names || !layers.empty()) &&
                   (has_extension(instance_extensions(), VK_EXT_DEBUG_UTILS_EXTENSION_NAME) ||
                    !layers.empty());
    if (debug_utils_) names.emplace_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    std::vector<const char*> extensions;
    for (const std::string& name : names)
        extensions.push_back(name.c_str());

    auto application = structure<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
    application.pApplicationName = "Vigil";
    application.apiVersion = VK_API_VERSION_1_2;

    auto messenger = structure<VkDebugUtilsMessengerCreateInfoEXT>(
        VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT);
    messenger.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT |
                                VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    messenger.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_GENERAL_BIT_EXT |
                            VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT |
                            VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
    messenger.pfnUserCallback = &Device::on_message;
    messenger.pUserData = this;

    // By options.validation, from 2 on; each slows the other down.
    constexpr VkValidationFeatureEnableEXT more[] = {
        VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT,
        VK_VALIDATION_FEATURE_ENABLE_GPU_ASSISTED_EXT};
    auto validation = structure<VkValidationFeaturesEXT>(VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT);
    validation.enabledValidationFeatureCount = 1;
    if (options.validation > 1)
        validation.pEnabledValidationFeatures = &more[options.validation - 2];

    auto info = structure<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
    info.pApplicationInfo = &application;
    info.enabledLayerCount = static_cast<uint32_t>(layers.size());
    info.ppEnabledLayerNames = layers.data();
    info.enabledExtensionCount = static_cast<uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    if (debug_utils_) info.pNext = &messenger;
    if (options.validation > 1 && !layers.empty()) {
        validation.pNext = info.pNext;
        info.pNext = &validation;
    }
    const VkResult result = vkCreateInstance(&info, nullptr, &instance_);
    if (result == VK_ERROR_INCOMPATIBLE_DRIVER)
        fail("no Vulkan driver found. Install mesa-vulkan-drivers, or the driver of your GPU's "
             "vendor.");
    check(result, "vkCreateInstance");

    const auto load = [&](const char* name) { return vkGetInstanceProcAddr(instance_, name); };
    if (debug_utils_) {
        set_object_name_ = reinterpret_cast<PFN_vkSetDebugUtilsObjectNameEXT>(
            load("vkSetDebugUtilsObjectNameEXT"));
        begin_label_ = reinterpret_cast<PFN_vkCmdBeginDebugUtilsLabelEXT>(
            load("vkCmdBeginDebugUtilsLabelEXT"));
        end_label_ =
            reinterpret_cast<PFN_vkCmdEndDebugUtilsLabelEXT>(load("vkCmdEndDebugUtilsLabelEXT"));
    }
    if (!layers.empty()) {
        const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
            load("vkCreateDebugUtilsMessengerEXT"));
        const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
            load("vkDestroyDebugUtilsMessengerEXT"));
        VkDebugUtilsMessengerEXT handle = VK_NULL_HANDLE;
        check(create(instance_, &messenger, nullptr, &handle), "vkCreateDebugUtilsMessengerEXT");
        messenger_ = {instance_, handle, destroy};
    }
    if (surface) surface_ = {instance_, surface->create_surface(instance_), vkDestroySurfaceKHR};
}

void Device::pick_physical_device(const DeviceOptions& options) {
    uint32_t count = 0;
    const VkResult found = vkEnumeratePhysicalDevices(instance_, &count, nullptr);
    if (found != VK_ERROR_INITIALIZATION_FAILED) check(found, "vkEnumeratePhysicalDevices");
    std::vector<VkPhysicalDevice> devices(count);
    if (count > 0)
        check(vkEnumeratePhysicalDevices(instance_, &count, devices.data()),
              "vkEnumeratePhysicalDevices");
    if (count == 0)
        fail("no Vulkan driver found. Install mesa-vulkan-drivers, or the driver of your GPU's "
             "vendor.");

    // A number is an index, if there are so many devices: names have digits, too.
    const char* const name_end = options.name.data() + options.name.size();
    uint32_t wanted_index = 0;
    const auto [number_end, error] = std::from_chars(options.name.data(), name_end, wanted_index);
    const bool by_index =
        error == std::errc() && number_end == name_end && wanted_index < devices.size();
    std::string rejected;
    int best_rank = 1000;
    for (uint32_t i = 0; i < count; ++i) {
        VkPhysicalDeviceProperties properties;
        vkGetPhysicalDeviceProperties(devices[i], &properties);
        const std::string name = properties.deviceName;
        const bool named =
            by_index ? wanted_index == i : name.find(options.name) != std::string::npos;
        if (!named) {
            rejected += fmt::format("\n  {} {}: not chosen by vk_device", i, name);
            continue;
        }
        const std::string missing = missing_from(devices[i], surface_.get());
        if (!missing.empty()) {
            rejected += fmt::format("\n  {} {}: lacks {}", i, name, missing);
            continue;
        }
        const int rank = type_rank(properties.deviceType);
        if (rank < best_rank) {
            best_rank = rank;
            physical_ = devices[i];
        }
    }
    if (!physical_) fail("no Vulkan device can run Vigil:{}", rejected);
    vkGetPhysicalDeviceProperties(physical_, &properties_);
    vkGetPhysicalDeviceMemoryProperties(physical_, &memory_);
    queue_family_ = static_cast<uint32_t>(find_queue_family(physical_, surface_.get()));
}

void Device::create_device(const DeviceOptions& options) {
    const std::vector<VkExtensionProperties> available = device_extensions(physical_);
    std::vector<const char*> extensions;
    if (surface_) extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);

    // Find out what the device offers.
    auto ray_query = structure<VkPhysicalDeviceRayQueryFeaturesKHR>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_QUERY_FEATURES_KHR);
    auto acceleration = structure<VkPhysicalDeviceAccelerationStructureFeaturesKHR>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_FEATURES_KHR, &ray_query);
    const bool may_query =
        options.allow_ray_query && std::ranges::all_of(query_extensions, [&](const char* name) {
            return has_extension(available, name);
        });
    auto offered12 = structure<VkPhysicalDeviceVulkan12Features>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES);
    if (may_query) offered12.pNext = &acceleration;
    auto offered = structure<VkPhysicalDeviceFeatures2>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &offered12);
    vkGetPhysicalDeviceFeatures2(physical_, &offered);
    features_.ray_query = may_query && ray_query.rayQuery && acceleration.accelerationStructure &&
                          offered12.bufferDeviceAddress;

    // Ask for just what Vigil uses.
    auto wanted12 = structure<VkPhysicalDeviceVulkan12Features>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES);
    wanted12.scalarBlockLayout = VK_TRUE;
    auto wanted = structure<VkPhysicalDeviceFeatures2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2,
                                                       &wanted12);
    if (features_.ray_query) {
        extensions.insert(extensions.end(), std::begin(query_extensions),
                          std::end(query_extensions));
        wanted12.bufferDeviceAddress = VK_TRUE;
        acceleration = structure<VkPhysicalDeviceAccelerationStructureFeaturesKHR>(
            VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_FEATURES_KHR, &ray_query);
        acceleration.accelerationStructure = VK_TRUE;
        wanted12.pNext = &acceleration;
    }
    const float priority = 1.0f;
    auto queue = structure<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
    queue.queueFamilyIndex = queue_family_;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    auto info = structure<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, &wanted);
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    info.enabledExtensionCount = static_cast<uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    check(vkCreateDevice(physical_, &info, nullptr, &device_), "vkCreateDevice");
    vkGetDeviceQueue(device_, queue_family_, 0, &queue_);

    // Note the limits other modules ask for.
    auto driver = structure<VkPhysicalDeviceDriverProperties>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES);
    auto subgroup = structure<VkPhysicalDeviceSubgroupProperties>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES, &driver);
    auto properties = structure<VkPhysicalDeviceProperties2>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &subgroup);
    vkGetPhysicalDeviceProperties2(physical_, &properties);
    driver_info_ = driver.driverInfo;
    // "Mesa 25.0.7 (LLVM 15.0.6)"; driverVersion does not tell.
    if (driver.driverID == VK_DRIVER_ID_MESA_LLVMPIPE && driver_info_.starts_with("Mesa "))
        std::from_chars(driver_info_.data() + 5, driver_info_.data() + driver_info_.size(),
                        features_.llvmpipe_mesa);
    features_.is_cpu = properties_.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
    features_.subgroup_size = subgroup.subgroupSize;
    features_.max_storage_buffer_bytes = properties_.limits.maxStorageBufferRange;
    features_.timestamp_bits = queue_families(physical_)[queue_family_].timestampValidBits;
    if (features_.timestamp_bits > 0)
        features_.timestamp_period_ns = properties_.limits.timestampPeriod;
}

std::string Device::description() const {
    return fmt::format("{}, {}, Vulkan {}.{}.{}", properties_.deviceName, driver_info_,
                       VK_API_VERSION_MAJOR(properties_.apiVersion),
                       VK_API_VERSION_MINOR(properties_.apiVersion),
                       VK_API_VERSION_PATCH(properties_.apiVersion));
}

uint32_t Device::memory_type(uint32_t type_bits, VkMemoryPropertyFlags wanted,
                             VkMemoryPropertyFlags preferred) const {
    for (const VkMemoryPropertyFlags flags : {wanted | preferred, wanted}) {
        for (uint32_t i = 0; i < memory_.memoryTypeCount; ++i) {
            const bool allowed = (type_bits >> i) & 1u;
            if (allowed && (memory_.memoryTypes[i].propertyFlags & flags) == flags) return i;
        }
    }
    fail("the device has no memory type with flags {:#x}", wanted);
}

void Device::wait_idle() const {
    check(vkDeviceWaitIdle(device_), "vkDeviceWaitIdle");
}

void Device::set_name_raw(VkObjectType type, uint64_t handle, std::string_view name) const {
    if (!set_object_name_) return;
    const std::string text(name);
    auto info = structure<VkDebugUtilsObjectNameInfoEXT>(
        VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT);
    info.objectType = type;
    info.objectHandle = handle;
    info.pObjectName = text.c_str();
    set_object_name_(device_, &info);
}

void Device::begin_label(VkCommandBuffer commands, const char* name) const {
    if (!begin_label_) return;
    auto label = structure<VkDebugUtilsLabelEXT>(VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT);
    label.pLabelName = name;
    begin_label_(commands, &label);
}

void Device::end_label(VkCommandBuffer commands) const {
    if (end_label_) end_label_(commands);
}

VKAPI_ATTR VkBool32 VKAPI_CALL Device::on_message(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                                  VkDebugUtilsMessageTypeFlagsEXT,
                                                  const VkDebugUtilsMessengerCallbackDataEXT* data,
                                                  void* user) {
    static_cast<Device*>(user)->validation_messages_.fetch_add(1);
    if (severity & VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT)
        log_error("Vulkan validation: {}", data->pMessage);
    else
        log_warning("Vulkan validation: {}", data->pMessage);
    return VK_FALSE;
}

} // namespace vigil::gpu
