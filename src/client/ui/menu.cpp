// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/ui/menu.h"

#include "client/ui/theme.h"
#include "client/ui/widget_input.h"

#include <algorithm>
#include <utility>

namespace vigil::client {

using platform::Key;
using platform::key_count;

namespace {

constexpr int page_rows = 10;      // that PGUP and PGDN move by
constexpr float about_rows = 3.0f; // room for the sentences below the rows
constexpr float letters_wide = 46.0f;

} // namespace

void Menu::open(MenuPage page) {
    pages_.clear();
    point_at_widgets(nowhere); // where the mouse appears it chooses nothing
    open_page(page);
}

void Menu::close() {
    pages_.clear();
    wants_key_ = false;
    clicked_.reset();
}

void Menu::open_page(MenuPage kind) {
    pages_.push_back({kind});
    if (kind == MenuPage::Levels) pages_.back().names = parts_.levels();
    if (kind == MenuPage::Demos) pages_.back().names = parts_.demos();
    moved_ = true;
}

std::vector<MenuRow> Menu::rows() const {
    const Page& page = pages_.back();
    switch (page.kind) {
    case MenuPage::Main:
    case MenuPage::Video:
    case MenuPage::Controls:
    case MenuPage::Research:
    case MenuPage::Quit:
        return item_rows(page.kind, parts_.commands.variables(), parts_.picture_size());
    case MenuPage::Keys:
        return key_rows(parts_.bindings);
    case MenuPage::Levels:
        return name_rows("map", page.names);
    case MenuPage::Demos:
        return name_rows("demomap", page.names);
    }
    return {};
}

void Menu::move(int rows) {
    const int count = static_cast<int>(this->rows().size());
    if (count == 0) return;
    size_t& chosen = pages_.back().chosen;
    const int wanted = static_cast<int>(chosen) + rows;
    // Single steps go round; leaps end at the ends.
    chosen = static_cast<size_t>(rows == 1 || rows == -1 ? (wanted + count) % count
                                                         : std::clamp(wanted, 0, count - 1));
    moved_ = true;
}

void Menu::enter() {
    const std::vector<MenuRow> all = rows();
    if (chosen() >= all.size()) return; // an empty page
    const MenuRow& row = all[chosen()];
    if (row.page) {
        open_page(*row.page);
    } else if (pages_.back().kind == MenuPage::Keys) {
        wants_key_ = true;
    } else if (!row.more.empty()) {
        parts_.commands.execute_text(row.more);
    } else {
        close();
        parts_.commands.execute_text(row.command);
    }
}

void Menu::bind_chosen(Key key) {
    wants_key_ = false;
    // These two always open menu and console.
    if (key == Key::Escape || key == Key::Grave) return;
    parts_.bindings.bind(key, rows()[chosen()].command);
}

void Menu::unbind_chosen() {
    if (pages_.back().kind != MenuPage::Keys) return;
    const std::string command = rows()[chosen()].command;
    for (int i = 0; i < key_count; ++i)
        if (parts_.bindings.command(static_cast<Key>(i)) == command)
            parts_.bindings.bind(static_cast<Key>(i), "");
}

void Menu::key(Key key, bool repeat) {
    if (wants_key_) {
        if (!repeat) bind_chosen(key);
        return;
    }
    const std::vector<MenuRow> all = rows();
    const int count = static_cast<int>(all.size());
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
        return move(-count);
    case Key::End:
        return move(count);
    case Key::Left:
    case Key::PadLeft:
        if (count > 0) parts_.commands.execute_text(all[chosen()].less);
        return;
    case Key::Right:
    case Key::PadRight:
        if (count > 0) parts_.commands.execute_text(all[chosen()].more);
        return;
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
    case Key::Escape:
    case Key::PadB:
    case Key::Mouse2:
        pages_.pop_back();
        moved_ = true;
        return;
    case Key::Backspace:
    case Key::Delete:
    case Key::PadX:
        return unbind_chosen();
    case Key::PadStart:
        return close();
    case Key::Y:
    case Key::N:
        if (pages_.back().kind != MenuPage::Quit) return;
        pages_.back().chosen = key == Key::Y ? 0 : 1;
        return enter();
    default:
        return;
    }
}

void Menu::run_clicked() {
    const std::optional<size_t> row = std::exchange(clicked_, std::nullopt);
    if (!row || !is_open()) return;
    pages_.back().chosen = *row;
    enter();
}

void Menu::draw_rows(const std::vector<MenuRow>& rows) {
    const ImVec2 mouse_way = ImGui::GetIO().MouseDelta;
    size_t& chosen = pages_.back().chosen;
    if (rows.empty()) ImGui::TextDisabled("There are none.");
    if (!ImGui::BeginTable("rows", 2, ImGuiTableFlags_SizingFixedFit)) return;
    for (size_t i = 0; i < rows.size(); ++i) {
        const MenuRow& row = rows[i];
        ImGui::TableNextColumn();
        ImGui::PushID(static_cast<int>(i));
        // A mouse that rests marks nothing beside the choice.
        ImGui::PushStyleColor(ImGuiCol_HeaderHovered,
                              ImGui::GetColorU32(i == chosen ? ImGuiCol_Header : ImGuiCol_ChildBg));
        if (ImGui::Selectable(row.label.c_str(), i == chosen, ImGuiSelectableFlags_SpanAllColumns))
            clicked_ = i;
        ImGui::PopStyleColor();
        ImGui::PopID();
        if (!wants_key_ && ImGui::IsItemHovered() && (mouse_way.x != 0.0f || mouse_way.y != 0.0f))
            chosen = i;
        if (i == chosen && std::exchange(moved_, false)) ImGui::SetScrollHereY();
        ImGui::TableNextColumn();
        if (i == chosen && wants_key_)
            ImGui::TextColored(theme::warning, "Press a key (ESCAPE: none)");
        else if (row.page)
            ImGui::TextColored(theme::value, "  >");
        else
            ImGui::TextColored(theme::value,
                               row.more.empty() ? "%s"
                               : i == chosen    ? "< %s >"
                                                : "  %s",
                               row.value.c_str());
    }
    ImGui::EndTable();
}

void Menu::draw() {
    const std::vector<MenuRow> all = rows();
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float letter = ImGui::CalcTextSize("0").x;
    const float row_height = ImGui::GetTextLineHeight() + 2.0f * ImGui::GetStyle().CellPadding.y;
    ImGui::SetNextWindowPos({screen.x / 2.0f, screen.y / 2.0f}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(screen.x, letters_wide * letter), 0.0f});
    ImGui::Begin("menu", nullptr, theme::sheet);
    ImGui::TextColored(theme::edge, "%s", std::string(title()).c_str());
    // Small windows show a part of the rows, with the chosen one.
    const float about_height = about_rows * row_height;
    const float above = ImGui::GetCursorPosY();
    const float rows_height =
        std::min(static_cast<float>(std::max<size_t>(all.size(), 1)) * row_height + 1.0f,
                 screen.y - 2.0f * above + row_height - about_height);
    ImGui::BeginChild("rows", {0.0f, std::max(rows_height, row_height)});
    draw_rows(all);
    ImGui::EndChild();
    ImGui::BeginChild("about", {0.0f, about_height});
    ImGui::PushTextWrapPos(0.0f);
    if (chosen() < all.size()) ImGui::TextDisabled("%s", all[chosen()].about.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndChild();
    ImGui::End();
}

} // namespace vigil::client
