// SPDX-License-Identifier: GPL-2.0-or-later
// The console as its user meets it: editing, history, completion, scroll-back.
#include "client/ui/console.h"

#include "common/log.h"
#include "test_game.h"

#include <gtest/gtest.h>

namespace vigil::client {
namespace {

using platform::Key;

TEST(LineEditor, EditsWholeCharactersAndWords) {
    LineEditor line;
    line.insert("map h\xc3\xb6hle two");
    line.erase_back(EditUnit::Word);
    EXPECT_EQ(line.text(), "map h\xc3\xb6hle ");
    line.move_left(EditUnit::Word);
    EXPECT_EQ(line.cursor(), 4u);
    line.move_right(EditUnit::Character);
    line.erase_forward(EditUnit::Character); // the two bytes of one letter
    EXPECT_EQ(line.text(), "map hhle ");
    line.erase_to_start();
    EXPECT_EQ(line.text(), "hle ");
    line.move_end();
    line.erase_back(EditUnit::Character);
    line.move_home();
    line.erase_to_end();
    EXPECT_EQ(line.text(), "");
    line.erase_back(EditUnit::Word);
    line.erase_forward(EditUnit::Word);
    line.move_left(EditUnit::Character);
    EXPECT_EQ(line.cursor(), 0u);
}

TEST(LineEditor, PastedLinesBecomeOneLine) {
    LineEditor line;
    line.insert("echo a\r\necho\tb\x01");
    EXPECT_EQ(line.text(), "echo a echo b");
}

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
        console_.set_open(true);
    }

    void press(Key key, bool ctrl = false, bool shift = false) { console_.key(key, ctrl, shift); }

    CvarRegistry variables_;
    CommandRegistry commands_{variables_};
    std::string ran_;
    std::string clipboard_ = "from elsewhere";
    Console console_{
        commands_,
        {[this] { return clipboard_; }, [this](const std::string& text) { clipboard_ = text; }}};
};

TEST_F(ConsoleTest, EnterRunsTheLineAndEchoesIt) {
    console_.text("map ring");
    press(Key::Enter);
    EXPECT_EQ(ran_, "ring");
    EXPECT_EQ(console_.input().text(), "");
    ASSERT_FALSE(console_.lines().empty());
    EXPECT_EQ(console_.lines().back().text, "]map ring");
    press(Key::Up);
    EXPECT_EQ(console_.input().text(), "map ring");
    press(Key::Down);
    EXPECT_EQ(console_.input().text(), "");
}

TEST_F(ConsoleTest, TabExtendsThenWalksThroughTheCandidates) {
    console_.text("map m");
    press(Key::Tab);
    EXPECT_EQ(console_.input().text(), "map min");
    ASSERT_EQ(console_.suggestions().size(), 2u);
    press(Key::Tab);
    EXPECT_EQ(console_.input().text(), "map mine");
    press(Key::Tab);
    EXPECT_EQ(console_.input().text(), "map minor");
    press(Key::Tab);
    EXPECT_EQ(console_.input().text(), "map mine");
    press(Key::Tab, false, true);
    EXPECT_EQ(console_.input().text(), "map minor");
    // Typing goes on from the chosen word.
    console_.text("x");
    EXPECT_EQ(console_.input().text(), "map minorx");
    EXPECT_EQ(console_.chosen_suggestion(), -1);
}

TEST_F(ConsoleTest, TabFinishesAnOnlyCandidateWithASpace) {
    console_.text("map r");
    press(Key::Tab);
    EXPECT_EQ(console_.input().text(), "map ring ");
    console_.key(Key::U, true, false);
    console_.text("pt_sp");
    press(Key::Tab);
    EXPECT_EQ(console_.input().text(), "pt_spp ");
    console_.key(Key::U, true, false);
    console_.text("no_such_thing");
    press(Key::Tab);
    EXPECT_EQ(console_.input().text(), "no_such_thing");
}

TEST_F(ConsoleTest, CompletionReplacesOnlyTheWordBeforeTheCursor) {
    console_.text("map r tail");
    for (int i = 0; i < 5; ++i)
        press(Key::Left);
    press(Key::Tab);
    EXPECT_EQ(console_.input().text(), "map ring  tail");
    EXPECT_EQ(console_.input().cursor(), 9u);
}

TEST_F(ConsoleTest, SuggestionsTellWhatTheyAre) {
    console_.text("map");
    ASSERT_GE(console_.suggestions().size(), 2u);
    EXPECT_EQ(console_.suggestions()[0].word, "map");
    EXPECT_EQ(console_.suggestions()[0].about, "NAME: loads");
    console_.key(Key::U, true, false);
    EXPECT_TRUE(console_.suggestions().empty());
    variables_.set("pt_nee", "uniform");
    console_.text("pt_ne");
    ASSERT_EQ(console_.suggestions().size(), 1u);
    EXPECT_TRUE(console_.suggestions()[0].about.starts_with("= uniform"));
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
    console_.update(0.0);
    press(Key::PageUp);
    const size_t scrolled = console_.scrolled();
    EXPECT_GT(scrolled, 0u);
    log_info("new");
    console_.update(0.1);
    EXPECT_EQ(console_.scrolled(), scrolled + 1);
    console_.scroll(1000);
    EXPECT_LT(console_.scrolled(), console_.lines().size());
    console_.scroll(-1000);
    EXPECT_EQ(console_.scrolled(), 0u);
}

TEST_F(ConsoleTest, CopiesAndPastes) {
    press(Key::V, true);
    EXPECT_EQ(console_.input().text(), "from elsewhere");
    console_.text("!");
    press(Key::C, true);
    EXPECT_EQ(clipboard_, "from elsewhere!");
}

} // namespace
} // namespace vigil::client
