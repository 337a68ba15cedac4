// SPDX-License-Identifier: GPL-2.0-or-later
// The client in a window that exists only here: what sticks, mouse and keys do to eye, line and
// window, frame by frame.
#include "client/client.h"
#include "console/builtin_commands.h"
#include "fake_renderer.h"
#include "test_game.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace vigil::client {
namespace {

using namespace platform;

/// Hands out what a test asks for in each frame, and closes itself at the end.
class ScriptedWindow final : public Window {
public:
    explicit ScriptedWindow(std::function<std::vector<Event>(int frame)> script)
        : script_(std::move(script)) {}

    std::vector<Event> poll_events() override { return script_(frame_++); }
    std::vector<std::string> instance_extensions() const override { return {}; }
    VkSurfaceKHR_T* create_surface(VkInstance_T*) override { return nullptr; }
    glm::ivec2 framebuffer_size() const override { return size; }
    void set_mouse_captured(bool captured) override { mouse_captured = captured; }
    void set_fullscreen(bool on) override { fullscreen = on; }
    void set_size(int width, int height) override { size = {width, height}; }
    void set_title(const std::string&) override {}
    std::string clipboard() const override { return {}; }
    void set_clipboard(const std::string&) override {}
    std::string_view driver() const override { return "scripted"; }

    glm::ivec2 size{500, 300};
    bool mouse_captured = false;
    bool fullscreen = false;

private:
    std::function<std::vector<Event>(int)> script_;
    int frame_ = 0;
};

class Steering : public testing::Test {
protected:
    Steering() {
        for (const CvarInfo& info : cvar_infos)
            cvars().reset(info.name);
        files_.mount_game(game_.basedir(), "baseq2");
        add_builtin_commands(commands_, [](std::string_view) { return ScriptText(); });
    }
    ~Steering() override {
        for (const CvarInfo& info : cvar_infos)
            cvars().reset(info.name);
    }

    static Event down(Key key) { return KeyEvent{key, true, false}; }
    static Event up(Key key) { return KeyEvent{key, false, false}; }

    /// Plays the level with these events, by frame; `look` sees the client after each frame's
    /// events were handled.
    void play(const std::vector<std::pair<int, Event>>& events, int frames,
              const std::function<void(int frame, Client&)>& look) {
        Client* running = nullptr;
        ScriptedWindow window([&](int frame) {
            look(frame, *running);
            std::vector<Event> now;
            for (const auto& [when, event] : events)
                if (when == frame) now.push_back(event);
            if (frame >= frames) now.emplace_back(CloseEvent{});
            return now;
        });
        window_ = &window;
        Overlay overlay;
        FakeRenderer renderer(log_);
        Client client({files_, commands_, bindings_, console_, overlay, renderer, &window});
        running = &client;
        client.load_map("tiny");
        commands_.execute_text("noclip"); // nothing to bump into
        client.run();
    }

    TestGame game_;
    FileSystem files_;
    CommandRegistry commands_{cvars()};
    KeyBindings bindings_;
    Console console_{commands_};
    RenderLog log_;
    ScriptedWindow* window_ = nullptr;
};

TEST_F(Steering, SticksFlyAndLookUnlessTheMenuIsOpen) {
    cvars().set("joy_look", "180");
    using Stick = StickEvent::Stick;
    glm::vec3 origin[5], angles[5];
    play({{10, StickEvent{Stick::Left, {0.0f, 1.0f}}},
          {30, StickEvent{Stick::Left, {0.05f, 0.05f}}}, // does not quite come back
          {30, StickEvent{Stick::Right, {1.0f, 0.0f}}},
          {50, StickEvent{Stick::Right, {0.0f, 0.0f}}},
          {50, down(Key::PadStart)},
          {50, up(Key::PadStart)},
          {52, StickEvent{Stick::Left, {1.0f, 0.0f}}},
          {52, StickEvent{Stick::Right, {0.0f, 1.0f}}}},
         70, [&](int frame, Client& client) {
             const Camera& camera = client.session().camera();
             const int mark = frame == 10   ? 0
                              : frame == 30 ? 1
                              : frame == 50 ? 2
                              : frame == 69 ? 3
                                            : 4;
             origin[mark] = camera.origin();
             angles[mark] = camera.angles();
             if (frame == 69) {
                 EXPECT_TRUE(client.menu().is_open());
             }
         });
    // The start looks along +y.
    EXPECT_GT(origin[1].y, origin[0].y + 5.0f);
    EXPECT_NEAR(origin[1].x, origin[0].x, 0.01f);
    EXPECT_EQ(angles[1], angles[0]);
    EXPECT_EQ(origin[2], origin[1]);            // in the dead zone
    EXPECT_LT(angles[2].y, angles[1].y - 1.0f); // to the right
    EXPECT_EQ(angles[2].x, angles[1].x);
    EXPECT_EQ(origin[3], origin[2]);
    EXPECT_EQ(angles[3], angles[2]);
}

TEST_F(Steering, WhileShadersAreCompiledTheWindowAnswersAndTheWorldStands) {
    log_.reports = 5;
    log_.compile_s = 0.4;
    bool open[2]{};
    // Polls 1 to 5 are those of the first frame's wait, the key's among them.
    play({{3, down(Key::Escape)}, {3, up(Key::Escape)}}, 9, [&](int poll, Client& client) {
        if (poll == 4) open[0] = client.menu().is_open();
        if (poll == 8) open[1] = client.menu().is_open();
    });
    EXPECT_EQ(log_.drawn, (std::vector<bool>{true, true, true, true, true}));
    EXPECT_FALSE(open[0]) << "the menu opened in the midst of a frame";
    EXPECT_TRUE(open[1]) << "what was typed is lost";
    ASSERT_GE(log_.times.size(), 2u);
    EXPECT_LT(log_.times[1] - log_.times[0], 0.3);
}

TEST_F(Steering, AWindowThatIsClosedWhileShadersAreCompiledEnds) {
    log_.reports = 1000;
    play({}, 3, [](int, Client&) {});
    EXPECT_LE(log_.drawn.size(), 3u);
    EXPECT_EQ(log_.count("render"), 0u);
}

TEST_F(Steering, TheRightButtonDragsTheLine) {
    float at[3];
    play({{2, down(Key::X)},
          {2, up(Key::X)},
          {4, down(Key::Mouse2)},
          {5, MouseMoveEvent{{}, {100.0f, 40.0f}}}, // a fifth of the width
          {8, up(Key::Mouse2)},
          {9, MouseMoveEvent{{}, {50.0f, 0.0f}}},
          {12, down(Key::LeftBracket)},
          {12, up(Key::LeftBracket)}},
         16, [&](int frame, Client& client) {
             if (frame == 8) at[0] = client.variables()->pt_compare_at;
             if (frame == 12) at[1] = client.variables()->pt_compare_at;
             if (frame == 8) {
                 EXPECT_EQ(client.session().camera().angles().x, 0.0f);
             }
             at[2] = client.variables()->pt_compare_at;
         });
    EXPECT_EQ(at[0], 0.7f);
    EXPECT_EQ(at[1], 0.7f);
    EXPECT_EQ(at[2], 0.65f);
    EXPECT_EQ(cvars().get_text("pt_compare"), "sll");
}

TEST_F(Steering, CompareGoesOnWithWhatWasComparedLast) {
    play({}, 2, [&](int frame, Client& client) {
        if (frame != 1) return;
        CommandRegistry& commands = client.commands();
        commands.execute_text("compare vlc+cdq");
        EXPECT_EQ(cvars().get_text("pt_compare"), "vlc+cdq");
        commands.execute_text("compare");
        EXPECT_EQ(cvars().get_text("pt_compare"), "none");
        commands.execute_text("compare");
        EXPECT_EQ(cvars().get_text("pt_compare"), "vlc+cdq");
        commands.execute_text("comparemove 7");
        EXPECT_EQ(cvars()->pt_compare_at, 1.0f);
        EXPECT_EQ(commands.failures(), 0);
        commands.execute_text("compare magic; comparemove; comparemove x");
        EXPECT_EQ(commands.failures(), 3);
        EXPECT_EQ(cvars().get_text("pt_compare"), "vlc+cdq");
    });
}

TEST_F(Steering, TheMenuFreesTheMouseAndSetsTheWindow) {
    bool captured[3];
    glm::ivec2 resized{0};
    play({{4, down(Key::Escape)}, {8, down(Key::Escape)}}, 14, [&](int frame, Client& client) {
        if (frame == 3) captured[0] = window_->mouse_captured;
        if (frame == 7) captured[1] = window_->mouse_captured;
        if (frame == 11) captured[2] = window_->mouse_captured;
        if (frame == 12) client.commands().execute_text("resolution 320 200");
        if (frame == 13) resized = client.picture_size();
    });
    EXPECT_TRUE(captured[0]);
    EXPECT_FALSE(captured[1]);
    EXPECT_TRUE(captured[2]);
    EXPECT_EQ(resized, glm::ivec2(320, 200));
    EXPECT_EQ(cvars()->vid_width, 320);
}

} // namespace
} // namespace vigil::client
