// SPDX-License-Identifier: GPL-2.0-or-later
// RAII for Vulkan handles: Handle<T> owns one device- or instance-level object and destroys it with
// the function it was given. Movable, not copyable. Also structure(), for what Vulkan is told.
#pragma once

#include <utility>
#include <vulkan/vulkan.h>

namespace vigil::gpu {

/// Owns `T`, created from `Parent` (VkDevice or VkInstance), destroyed by vkDestroyX(parent,
/// handle, nullptr).
template <typename Parent, typename T> class OwnedHandle {
public:
    using Destroy = void(VKAPI_PTR*)(Parent, T, const VkAllocationCallbacks*);

    OwnedHandle() = default;
    OwnedHandle(Parent parent, T handle, Destroy destroy)
        : parent_(parent), handle_(handle), destroy_(destroy) {}
    OwnedHandle(OwnedHandle&& other) noexcept
        : parent_(other.parent_), handle_(std::exchange(other.handle_, VK_NULL_HANDLE)),
          destroy_(other.destroy_) {}
    OwnedHandle& operator=(OwnedHandle&& other) noexcept {
        if (this != &other) {
            reset();
            parent_ = other.parent_;
            handle_ = std::exchange(other.handle_, VK_NULL_HANDLE);
            destroy_ = other.destroy_;
        }
        return *this;
    }
    OwnedHandle(const OwnedHandle&) = delete;
    OwnedHandle& operator=(const OwnedHandle&) = delete;
    ~OwnedHandle() { reset(); }

    void reset() {
        if (handle_ != VK_NULL_HANDLE) destroy_(parent_, handle_, nullptr);
        handle_ = VK_NULL_HANDLE;
    }
    T get() const { return handle_; }
    explicit operator bool() const { return handle_ != VK_NULL_HANDLE; }

private:
    Parent parent_{};
    T handle_ = VK_NULL_HANDLE;
    Destroy destroy_ = nullptr;
};

/// A Vulkan structure of this type, continued by `next`, with all else zero.
template <typename T> T structure(VkStructureType type, void* next = nullptr) {
    T made{};
    made.sType = type;
    made.pNext = next;
    return made;
}

template <typename T> using Handle = OwnedHandle<VkDevice, T>;
template <typename T> using InstanceHandle = OwnedHandle<VkInstance, T>;

} // namespace vigil::gpu
