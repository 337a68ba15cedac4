// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/ui/menu_items.h"

#include "console/command_text.h"
#include "console/preset.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace vigil::client {

namespace {

/// A row that runs a command or opens a page, or, with neither, one of a variable, or of what is
/// not one variable: presets and the window's size.
struct MenuItem {
    std::string_view label;
    std::string_view variable{};
    std::string_view about{};
    std::string_view command{};
    std::optional<MenuPage> page{};
};

constexpr MenuItem items[] = {
    {"Continue", {}, "back to the level"},
    {"Levels", {}, "walk through a level", {}, MenuPage::Levels},
    {"Demos", {}, "watch a recorded walk", {}, MenuPage::Demos},
    {"Quality", "pt_preset"},
    {"Lights chosen by", "pt_nee"},
    {"Rays guided by", "pt_guide"},
    {"Paths per pixel", "pt_spp"},
    {"Denoiser", "flt_enable"},
    {"Compare with", "pt_compare"},
    {"Show", "pt_view"},
    {"Statistics", "scr_stats"},
    {"Resolution", "resolution"},
    {"Full screen", "vid_fullscreen"},
    {"Mouse speed", "sensitivity"},
    {"Invert mouse", "m_invert"},
    {"Stick speed", "joy_look"},
    {"Keys", {}, "which key does what", {}, MenuPage::Keys},
    {"Console", {}, "all variables and commands; its key is ` as well", "toggleconsole"},
    {"Quit", {}, "ends the program", "quit"},
};

/// Something that keys do.
struct MenuAction {
    std::string_view label;
    std::string_view command;
};

constexpr MenuAction actions[] = {
    {"Forward", "+forward"},
    {"Back", "+back"},
    {"Left", "+moveleft"},
    {"Right", "+moveright"},
    {"Jump, up", "+moveup"},
    {"Crouch, down", "+movedown"},
    {"Walk slowly, fly fast", "+speed"},
    {"Shoot", "+attack"},
    {"Turn left", "+left"},
    {"Turn right", "+right"},
    {"Look up", "+lookup"},
    {"Look down", "+lookdown"},
    {"Fly through walls", "noclip"},
    {"Compare", "compare"},
    {"Drag the line", "+comparedrag"},
    {"Line to the left", "comparemove -0.05"},
    {"Line to the right", "comparemove 0.05"},
    {"Next technique", "toggle pt_nee"},
    {"Guided rays", "toggle pt_guide brdf cdq"},
    {"Next view", "viewnext"},
    {"Statistics", "toggle scr_stats"},
    {"Full screen", "toggle vid_fullscreen"},
    {"Screenshot", "screenshot"},
    {"Menu", "togglemenu"},
    {"Console", "toggleconsole"},
};

constexpr glm::ivec2 sizes[] = {{320, 180},  {480, 270},  {640, 360},   {854, 480},   {960, 540},
                                {1280, 720}, {1600, 900}, {1920, 1080}, {2560, 1440}, {3840, 2160}};

/// Steps of numbers; others move by a twentieth of their range.
struct NumberStep {
    std::string_view variable;
    double factor; // 0: add `term`
    double term;
};
constexpr NumberStep number_steps[] = {
    {"pt_spp", 2.0, 0.0}, {"sensitivity", 0.0, 0.5}, {"joy_look", 0.0, 30.0}};

bool is_switch(const CvarInfo& info) {
    return info.type == CvarType::Integer && info.minimum == 0.0 && info.maximum == 1.0;
}

std::string next_number(const CvarInfo& info, double now, int direction) {
    const auto* step = std::ranges::find(number_steps, info.name, &NumberStep::variable);
    double next = now + direction * (info.maximum - info.minimum) / 20.0;
    if (step != std::end(number_steps) && step->factor > 0.0)
        next = direction > 0 ? now * step->factor : now / step->factor;
    else if (step != std::end(number_steps))
        next = now + direction * step->term;
    next = std::clamp(next, info.minimum, info.maximum);
    return info.type == CvarType::Integer ? fmt::format("{:.0f}", next)
                                          : fmt::format("{:.6g}", next);
}

/// The value of a variable that is `direction` (1 or -1) further; choices and switches go round,
/// numbers end.
std::string next_value(const CvarInfo& info, const std::string& text, int direction) {
    if (info.type == CvarType::Choice) {
        const int count = choice_count(info.choices);
        return fmt::to_string((choice_index(info.choices, text) + direction + count) % count);
    }
    if (is_switch(info)) return text == "0" ? "1" : "0";
    return next_number(info, std::stod(text), direction);
}

/// What the present value is: the technique's own words, else the variable's help.
std::string about_value(const CvarInfo& info, const std::string& text) {
    const bool technique = info.name == "pt_nee" || (info.name == "pt_compare" && text != "none");
    if (const std::optional<TechniqueRow> row = find_technique_row(technique ? text : ""))
        return std::string(technique_infos[static_cast<size_t>(row->technique)].help);
    return std::string(info.help);
}

MenuRow variable_row(const MenuItem& item, const CvarRegistry& variables) {
    const CvarInfo& info = *find_cvar(item.variable);
    const std::string text = variables.get_text(item.variable);
    const auto command = [&](int direction) {
        return fmt::format("{} {}", item.variable, next_value(info, text, direction));
    };
    return {.label = std::string(item.label),
            .value = !is_switch(info) ? text
                     : text == "0"    ? "off"
                                      : "on",
            .about = about_value(info, text),
            .less = command(-1),
            .more = command(1)};
}

MenuRow preset_row(const MenuItem& item, const CvarRegistry& variables) {
    const Preset* present = present_preset(variables);
    const int count = static_cast<int>(presets().size());
    // From a mixture of one's own, the step goes to the first or the last.
    const auto command = [&](int direction) {
        const int now = present != nullptr ? static_cast<int>(present - presets().data())
                                           : (direction > 0 ? -1 : 0);
        const auto next = static_cast<size_t>((now + direction + count) % count);
        return fmt::format("pt_preset {}", presets()[next].name);
    };
    return {.label = std::string(item.label),
            .value = std::string(present != nullptr ? present->name : "own"),
            .about = std::string(present != nullptr
                                     ? present->purpose
                                     : "settings of your own; left and right choose a preset"),
            .less = command(-1),
            .more = command(1)};
}

MenuRow size_row(const MenuItem& item, glm::ivec2 size) {
    const auto* larger =
        std::ranges::find_if(sizes, [&](glm::ivec2 other) { return other.x > size.x; });
    const auto* smaller = std::ranges::lower_bound(sizes, size.x, {}, &glm::ivec2::x);
    const auto command = [](glm::ivec2 next) {
        return fmt::format("resolution {} {}", next.x, next.y);
    };
    return {.label = std::string(item.label),
            .value = fmt::format("{} x {}", size.x, size.y),
            .about = "size of the window: smaller is faster",
            .less = command(smaller == std::begin(sizes) ? size : smaller[-1]),
            .more = command(larger == std::end(sizes) ? size : *larger)};
}

} // namespace

std::string_view menu_page_title(MenuPage page) {
    constexpr std::string_view titles[] = {"Vigil", "Levels", "Demos", "Keys"};
    return titles[static_cast<size_t>(page)];
}

std::vector<MenuRow> main_rows(const CvarRegistry& variables, glm::ivec2 window_size) {
    std::vector<MenuRow> rows;
    for (const MenuItem& item : items) {
        if (item.variable == "pt_preset")
            rows.push_back(preset_row(item, variables));
        else if (item.variable == "resolution")
            rows.push_back(size_row(item, window_size));
        else if (!item.variable.empty())
            rows.push_back(variable_row(item, variables));
        else
            rows.push_back({.label = std::string(item.label),
                            .about = std::string(item.about),
                            .command = std::string(item.command),
                            .page = item.page});
    }
    return rows;
}

std::vector<MenuRow> name_rows(std::string_view command, std::span<const std::string> names) {
    std::vector<MenuRow> rows;
    for (const std::string& name : names)
        rows.push_back({.label = name, .command = fmt::format("{} {}", command, quote_word(name))});
    return rows;
}

std::vector<MenuRow> key_rows(const KeyBindings& bindings) {
    std::vector<MenuRow> rows;
    for (const MenuAction& action : actions) {
        std::string keys;
        for (int i = 0; i < platform::key_count; ++i) {
            const auto key = static_cast<platform::Key>(i);
            if (bindings.command(key) == action.command)
                keys += (keys.empty() ? "" : ", ") + std::string(key_name(key));
        }
        rows.push_back({.label = std::string(action.label),
                        .value = std::move(keys),
                        .about = "ENTER: one more key for this; BACKSPACE: no key",
                        .command = std::string(action.command)});
    }
    return rows;
}

} // namespace vigil::client
