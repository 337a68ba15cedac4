// SPDX-License-Identifier: GPL-2.0-or-later
// The program in a real window: an X server without a screen (Xvfb), keys and mouse from xdotool,
// under validation. What the program did is read from its log and asked of the X server, again and
// again until it is so: nothing depends on how fast the machine is.
#include "common/process.h"
#include "common/scratch_folder.h"

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace vigil::test {
namespace {

using namespace std::chrono_literals;

/// Until something has happened: pipelines are compiled under validation on a machine that may be
/// busy.
constexpr auto patience = 600s;
constexpr int screen_width = 480, screen_height = 320;

bool is_installed(const std::string& program) {
    return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

/// The X server, asked about the one window that is seen: there is no window manager.
class Screen {
public:
    Screen() : display_(XOpenDisplay(nullptr)) {
        // A window may go while it is asked about.
        XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
    }
    ~Screen() {
        if (display_ != nullptr) XCloseDisplay(display_);
    }
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    explicit operator bool() const { return display_ != nullptr; }

    /// 0: none.
    Window window() const {
        Window root = 0, parent = 0, *children = nullptr, found = 0;
        unsigned count = 0;
        XQueryTree(display_, DefaultRootWindow(display_), &root, &parent, &children, &count);
        for (unsigned i = 0; i < count; ++i) {
            XWindowAttributes attributes;
            if (XGetWindowAttributes(display_, children[i], &attributes) != 0 &&
                attributes.map_state == IsViewable)
                found = children[i];
        }
        if (children != nullptr) XFree(children);
        return found;
    }
    void resize(unsigned width, unsigned height) {
        XResizeWindow(display_, window(), width, height);
        XSync(display_, False);
    }
    /// Gives it the keyboard, which nobody else does; false if it does not have it yet.
    bool focus() {
        const Window seen = window();
        if (seen == 0) return false;
        XSetInputFocus(display_, seen, RevertToNone, CurrentTime);
        XSync(display_, False);
        Window focused = 0;
        int revert = 0;
        XGetInputFocus(display_, &focused, &revert);
        return focused == seen;
    }
    /// Asks it to close, as its frame's button would.
    void close() {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = window();
        event.xclient.message_type = XInternAtom(display_, "WM_PROTOCOLS", False);
        event.xclient.format = 32;
        event.xclient.data.l[0] =
            static_cast<long>(XInternAtom(display_, "WM_DELETE_WINDOW", False));
        XSendEvent(display_, event.xclient.window, False, NoEventMask, &event);
        XSync(display_, False);
    }
    /// Pixels of this colour that it shows, as 0xrrggbb.
    int count_pixels(unsigned long color) const {
        XWindowAttributes attributes;
        const Window seen = window();
        if (seen == 0 || XGetWindowAttributes(display_, seen, &attributes) == 0) return 0;
        XImage* image = XGetImage(display_, seen, 0, 0, static_cast<unsigned>(attributes.width),
                                  static_cast<unsigned>(attributes.height), AllPlanes, ZPixmap);
        if (image == nullptr) return 0;
        int count = 0;
        for (int y = 0; y < image->height; ++y)
            for (int x = 0; x < image->width; ++x)
                count += (XGetPixel(image, x, y) & 0xffffff) == color ? 1 : 0;
        XDestroyImage(image);
        return count;
    }

private:
    Display* display_;
};

class WindowTest : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        if (!is_installed("Xvfb") || !is_installed("xdotool"))
            GTEST_SKIP() << "needs Xvfb and xdotool (Debian: xvfb, xdotool)";
        // Xvfb chooses a free display and tells which.
        const std::string number = path("display");
        server_ = std::make_unique<Process>(
            std::vector<std::string>{"sh", "-c",
                                     "exec Xvfb -displayfd 3 -nolisten tcp -screen 0 " +
                                         std::to_string(screen_width) + "x" +
                                         std::to_string(screen_height) + "x24 3>" + number},
            path("xvfb.log"));
        ASSERT_TRUE(wait_for([&] { return text_of(number).ends_with('\n'); }))
            << text_of(path("xvfb.log"));
        std::string display = ":" + text_of(number);
        display.pop_back();
        setenv("DISPLAY", display.c_str(), 1);
        unsetenv("WAYLAND_DISPLAY");
        setenv("XDG_CONFIG_HOME", path("config").c_str(), 1); // not the player's
        setenv("XDG_CACHE_HOME", (std::filesystem::current_path() / "test-cache").c_str(), 1);
        log_ = path("vigil.log");
        screen_ = std::make_unique<Screen>();
        ASSERT_TRUE(*screen_);
    }
    /// Starts the program with a window; it looks for the game in `basedir`.
    void start(const std::string& basedir, std::vector<std::string> words) {
        std::vector<std::string> all{VIGIL_PROGRAM};
        for (const auto& [name, value] :
             std::initializer_list<std::pair<const char*, std::string>>{{"vid_driver", GetParam()},
                                                                        {"basedir", basedir},
                                                                        {"outdir", path("out")},
                                                                        {"vk_validation", "2"},
                                                                        {"vid_width", "160"},
                                                                        {"vid_height", "100"}})
            all.insert(all.end(), {"+set", name, value});
        all.insert(all.end(), words.begin(), words.end());
        program_ = std::make_unique<Process>(all, log_);
    }
    void TearDown() override {
        program_.reset();
        screen_.reset();
        server_.reset();
    }

    std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
    static std::string text_of(const std::string& file) {
        std::ifstream stream(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    bool logged(const std::string& text) const {
        return text_of(log_).find(text, seen_) != std::string::npos;
    }
    bool wait_for(const auto& condition) {
        for (const auto end = std::chrono::steady_clock::now() + patience;
             std::chrono::steady_clock::now() < end;) {
            if (condition()) return true;
            if (program_ && !program_->running()) return condition();
            std::this_thread::sleep_for(50ms);
        }
        return false;
    }
    /// Waits for `text` in what was logged since the last answer, and keeps its line in answer_.
    testing::AssertionResult answered(const std::string& text) {
        if (!wait_for([&] {
                const std::string log = text_of(log_);
                const size_t begin = log.find(text, seen_);
                return begin != std::string::npos && log.find('\n', begin) != std::string::npos;
            }))
            return testing::AssertionFailure() << "no \"" << text << "\" in:\n"
                                               << text_of(log_).substr(seen_);
        const std::string all = text_of(log_);
        const size_t begin = all.find(text, seen_), end = all.find('\n', begin);
        answer_ = all.substr(begin, end - begin);
        seen_ = end;
        return testing::AssertionSuccess();
    }

    static void xdotool(const std::string& words) {
        EXPECT_EQ(std::system(("timeout 60 xdotool " + words + " >/dev/null").c_str()), 0) << words;
    }
    /// Presses a key that may be pressed again until `text` is answered, which may take a while:
    /// the window may just be changing, and without the keyboard.
    testing::AssertionResult asked(const std::string& key, const std::string& text) {
        const bool found = wait_for([&] {
            if (!screen_->focus()) return false;
            press(key);
            for (int i = 0; i < 40 && !logged(text); ++i)
                std::this_thread::sleep_for(50ms);
            return logged(text);
        });
        if (!found)
            return testing::AssertionFailure() << "no \"" << text << "\" in:\n"
                                               << text_of(log_).substr(seen_);
        return answered(text);
    }
    static void press(const std::string& keys) { xdotool("key --delay 30 " + keys); }
    /// Types a line at the console.
    static void type(const std::string& line) {
        press("grave");
        xdotool("type --delay 20 '" + line + "'");
        press("Return grave");
    }
    ScratchFolder folder_;
    std::unique_ptr<Process> server_, program_;
    std::unique_ptr<Screen> screen_;
    std::string log_, answer_;
    size_t seen_ = 0;
};

TEST_P(WindowTest, APlayerWalksTypesChoosesSwitchesAndLeaves) {
    start(VIGIL_SOURCE_DIR "/tests/data",
          {"+bind", "F6", "resolution", "+bind", "F7", "echo listening", "+map", "lamp"});
    ASSERT_TRUE(wait_for([&] { return logged("lamp: "); })) << text_of(log_);
    ASSERT_TRUE(asked("F7", "listening")); // the first picture is done when this is answered

    // Walks.
    press("F2");
    ASSERT_TRUE(answered("setviewpos"));
    const std::string start = answer_;
    xdotool("keydown w");
    EXPECT_TRUE(wait_for([&] {
        press("F2");
        return answered("setviewpos") && answer_ != start;
    }));
    xdotool("keyup w");
    press("F2");
    ASSERT_TRUE(answered("setviewpos"));
    // And looks.
    const std::string walked = answer_;
    xdotool("mousemove_relative 60 10");
    press("F2");
    ASSERT_TRUE(answered("setviewpos"));
    EXPECT_NE(answer_, walked);

    // The console.
    type("echo typed by keys");
    ASSERT_TRUE(answered("typed by keys"));

    // The menu: levels, then the technique, which F3 tells also while it is open.
    press("Escape Down Return");
    press("End Up Up Up Return"); // furnace, lamp, opensky, rooms
    ASSERT_TRUE(answered("furnace: ")) << "the level chosen in the menu was not loaded";
    press("Escape Down Down Down Down Right F3 Escape");
    ASSERT_TRUE(answered("light sampling  cut"));

    // Techniques by their keys, in play.
    press("t");
    ASSERT_TRUE(answered("pt_nee \"uniform\""));
    press("g");
    ASSERT_TRUE(answered("pt_guide \"brdf\""));
    press("x");
    ASSERT_TRUE(answered("uniform | sll"));
    press("bracketleft bracketleft");
    type("pt_compare_at");
    ASSERT_TRUE(answered("\"0.4\""));
    press("x Tab");
    ASSERT_TRUE(answered("scr_stats \"groups\""));

    // The window changes its size, fills the screen, and comes back.
    screen_->resize(200, 120);
    ASSERT_TRUE(asked("F6", "the picture has 200 x 120 pixels"));
    press("F11");
    ASSERT_TRUE(answered("vid_fullscreen \"1\""));
    ASSERT_TRUE(asked("F6", "the picture has " + std::to_string(screen_width) + " x " +
                                std::to_string(screen_height) + " pixels"));
    press("F11");
    // Without a window manager SDL keeps the size of the screen.
    ASSERT_TRUE(answered("vid_fullscreen \"0\""));
    press("F12");
    ASSERT_TRUE(answered("wrote "));
    EXPECT_TRUE(std::filesystem::exists(path("out") + "/vigil0000.png"));

    // Another window and renderer; the level and its player stay.
    press("F2");
    ASSERT_TRUE(answered("setviewpos"));
    const std::string before = answer_;
    type("vid_restart");
    ASSERT_TRUE(answered("window and renderer are new"));
    ASSERT_TRUE(asked("F2", "setviewpos"));
    EXPECT_EQ(answer_, before);
    ASSERT_TRUE(asked("F6", "the picture has "));

    // Whoever presses F10 is asked.
    press("F10 n");
    ASSERT_TRUE(asked("F7", "listening"));

    // Closed by its button.
    screen_->close();
    ASSERT_TRUE(wait_for([&] { return !program_->running(); }));
    const std::string all = text_of(log_);
    EXPECT_EQ(program_->wait(), 0) << all;
    EXPECT_EQ(all.find("alidation"), std::string::npos) << all;
    EXPECT_EQ(all.find("rror"), std::string::npos) << all;
    // What was changed is kept.
    const std::string kept = text_of(path("config/vigil/config.cfg"));
    EXPECT_NE(kept.find("scr_stats"), std::string::npos) << kept;
    EXPECT_NE(kept.find("set pt_nee \"uniform\""), std::string::npos) << kept;
    EXPECT_NE(kept.find("set pt_preset \"custom\""), std::string::npos) << kept;
}

TEST_P(WindowTest, ClosedInMidBenchmarkItKeepsWhatIsFinished) {
    // A folder in the place of the configuration hinders nothing.
    std::filesystem::create_directories(path("config/vigil/config.cfg"));
    start(VIGIL_SOURCE_DIR,
          {"+set", "timedemo", "1000", "+set", "timedemo_json", "demo.json", "+demomap", "ring"});
    // Quake's line: one repetition is finished, the next is under way.
    ASSERT_TRUE(answered(" fps"));
    screen_->close();
    ASSERT_TRUE(wait_for([&] { return !program_->running(); }));
    const std::string all = text_of(log_);
    EXPECT_EQ(program_->wait(), 1) << all;
    EXPECT_NE(all.find("the report has what was finished"), std::string::npos) << all;
    EXPECT_NE(all.find("config.cfg: not a regular file"), std::string::npos) << all;
    EXPECT_NE(all.find("config.cfg: cannot replace: Is a directory"), std::string::npos) << all;
    const auto report = nlohmann::json::parse(text_of(path("out/demo.json")), nullptr, false);
    ASSERT_TRUE(report.is_object()) << all;
    EXPECT_GE(report["repetitions"].size(), 1u);
    EXPECT_LT(report["repetitions"].size(), 1000u);
}

TEST_P(WindowTest, ItShowsWhatIsCompiledAndMayBeClosedMeanwhile) {
    // Nothing was ever compiled.
    setenv("XDG_CACHE_HOME", path("cache").c_str(), 1);
    start(VIGIL_SOURCE_DIR "/tests/data", {"+map", "lamp"});
    // The box around the bar is wider than a third of the window.
    constexpr unsigned long edge = 0xe69632;
    ASSERT_TRUE(wait_for([&] { return screen_->count_pixels(edge) > 160; })) << text_of(log_);
    screen_->close();
    ASSERT_TRUE(wait_for([&] { return !program_->running(); }));
    const std::string all = text_of(log_);
    EXPECT_EQ(program_->wait(), 0) << all;
    EXPECT_EQ(all.find("alidation"), std::string::npos) << all;
    EXPECT_EQ(all.find("rror"), std::string::npos) << all;
    EXPECT_TRUE(std::filesystem::exists(path("config/vigil/config.cfg")));
}

INSTANTIATE_TEST_SUITE_P(Systems, WindowTest, testing::Values("sdl", "glfw"),
                         [](const auto& system) { return std::string(system.param); });

} // namespace
} // namespace vigil::test
