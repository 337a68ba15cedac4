// SPDX-License-Identifier: GPL-2.0-or-later
// The window by SDL 2. Keys are scancodes (places on the keyboard), text is SDL's text input.
#include "common/error.h"
#include "platform/gamepad_sdl.h"
#include "platform/window.h"

#include <SDL.h>
#include <SDL_vulkan.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vigil::platform {

namespace {

using KeyPair = std::pair<SDL_Scancode, Key>;

/// Scancodes that are not part of a run of letters, digits or function keys.
constexpr KeyPair single_keys[] = {
    {SDL_SCANCODE_0, Key::Digit0},
    {SDL_SCANCODE_TAB, Key::Tab},
    {SDL_SCANCODE_RETURN, Key::Enter},
    {SDL_SCANCODE_ESCAPE, Key::Escape},
    {SDL_SCANCODE_SPACE, Key::Space},
    {SDL_SCANCODE_BACKSPACE, Key::Backspace},
    {SDL_SCANCODE_CAPSLOCK, Key::CapsLock},
    {SDL_SCANCODE_PAUSE, Key::Pause},
    {SDL_SCANCODE_LSHIFT, Key::Shift},
    {SDL_SCANCODE_RSHIFT, Key::Shift},
    {SDL_SCANCODE_LCTRL, Key::Ctrl},
    {SDL_SCANCODE_RCTRL, Key::Ctrl},
    {SDL_SCANCODE_LALT, Key::Alt},
    {SDL_SCANCODE_RALT, Key::Alt},
    {SDL_SCANCODE_LGUI, Key::Super},
    {SDL_SCANCODE_RGUI, Key::Super},
    {SDL_SCANCODE_UP, Key::Up},
    {SDL_SCANCODE_DOWN, Key::Down},
    {SDL_SCANCODE_LEFT, Key::Left},
    {SDL_SCANCODE_RIGHT, Key::Right},
    {SDL_SCANCODE_INSERT, Key::Insert},
    {SDL_SCANCODE_DELETE, Key::Delete},
    {SDL_SCANCODE_PAGEUP, Key::PageUp},
    {SDL_SCANCODE_PAGEDOWN, Key::PageDown},
    {SDL_SCANCODE_HOME, Key::Home},
    {SDL_SCANCODE_END, Key::End},
    {SDL_SCANCODE_GRAVE, Key::Grave},
    {SDL_SCANCODE_MINUS, Key::Minus},
    {SDL_SCANCODE_EQUALS, Key::Equals},
    {SDL_SCANCODE_LEFTBRACKET, Key::LeftBracket},
    {SDL_SCANCODE_RIGHTBRACKET, Key::RightBracket},
    {SDL_SCANCODE_BACKSLASH, Key::Backslash},
    {SDL_SCANCODE_SEMICOLON, Key::Semicolon},
    {SDL_SCANCODE_APOSTROPHE, Key::Apostrophe},
    {SDL_SCANCODE_COMMA, Key::Comma},
    {SDL_SCANCODE_PERIOD, Key::Period},
    {SDL_SCANCODE_SLASH, Key::Slash},
    {SDL_SCANCODE_KP_0, Key::Keypad0},
    {SDL_SCANCODE_KP_ENTER, Key::KeypadEnter},
    {SDL_SCANCODE_KP_PLUS, Key::KeypadPlus},
    {SDL_SCANCODE_KP_MINUS, Key::KeypadMinus},
    {SDL_SCANCODE_KP_MULTIPLY, Key::KeypadMultiply},
    {SDL_SCANCODE_KP_DIVIDE, Key::KeypadDivide},
    {SDL_SCANCODE_KP_PERIOD, Key::KeypadPeriod},
};

Key offset_key(Key first, int offset) {
    return static_cast<Key>(static_cast<int>(first) + offset);
}

/// The key of a scancode in one of the runs SDL lays out in order.
Key key_of(SDL_Scancode code) {
    const auto in = [code](SDL_Scancode first, SDL_Scancode last) {
        return code >= first && code <= last;
    };
    if (in(SDL_SCANCODE_A, SDL_SCANCODE_Z)) return offset_key(Key::A, code - SDL_SCANCODE_A);
    if (in(SDL_SCANCODE_1, SDL_SCANCODE_9)) return offset_key(Key::Digit1, code - SDL_SCANCODE_1);
    if (in(SDL_SCANCODE_F1, SDL_SCANCODE_F12)) return offset_key(Key::F1, code - SDL_SCANCODE_F1);
    if (in(SDL_SCANCODE_KP_1, SDL_SCANCODE_KP_9)) {
        return offset_key(Key::Keypad1, code - SDL_SCANCODE_KP_1);
    }
    const auto* found = std::ranges::find(single_keys, code, &KeyPair::first);
    return found == std::end(single_keys) ? Key::None : found->second;
}

Key key_of_button(uint8_t button) {
    switch (button) {
    case SDL_BUTTON_LEFT:
        return Key::Mouse1;
    case SDL_BUTTON_RIGHT:
        return Key::Mouse2;
    case SDL_BUTTON_MIDDLE:
        return Key::Mouse3;
    case SDL_BUTTON_X1:
        return Key::Mouse4;
    case SDL_BUTTON_X2:
        return Key::Mouse5;
    default:
        return Key::None;
    }
}

/// SDL's video subsystem, started and ended with the window.
class VideoSystem {
public:
    VideoSystem() {
        if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) fail("{}", SDL_GetError());
    }
    ~VideoSystem() { SDL_QuitSubSystem(SDL_INIT_VIDEO); }
    VideoSystem(const VideoSystem&) = delete;
    VideoSystem& operator=(const VideoSystem&) = delete;
};

class SdlWindow final : public Window {
public:
    explicit SdlWindow(const WindowOptions& options) {
        uint32_t flags = SDL_WINDOW_VULKAN | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI;
        if (options.fullscreen) flags |= SDL_WINDOW_FULLSCREEN_DESKTOP;
        window_.reset(SDL_CreateWindow(options.title.c_str(), SDL_WINDOWPOS_CENTERED,
                                       SDL_WINDOWPOS_CENTERED, options.width, options.height,
                                       flags));
        if (!window_) fail("{}", SDL_GetError());
        SDL_StartTextInput();
    }

    std::vector<std::string> instance_extensions() const override {
        unsigned count = 0;
        if (!SDL_Vulkan_GetInstanceExtensions(window_.get(), &count, nullptr)) {
            fail("SDL names no Vulkan extensions: {}", SDL_GetError());
        }
        std::vector<const char*> names(count);
        if (!SDL_Vulkan_GetInstanceExtensions(window_.get(), &count, names.data())) {
            fail("SDL names no Vulkan extensions: {}", SDL_GetError());
        }
        return {names.begin(), names.end()};
    }

    VkSurfaceKHR_T* create_surface(VkInstance_T* instance) override {
        VkSurfaceKHR surface{};
        if (!SDL_Vulkan_CreateSurface(window_.get(), instance, &surface)) {
            fail("SDL cannot make a Vulkan surface: {}", SDL_GetError());
        }
        return surface;
    }

    glm::ivec2 framebuffer_size() const override {
        if ((SDL_GetWindowFlags(window_.get()) & SDL_WINDOW_MINIMIZED) != 0) return {0, 0};
        glm::ivec2 size{0};
        SDL_Vulkan_GetDrawableSize(window_.get(), &size.x, &size.y);
        return size;
    }

    std::vector<Event> poll_events() override {
        std::vector<Event> events;
        SDL_Event event;
        while (SDL_PollEvent(&event) != 0) {
            translate(event, events);
        }
        return events;
    }

    void set_mouse_captured(bool captured) override {
        SDL_SetRelativeMouseMode(captured ? SDL_TRUE : SDL_FALSE);
    }

    void set_fullscreen(bool fullscreen) override {
        const uint32_t flags = fullscreen ? uint32_t{SDL_WINDOW_FULLSCREEN_DESKTOP} : 0u;
        if (SDL_SetWindowFullscreen(window_.get(), flags) != 0) {
            fail("cannot change to {}: {}", fullscreen ? "full screen" : "a window",
                 SDL_GetError());
        }
    }

    void set_size(int width, int height) override {
        SDL_SetWindowSize(window_.get(), width, height);
    }

    void set_title(const std::string& title) override {
        SDL_SetWindowTitle(window_.get(), title.c_str());
    }

    std::string clipboard() const override {
        char* text = SDL_GetClipboardText();
        std::string result = text != nullptr ? text : "";
        SDL_free(text);
        return result;
    }

    void set_clipboard(const std::string& text) override { SDL_SetClipboardText(text.c_str()); }

    std::string_view driver() const override { return "sdl"; }

private:
    struct DestroyWindow {
        void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
    };

    /// Framebuffer pixels per screen unit.
    glm::vec2 pixel_scale() const {
        glm::ivec2 size{0};
        SDL_GetWindowSize(window_.get(), &size.x, &size.y);
        return glm::vec2(framebuffer_size()) / glm::vec2(glm::max(size, glm::ivec2(1)));
    }

    void translate_wheel(const SDL_MouseWheelEvent& wheel, std::vector<Event>& events) {
        const float sign = wheel.direction == SDL_MOUSEWHEEL_FLIPPED ? -1.0f : 1.0f;
        events.emplace_back(WheelEvent{sign * wheel.preciseY});
        const int steps = wheel.direction == SDL_MOUSEWHEEL_FLIPPED ? -wheel.y : wheel.y;
        const Key key = steps > 0 ? Key::WheelUp : Key::WheelDown;
        for (int i = 0; i < std::abs(steps); ++i) {
            events.emplace_back(KeyEvent{key, true, false});
            events.emplace_back(KeyEvent{key, false, false});
        }
    }

    void translate_window(const SDL_WindowEvent& event, std::vector<Event>& events) {
        switch (event.event) {
        case SDL_WINDOWEVENT_SIZE_CHANGED:
        case SDL_WINDOWEVENT_MINIMIZED:
        case SDL_WINDOWEVENT_RESTORED:
            events.emplace_back(ResizeEvent{framebuffer_size()});
            break;
        case SDL_WINDOWEVENT_FOCUS_GAINED:
            events.emplace_back(FocusEvent{true});
            break;
        case SDL_WINDOWEVENT_FOCUS_LOST:
            events.emplace_back(FocusEvent{false});
            break;
        default:
            break;
        }
    }

    void translate(const SDL_Event& event, std::vector<Event>& events) {
        switch (event.type) {
        case SDL_QUIT:
            events.emplace_back(CloseEvent{});
            break;
        case SDL_KEYDOWN:
        case SDL_KEYUP: {
            const Key key = key_of(event.key.keysym.scancode);
            if (key == Key::None) break;
            events.emplace_back(KeyEvent{key, event.type == SDL_KEYDOWN, event.key.repeat != 0});
            break;
        }
        case SDL_TEXTINPUT:
            events.emplace_back(TextEvent{event.text.text});
            break;
        case SDL_MOUSEBUTTONDOWN:
        case SDL_MOUSEBUTTONUP: {
            const Key key = key_of_button(event.button.button);
            if (key == Key::None) break;
            events.emplace_back(KeyEvent{key, event.type == SDL_MOUSEBUTTONDOWN, false});
            break;
        }
        case SDL_MOUSEMOTION:
            events.emplace_back(
                MouseMoveEvent{glm::vec2(event.motion.x, event.motion.y) * pixel_scale(),
                               glm::vec2(event.motion.xrel, event.motion.yrel)});
            break;
        case SDL_MOUSEWHEEL:
            translate_wheel(event.wheel, events);
            break;
        case SDL_WINDOWEVENT:
            translate_window(event.window, events);
            break;
        default:
            gamepads_.handle(event, events);
            break;
        }
    }

    VideoSystem video_;
    SdlGamepads gamepads_;
    std::unique_ptr<SDL_Window, DestroyWindow> window_;
};

} // namespace

std::unique_ptr<Window> open_sdl_window(const WindowOptions& options) {
    // The program has its own main(); SDL must not look for SDL_main.
    SDL_SetMainReady();
    return std::make_unique<SdlWindow>(options);
}

} // namespace vigil::platform
