// SPDX-License-Identifier: GPL-2.0-or-later
// The console as its user meets it: editing, history, completion, scroll-back.
#include "client/ui_screen.h"
#include "common/log.h"
#include "test_game.h"

#include <gtest/gtest.h>

namespace vigil::client {
namespace {

using platform::Key;

TEST(CommandHistory, WalksBackAndReturnsWhatWasBeingTyped) {
    CommandHistory history;
    history.add("one");
    history.add("two");
    history.add("two"); // repeated lines are kept once
    history.add("");
    EXPECT_EQ(history.lines().size(), 2u);
    EXPECT_EQ(history.older("typ"), "two");
    EXPECT_EQ(history.older("two"), "one");
    EXPECT_EQ(history.older("one"), "one");
    EXPECT_EQ(history.newer("one"), "two");
    EXPECT_EQ(history.newer("two"), "typ");
    EXPECT_EQ(history.newer("typ"), "typ");
}

TEST(CommandHistory, SurvivesAsAFileAndForgetsTheOldest) {
    const TestGame game;
    CommandHistory history;
    for (size_t i = 0; i < CommandHistory::capacity + 5; ++i)
        history.add(std::to_string(i));
    history.save(game.path("cache/history"));
    CommandHistory again;
    again.load(game.path("cache/history"));
    EXPECT_EQ(again.lines(), history.lines());
    EXPECT_EQ(again.lines().front(), "5");
    EXPECT_NO_THROW(again.load(game.path("cache/none")));
}

class ConsoleTest : public testing::Test {
protected:
    ConsoleTest() {
        commands_.add(
            "map", "NAME: loads",
            [this](CommandArguments arguments) { ran_ = arguments.empty() ? "?" : arguments[0]; },
            [](CommandArguments) {
                return std::vector<std::string>{"mine", "minor", "ring"};
            });
        commands_.add("maps", ": lists", [](CommandArguments) {});
        press(Key::Grave);
    }

    void press(Key key, int times = 1) { screen_.press(key, times); }
    void ctrl(Key key) { screen_.press_with(Key::Ctrl, key); }
    void type(const std::string& text) { screen_.type(text); }
    std::string_view line() const { return console_.input(); }

    CvarRegistry variables_;
    CommandRegistry commands_{variables_};
    KeyBindings bindings_;
    std::string ran_;
    std::string clipboard_ = "from elsewhere";
    UiScreen screen_{
        commands_,
        bindings_,
        {[this] { return clipboard_; }, [this](const std::string& text) { clipboard_ = text; }}};
    Console& console_ = screen_.console;
};

TEST_F(ConsoleTest, EditsWholeCharactersAndWords) {
    type("map h\xc3\xb6hle two");
    ctrl(Key::W);
    EXPECT_EQ(line(), "map h\xc3\xb6hle ");
    ctrl(Key::Left);
    EXPECT_EQ(console_.cursor(), 4u);
    press(Key::Right);
    press(Key::Delete); // the two bytes of one letter
    EXPECT_EQ(line(), "map hhle ");
    ctrl(Key::U);
    EXPECT_EQ(line(), "hle ");
    ctrl(Key::E);
    press(Key::Backspace);
    ctrl(Key::Backspace);
    EXPECT_EQ(line(), "");
    type("one two");
    ctrl(Key::A);
    type("x");
    EXPECT_EQ(line(), "xone two");
    press(Key::Home);
    ctrl(Key::K);
    EXPECT_EQ(line(), "");
    press(Key::Backspace);
    press(Key::Delete);
    press(Key::Left);
    EXPECT_EQ(console_.cursor(), 0u);
}

TEST_F(ConsoleTest, PastedLinesBecomeOneLine) {
    clipboard_ = "echo a\r\necho\tb\x01";
    ctrl(Key::V);
    EXPECT_EQ(line(), "echo a echo b");
}

TEST_F(ConsoleTest, WhatWasTypedStaysWhileItIsClosed) {
    type("map ri");
    press(Key::Grave);
    EXPECT_FALSE(console_.is_open());
    type("nobody listens");
    press(Key::Grave);
    type("ng");
    EXPECT_EQ(line(), "map ring");
}

TEST_F(ConsoleTest, AClickElsewhereLeavesItTheKeyboard) {
    type("map");
    screen_.draw(1.0);
    screen_.point({300.0f, 300.0f});
    press(Key::Mouse1);
    type(" ring");
    press(Key::Enter);
    EXPECT_EQ(ran_, "ring");
}

TEST_F(ConsoleTest, EnterRunsTheLineAndEchoesIt) {
    type("map ring");
    press(Key::Enter);
    EXPECT_EQ(ran_, "ring");
    EXPECT_EQ(line(), "");
    ASSERT_FALSE(console_.lines().empty());
    EXPECT_EQ(console_.lines().back().text, "]map ring");
    press(Key::Up);
    EXPECT_EQ(line(), "map ring");
    press(Key::Down);
    EXPECT_EQ(line(), "");
    type("map mine");
    press(Key::KeypadEnter);
    EXPECT_EQ(ran_, "mine");
}

TEST_F(ConsoleTest, TabExtendsThenWalksThroughTheCandidates) {
    type("map m");
    press(Key::Tab);
    EXPECT_EQ(line(), "map min");
    ASSERT_EQ(console_.suggestions().size(), 2u);
    press(Key::Tab);
    EXPECT_EQ(line(), "map mine");
    press(Key::Tab);
    EXPECT_EQ(line(), "map minor");
    press(Key::Tab);
    EXPECT_EQ(line(), "map mine");
    screen_.press_with(Key::Shift, Key::Tab);
    EXPECT_EQ(line(), "map minor");
    // Typing goes on from the chosen word.
    type("x");
    EXPECT_EQ(line(), "map minorx");
    EXPECT_EQ(console_.chosen_suggestion(), -1);
}

TEST_F(ConsoleTest, TabFinishesAnOnlyCandidateWithASpace) {
    type("map r");
    press(Key::Tab);
    EXPECT_EQ(line(), "map ring ");
    ctrl(Key::U);
    type("pt_sp");
    press(Key::Tab);
    EXPECT_EQ(line(), "pt_spp ");
    ctrl(Key::U);
    type("no_such_thing");
    press(Key::Tab);
    EXPECT_EQ(line(), "no_such_thing");
}

TEST_F(ConsoleTest, CompletionReplacesOnlyTheWordBeforeTheCursor) {
    type("map r tail");
    press(Key::Left, 5);
    press(Key::Tab);
    EXPECT_EQ(line(), "map ring  tail");
    EXPECT_EQ(console_.cursor(), 9u);
}

TEST_F(ConsoleTest, SuggestionsTellWhatTheyAre) {
    type("map");
    ASSERT_GE(console_.suggestions().size(), 2u);
    EXPECT_EQ(console_.suggestions()[0].word, "map");
    EXPECT_EQ(console_.suggestions()[0].about, "NAME: loads");
    ctrl(Key::U);
    EXPECT_TRUE(console_.suggestions().empty());
    variables_.set("pt_nee", "uniform");
    type("pt_ne");
    ASSERT_EQ(console_.suggestions().size(), 1u);
    EXPECT_TRUE(console_.suggestions()[0].about.starts_with("= uniform"));
    press(Key::Up);
    EXPECT_TRUE(console_.suggestions().empty());
}

TEST_F(ConsoleTest, KeepsLogLinesWithTheirSeverity) {
    log_warning("low on light");
    log_error("first\nsecond");
    console_.update(2.5);
    ASSERT_EQ(console_.lines().size(), 3u);
    EXPECT_EQ(console_.lines()[0].severity, Severity::Warning);
    EXPECT_EQ(console_.lines()[0].time_s, 2.5);
    EXPECT_EQ(console_.lines()[2].text, "second");
    for (size_t i = 0; i < Console::line_capacity + 10; ++i)
        log_info("{}", i);
    console_.update(3.0);
    EXPECT_EQ(console_.lines().size(), Console::line_capacity);
}

TEST_F(ConsoleTest, ScrolledTextStaysInPlaceWhileLinesArrive) {
    for (int i = 0; i < 50; ++i)
        log_info("{}", i);
    screen_.draw(1.0);
    screen_.draw(0.1); // the lines have been laid out
    EXPECT_TRUE(console_.shows_newest());
    press(Key::PageUp);
    EXPECT_FALSE(console_.shows_newest());
    log_info("new");
    screen_.draw(0.1);
    screen_.draw(0.1);
    EXPECT_FALSE(console_.shows_newest());
    press(Key::PageDown);
    EXPECT_FALSE(console_.shows_newest()) << "a line more has come";
    ctrl(Key::End);
    EXPECT_TRUE(console_.shows_newest());
    screen_.send(platform::WheelEvent{0.5f});
    screen_.send(platform::WheelEvent{0.5f});
    screen_.draw(0.1);
    EXPECT_FALSE(console_.shows_newest());
    press(Key::Enter); // what is typed is seen
    EXPECT_TRUE(console_.shows_newest());
    ctrl(Key::Home);
    EXPECT_FALSE(console_.shows_newest());
    press(Key::Grave, 2);
    EXPECT_TRUE(console_.shows_newest());
    ctrl(Key::L);
    EXPECT_TRUE(console_.lines().empty());
}

TEST_F(ConsoleTest, CopiesAndPastes) {
    ctrl(Key::V);
    EXPECT_EQ(line(), "from elsewhere");
    type("!");
    ctrl(Key::C);
    EXPECT_EQ(clipboard_, "from elsewhere!");
}

TEST_F(ConsoleTest, IsDrawnAtAnySizeAndNotWhereThereIsNothingToSee) {
    for (int i = 0; i < 100; ++i)
        log_info("a line that is far too long for small windows, so that it goes on below {}", i);
    type("pt_");
    for (const glm::ivec2 size : {glm::ivec2(1, 1), {8, 6}, {160, 90}, {320, 180}, {3840, 2160}}) {
        screen_.size = size;
        for (int i = 0; i < 3; ++i)
            EXPECT_NE(screen_.draw(0.5), nullptr);
        press(Key::Tab);
    }
    EXPECT_NE(console_.chosen_suggestion(), -1);
    screen_.size = {640, 360};
    press(Key::Grave);
    EXPECT_NE(screen_.draw(0.1), nullptr) << "it slides";
    log_info("news");
    EXPECT_NE(screen_.draw(1.0), nullptr) << "notices stay";
    EXPECT_EQ(screen_.draw(5.0), nullptr);
    screen_.stats = {"1 fps"};
    EXPECT_NE(screen_.draw(0.1), nullptr);
}

} // namespace
} // namespace vigil::client
