// SPDX-License-Identifier: GPL-2.0-or-later
// A window that Vulkan can draw into, and the choice of window system: SDL2, GLFW, or none
// (headless). It draws nothing itself; the renderer makes its surface through
// refresh::SurfaceProvider.
#pragma once

#include "platform/event.h"
#include "refresh/refresh.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace vigil::platform {

struct WindowOptions {
    int width = 1280; // wanted size in screen units
    int height = 720;
    bool fullscreen = false; // covers the desktop; the display's mode stays
    std::string title = "Vigil";
};

/// One window. Used from the main thread only. Destroy it after the renderer that draws into it.
class Window : public refresh::SurfaceProvider {
public:
    /// Everything that happened since the last call, in order.
    virtual std::vector<Event> poll_events() = 0;
    /// Hides and holds the mouse; motion is then reported without limits.
    virtual void set_mouse_captured(bool captured) = 0;
    virtual void set_fullscreen(bool fullscreen) = 0;
    /// Wanted size in screen units; in full screen it is that of the window afterwards.
    virtual void set_size(int width, int height) = 0;
    virtual void set_title(const std::string& title) = 0;
    /// Text of the system's clipboard, "" when there is none.
    virtual std::string clipboard() const = 0;
    virtual void set_clipboard(const std::string& text) = 0;
    /// "sdl" or "glfw".
    virtual std::string_view driver() const = 0;
};

/// Opens a window by the value of `vid_driver`: "sdl", "glfw", "headless" or "auto" (SDL if the
/// environment names a display, else headless). A window system that fails is reported as a warning
/// and the next of SDL, GLFW, headless is tried. Returns null for headless.
std::unique_ptr<Window> open_window(std::string_view driver, const WindowOptions& options);

/// False when `driver` is "headless", or "auto" without a display in the environment.
bool wants_window(std::string_view driver);

/// Appends that the wheel turned, and a press of its key for each whole step.
void add_wheel_events(float turned, int steps, std::vector<Event>& events);

/// One window system each; throw Error when it is not available.
std::unique_ptr<Window> open_sdl_window(const WindowOptions& options);
std::unique_ptr<Window> open_glfw_window(const WindowOptions& options);

} // namespace vigil::platform
