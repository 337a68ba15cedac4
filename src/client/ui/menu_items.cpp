// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/ui/menu_items.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace vigil::client {

namespace {

constexpr MenuItem items[] = {
    {MenuItemKind::Command, "Continue", "", "back to the level"},
    {MenuItemKind::Levels, "Levels", "", "walk through a level"},
    {MenuItemKind::Demos, "Demos", "", "watch a recorded walk"},
    {MenuItemKind::Preset, "Quality", "", ""},
    {MenuItemKind::Variable, "Lights chosen by", "pt_nee"},
    {MenuItemKind::Variable, "Rays guided by", "pt_guide"},
    {MenuItemKind::Variable, "Paths per pixel", "pt_spp"},
    {MenuItemKind::Variable, "Compare with", "pt_compare"},
    {MenuItemKind::Variable, "Show", "pt_view"},
    {MenuItemKind::Variable, "Statistics", "scr_stats"},
    {MenuItemKind::Resolution, "Resolution", "", "size of the window: smaller is faster"},
    {MenuItemKind::Variable, "Full screen", "vid_fullscreen"},
    {MenuItemKind::Variable, "Mouse speed", "sensitivity"},
    {MenuItemKind::Variable, "Invert mouse", "m_invert"},
    {MenuItemKind::Variable, "Stick speed", "joy_look"},
    {MenuItemKind::Keys, "Keys", "", "which key does what"},
    {MenuItemKind::Command, "Console", "toggleconsole",
     "all variables and commands; its key is ` as well"},
    {MenuItemKind::Command, "Quit", "quit", "ends the program"},
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

} // namespace

std::span<const MenuItem> menu_items() {
    return items;
}

std::span<const MenuAction> menu_actions() {
    return actions;
}

std::string menu_value(std::string_view variable, const CvarRegistry& variables) {
    const std::string text = variables.get_text(variable);
    if (is_switch(*find_cvar(variable))) return text == "0" ? "off" : "on";
    return text;
}

std::string next_menu_value(std::string_view variable, int direction,
                            const CvarRegistry& variables) {
    const CvarInfo& info = *find_cvar(variable);
    const std::string text = variables.get_text(variable);
    if (info.type == CvarType::Choice) {
        const int count = choice_count(info.choices);
        return fmt::to_string((choice_index(info.choices, text) + direction + count) % count);
    }
    if (is_switch(info)) return text == "0" ? "1" : "0";
    return next_number(info, std::stod(text), direction);
}

std::string menu_about(std::string_view variable, const CvarRegistry& variables) {
    std::string_view name = variable == "pt_nee" ? choice_name(technique_choices, variables->pt_nee)
                                                 : std::string_view();
    if (variable == "pt_compare" && variables->pt_compare != 0)
        name = choice_name(compare_choices, variables->pt_compare);
    if (const std::optional<TechniqueRow> row = find_technique_row(name))
        return std::string(technique_infos[static_cast<size_t>(row->technique)].help);
    return std::string(find_cvar(variable)->help);
}

glm::ivec2 next_menu_size(glm::ivec2 size, int direction) {
    if (direction > 0) {
        const auto* larger =
            std::ranges::find_if(sizes, [&](glm::ivec2 other) { return other.x > size.x; });
        return larger == std::end(sizes) ? size : *larger;
    }
    for (auto other = std::rbegin(sizes); other != std::rend(sizes); ++other)
        if (other->x < size.x) return *other;
    return size;
}

} // namespace vigil::client
