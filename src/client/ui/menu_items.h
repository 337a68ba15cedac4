// SPDX-License-Identifier: GPL-2.0-or-later
// The menu's rows: what its pages change or do, the names of levels and demos, and the actions that
// keys can be given. Each is a label, a value, and the commands that it runs.
#pragma once

#include "client/ui/key_bindings.h"
#include "console/cvar.h"

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vigil::client {

enum class MenuPage { Main, Levels, Demos, Video, Keys, Controls, Research, Quit };

std::string_view menu_page_title(MenuPage page);

/// A line of a page.
struct MenuRow {
    std::string label;
    std::string value{};               ///< beside the label; may be empty
    std::string about{};               ///< a sentence on what is chosen
    std::string less{}, more{};        ///< change the value: commands of left and right
    std::string command{};             ///< for ENTER, after the menu has closed; what a key runs
    std::optional<MenuPage> page = {}; ///< that ENTER opens
};

/// A page of items, for a window of this size in pixels; none for Levels, Demos and Keys.
std::vector<MenuRow> item_rows(MenuPage page, const CvarRegistry& variables,
                               glm::ivec2 window_size);
/// A row for each name, which is the command's word.
std::vector<MenuRow> name_rows(std::string_view command, std::span<const std::string> names);
/// A row for each action, with its keys.
std::vector<MenuRow> key_rows(const KeyBindings& bindings);

} // namespace vigil::client
