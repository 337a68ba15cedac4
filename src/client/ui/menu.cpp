// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/ui/menu.h"

#include "client/ui/menu_items.h"
#include "console/command_text.h"
#include "console/preset.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace vigil::client {

using platform::Key;
using platform::key_count;
using platform::key_name;

namespace {

constexpr int page_rows = 10; // that PGUP and PGDN move by

int present_preset_index(const CvarRegistry& variables) {
    const Preset* present = present_preset(variables);
    return present != nullptr ? static_cast<int>(present - presets().data()) : -1;
}

/// From a mixture of one's own, the step goes to the first or the last.
std::string next_preset(int direction, const CvarRegistry& variables) {
    const int count = static_cast<int>(presets().size());
    const int now = present_preset_index(variables);
    const int next = now < 0 ? (direction > 0 ? 0 : count - 1) : (now + direction + count) % count;
    return std::string(presets()[static_cast<size_t>(next)].name);
}

MenuRow preset_row(const MenuItem& item, const CvarRegistry& variables) {
    const Preset* present = present_preset(variables);
    if (present == nullptr)
        return {std::string(item.label), "own", true,
                "settings of your own; left and right choose a preset"};
    return {std::string(item.label), std::string(present->name), true,
            std::string(present->purpose)};
}

std::string keys_of(std::string_view command, const KeyBindings& bindings) {
    std::string keys;
    for (int i = 0; i < key_count; ++i) {
        const Key key = static_cast<Key>(i);
        if (bindings.command(key) != command) continue;
        keys += (keys.empty() ? "" : ", ") + std::string(key_name(key));
    }
    return keys;
}

} // namespace

Menu::Menu(MenuParts parts) : parts_(std::move(parts)) {}

void Menu::open() {
    pages_.clear();
    pointer_.reset();
    open_page(PageKind::Main);
}

void Menu::close() {
    pages_.clear();
    places_.clear();
    wants_key_ = false;
}

void Menu::open_page(PageKind kind) {
    Page page{kind, {}, 0};
    if (kind == PageKind::Levels) page.names = parts_.levels();
    if (kind == PageKind::Demos) page.names = parts_.demos();
    pages_.push_back(std::move(page));
    places_.clear(); // until it was drawn
}

void Menu::back() {
    pages_.pop_back();
    places_.clear();
}

std::string Menu::title() const {
    switch (pages_.back().kind) {
    case PageKind::Main:
        return "Vigil";
    case PageKind::Levels:
        return "Levels";
    case PageKind::Demos:
        return "Demos";
    case PageKind::Keys:
        return "Keys";
    }
    return {};
}

size_t Menu::row_count() const {
    const Page& page = pages_.back();
    switch (page.kind) {
    case PageKind::Main:
        return menu_items().size();
    case PageKind::Keys:
        return menu_actions().size();
    case PageKind::Levels:
    case PageKind::Demos:
        return page.names.size();
    }
    return 0;
}

std::vector<MenuRow> Menu::rows() const {
    const Page& page = pages_.back();
    const CvarRegistry& variables = parts_.commands.variables();
    std::vector<MenuRow> rows;
    for (const std::string& name : page.names)
        rows.push_back({name, "", false, ""});
    if (page.kind == PageKind::Keys) {
        for (const MenuAction& action : menu_actions())
            rows.push_back({std::string(action.label), keys_of(action.command, parts_.bindings),
                            false, "ENTER: one more key for this; BACKSPACE: no key"});
        if (wants_key_) rows[page.chosen].value = "press a key (ESCAPE: none)";
    }
    if (page.kind != PageKind::Main) return rows;
    for (const MenuItem& item : menu_items()) {
        switch (item.kind) {
        case MenuItemKind::Variable:
            rows.push_back({std::string(item.label), menu_value(item.target, variables), true,
                            menu_about(item.target, variables)});
            break;
        case MenuItemKind::Preset:
            rows.push_back(preset_row(item, variables));
            break;
        case MenuItemKind::Resolution: {
            const glm::ivec2 size = parts_.picture_size();
            rows.push_back({std::string(item.label), fmt::format("{} x {}", size.x, size.y), true,
                            std::string(item.about)});
            break;
        }
        default:
            rows.push_back({std::string(item.label), "", false, std::string(item.about)});
            break;
        }
    }
    return rows;
}

void Menu::move(int rows) {
    const int count = static_cast<int>(row_count());
    if (count == 0) return;
    size_t& chosen = pages_.back().chosen;
    const int wanted = static_cast<int>(chosen) + rows;
    // Single steps go round; leaps end at the ends.
    chosen = static_cast<size_t>(rows == 1 || rows == -1 ? (wanted + count) % count
                                                         : std::clamp(wanted, 0, count - 1));
}

void Menu::step(int direction) {
    if (pages_.back().kind != PageKind::Main) return;
    const MenuItem& item = menu_items()[chosen()];
    CommandRegistry& commands = parts_.commands;
    const CvarRegistry& variables = commands.variables();
    switch (item.kind) {
    case MenuItemKind::Variable:
        commands.set_variable(item.target, next_menu_value(item.target, direction, variables));
        break;
    case MenuItemKind::Preset:
        commands.execute_text("pt_preset " + next_preset(direction, variables));
        break;
    case MenuItemKind::Resolution: {
        const glm::ivec2 size = next_menu_size(parts_.picture_size(), direction);
        commands.execute_text(fmt::format("resolution {} {}", size.x, size.y));
        break;
    }
    default:
        break;
    }
}

void Menu::enter() {
    const Page& page = pages_.back();
    if (page.chosen >= row_count()) return; // an empty page
    if (page.kind == PageKind::Keys) {
        wants_key_ = true;
        return;
    }
    if (page.kind != PageKind::Main) {
        const char* command = page.kind == PageKind::Levels ? "map" : "demomap";
        const std::string text =
            fmt::format("{} {}", command, quote_word(page.names.at(page.chosen)));
        close();
        parts_.commands.execute_text(text);
        return;
    }
    const MenuItem& item = menu_items()[page.chosen];
    switch (item.kind) {
    case MenuItemKind::Command:
        close();
        parts_.commands.execute_text(item.target);
        break;
    case MenuItemKind::Levels:
        open_page(PageKind::Levels);
        break;
    case MenuItemKind::Demos:
        open_page(PageKind::Demos);
        break;
    case MenuItemKind::Keys:
        open_page(PageKind::Keys);
        break;
    default:
        step(1);
        break;
    }
}

void Menu::take_key(Key key) {
    wants_key_ = false;
    // These two always open menu and console.
    if (key == Key::Escape || key == Key::Grave) return;
    parts_.bindings.bind(key, menu_actions()[chosen()].command);
}

void Menu::unbind_chosen() {
    if (pages_.back().kind != PageKind::Keys) return;
    for (int i = 0; i < key_count; ++i) {
        const Key key = static_cast<Key>(i);
        if (parts_.bindings.command(key) == menu_actions()[chosen()].command)
            parts_.bindings.bind(key, "");
    }
}

void Menu::key(Key key, bool repeat) {
    if (wants_key_) {
        if (!repeat) take_key(key);
        return;
    }
    switch (key) {
    case Key::Up:
    case Key::PadUp:
    case Key::WheelUp:
        return move(-1);
    case Key::Down:
    case Key::PadDown:
    case Key::WheelDown:
    case Key::Tab:
        return move(1);
    case Key::PageUp:
    case Key::PadLeftShoulder:
        return move(-page_rows);
    case Key::PageDown:
    case Key::PadRightShoulder:
        return move(page_rows);
    case Key::Home:
        return move(-static_cast<int>(row_count()));
    case Key::End:
        return move(static_cast<int>(row_count()));
    case Key::Left:
    case Key::PadLeft:
        return step(-1);
    case Key::Right:
    case Key::PadRight:
        return step(1);
    default:
        break;
    }
    if (repeat) return; // the rest does something once
    switch (key) {
    case Key::Enter:
    case Key::KeypadEnter:
    case Key::Space:
    case Key::PadA:
        return enter();
    case Key::Mouse1:
        if (const std::optional<size_t> row = row_under_pointer()) {
            pages_.back().chosen = *row;
            enter();
        }
        return;
    case Key::Escape:
    case Key::PadB:
    case Key::Mouse2:
        return back();
    case Key::Backspace:
    case Key::Delete:
    case Key::PadX:
        return unbind_chosen();
    case Key::PadStart:
        return close();
    default:
        return;
    }
}

std::optional<size_t> Menu::row_under_pointer() const {
    if (!pointer_) return std::nullopt;
    for (const MenuPlace& row : places_)
        if (glm::all(glm::greaterThanEqual(*pointer_, row.low)) &&
            glm::all(glm::lessThan(*pointer_, row.high)))
            return row.row;
    return std::nullopt;
}

void Menu::point(glm::vec2 place) {
    const bool appeared = !std::exchange(pointer_, place).has_value();
    if (appeared || wants_key_) return;
    if (const std::optional<size_t> row = row_under_pointer()) pages_.back().chosen = *row;
}

} // namespace vigil::client
