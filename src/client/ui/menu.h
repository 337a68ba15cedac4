// SPDX-License-Identifier: GPL-2.0-or-later
// The menu: levels, demos, and what a player may want to change, without a console. It is one table
// of items (menu_items.cpp); each page is rows of text with one of them chosen, moved by keyboard,
// mouse or game controller. menu_view.h draws it.
#pragma once

#include "client/ui/key_bindings.h"
#include "console/command.h"
#include "platform/key.h"

#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
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

/// A line of a page.
struct MenuRow {
    std::string label;
    std::string value;   ///< beside the label; may be empty
    bool steps = false;  ///< left and right change the value
    std::string about{}; ///< a sentence on what is chosen
};

/// Where a row was drawn, in pixels.
struct MenuPlace {
    size_t row = 0;
    glm::vec2 low{0.0f};
    glm::vec2 high{0.0f};
};

class Menu {
public:
    explicit Menu(MenuParts parts);

    bool is_open() const { return !pages_.empty(); }
    /// Opens on the first page.
    void open();
    void close();

    /// A key went down (`repeat`: is held). Not to be called while it is closed.
    void key(platform::Key key, bool repeat);
    /// The mouse went to this place, in pixels. The first place after open() is where it appears,
    /// and chooses nothing.
    void point(glm::vec2 place);
    /// Where the rows are, after they were drawn.
    void set_places(std::vector<MenuPlace> places) { places_ = std::move(places); }

    std::string title() const;
    std::vector<MenuRow> rows() const;
    size_t chosen() const { return pages_.back().chosen; }
    /// Waits for the key that the chosen row shall have.
    bool wants_key() const { return wants_key_; }
    /// The first row that was drawn last, so that a long page scrolls no more than it must.
    size_t first_shown() const { return places_.empty() ? 0 : places_.front().row; }

private:
    enum class PageKind { Main, Levels, Demos, Keys };
    struct Page {
        PageKind kind = PageKind::Main;
        std::vector<std::string> names{}; // of levels and demos
        size_t chosen = 0;
    };

    void open_page(PageKind kind);
    void back();
    void move(int rows);
    void step(int direction);
    void enter();
    void take_key(platform::Key key);
    void unbind_chosen();
    size_t row_count() const;
    std::optional<size_t> row_under_pointer() const;

    MenuParts parts_;
    std::vector<Page> pages_; // the one that is shown last
    std::vector<MenuPlace> places_;
    std::optional<glm::vec2> pointer_; // none before it has moved
    bool wants_key_ = false;
};

} // namespace vigil::client
