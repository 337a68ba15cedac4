// SPDX-License-Identifier: GPL-2.0-or-later
// The menu by its keys: pages, values, keys of actions; and the lines of scr_stats.
#include "client/client.h"
#include "client/ui/menu_items.h"
#include "client/ui_screen.h"
#include "common/sentence_fault.h"
#include "console/builtin_commands.h"
#include "console/preset.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace vigil::client {
namespace {

using platform::Key;

class MenuTest : public testing::Test {
protected:
    MenuTest() {
        for (const char* name : {"map", "demomap", "quit", "togglemenu", "resolution"})
            commands_.add(name, "", [this, name](CommandArguments arguments) {
                std::string line = name;
                for (const std::string& word : arguments)
                    line += " " + word;
                ran_.push_back(line);
            });
        menu_.open();
    }

    void press(Key key, int times = 1) { screen_.press(key, times); }
    void choose(std::string_view label) {
        press(Key::Home);
        for (size_t i = 0; i < menu_.rows().size() && chosen().label != label; ++i)
            press(Key::Down);
        ASSERT_EQ(chosen().label, label);
    }
    /// From a page of the first page to another.
    void go_to(std::string_view page) {
        if (menu_.title() != "Vigil") press(Key::Escape);
        choose(page);
        press(Key::Enter);
        ASSERT_EQ(menu_.title(), page);
    }
    MenuRow chosen() const { return menu_.rows().at(menu_.chosen()); }

    CvarRegistry variables_;
    CommandRegistry commands_{variables_};
    KeyBindings bindings_;
    std::vector<std::string> ran_;
    UiScreen screen_{commands_, bindings_};
    Menu& menu_ = screen_.menu;
};

TEST_F(MenuTest, EveryItemIsOfAVariableOrCommandThatExists) {
    for (const MenuPage page : {MenuPage::Main, MenuPage::Video, MenuPage::Controls,
                                MenuPage::Research, MenuPage::Quit}) {
        const std::vector<MenuRow> rows = item_rows(page, variables_, {640, 360});
        EXPECT_GE(rows.size(), 2u) << menu_page_title(page);
        for (const MenuRow& row : rows) {
            EXPECT_EQ(test::sentence_fault(row.about), "") << row.label << ": " << row.about;
            EXPECT_LT(row.about.size(), 150u) << row.label; // three lines below the rows
            if (row.more.empty()) continue;
            // All that it offers is taken.
            commands_.execute_text(row.more + "\n" + row.less);
        }
    }
    EXPECT_EQ(commands_.failures(), 0);
    // Every action that a default key has by its own command.
    for (const MenuRow& action : key_rows(bindings_)) {
        bool bound = false;
        for (int i = 0; i < platform::key_count; ++i)
            bound |= bindings_.command(static_cast<Key>(i)) == action.command;
        EXPECT_TRUE(bound || action.command == "noclip" || action.command == "togglemenu")
            << action.command;
    }
}

TEST(Commands, HelpIsPlainEnglish) {
    CvarRegistry variables;
    CommandRegistry all(variables);
    add_builtin_commands(all, {});
    KeyBindings bindings;
    add_binding_commands(all, bindings);
    HeldButtons buttons;
    buttons.add_commands(all);
    for (const CommandGroup& group : command_groups())
        for (const ClientCommand& command : group.commands)
            all.add(command.name, command.help, [](CommandArguments) {});
    for (const auto& [name, command] : all.commands()) {
        const size_t colon = command.help.find(": ");
        ASSERT_NE(colon, std::string::npos) << name;
        EXPECT_EQ(test::sentence_fault(std::string_view(command.help).substr(colon + 2)), "")
            << name << " " << command.help;
    }
    // What keys and the menu run is there.
    const KeyBindings untouched;
    for (int i = 0; i < platform::key_count; ++i) {
        const std::string& line = untouched.command(static_cast<Key>(i));
        if (!line.empty()) {
            EXPECT_TRUE(all.commands().contains(line.substr(0, line.find(' ')))) << line;
        }
    }
    for (const MenuRow& row : key_rows(untouched))
        EXPECT_TRUE(all.commands().contains(row.command.substr(0, row.command.find(' '))))
            << row.command;
}

TEST_F(MenuTest, ChoicesGoRoundAndNumbersEnd) {
    choose("Light sampling");
    EXPECT_EQ(chosen().value, "light cache (vlc)");
    press(Key::Left);
    EXPECT_EQ(variables_.get_text("pt_nee"), "lh");
    press(Key::PadLeft, 2);
    EXPECT_EQ(variables_.get_text("pt_nee"), "brute"); // the last
    press(Key::Enter);                                 // forward, as the right arrow
    EXPECT_EQ(variables_.get_text("pt_nee"), "sll");
    EXPECT_EQ(chosen().about, technique_infos[0].help);

    choose("Denoiser");
    press(Key::Left);
    EXPECT_EQ(variables_->flt_enable, 0);
    EXPECT_EQ(chosen().value, "off");

    go_to("Research");
    choose("Paths per pixel");
    press(Key::Left);
    EXPECT_EQ(variables_->pt_spp, 1);
    press(Key::Right, 3);
    EXPECT_EQ(variables_->pt_spp, 8);
    choose("Compare with");
    EXPECT_EQ(chosen().value, "off");
    press(Key::Right);
    EXPECT_EQ(chosen().value, "unfiltered (raw)");
    press(Key::Right, 2);
    EXPECT_EQ(chosen().value, "sll+cdq");
    EXPECT_EQ(chosen().about, technique_infos[0].help);

    go_to("Video");
    choose("Statistics");
    EXPECT_EQ(chosen().value, "off");
    press(Key::PadA);
    EXPECT_EQ(chosen().value, "groups");
    EXPECT_EQ(variables_->scr_stats, 1);
    choose("Render scale");
    press(Key::Left, 2);
    EXPECT_EQ(chosen().value, "90 %");
    choose("Frame rate goal");
    EXPECT_EQ(chosen().value, "off");
    press(Key::Right, 12);
    EXPECT_EQ(chosen().value, "60 fps");

    go_to("Controls");
    choose("Mouse speed");
    press(Key::Right);
    EXPECT_EQ(variables_->sensitivity, 3.5f);
    EXPECT_TRUE(menu_.is_open());
}

TEST_F(MenuTest, StepsThroughPresetsAndResolutions) {
    go_to("Video");
    choose("Resolution");
    EXPECT_EQ(chosen().value, "640 x 360");
    press(Key::Right);
    press(Key::Left);
    EXPECT_EQ(ran_, (std::vector<std::string>{"resolution 854 480", "resolution 480 270"}));
    const auto size_row = [&](glm::ivec2 size) {
        const std::vector<MenuRow> rows = item_rows(MenuPage::Video, variables_, size);
        return *std::ranges::find(rows, "Resolution", &MenuRow::label);
    };
    EXPECT_EQ(size_row({320, 180}).less, "resolution 320 180");
    EXPECT_EQ(size_row({1000, 700}).less, "resolution 960 540");
    EXPECT_EQ(size_row({1000, 700}).more, "resolution 1280 720");
    EXPECT_EQ(size_row({3840, 2160}).more, "resolution 3840 2160");
    press(Key::Escape);
    choose("Quality");
    EXPECT_EQ(chosen().value, "balanced");
    press(Key::Right);
    EXPECT_EQ(variables_->pt_spp, 4);
    EXPECT_EQ(chosen().value, "accurate");
    press(Key::Right); // round to the first
    EXPECT_EQ(chosen().value, "as in the paper");
    EXPECT_EQ(chosen().about, find_preset("paper")->purpose);
    press(Key::Left, 3);
    EXPECT_EQ(variables_.get_text("pt_preset"), "fast");
    variables_.set("pt_spp", "3"); // of one's own
    EXPECT_EQ(chosen().value, "custom");
    press(Key::Right);
    EXPECT_EQ(chosen().value, "as in the paper");
    variables_.set("pt_spp", "3");
    press(Key::Left);
    EXPECT_EQ(chosen().value, "accurate");
}

TEST_F(MenuTest, LevelsAreLoadedAndDemosMayBeMissing) {
    choose("Levels");
    press(Key::Enter);
    EXPECT_EQ(menu_.title(), "Levels");
    press(Key::Down);
    press(Key::Enter);
    EXPECT_EQ(ran_, std::vector<std::string>{"map two words"}); // one word, in quotes
    EXPECT_FALSE(menu_.is_open());

    menu_.open();
    choose("Demos");
    press(Key::Enter);
    EXPECT_TRUE(menu_.rows().empty());
    press(Key::Down);
    press(Key::Enter);
    press(Key::End);
    EXPECT_TRUE(menu_.is_open());
    press(Key::PadB);
    EXPECT_EQ(menu_.title(), "Vigil");
    EXPECT_EQ(chosen().label, "Demos"); // where one was
    press(Key::Escape);
    EXPECT_FALSE(menu_.is_open());
}

TEST_F(MenuTest, CommandsRunAfterItHasClosed) {
    choose("Quit");
    press(Key::Space);
    EXPECT_EQ(ran_, std::vector<std::string>{"quit"});
    EXPECT_FALSE(menu_.is_open());
}

TEST_F(MenuTest, QuittingByAKeyIsAskedFor) {
    menu_.close();
    menu_.open(MenuPage::Quit);
    EXPECT_EQ(menu_.title(), "Quit Vigil?");
    press(Key::Escape);
    EXPECT_FALSE(menu_.is_open());
    for (const Key no : {Key::N, Key::Down}) { // "Go on"
        menu_.open(MenuPage::Quit);
        press(no);
        if (no == Key::Down) press(Key::Enter);
        EXPECT_FALSE(menu_.is_open());
    }
    EXPECT_TRUE(ran_.empty());
    for (const Key yes : {Key::Y, Key::Enter}) {
        menu_.open(MenuPage::Quit);
        press(yes);
        EXPECT_FALSE(menu_.is_open());
    }
    EXPECT_EQ(ran_, (std::vector<std::string>{"quit", "quit"}));
    menu_.open();
    press(Key::Y); // elsewhere it is no answer
    EXPECT_TRUE(menu_.is_open());
}

TEST_F(MenuTest, KeysAreGivenAndTaken) {
    go_to("Controls");
    choose("Keys");
    press(Key::Enter);
    choose("Jump, up");
    EXPECT_EQ(chosen().value, "e, SPACE, PAD_A");
    press(Key::Enter);
    EXPECT_TRUE(menu_.wants_key());
    screen_.send(platform::KeyEvent{Key::Enter, true, true}); // still held
    EXPECT_TRUE(menu_.wants_key());
    press(Key::Down); // any key, also one that the menu uses
    EXPECT_FALSE(menu_.wants_key());
    EXPECT_EQ(bindings_.command(Key::Down), "+moveup");
    press(Key::Enter);
    press(Key::Escape);
    EXPECT_FALSE(menu_.wants_key());
    EXPECT_EQ(bindings_.command(Key::Escape), "");
    press(Key::Backspace);
    EXPECT_EQ(chosen().value, "");
    EXPECT_EQ(bindings_.command(Key::Space), "");
    EXPECT_EQ(bindings_.command(Key::W), "+forward");
    // The configuration keeps it.
    EXPECT_NE(bindings_.archive_text().find("unbind SPACE"), std::string::npos);
}

TEST_F(MenuTest, TheMousePointsAndClicks) {
    // The rows lie somewhere in the middle of the window, one below the other.
    const auto choose_by_mouse = [&](std::string_view label) {
        for (float y = 0.0f; y < 360.0f && chosen().label != label; y += 1.0f) {
            screen_.point({320.0f, y});
            screen_.draw(0.1);
        }
        ASSERT_EQ(chosen().label, label);
    };
    screen_.draw(0.1);
    screen_.point({320.0f, 180.0f}); // where it appears
    screen_.draw(0.1);
    EXPECT_EQ(menu_.chosen(), 0u);
    choose_by_mouse("Path guiding");
    press(Key::Mouse1);
    EXPECT_EQ(variables_.get_text("pt_guide"), "lobe");
    const size_t guide = menu_.chosen();
    screen_.point({2.0f, 180.0f}); // beside it
    screen_.draw(0.1);
    EXPECT_EQ(menu_.chosen(), guide);
    press(Key::Mouse1);
    EXPECT_EQ(variables_.get_text("pt_guide"), "lobe");
    choose_by_mouse("Denoiser");
    EXPECT_EQ(menu_.chosen(), guide + 1);
    press(Key::Mouse2);
    EXPECT_FALSE(menu_.is_open());
    // A click chooses what it hits, also where the mouse has not moved.
    menu_.open();
    choose_by_mouse("Path guiding");
    press(Key::Home);
    press(Key::Mouse1);
    EXPECT_EQ(menu_.chosen(), guide);
    EXPECT_EQ(variables_.get_text("pt_guide"), "brdf");
    // A page is opened by a click; what lies under the mouse then is not chosen by itself.
    choose_by_mouse("Controls");
    press(Key::Mouse1);
    choose_by_mouse("Keys");
    press(Key::Mouse1);
    EXPECT_EQ(menu_.title(), "Keys");
    screen_.draw(0.1);
    EXPECT_EQ(menu_.chosen(), 0u);
    // A mouse button is a key that an action can have.
    press(Key::Enter);
    press(Key::Mouse1);
    EXPECT_EQ(bindings_.command(Key::Mouse1), "+forward");
}

TEST_F(MenuTest, SmallWindowsShowThePartWithTheChoice) {
    screen_.size = {160, 90};
    const size_t last = menu_.rows().size() - 1;
    press(Key::End);
    screen_.draw(0.1);
    screen_.point({80.0f, 30.0f});
    screen_.draw(0.1);
    screen_.point({80.0f, 40.0f});
    screen_.draw(0.1);
    EXPECT_GT(menu_.chosen(), last - 5);
    for (const glm::ivec2 size : {glm::ivec2(1, 1), {20, 10}, {3840, 2160}}) {
        screen_.size = size;
        EXPECT_NE(screen_.draw(0.1), nullptr);
        press(Key::Up);
    }
    EXPECT_TRUE(menu_.is_open());
}

TEST_F(MenuTest, TheChoiceGoesRound) {
    press(Key::Up);
    EXPECT_EQ(menu_.chosen(), menu_.rows().size() - 1);
    press(Key::WheelDown);
    EXPECT_EQ(menu_.chosen(), 0u);
    press(Key::PageDown, 5);
    EXPECT_EQ(menu_.chosen(), menu_.rows().size() - 1);
}

std::vector<refresh::PassTime> times_of(double tracing, double preparation, double other) {
    return {{"primary", tracing / 2, refresh::PassGroup::PathTracing},
            {"direct", tracing / 2, refresh::PassGroup::PathTracing},
            {"guide_adapt", preparation, refresh::PassGroup::Preparation},
            {"tonemap", other, refresh::PassGroup::Other}};
}

double sum_of(const std::vector<refresh::PassTime>& passes, refresh::PassGroup group) {
    double sum = 0.0;
    for (const refresh::PassTime& pass : passes)
        if (pass.group == group) sum += pass.milliseconds;
    return sum;
}

TEST(PassStatistics, RecentMeansAreOverTheLastFrames) {
    PassStatistics recent;
    EXPECT_TRUE(recent.recent_means(30).empty());
    recent.add_frame({}); // a device without timestamps
    EXPECT_TRUE(recent.recent_means(30).empty());
    for (int i = 0; i < 10; ++i)
        recent.add_frame(times_of(1000, 1000, 1000)); // long ago
    for (size_t i = 0; i < 30; ++i)
        recent.add_frame(i % 2 == 0 ? times_of(10, 2, 1) : times_of(20, 4, 3));
    const std::vector<refresh::PassTime> means = recent.recent_means(30);
    EXPECT_NEAR(sum_of(means, refresh::PassGroup::PathTracing), 15.0, 1e-9);
    EXPECT_NEAR(sum_of(means, refresh::PassGroup::Preparation), 3.0, 1e-9);
    EXPECT_NEAR(sum_of(means, refresh::PassGroup::Other), 2.0, 1e-9);
    ASSERT_EQ(means.size(), 4u);
    EXPECT_EQ(means[1].name, "direct");
    EXPECT_NEAR(means[1].milliseconds, 7.5, 1e-9);
}

TEST(ScreenStats, SaysWhatAPlayerWantsToKnowTwiceASecond) {
    CvarRegistry variables;
    PassStatistics recent;
    recent.add_frame(times_of(10, 2, 1));
    ScreenStats stats;
    EXPECT_TRUE(stats.lines().empty());
    stats.add_frame(0.020, recent, variables, {640, 360});
    ASSERT_EQ(stats.lines().size(), 7u);
    EXPECT_EQ(stats.lines()[0], "20.0 ms  50.0 fps");
    EXPECT_EQ(stats.lines()[1], "path tracing       10.0 ms");
    EXPECT_EQ(stats.lines()[5], "vlc+cdq");
    EXPECT_EQ(stats.lines()[6], "640 x 360, 1 path per pixel");
    variables.set("pt_compare", "sll");
    variables.set("pt_spp", "4");
    for (int i = 0; i < 12; ++i) // 0.48 s: not yet
        stats.add_frame(0.040, recent, variables, {1280, 720});
    EXPECT_EQ(stats.lines()[5], "vlc+cdq");
    stats.add_frame(0.040, recent, variables, {1280, 720});
    EXPECT_EQ(stats.lines()[0], "40.0 ms  25.0 fps");
    EXPECT_EQ(stats.lines()[5], "vlc+cdq | sll");
    EXPECT_EQ(stats.lines()[6], "1280 x 720, 4 paths per pixel");
    variables.set("scr_stats", "passes");
    for (int i = 0; i < 13; ++i)
        stats.add_frame(0.040, recent, variables, {1280, 720});
    ASSERT_EQ(stats.lines().size(), 11u);
    EXPECT_EQ(stats.lines()[3], "  direct            5.0 ms");
}

} // namespace
} // namespace vigil::client
