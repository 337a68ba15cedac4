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
/// not one variable: the window's size.
struct MenuItem {
    MenuPage on;
    std::string_view label;
    std::string_view variable{};
    std::string_view about{}; ///< empty: the variable's help
    std::string_view command{};
    std::optional<MenuPage> page{};
};

constexpr MenuItem items[] = {
    {MenuPage::Main, "Continue", {}, "Back to the level."},
    {MenuPage::Main, "Levels", {}, "Walk through a level.", {}, MenuPage::Levels},
    {MenuPage::Main, "Demos", {}, "Watch a recorded walk.", {}, MenuPage::Demos},
    {MenuPage::Main, "Quality", "pt_preset"},
    {MenuPage::Main, "Light sampling", "pt_nee"},
    {MenuPage::Main, "Path guiding", "pt_guide"},
    {MenuPage::Main, "Denoiser", "flt_enable",
     "On: The noise of path tracing is filtered out. Off: The picture stays as it is traced."},
    {MenuPage::Main, "Video", {}, "Window, brightness and frame rate.", {}, MenuPage::Video},
    {MenuPage::Main, "Controls", {}, "Mouse, game controller and keys.", {}, MenuPage::Controls},
    {MenuPage::Main,
     "Research",
     {},
     "Compare techniques, and see what the renderer has learned.",
     {},
     MenuPage::Research},
    {MenuPage::Main, "Console", {}, "All variables and commands. Its key is `.", "toggleconsole"},
    {MenuPage::Main, "Quit", {}, "Ends the program. Settings are kept.", "quit"},

    {MenuPage::Video, "Resolution", "resolution"},
    {MenuPage::Video, "Full screen", "vid_fullscreen"},
    {MenuPage::Video, "Render scale", "vid_scale",
     "Part of the width and height that is traced. Smaller is faster and softer."},
    {MenuPage::Video, "Frame rate goal", "vid_fps_target",
     "The render scale falls by itself until this rate is reached."},
    {MenuPage::Video, "Vertical sync", "vid_vsync"},
    {MenuPage::Video, "Field of view", "fov"},
    {MenuPage::Video, "Brightness", "pt_exposure_bias"},
    {MenuPage::Video, "Tone curve", "pt_tonemap", "How bright light is brought onto the display."},
    {MenuPage::Video, "Smooth edges", "flt_taa",
     "On: Edges are averaged over frames, while the denoiser is on."},
    {MenuPage::Video, "Statistics", "scr_stats",
     "Frame rate and times in the corner: groups of passes, or every pass."},

    {MenuPage::Controls, "Mouse speed", "sensitivity", "How far the view turns with the mouse."},
    {MenuPage::Controls, "Invert mouse", "m_invert"},
    {MenuPage::Controls, "Stick speed", "joy_look",
     "How fast a controller's stick turns the view."},
    {MenuPage::Controls, "Invert stick", "joy_invert"},
    {MenuPage::Controls, "Keys", {}, "Which key does what.", {}, MenuPage::Keys},

    {MenuPage::Research, "Compare with", "pt_compare"},
    {MenuPage::Research, "View", "pt_view"},
    {MenuPage::Research, "Paths per pixel", "pt_spp", "More paths: less noise, longer frames."},
    {MenuPage::Research, "Points per light", "pt_light_points"},
    {MenuPage::Research, "Sky as light", "pt_env_nee"},
    {MenuPage::Research, "Bounces", "pt_bounces", "How often light is followed from wall to wall."},
    {MenuPage::Research, "Further bounces", "pt_tail",
     "On: Path guiding adds the light of all further bounces, roughly."},
    {MenuPage::Research, "Average frames", "pt_accumulate"},
    {MenuPage::Research, "Test lights", "testlights",
     "Coloured lights that wander through the level."},
    {MenuPage::Research,
     "Learn anew",
     {},
     "Forgets what frames have taught. Then the picture settles again.",
     "guidingreset"},

    {MenuPage::Quit, "Quit", {}, "Y: The program ends, and settings are kept.", "quit"},
    {MenuPage::Quit, "Go on", {}, "N: Back to the level."},
};

/// How a value reads that a player does not know by its name at the console.
struct ValueName {
    std::string_view variable, value, shown;
};
constexpr ValueName value_names[] = {
    {"pt_preset", "paper", "as in the paper"},
    {"pt_nee", "sll", "light lists (sll)"},
    {"pt_nee", "lh", "light tree (lh)"},
    {"pt_nee", "vlc", "light cache (vlc)"},
    {"pt_nee", "uniform", "at random (uniform)"},
    {"pt_nee", "power", "by power (power)"},
    {"pt_nee", "ris", "resampled (ris)"},
    {"pt_nee", "brute", "off (brute)"},
    {"pt_guide", "brdf", "off (brdf)"},
    {"pt_guide", "cdq", "quadtrees (cdq)"},
    {"pt_guide", "lobe", "lobes (lobe)"},
    {"pt_compare", "none", "off"},
    {"pt_compare", "raw", "unfiltered (raw)"},
    {"pt_view", "none", "picture"},
    {"vid_fps_target", "0", "off"},
    {"testlights", "0", "off"},
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
    {"Look straight ahead", "centerview"},
    {"Flashlight", "flashlight"},
    {"Fly through walls", "noclip"},
    {"Compare techniques", "compare"},
    {"Drag the compare line", "+comparedrag"},
    {"Line to the left", "comparemove -0.05"},
    {"Line to the right", "comparemove 0.05"},
    {"Next light sampling", "toggle pt_nee"},
    {"Path guiding", "toggle pt_guide brdf cdq"},
    {"Next view", "viewnext"},
    {"Statistics", "toggle scr_stats"},
    {"Full screen", "toggle vid_fullscreen"},
    {"Screenshot", "screenshot"},
    {"Menu", "togglemenu"},
    {"Quit", "menu_quit"},
    {"Console", "toggleconsole"},
};

constexpr glm::ivec2 sizes[] = {{320, 180},  {480, 270},  {640, 360},   {854, 480},   {960, 540},
                                {1280, 720}, {1600, 900}, {1920, 1080}, {2560, 1440}, {3840, 2160}};

/// Steps and units of numbers; others move by a twentieth of their range.
struct NumberStep {
    std::string_view variable;
    double factor; // 0: add `term`
    double term;
    std::string_view unit{};
};
constexpr NumberStep number_steps[] = {{"pt_spp", 2.0, 0.0},
                                       {"pt_light_points", 2.0, 0.0},
                                       {"testlights", 0.0, 8.0},
                                       {"sensitivity", 0.0, 0.5},
                                       {"joy_look", 0.0, 30.0, " degrees/s"},
                                       {"fov", 0.0, 5.0, " degrees"},
                                       {"pt_exposure_bias", 0.0, 0.5, " stops"},
                                       {"vid_scale", 0.0, 5.0, " %"},
                                       {"vid_fps_target", 0.0, 5.0, " fps"}};

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

/// How a value is shown.
std::string value_text(const CvarInfo& info, const std::string& text) {
    for (const ValueName& name : value_names)
        if (name.variable == info.name && name.value == text) return std::string(name.shown);
    if (is_switch(info)) return text == "0" ? "off" : "on";
    const auto* step = std::ranges::find(number_steps, info.name, &NumberStep::variable);
    return step != std::end(number_steps) ? fmt::format("{}{}", text, step->unit) : text;
}

/// What the present value is: the words of a preset, technique, guider or view, else the item's or
/// the variable's.
std::string_view about_value(const MenuItem& item, const CvarInfo& info, const std::string& text) {
    if (info.name == "pt_preset") {
        const Preset* preset = find_preset(text);
        return preset != nullptr ? preset->purpose
                                 : "Settings of your own. Left and right choose a preset.";
    }
    const auto index = static_cast<size_t>(std::max(choice_index(info.choices, text), 0));
    if (info.name == "pt_nee") return technique_infos[index].help;
    if (info.name == "pt_guide") return guider_infos[index].help;
    if (info.name == "pt_view" && index > 0) return view_infos[index].help;
    if (info.name == "pt_compare") {
        if (text == "none") return "Splits the picture: another technique on the right side.";
        if (text == "raw") return "The right side is the same, unfiltered.";
        return technique_infos[static_cast<size_t>(find_technique_row(text)->technique)].help;
    }
    return item.about.empty() ? info.help : item.about;
}

MenuRow variable_row(const MenuItem& item, const CvarRegistry& variables) {
    const CvarInfo& info = *find_cvar(item.variable);
    const std::string text = variables.get_text(item.variable);
    const auto command = [&](int direction) {
        const std::string next = info.name == "pt_preset"
                                     ? std::string(next_preset(variables, direction))
                                     : next_value(info, text, direction);
        return fmt::format("{} {}", item.variable, next);
    };
    return {.label = std::string(item.label),
            .value = value_text(info, text),
            .about = std::string(about_value(item, info, text)),
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
            .about = "Size of the window. Smaller is faster.",
            .less = command(smaller == std::begin(sizes) ? size : smaller[-1]),
            .more = command(larger == std::end(sizes) ? size : *larger)};
}

} // namespace

std::string_view menu_page_title(MenuPage page) {
    constexpr std::string_view titles[] = {"Vigil", "Levels",   "Demos",    "Video",
                                           "Keys",  "Controls", "Research", "Quit Vigil?"};
    return titles[static_cast<size_t>(page)];
}

std::vector<MenuRow> item_rows(MenuPage page, const CvarRegistry& variables,
                               glm::ivec2 window_size) {
    std::vector<MenuRow> rows;
    for (const MenuItem& item : items) {
        if (item.on != page) continue;
        if (item.variable == "resolution")
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
                        .about = "ENTER gives it one more key. BACKSPACE takes all its keys.",
                        .command = std::string(action.command)});
    }
    return rows;
}

} // namespace vigil::client
