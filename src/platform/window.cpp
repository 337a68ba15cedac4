// SPDX-License-Identifier: GPL-2.0-or-later
// Choice of the window system, with fallback from one to the next until headless.
#include "platform/window.h"

#include "common/error.h"
#include "common/log.h"

#include <cstdlib>

namespace vigil::platform {

namespace {

bool has_display() {
    const auto is_set = [](const char* name) {
        const char* value = std::getenv(name);
        return value != nullptr && value[0] != '\0';
    };
    return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
}

} // namespace

bool wants_window(std::string_view driver) {
    return driver != "headless" && (driver != "auto" || has_display());
}

void add_wheel_events(float turned, int steps, std::vector<Event>& events) {
    events.emplace_back(WheelEvent{turned});
    const Key key = steps > 0 ? Key::WheelUp : Key::WheelDown;
    for (int i = 0; i < std::abs(steps); ++i) {
        events.emplace_back(KeyEvent{key, true, false});
        events.emplace_back(KeyEvent{key, false, false});
    }
}

std::unique_ptr<Window> open_window(std::string_view driver, const WindowOptions& options) {
    if (!wants_window(driver)) return nullptr;

    struct System {
        std::string_view name;
        std::unique_ptr<Window> (*open)(const WindowOptions&);
    };
    const System sdl{"SDL", open_sdl_window};
    const System glfw{"GLFW", open_glfw_window};
    const System order[] = {driver == "glfw" ? glfw : sdl, driver == "glfw" ? sdl : glfw};
    for (const System& system : order) {
        try {
            return system.open(options);
        } catch (const Error& error) {
            log_warning("{} cannot open a window: {}", system.name, error.what());
        }
    }
    log_warning("no window opens. The program runs headless, and `screenshot` writes pictures.");
    return nullptr;
}

} // namespace vigil::platform
