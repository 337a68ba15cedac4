// SPDX-License-Identifier: GPL-2.0-or-later
// The menu: levels, demos, and what a player may want to change, without a console. Each page is
// rows (menu_items.h) in a window of Dear ImGui, one of them chosen by keyboard, mouse or game
// controller.
#pragma once

#include "client/ui/menu_items.h"
#include "console/command.h"
#include "platform/key.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vigil::client {

/// What the menu shows and changes; all must outlive it.
struct MenuParts {
    CommandRegistry& commands;
    KeyBindings& bindings;
    std::function<std::vector<std::string>()> levels; ///< names for `map`
    std::function<std::vector<std::string>()> demos;  ///< names for `demomap`
    std::function<glm::ivec2()> picture_size;         ///< pixels
};

class Menu {
public:
    explicit Menu(MenuParts parts) : parts_(std::move(parts)) {}

    bool is_open() const { return !pages_.empty(); }
    /// Opens on a page; what leaves it closes the menu.
    void open(MenuPage page = MenuPage::Main);
    void close();

    /// A key went down (`repeat`: is held). Not to be called while it is closed.
    void key(platform::Key key, bool repeat);
    /// Draws it into the middle of the current ImGui frame, and lets the mouse choose.
    void draw();
    /// Does what was clicked in the last frame, if anything.
    void run_clicked();

    std::string_view title() const { return menu_page_title(pages_.back().kind); }
    std::vector<MenuRow> rows() const;
    size_t chosen() const { return pages_.back().chosen; }
    /// Waits for the key that the chosen row shall have.
    bool wants_key() const { return wants_key_; }

private:
    struct Page {
        MenuPage kind = MenuPage::Main;
        std::vector<std::string> names{}; // of levels and demos
        size_t chosen = 0;
    };

    void open_page(MenuPage kind);
    void move(int rows);
    void enter();
    void bind_chosen(platform::Key key);
    void unbind_chosen();
    void draw_rows(const std::vector<MenuRow>& rows);

    MenuParts parts_;
    std::vector<Page> pages_; // the one that is shown last
    bool wants_key_ = false;
    bool moved_ = false; // by keys, since it was drawn
    std::optional<size_t> clicked_;
};

} // namespace vigil::client
