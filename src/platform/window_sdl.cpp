// SPDX-License-Identifier: GPL-2.0-or-later
// The window by SDL 2. Keys are scancodes (places on the keyboard), text is SDL's text input.
#include "common/error.h"
#include "platform/gamepad.h"
#include "platform/window.h"

#include <SDL.h>
#include <SDL_vulkan.h>

namespace vigil::platform {

namespace {

constexpr CodeRun key_runs[] = {{SDL_SCANCODE_A, SDL_SCANCODE_Z, Key::A},
                                {SDL_SCANCODE_1, SDL_SCANCODE_9, Key::Digit1},
                                {SDL_SCANCODE_0, SDL_SCANCODE_0, Key::Digit0},
                                {SDL_SCANCODE_F1, SDL_SCANCODE_F12, Key::F1},
                                {SDL_SCANCODE_KP_1, SDL_SCANCODE_KP_9, Key::Keypad1},
                                {SDL_SCANCODE_KP_0, SDL_SCANCODE_KP_0, Key::Keypad0}};
constexpr int from_tab[] = {
    SDL_SCANCODE_TAB,         SDL_SCANCODE_RETURN,       SDL_SCANCODE_ESCAPE,
    SDL_SCANCODE_SPACE,       SDL_SCANCODE_BACKSPACE,    SDL_SCANCODE_CAPSLOCK,
    SDL_SCANCODE_PAUSE,       SDL_SCANCODE_LSHIFT,       SDL_SCANCODE_LCTRL,
    SDL_SCANCODE_LALT,        SDL_SCANCODE_LGUI,         SDL_SCANCODE_UP,
    SDL_SCANCODE_DOWN,        SDL_SCANCODE_LEFT,         SDL_SCANCODE_RIGHT,
    SDL_SCANCODE_INSERT,      SDL_SCANCODE_DELETE,       SDL_SCANCODE_PAGEUP,
    SDL_SCANCODE_PAGEDOWN,    SDL_SCANCODE_HOME,         SDL_SCANCODE_END,
    SDL_SCANCODE_GRAVE,       SDL_SCANCODE_MINUS,        SDL_SCANCODE_EQUALS,
    SDL_SCANCODE_LEFTBRACKET, SDL_SCANCODE_RIGHTBRACKET, SDL_SCANCODE_BACKSLASH,
    SDL_SCANCODE_SEMICOLON,   SDL_SCANCODE_APOSTROPHE,   SDL_SCANCODE_COMMA,
    SDL_SCANCODE_PERIOD,      SDL_SCANCODE_SLASH};
constexpr int from_shift[] = {SDL_SCANCODE_RSHIFT, SDL_SCANCODE_RCTRL, SDL_SCANCODE_RALT,
                              SDL_SCANCODE_RGUI};
constexpr int from_keypad_enter[] = {SDL_SCANCODE_KP_ENTER,  SDL_SCANCODE_KP_PLUS,
                                     SDL_SCANCODE_KP_MINUS,  SDL_SCANCODE_KP_MULTIPLY,
                                     SDL_SCANCODE_KP_DIVIDE, SDL_SCANCODE_KP_PERIOD};
constexpr CodeList key_lists[] = {
    {from_tab, Key::Tab}, {from_shift, Key::Shift}, {from_keypad_enter, Key::KeypadEnter}};
constexpr int from_mouse1[] = {SDL_BUTTON_LEFT, SDL_BUTTON_RIGHT, SDL_BUTTON_MIDDLE, SDL_BUTTON_X1,
                               SDL_BUTTON_X2};
constexpr CodeList button_lists[] = {{from_mouse1, Key::Mouse1}};

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
        const int steps = wheel.direction == SDL_MOUSEWHEEL_FLIPPED ? -wheel.y : wheel.y;
        add_wheel_events(sign * wheel.preciseY, steps, events);
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
            const Key key = key_of_code(event.key.keysym.scancode, key_runs, key_lists);
            if (key == Key::None) break;
            events.emplace_back(KeyEvent{key, event.type == SDL_KEYDOWN, event.key.repeat != 0});
            break;
        }
        case SDL_TEXTINPUT:
            events.emplace_back(TextEvent{event.text.text});
            break;
        case SDL_MOUSEBUTTONDOWN:
        case SDL_MOUSEBUTTONUP: {
            const Key key = key_of_code(event.button.button, {}, button_lists);
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
    Gamepads gamepads_;
    std::unique_ptr<SDL_Window, DestroyWindow> window_;
};

} // namespace

std::unique_ptr<Window> open_sdl_window(const WindowOptions& options) {
    // The program has its own main(); SDL must not look for SDL_main.
    SDL_SetMainReady();
    return std::make_unique<SdlWindow>(options);
}

} // namespace vigil::platform
