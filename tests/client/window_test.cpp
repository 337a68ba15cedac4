// SPDX-License-Identifier: GPL-2.0-or-later
// The program in a real window: an X server without a screen (Xvfb), keys and mouse from xdotool,
// under validation. What the program did is read from its log, so nothing depends on how fast the
// machine is.
#include "common/process.h"
#include "common/scratch_folder.h"

#include <X11/Xlib.h>
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
constexpr auto patience = 300s;
constexpr int screen_width = 480, screen_height = 320;

bool is_installed(const std::string& program) {
    return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

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
        EXPECT_EQ(std::system(("xdotool " + words + " >/dev/null").c_str()), 0) << words;
    }
    static void press(const std::string& keys) { xdotool("key --delay 30 " + keys); }
    /// Types a line at the console.
    static void type(const std::string& line) {
        press("grave");
        xdotool("type --delay 20 '" + line + "'");
        press("Return grave");
    }
    /// Asks the window to close, as its frame's button would.
    static void close_window() {
        Display* display = XOpenDisplay(nullptr);
        ASSERT_NE(display, nullptr);
        Window root = 0, parent = 0, *children = nullptr;
        unsigned count = 0;
        XQueryTree(display, DefaultRootWindow(display), &root, &parent, &children, &count);
        for (unsigned i = 0; i < count; ++i) {
            XEvent event{};
            event.xclient.type = ClientMessage;
            event.xclient.window = children[i];
            event.xclient.message_type = XInternAtom(display, "WM_PROTOCOLS", False);
            event.xclient.format = 32;
            event.xclient.data.l[0] =
                static_cast<long>(XInternAtom(display, "WM_DELETE_WINDOW", False));
            XWindowAttributes attributes;
            if (XGetWindowAttributes(display, children[i], &attributes) != 0 &&
                attributes.map_state == IsViewable)
                XSendEvent(display, children[i], False, NoEventMask, &event);
        }
        if (children != nullptr) XFree(children);
        XCloseDisplay(display);
    }

    ScratchFolder folder_;
    std::unique_ptr<Process> server_, program_;
    std::string log_, answer_;
    size_t seen_ = 0;
};

TEST_P(WindowTest, APlayerWalksTypesChoosesSwitchesAndLeaves) {
    start(VIGIL_SOURCE_DIR "/tests/data", {"+map", "lamp"});
    ASSERT_TRUE(wait_for([&] { return logged("lamp: "); })) << text_of(log_);
    // Without a window manager nobody else gives it the keyboard.
    xdotool("search --sync --onlyvisible --name Vigil windowfocus --sync");
    press("F2"); // the first picture is done when this is answered
    ASSERT_TRUE(answered("setviewpos"));

    // Walks.
    press("F2");
    ASSERT_TRUE(answered("setviewpos"));
    const std::string start = answer_;
    xdotool("keydown w");
    std::this_thread::sleep_for(1500ms);
    xdotool("keyup w");
    press("F2");
    ASSERT_TRUE(answered("setviewpos"));
    EXPECT_NE(answer_, start);
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
    ASSERT_TRUE(answered("light sampling  uniform"));

    // Techniques by their keys, in play.
    press("t");
    ASSERT_TRUE(answered("pt_nee \"power\""));
    press("g");
    ASSERT_TRUE(answered("pt_guide \"brdf\""));
    press("F10");
    ASSERT_TRUE(answered("power | sll"));
    press("bracketleft bracketleft");
    type("pt_compare_at");
    ASSERT_TRUE(answered("\"0.4\""));
    press("F10 Tab");
    ASSERT_TRUE(answered("scr_stats \"groups\""));

    // The window changes its size, fills the screen, and comes back.
    xdotool("search --onlyvisible --name Vigil windowsize 200 120");
    std::this_thread::sleep_for(500ms);
    type("resolution");
    ASSERT_TRUE(answered("the picture has 200 x 120 pixels"));
    press("F11");
    ASSERT_TRUE(answered("vid_fullscreen \"1\""));
    std::this_thread::sleep_for(1000ms);
    xdotool("search --onlyvisible --name Vigil windowfocus");
    type("resolution");
    ASSERT_TRUE(answered("the picture has " + std::to_string(screen_width) + " x " +
                         std::to_string(screen_height) + " pixels"));
    press("F11");
    ASSERT_TRUE(answered("vid_fullscreen \"0\""));
    std::this_thread::sleep_for(1000ms);
    xdotool("search --onlyvisible --name Vigil windowfocus");
    press("F12");
    ASSERT_TRUE(answered("wrote "));
    EXPECT_TRUE(std::filesystem::exists(path("out") + "/vigil0000.png"));

    // Closed by its button.
    close_window();
    ASSERT_TRUE(wait_for([&] { return !program_->running(); }));
    const std::string all = text_of(log_);
    EXPECT_EQ(program_->wait(), 0) << all;
    EXPECT_EQ(all.find("alidation"), std::string::npos) << all;
    EXPECT_EQ(all.find("rror"), std::string::npos) << all;
    // What was changed is kept.
    EXPECT_NE(text_of(path("config/vigil/config.cfg")).find("scr_stats"), std::string::npos);
}

TEST_P(WindowTest, ClosedInMidBenchmarkItKeepsWhatIsFinished) {
    start(VIGIL_SOURCE_DIR,
          {"+set", "timedemo", "1000", "+set", "timedemo_json", "demo.json", "+demomap", "ring"});
    // Quake's line: one repetition is finished, the next is under way.
    ASSERT_TRUE(answered(" fps"));
    close_window();
    ASSERT_TRUE(wait_for([&] { return !program_->running(); }));
    const std::string all = text_of(log_);
    EXPECT_EQ(program_->wait(), 1) << all;
    EXPECT_NE(all.find("reported is what was finished"), std::string::npos) << all;
    const auto report = nlohmann::json::parse(text_of(path("out/demo.json")), nullptr, false);
    ASSERT_TRUE(report.is_object()) << all;
    EXPECT_GE(report["repetitions"].size(), 1u);
    EXPECT_LT(report["repetitions"].size(), 1000u);
}

INSTANTIATE_TEST_SUITE_P(Systems, WindowTest, testing::Values("sdl", "glfw"),
                         [](const auto& system) { return std::string(system.param); });

} // namespace
} // namespace vigil::test
