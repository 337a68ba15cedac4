// SPDX-License-Identifier: GPL-2.0-or-later
// The menu's items as data: what its first page changes or does, and the actions that keys can be
// given.
#pragma once

#include "console/cvar.h"

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>

namespace vigil::client {

enum class MenuItemKind {
    Command,    ///< runs `target`, after the menu has closed
    Levels,     ///< a page of them
    Demos,      ///< the same
    Keys,       ///< the same, of menu_actions()
    Variable,   ///< steps through the values of the variable `target`
    Preset,     ///< steps through pt_preset
    Resolution, ///< steps through sizes of the window
};

struct MenuItem {
    MenuItemKind kind;
    std::string_view label;
    std::string_view target{};
    std::string_view about{}; ///< "": a variable's own help text
};

std::span<const MenuItem> menu_items();

/// Something that keys do.
struct MenuAction {
    std::string_view label;
    std::string_view command;
};

std::span<const MenuAction> menu_actions();

/// What a row shows of a variable: a choice by name; a switch as on or off.
std::string menu_value(std::string_view variable, const CvarRegistry& variables);
/// The value that is `direction` (1 or -1) further, as text; choices and switches go round, numbers
/// end. Paths per pixel double.
std::string next_menu_value(std::string_view variable, int direction,
                            const CvarRegistry& variables);
/// A sentence about the present value: what the technique is, else the variable's help.
std::string menu_about(std::string_view variable, const CvarRegistry& variables);

/// The next larger or smaller of the usual sizes; the same where there is none.
glm::ivec2 next_menu_size(glm::ivec2 size, int direction);

} // namespace vigil::client
