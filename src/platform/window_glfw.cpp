// SPDX-License-Identifier: GPL-2.0-or-later
// The window by GLFW 3. GLFW's key tokens are places on a US keyboard; its callbacks fill a list
// that poll_events hands out.
#include "common/error.h"
#include "platform/gamepad.h"
#include "platform/window.h"

#include <vulkan/vulkan.h>

#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vigil::platform {

namespace {

using KeyPair = std::pair<int, Key>;

constexpr KeyPair single_keys[] = {
    {GLFW_KEY_TAB, Key::Tab},
    {GLFW_KEY_ENTER, Key::Enter},
    {GLFW_KEY_ESCAPE, Key::Escape},
    {GLFW_KEY_SPACE, Key::Space},
    {GLFW_KEY_BACKSPACE, Key::Backspace},
    {GLFW_KEY_CAPS_LOCK, Key::CapsLock},
    {GLFW_KEY_PAUSE, Key::Pause},
    {GLFW_KEY_LEFT_SHIFT, Key::Shift},
    {GLFW_KEY_RIGHT_SHIFT, Key::Shift},
    {GLFW_KEY_LEFT_CONTROL, Key::Ctrl},
    {GLFW_KEY_RIGHT_CONTROL, Key::Ctrl},
    {GLFW_KEY_LEFT_ALT, Key::Alt},
    {GLFW_KEY_RIGHT_ALT, Key::Alt},
    {GLFW_KEY_LEFT_SUPER, Key::Super},
    {GLFW_KEY_RIGHT_SUPER, Key::Super},
    {GLFW_KEY_UP, Key::Up},
    {GLFW_KEY_DOWN, Key::Down},
    {GLFW_KEY_LEFT, Key::Left},
    {GLFW_KEY_RIGHT, Key::Right},
    {GLFW_KEY_INSERT, Key::Insert},
    {GLFW_KEY_DELETE, Key::Delete},
    {GLFW_KEY_PAGE_UP, Key::PageUp},
    {GLFW_KEY_PAGE_DOWN, Key::PageDown},
    {GLFW_KEY_HOME, Key::Home},
    {GLFW_KEY_END, Key::End},
    {GLFW_KEY_GRAVE_ACCENT, Key::Grave},
    {GLFW_KEY_MINUS, Key::Minus},
    {GLFW_KEY_EQUAL, Key::Equals},
    {GLFW_KEY_LEFT_BRACKET, Key::LeftBracket},
    {GLFW_KEY_RIGHT_BRACKET, Key::RightBracket},
    {GLFW_KEY_BACKSLASH, Key::Backslash},
    {GLFW_KEY_SEMICOLON, Key::Semicolon},
    {GLFW_KEY_APOSTROPHE, Key::Apostrophe},
    {GLFW_KEY_COMMA, Key::Comma},
    {GLFW_KEY_PERIOD, Key::Period},
    {GLFW_KEY_SLASH, Key::Slash},
    {GLFW_KEY_KP_ENTER, Key::KeypadEnter},
    {GLFW_KEY_KP_ADD, Key::KeypadPlus},
    {GLFW_KEY_KP_SUBTRACT, Key::KeypadMinus},
    {GLFW_KEY_KP_MULTIPLY, Key::KeypadMultiply},
    {GLFW_KEY_KP_DIVIDE, Key::KeypadDivide},
    {GLFW_KEY_KP_DECIMAL, Key::KeypadPeriod},
};

Key offset_key(Key first, int offset) {
    return static_cast<Key>(static_cast<int>(first) + offset);
}

Key key_of(int code) {
    const auto in = [code](int first, int last) { return code >= first && code <= last; };
    if (in(GLFW_KEY_A, GLFW_KEY_Z)) return offset_key(Key::A, code - GLFW_KEY_A);
    if (in(GLFW_KEY_0, GLFW_KEY_9)) return offset_key(Key::Digit0, code - GLFW_KEY_0);
    if (in(GLFW_KEY_F1, GLFW_KEY_F12)) return offset_key(Key::F1, code - GLFW_KEY_F1);
    if (in(GLFW_KEY_KP_0, GLFW_KEY_KP_9)) return offset_key(Key::Keypad0, code - GLFW_KEY_KP_0);
    const auto* found = std::ranges::find(single_keys, code, &KeyPair::first);
    return found == std::end(single_keys) ? Key::None : found->second;
}

/// GLFW numbers the buttons left, right, middle, back, forward.
Key key_of_button(int button) {
    return button >= 0 && button < 5 ? offset_key(Key::Mouse1, button) : Key::None;
}

/// GLFW's buttons in the order of its numbers.
constexpr Key gamepad_keys[] = {
    Key::PadA,
    Key::PadB,
    Key::PadX,
    Key::PadY,
    Key::PadLeftShoulder,
    Key::PadRightShoulder,
    Key::PadBack,
    Key::PadStart,
    Key::PadGuide,
    Key::PadLeftStick,
    Key::PadRightStick,
    Key::PadUp,
    Key::PadRight,
    Key::PadDown,
    Key::PadLeft,
};
static_assert(std::size(gamepad_keys) == GLFW_GAMEPAD_BUTTON_LAST + 1);

GamepadState gamepad_state_of(const GLFWgamepadstate& raw, GamepadState before) {
    GamepadState state;
    for (size_t i = 0; i < std::size(gamepad_keys); ++i)
        state.button(gamepad_keys[i]) = raw.buttons[i] == GLFW_PRESS;
    // GLFW: down positive, and triggers from -1.
    state.left = {raw.axes[GLFW_GAMEPAD_AXIS_LEFT_X], -raw.axes[GLFW_GAMEPAD_AXIS_LEFT_Y]};
    state.right = {raw.axes[GLFW_GAMEPAD_AXIS_RIGHT_X], -raw.axes[GLFW_GAMEPAD_AXIS_RIGHT_Y]};
    const auto pull = [&](Key key, int axis) {
        state.button(key) = trigger_is_down(before.button(key), 0.5f * raw.axes[axis] + 0.5f);
    };
    pull(Key::PadLeftTrigger, GLFW_GAMEPAD_AXIS_LEFT_TRIGGER);
    pull(Key::PadRightTrigger, GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER);
    return state;
}

std::string to_utf8(unsigned code_point) {
    std::string text;
    const auto put = [&text](unsigned value) { text.push_back(static_cast<char>(value)); };
    if (code_point < 0x80u) {
        put(code_point);
    } else if (code_point < 0x800u) {
        put(0xc0u | code_point >> 6);
        put(0x80u | (code_point & 0x3fu));
    } else if (code_point < 0x10000u) {
        put(0xe0u | code_point >> 12);
        put(0x80u | (code_point >> 6 & 0x3fu));
        put(0x80u | (code_point & 0x3fu));
    } else {
        put(0xf0u | code_point >> 18);
        put(0x80u | (code_point >> 12 & 0x3fu));
        put(0x80u | (code_point >> 6 & 0x3fu));
        put(0x80u | (code_point & 0x3fu));
    }
    return text;
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
        add(WheelEvent{static_cast<float>(steps)});
        wheel_remainder_ += steps;
        const double whole = std::trunc(wheel_remainder_);
        wheel_remainder_ -= whole;
        const Key key = whole > 0.0 ? Key::WheelUp : Key::WheelDown;
        for (int i = 0; i < static_cast<int>(std::abs(whole)); ++i) {
            add(KeyEvent{key, true, false});
            add(KeyEvent{key, false, false});
        }
    }

    void install_callbacks() {
        GLFWwindow* window = window_.get();
        glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) {
            self(w).add_key(key_of(key), action);
        });
        glfwSetCharCallback(window, [](GLFWwindow* w, unsigned code_point) {
            self(w).add(TextEvent{to_utf8(code_point)});
        });
        glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
            self(w).add_key(key_of_button(button), action);
        });
        glfwSetCursorPosCallback(
            window, [](GLFWwindow* w, double x, double y) { self(w).add_motion(x, y); });
        glfwSetScrollCallback(window,
                              [](GLFWwindow* w, double, double y) { self(w).add_wheel(y); });
        glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) {
            self(w).add(ResizeEvent{self(w).framebuffer_size()});
        });
        glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
            self(w).add(FocusEvent{focused == GLFW_TRUE});
        });
        glfwSetWindowCloseCallback(window, [](GLFWwindow* w) {
            // Closing is the program's decision; the flag would stay set after `CloseEvent`.
            glfwSetWindowShouldClose(w, GLFW_FALSE);
            self(w).add(CloseEvent{});
        });
    }

    /// GLFW reports no events of controllers, so they are looked at once a frame; a press that is
    /// shorter is missed.
    void poll_gamepads() {
        const bool focused = glfwGetWindowAttrib(window_.get(), GLFW_FOCUSED) == GLFW_TRUE;
        for (int joystick = GLFW_JOYSTICK_1; joystick <= GLFW_JOYSTICK_LAST; ++joystick) {
            GLFWgamepadstate raw;
            GamepadState& before = gamepads_.at(static_cast<size_t>(joystick));
            GamepadState now; // at rest: of one that was pulled out, or while another window has
                              // the keyboard
            if (focused && glfwGetGamepadState(joystick, &raw) == GLFW_TRUE)
                now = gamepad_state_of(raw, before);
            add_gamepad_events(before, now, events_);
            before = now;
        }
    }

    Library library_;
    std::unique_ptr<GLFWwindow, DestroyWindow> window_;
    std::vector<Event> events_;
    std::array<GamepadState, GLFW_JOYSTICK_LAST + 1> gamepads_;
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
