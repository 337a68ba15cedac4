// SPDX-License-Identifier: GPL-2.0-or-later
// Keys, bindings and where events go.
#include "client/client.h"
#include "client/ui_screen.h"
#include "console/builtin_commands.h"

#include <gtest/gtest.h>

#include <set>

namespace vigil::client {
namespace {

using namespace platform;

TEST(Keys, EveryKeyHasOneNameThatFindsIt) {
    std::set<std::string_view> names;
    for (int i = 1; i < key_count; ++i) {
        const Key key = static_cast<Key>(i);
        EXPECT_FALSE(key_name(key).empty()) << i;
        EXPECT_EQ(key_from_name(key_name(key)), key) << key_name(key);
        EXPECT_TRUE(names.insert(key_name(key)).second) << key_name(key);
    }
    EXPECT_EQ(key_from_name("uparrow"), Key::Up);
    EXPECT_EQ(key_from_name(";"), Key::Semicolon);
    EXPECT_FALSE(key_from_name(""));
    EXPECT_FALSE(key_from_name("nokey"));
}

TEST(Window, HeadlessOpensNone) {
    EXPECT_EQ(open_window("headless", {}), nullptr);
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    EXPECT_FALSE(wants_window("auto"));
    EXPECT_TRUE(wants_window("sdl"));
    EXPECT_EQ(open_window("auto", {}), nullptr);
}

TEST(KeyBindings, HeldCommandsNameTheirKey) {
    KeyBindings bindings;
    bindings.bind(Key::X, "+forward");
    EXPECT_EQ(bindings.press(Key::X).text, "+forward x");
    bindings.bind(Key::X, "viewpos"); // bound anew while held
    EXPECT_EQ(bindings.release(Key::X).text, "-forward x");
    EXPECT_EQ(bindings.press(Key::X).text, "viewpos");
    EXPECT_EQ(bindings.release(Key::X).text, "");
}

TEST(KeyBindings, ArchiveHoldsOnlyWhatChanged) {
    KeyBindings bindings;
    EXPECT_EQ(bindings.archive_text(), "");
    bindings.bind(Key::F5, "map mine; wait 2");
    bindings.bind(Key::W, "");
    const std::string text = bindings.archive_text();

    CvarRegistry variables;
    CommandRegistry commands(variables);
    KeyBindings other;
    add_binding_commands(commands, other);
    commands.execute_text(text);
    EXPECT_EQ(commands.failures(), 0);
    EXPECT_EQ(other.command(Key::F5), "map mine; wait 2");
    EXPECT_EQ(other.command(Key::W), "");
    EXPECT_EQ(other.archive_text(), text);
}

TEST(KeyBindings, WhatAnArchiveBindsRunsAsItsOwnAndIsNotKept) {
    CvarRegistry variables;
    CommandRegistry commands(variables);
    add_builtin_commands(commands, [](std::string_view) { return ScriptText(); });
    KeyBindings bindings;
    add_binding_commands(commands, bindings);
    commands.execute_text("bind F5 viewpos; unbind q");
    const std::string kept = bindings.archive_text();
    commands.execute_text("bind F5 \"set vid_width 320\"; bind x \"+set vid_height 99; +set\"; "
                          "unbind w; bind q \"set fov 100\"",
                          "default.cfg", Trust::Archive);
    EXPECT_EQ(commands.failures(), 0);
    EXPECT_EQ(bindings.archive_text(), kept);
    EXPECT_EQ(bindings.command(Key::W), "");
    const auto run = [&](const ScriptText& script) {
        commands.execute_text(script.text, {}, script.trust);
    };
    run(bindings.press(Key::F5));
    run(bindings.press(Key::Q));
    bindings.press(Key::X);
    EXPECT_EQ(bindings.release_all().trust, Trust::Archive);
    EXPECT_EQ(variables->vid_width, 640);
    EXPECT_EQ(variables->fov, 100.0f);
    bindings.bind(Key::F5, "set vid_width 320"); // by a person
    run(bindings.press(Key::F5));
    EXPECT_EQ(variables->vid_width, 320);
}

TEST(KeyBindings, CommandsReportKeysThatDoNotExist) {
    CvarRegistry variables;
    CommandRegistry commands(variables);
    KeyBindings bindings;
    add_binding_commands(commands, bindings);
    commands.execute_text("bind w echo hi\nbind nokey quit\nunbind q\nbindlist");
    EXPECT_EQ(commands.failures(), 1);
    EXPECT_EQ(bindings.command(Key::W), "echo hi");
    EXPECT_EQ(bindings.command(Key::Q), "");
}

class InputTest : public testing::Test {
protected:
    InputTest() { buttons_.add_commands(commands_); }

    void key(Key key, bool down, bool repeat = false) { send(KeyEvent{key, down, repeat}); }
    void send(const Event& event) { screen_.send(event); }

    CvarRegistry variables_;
    CommandRegistry commands_{variables_};
    KeyBindings bindings_;
    HeldButtons buttons_;
    UiScreen screen_{commands_, bindings_};
    Console& console_ = screen_.console;
    Camera& camera_ = screen_.camera;
    Menu& menu_ = screen_.menu;
    Input& input_ = screen_.input;
};

TEST_F(InputTest, AHeldKeyFliesUntilItComesUp) {
    key(Key::W, true);
    EXPECT_EQ(buttons_.take_frame().forward, 1.0f);
    key(Key::W, true, true); // auto-repeat changes nothing
    key(Key::Up, true);      // a second key for the same command
    key(Key::W, false);
    EXPECT_EQ(buttons_.take_frame().forward, 1.0f);
    key(Key::Up, false);
    EXPECT_EQ(buttons_.take_frame().forward, 0.0f);
}

TEST_F(InputTest, AShortPressWithinOneFrameStillMoves) {
    key(Key::D, true);
    key(Key::D, false);
    EXPECT_EQ(buttons_.take_frame().right, 0.5f);
    EXPECT_EQ(buttons_.take_frame().right, 0.0f);
}

TEST_F(InputTest, TheConsoleTakesKeysAndTextWhileOpen) {
    key(Key::W, true);
    key(Key::Grave, true);
    send(TextEvent{"`"}); // typed by the key that opens the console
    key(Key::Grave, false);
    EXPECT_TRUE(console_.is_open());
    send(TextEvent{"ec"});
    key(Key::W, false); // the key held before must not be stuck
    EXPECT_EQ(buttons_.take_frame().forward, 0.5f - 0.5f + 0.5f);
    EXPECT_EQ(buttons_.take_frame().forward, 0.0f);
    EXPECT_EQ(console_.input(), "ec");
    key(Key::S, true);
    EXPECT_EQ(buttons_.take_frame().forward, 0.0f);
    key(Key::Escape, true);
    EXPECT_FALSE(console_.is_open());
}

TEST_F(InputTest, EscapeClosesTheConsoleAndThenOpensTheMenu) {
    key(Key::Grave, true);
    key(Key::Escape, true);
    EXPECT_FALSE(console_.is_open());
    EXPECT_FALSE(menu_.is_open());
    key(Key::Escape, true, true); // held too long
    EXPECT_FALSE(menu_.is_open());
    key(Key::Escape, true);
    EXPECT_TRUE(menu_.is_open());
    key(Key::W, true); // moves nobody
    EXPECT_EQ(buttons_.take_frame().forward, 0.0f);
    key(Key::Escape, true);
    EXPECT_FALSE(menu_.is_open());
    // The console takes the menu's place.
    key(Key::Escape, true);
    key(Key::Grave, true);
    EXPECT_TRUE(console_.is_open());
    EXPECT_FALSE(menu_.is_open());
}

TEST_F(InputTest, SticksStandWhereTheControllerSaysUntilTheWindowLosesTheKeyboard) {
    send(StickEvent{StickEvent::Stick::Left, {0.25f, 1.0f}});
    send(StickEvent{StickEvent::Stick::Right, {-1.0f, 0.0f}});
    EXPECT_EQ(input_.stick_move(), glm::vec2(0.25f, 1.0f));
    EXPECT_EQ(input_.stick_look(), glm::vec2(-1.0f, 0.0f));
    send(FocusEvent{false});
    EXPECT_EQ(input_.stick_move(), glm::vec2(0.0f));
    EXPECT_EQ(input_.stick_look(), glm::vec2(0.0f));
}

TEST_F(InputTest, TheStickStepsThroughTheMenuOncePerPush) {
    menu_.open();
    for (const float y : {-0.2f, -0.6f, -0.9f, -0.6f, 0.0f, -1.0f})
        send(StickEvent{StickEvent::Stick::Left, {0.0f, y}});
    EXPECT_EQ(menu_.chosen(), 2u);
    send(StickEvent{StickEvent::Stick::Left, {0.0f, 1.0f}});
    EXPECT_EQ(menu_.chosen(), 1u);
}

TEST_F(InputTest, TheMouseMovesTheLineWhileItIsDragged) {
    input_.set_dragging(true);
    send(MouseMoveEvent{{}, {10.0f, 5.0f}}); // nothing is compared
    EXPECT_EQ(input_.take_drag(), 0.0f);
    EXPECT_NE(camera_.angles().y, 0.0f);
    const glm::vec3 angles = camera_.angles();
    variables_.set("pt_compare", "sll");
    send(MouseMoveEvent{{}, {10.0f, 5.0f}});
    send(MouseMoveEvent{{}, {-4.0f, 0.0f}});
    EXPECT_EQ(input_.take_drag(), 6.0f);
    EXPECT_EQ(input_.take_drag(), 0.0f);
    EXPECT_EQ(camera_.angles(), angles);
    input_.set_dragging(false);
    send(MouseMoveEvent{{}, {10.0f, 5.0f}});
    EXPECT_NE(camera_.angles(), angles);
}

TEST_F(InputTest, FastTypingWithinOneFrameStaysInOrder) {
    console_.set_open(true);
    send(TextEvent{"echo ab"});
    key(Key::Backspace, true);
    key(Key::Backspace, false);
    send(TextEvent{"c"});
    key(Key::Enter, true);
    key(Key::Enter, false);
    console_.update(0.0);
    EXPECT_EQ(console_.history().lines().back(), "echo ac");
}

TEST_F(InputTest, ControlLettersEditInsteadOfTyping) {
    console_.set_open(true);
    send(TextEvent{"one two"});
    key(Key::Ctrl, true);
    key(Key::W, true);
    send(TextEvent{"w"}); // some systems report the letter as well
    key(Key::W, false);
    key(Key::Ctrl, false);
    EXPECT_EQ(console_.input(), "one ");
}

TEST_F(InputTest, LosingTheKeyboardReleasesEverything) {
    key(Key::W, true);
    key(Key::Shift, true);
    (void)buttons_.take_frame();
    send(FocusEvent{false});
    EXPECT_FALSE(input_.focused());
    const FlightInput held = buttons_.take_frame();
    EXPECT_EQ(held.forward, 0.0f);
    EXPECT_FALSE(held.fast);
}

TEST_F(InputTest, TheMouseTurnsTheViewAsInQuake) {
    variables_.set("sensitivity", "1");
    send(MouseMoveEvent{{}, {100.0f, 50.0f}});
    EXPECT_NEAR(camera_.angles().y, -2.2f, 1e-4f);
    EXPECT_NEAR(camera_.angles().x, 1.1f, 1e-4f);
    send(MouseMoveEvent{{}, {0.0f, 1e6f}});
    EXPECT_EQ(camera_.angles().x, 90.0f); // not over the top
    console_.set_open(true);
    send(MouseMoveEvent{{}, {0.0f, -100.0f}});
    EXPECT_EQ(camera_.angles().x, 90.0f);
}

TEST_F(InputTest, ClosingIsAskedForOnce) {
    EXPECT_FALSE(input_.close_requested());
    send(CloseEvent{});
    EXPECT_TRUE(input_.close_requested());
}

} // namespace
} // namespace vigil::client
