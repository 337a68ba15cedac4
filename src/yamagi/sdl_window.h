// SPDX-License-Identifier: GPL-2.0-or-later
// The engine's window as a Vulkan surface. The engine brings SDL 2 or 3; its functions are looked
// up in the process, so that the module is linked to neither.
#pragma once

#include "refresh/refresh.h"

#include <optional>

namespace vigil::yamagi {

/// Flag of SDL_CreateWindow, the same in SDL 2 and 3.
inline constexpr int sdl_window_vulkan = 0x10000000;

/// 2 or 3: the main version of the SDL in this process; 0: there is none.
int sdl_version();

/// Whether SDL finds Vulkan for the display that it uses; else what it says.
std::optional<std::string> load_sdl_vulkan();

/// Lets SDL take what the window system sends, which the engine reads later; without SDL does
/// nothing. True: the window was closed.
bool answer_window_system();

class SdlWindow final : public refresh::SurfaceProvider {
public:
    /// `window` is SDL's.
    explicit SdlWindow(void* window) : window_(window) {}

    std::vector<std::string> instance_extensions() const override;
    VkSurfaceKHR_T* create_surface(VkInstance_T* instance) override;
    glm::ivec2 framebuffer_size() const override;

private:
    void* window_;
};

} // namespace vigil::yamagi
