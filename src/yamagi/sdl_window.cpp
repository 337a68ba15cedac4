// SPDX-License-Identifier: GPL-2.0-or-later
#include "yamagi/sdl_window.h"

#include "common/error.h"

#include <dlfcn.h>

namespace vigil::yamagi {

namespace {

/// A function of SDL in this process; null: there is none.
template <typename Function> Function* find(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

template <typename Function> Function* get(const char* name) {
    Function* const function = find<Function>(name);
    if (function == nullptr) fail("SDL lacks {}: it was built without Vulkan", name);
    return function;
}

std::string sdl_error() {
    const auto text = find<const char*()>("SDL_GetError");
    return text != nullptr ? text() : "";
}

} // namespace

int sdl_version() {
    if (find<void>("SDL_CreateWindowWithProperties") != nullptr) return 3;
    return find<void>("SDL_CreateWindow") != nullptr ? 2 : 0;
}

std::optional<std::string> load_sdl_vulkan() {
    if (sdl_version() == 3) {
        const auto load = find<bool(const char*)>("SDL_Vulkan_LoadLibrary");
        if (load == nullptr) return "SDL was built without Vulkan";
        return load(nullptr) ? std::nullopt : std::optional(sdl_error());
    }
    const auto load = find<int(const char*)>("SDL_Vulkan_LoadLibrary");
    if (load == nullptr) return "SDL was built without Vulkan";
    return load(nullptr) == 0 ? std::nullopt : std::optional(sdl_error());
}

bool answer_window_system() {
    constexpr uint32_t quit_event = 0x100; // the same in SDL 2 and 3
    if (const auto pump = find<void()>("SDL_PumpEvents"); pump != nullptr) pump();
    const auto has = find<int(uint32_t)>("SDL_HasEvent");
    return has != nullptr && (has(quit_event) & 0xff) != 0;
}

std::vector<std::string> SdlWindow::instance_extensions() const {
    constexpr const char* name = "SDL_Vulkan_GetInstanceExtensions";
    if (sdl_version() == 3) {
        uint32_t count = 0;
        const char* const* const names = get<const char* const*(uint32_t*)>(name)(&count);
        if (names == nullptr) fail("SDL: {}", sdl_error());
        return {names, names + count};
    }
    const auto list = get<int(void*, unsigned*, const char**)>(name);
    unsigned count = 0;
    if (list(window_, &count, nullptr) == 0) fail("SDL: {}", sdl_error());
    std::vector<const char*> names(count);
    if (list(window_, &count, names.data()) == 0) fail("SDL: {}", sdl_error());
    return {names.begin(), names.end()};
}

VkSurfaceKHR_T* SdlWindow::create_surface(VkInstance_T* instance) {
    constexpr const char* name = "SDL_Vulkan_CreateSurface";
    VkSurfaceKHR_T* surface = nullptr;
    // SDL 2 returns an int's worth of truth, SDL 3 a byte's: the byte is good for both.
    const bool made = sdl_version() == 3
                          ? get<bool(void*, VkInstance_T*, const void*, VkSurfaceKHR_T**)>(name)(
                                window_, instance, nullptr, &surface)
                          : get<int(void*, VkInstance_T*, VkSurfaceKHR_T**)>(name)(
                                window_, instance, &surface) != 0;
    if (!made) fail("SDL: no Vulkan surface: {}", sdl_error());
    return surface;
}

glm::ivec2 SdlWindow::framebuffer_size() const {
    glm::ivec2 size(0);
    const char* const name =
        sdl_version() == 3 ? "SDL_GetWindowSizeInPixels" : "SDL_Vulkan_GetDrawableSize";
    const auto measure = find<void(void*, int*, int*)>(name);
    if (measure != nullptr) measure(window_, &size.x, &size.y);
    return size;
}

} // namespace vigil::yamagi
