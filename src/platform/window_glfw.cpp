// SPDX-License-Identifier: GPL-2.0-or-later
// The window by GLFW 3. GLFW's key tokens are places on a US keyboard; its callbacks fill a list
// that poll_events hands out.
#include "common/error.h"
#include "platform/gamepad.h"
#include "platform/window.h"

#include <vulkan/vulkan.h>

#include <GLFW/glfw3.h>
#include <SDL.h>

#include <cmath>
#include <utility>

namespace vigil::platform {

namespace {

constexpr CodeRun key_runs[] = {{GLFW_KEY_A, GLFW_KEY_Z, Key::A},
                                {GLFW_KEY_0, GLFW_KEY_9, Key::Digit0},
                                {GLFW_KEY_F1, GLFW_KEY_F12, Key::F1},
                                {GLFW_KEY_KP_0, GLFW_KEY_KP_9, Key::Keypad0}};
constexpr int from_tab[] = {
    GLFW_KEY_TAB,          GLFW_KEY_ENTER,         GLFW_KEY_ESCAPE,     GLFW_KEY_SPACE,
    GLFW_KEY_BACKSPACE,    GLFW_KEY_CAPS_LOCK,     GLFW_KEY_PAUSE,      GLFW_KEY_LEFT_SHIFT,
    GLFW_KEY_LEFT_CONTROL, GLFW_KEY_LEFT_ALT,      GLFW_KEY_LEFT_SUPER, GLFW_KEY_UP,
    GLFW_KEY_DOWN,         GLFW_KEY_LEFT,          GLFW_KEY_RIGHT,      GLFW_KEY_INSERT,
    GLFW_KEY_DELETE,       GLFW_KEY_PAGE_UP,       GLFW_KEY_PAGE_DOWN,  GLFW_KEY_HOME,
    GLFW_KEY_END,          GLFW_KEY_GRAVE_ACCENT,  GLFW_KEY_MINUS,      GLFW_KEY_EQUAL,
    GLFW_KEY_LEFT_BRACKET, GLFW_KEY_RIGHT_BRACKET, GLFW_KEY_BACKSLASH,  GLFW_KEY_SEMICOLON,
    GLFW_KEY_APOSTROPHE,   GLFW_KEY_COMMA,         GLFW_KEY_PERIOD,     GLFW_KEY_SLASH};
constexpr int from_shift[] = {GLFW_KEY_RIGHT_SHIFT, GLFW_KEY_RIGHT_CONTROL, GLFW_KEY_RIGHT_ALT,
                              GLFW_KEY_RIGHT_SUPER};
constexpr int from_keypad_enter[] = {GLFW_KEY_KP_ENTER,    GLFW_KEY_KP_ADD,    GLFW_KEY_KP_SUBTRACT,
                                     GLFW_KEY_KP_MULTIPLY, GLFW_KEY_KP_DIVIDE, GLFW_KEY_KP_DECIMAL};
constexpr CodeList key_lists[] = {
    {from_tab, Key::Tab}, {from_shift, Key::Shift}, {from_keypad_enter, Key::KeypadEnter}};
/// GLFW numbers the buttons left, right, middle, back, forward.
constexpr CodeRun button_runs[] = {{GLFW_MOUSE_BUTTON_1, GLFW_MOUSE_BUTTON_5, Key::Mouse1}};

std::string to_utf8(uint32_t code_point) {
    const std::unique_ptr<char, void (*)(void*)> text(
        SDL_iconv_string("UTF-8", "UTF-32LE", reinterpret_cast<const char*>(&code_point),
                         sizeof(code_point)),
        SDL_free);
    return text ? text.get() : "";
}

std::string last_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text != nullptr ? text : "unknown error";
}

/// The library, started and ended with the window.
class Library {
public:
    Library() {
        if (glfwInit() != GLFW_TRUE) fail("{}", last_error());
    }
    ~Library() { glfwTerminate(); }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
};

class GlfwWindow final : public Window {
public:
    explicit GlfwWindow(const WindowOptions& options) {
        glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
        window_.reset(glfwCreateWindow(options.width, options.height, options.title.c_str(),
                                       nullptr, nullptr));
        if (!window_) fail("{}", last_error());
        if (glfwVulkanSupported() != GLFW_TRUE) fail("GLFW finds no Vulkan: {}", last_error());
        glfwSetWindowUserPointer(window_.get(), this);
        install_callbacks();
        if (options.fullscreen) set_fullscreen(true);
    }

    std::vector<std::string> instance_extensions() const override {
        uint32_t count = 0;
        const char** names = glfwGetRequiredInstanceExtensions(&count);
        if (names == nullptr) fail("GLFW names no Vulkan extensions: {}", last_error());
        return {names, names + count};
    }

    VkSurfaceKHR_T* create_surface(VkInstance_T* instance) override {
        VkSurfaceKHR surface{};
        if (glfwCreateWindowSurface(instance, window_.get(), nullptr, &surface) != VK_SUCCESS) {
            fail("GLFW cannot make a Vulkan surface: {}", last_error());
        }
        return surface;
    }

    glm::ivec2 framebuffer_size() const override {
        if (glfwGetWindowAttrib(window_.get(), GLFW_ICONIFIED) == GLFW_TRUE) return {0, 0};
        glm::ivec2 size{0};
        glfwGetFramebufferSize(window_.get(), &size.x, &size.y);
        return size;
    }

    std::vector<Event> poll_events() override {
        glfwPollEvents();
        poll_gamepads();
        return std::exchange(events_, {});
    }

    void set_mouse_captured(bool captured) override {
        glfwSetInputMode(window_.get(), GLFW_CURSOR,
                         captured ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
        if (glfwRawMouseMotionSupported() == GLFW_TRUE) {
            glfwSetInputMode(window_.get(), GLFW_RAW_MOUSE_MOTION,
                             captured ? GLFW_TRUE : GLFW_FALSE);
        }
        // The position jumps when the mode changes; that is no motion of the hand.
        glfwGetCursorPos(window_.get(), &cursor_.x, &cursor_.y);
    }

    void set_fullscreen(bool fullscreen) override {
        if (fullscreen == (glfwGetWindowMonitor(window_.get()) != nullptr)) return;
        if (fullscreen) {
            GLFWmonitor* monitor = glfwGetPrimaryMonitor();
            const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
            if (mode == nullptr) fail("cannot change to full screen: {}", last_error());
            glfwGetWindowPos(window_.get(), &restore_position_.x, &restore_position_.y);
            glfwGetWindowSize(window_.get(), &restore_size_.x, &restore_size_.y);
            glfwSetWindowMonitor(window_.get(), monitor, 0, 0, mode->width, mode->height,
                                 mode->refreshRate);
        } else {
            glfwSetWindowMonitor(window_.get(), nullptr, restore_position_.x, restore_position_.y,
                                 restore_size_.x, restore_size_.y, 0);
        }
    }

    void set_size(int width, int height) override {
        if (glfwGetWindowMonitor(window_.get()) != nullptr)
            restore_size_ = {width, height};
        else
            glfwSetWindowSize(window_.get(), width, height);
    }

    void set_title(const std::string& title) override {
        glfwSetWindowTitle(window_.get(), title.c_str());
    }

    std::string clipboard() const override {
        const char* text = glfwGetClipboardString(window_.get());
        return text != nullptr ? text : "";
    }

    void set_clipboard(const std::string& text) override {
        glfwSetClipboardString(window_.get(), text.c_str());
    }

    std::string_view driver() const override { return "glfw"; }

private:
    struct DestroyWindow {
        void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
    };

    static GlfwWindow& self(GLFWwindow* window) {
        return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window));
    }

    template <typename T> void add(T event) { events_.emplace_back(std::move(event)); }

    void add_key(Key key, int action) {
        if (key != Key::None) add(KeyEvent{key, action != GLFW_RELEASE, action == GLFW_REPEAT});
    }

    void add_motion(double x, double y) {
        glm::ivec2 size{0};
        glfwGetWindowSize(window_.get(), &size.x, &size.y);
        const glm::dvec2 scale =
            glm::dvec2(framebuffer_size()) / glm::dvec2(glm::max(size, glm::ivec2(1)));
        const glm::dvec2 position(x, y);
        add(MouseMoveEvent{glm::vec2(position * scale), glm::vec2(position - cursor_)});
        cursor_ = position;
    }

    /// Fine wheels report fractions; a key press stands for each whole step they add up to.
    void add_wheel(double steps) {
        wheel_remainder_ += steps;
        const double whole = std::trunc(wheel_remainder_);
        wheel_remainder_ -= whole;
        add_wheel_events(static_cast<float>(steps), static_cast<int>(whole), events_);
    }

    void add_focus(bool focused) {
        add(FocusEvent{focused});
        if (!focused) gamepads_.let_go(events_);
    }

    void install_callbacks() {
        GLFWwindow* window = window_.get();
        glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) {
            self(w).add_key(key_of_code(key, key_runs, key_lists), action);
        });
        glfwSetCharCallback(window, [](GLFWwindow* w, unsigned code_point) {
            self(w).add(TextEvent{to_utf8(code_point)});
        });
        glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
            self(w).add_key(key_of_code(button, button_runs), action);
        });
        glfwSetCursorPosCallback(
            window, [](GLFWwindow* w, double x, double y) { self(w).add_motion(x, y); });
        glfwSetScrollCallback(window,
                              [](GLFWwindow* w, double, double y) { self(w).add_wheel(y); });
        glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) {
            self(w).add(ResizeEvent{self(w).framebuffer_size()});
        });
        glfwSetWindowFocusCallback(
            window, [](GLFWwindow* w, int focused) { self(w).add_focus(focused == GLFW_TRUE); });
        glfwSetWindowCloseCallback(window, [](GLFWwindow* w) {
            // Closing is the program's decision; the flag would stay set after `CloseEvent`.
            glfwSetWindowShouldClose(w, GLFW_FALSE);
            self(w).add(CloseEvent{});
        });
    }

    /// GLFW reports no events of controllers: they are SDL's, which does not know this window.
    void poll_gamepads() {
        std::vector<Event> unseen; // while another window has the keyboard
        const bool focused = glfwGetWindowAttrib(window_.get(), GLFW_FOCUSED) == GLFW_TRUE;
        SDL_Event event;
        while (SDL_PollEvent(&event) != 0) {
            if (event.type == SDL_QUIT) add(CloseEvent{}); // a signal
            gamepads_.handle(event, focused ? events_ : unseen);
        }
    }

    Library library_;
    std::unique_ptr<GLFWwindow, DestroyWindow> window_;
    std::vector<Event> events_;
    Gamepads gamepads_;
    glm::dvec2 cursor_{0.0};
    double wheel_remainder_ = 0.0;
    glm::ivec2 restore_position_{0};
    glm::ivec2 restore_size_{1280, 720};
};

} // namespace

std::unique_ptr<Window> open_glfw_window(const WindowOptions& options) {
    return std::make_unique<GlfwWindow>(options);
}

} // namespace vigil::platform
