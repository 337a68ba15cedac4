// SPDX-License-Identifier: GPL-2.0-or-later
// Prints docs/play/cvars.md, the page of all console variables, from the one table in
// shaders/shared/settings_table.h, or docs/play/commands.md, from the program's tables of commands.
// With
// --check it compares instead, for the tests; it writes no files.
#include "command_page.h"
#include "console/cvar.h"
#include "console/preset.h"

#include <CLI/CLI.hpp>
#include <fmt/ranges.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace vigil;

using docs::cell;

std::string code_cell(std::string_view text) {
    return text.empty() ? std::string("*(empty)*") : '`' + cell(text) + '`';
}

std::string_view life_text(const CvarInfo& info) {
    switch (info.life) {
    case CvarLife::Archived:
        return info.guarded ? "kept, guarded" : "kept";
    case CvarLife::Session:
        return info.guarded ? "session, guarded" : "session";
    case CvarLife::Start:
        break;
    }
    return "start, guarded";
}

std::string_view affects_text(Affects affects) {
    switch (affects) {
    case Affects::Nothing:
        break;
    case Affects::Display:
        return "display";
    case Affects::Picture:
        return "picture";
    case Affects::Reference:
        return "reference";
    }
    return "";
}

struct Section {
    std::string_view title;
    std::string_view prefix; ///< of the names; empty takes what no other section has
};
constexpr Section sections[] = {{"Files and play", ""},
                                {"Video", "vid_"},
                                {"Path tracer", "pt_"},
                                {"Filter", "flt_"},
                                {"Vulkan", "vk_"}};

const Section& section_of(const CvarInfo& info) {
    for (const Section& section : sections)
        if (!section.prefix.empty() && info.name.starts_with(section.prefix)) return section;
    return sections[0];
}

std::string row(const CvarInfo& info) {
    const std::string range = cvar_range_text(info);
    return fmt::format("| `{}` | {} | {} | {} | {} | {}{} |\n", info.name,
                       code_cell(cvar_default_text(info)),
                       info.type == CvarType::Choice ? code_cell(range) : range, life_text(info),
                       affects_text(info.affects), cell(info.help), info.gpu ? " (GPU)" : "");
}

/// A table of what choices mean.
template <typename Rows> std::string choices_text(std::string_view variable, const Rows& rows) {
    std::string text =
        fmt::format("\n## Choices of `{}`\n\n| name | meaning |\n|---|---|\n", variable);
    for (const auto& row : rows)
        text += fmt::format("| `{}` | {} |\n", row.name, cell(row.help));
    return text;
}

std::string variable_page() {
    std::string text = R"(# Console variables

`vigil_cvar_docs` generates this page from `shaders/shared/settings_table.h`. Edit that table, not this page.

`NAME` at the console shows a variable. `NAME VALUE` or `set NAME VALUE` sets it. `reset NAME` brings the default back.
`toggle NAME` goes to the next value. A choice is given by name, or by index from 0. A number out of range is brought into it
with a message. A text that is no number or choice is refused.

*Life* tells how long a value lasts:

- **kept** values are written to the configuration file when they differ from the default.
- **session** values last until the program ends.
- **start** values are read once when the program starts. They belong on the command line (`vigil +set NAME VALUE`), or in
  front of `vid_restart`, which reads those with `vid_` and `vk_` anew.

Values of `+set` before the first other command are never kept. A later `+set` is kept like one at the console. A cfg file inside a game archive cannot set **guarded** variables. What it sets
of the others is not kept ([files.md](../internals/files.md)). Shaders read the variables marked *(GPU)*.

*Affects* tells what a value changes. **display**: how finished radiance is shown. **picture**: the radiance too.
**reference**: also what a kept reference picture is of.

Where `pt_preset` is not `custom`, the configuration file keeps its name in place of the settings that it stands for.
Names of Quake II RTX work as well: [commands.md](commands.md) lists them.
)";

    for (const Section& section : sections) {
        text +=
            fmt::format("\n## {}\n\n| variable | default | values | life | affects | meaning |\n"
                        "|---|---|---|---|---|---|\n",
                        section.title);
        for (const CvarInfo& info : cvar_infos)
            if (&section_of(info) == &section) text += row(info);
    }

    text += "\n## Choices of `pt_preset`\n\n| name | meaning | sets |\n|---|---|---|\n";
    for (const Preset& preset : presets()) {
        std::vector<std::string> settings;
        for (const PresetSetting& setting : preset.settings)
            settings.push_back(fmt::format("`{} {}`", setting.variable, setting.value));
        text += fmt::format("| `{}` | {} | {} |\n", preset.name, cell(preset.purpose),
                            fmt::join(settings, ", "));
    }
    text += choices_text("pt_nee", technique_infos);
    text += choices_text("pt_guide", guider_infos);
    text += choices_text("pt_view", view_infos);
    return text;
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app("Prints the page of all console variables, or that of all commands.",
                 "vigil_cvar_docs");
    bool commands = false;
    std::vector<std::string> files;
    app.add_flag("--commands", commands, "print the page of commands");
    app.add_option("--check", files, "compare these files, cvars.md or commands.md, instead")
        ->check(CLI::ExistingFile);
    CLI11_PARSE(app, argc, argv)
    if (files.empty()) {
        fmt::print("{}", commands ? docs::command_page() : variable_page());
        return 0;
    }
    int status = 0;
    for (const std::string& path : files) {
        const bool is_commands = path.ends_with("commands.md");
        std::ifstream file(path, std::ios::binary);
        const std::string committed((std::istreambuf_iterator<char>(file)),
                                    std::istreambuf_iterator<char>());
        if (committed == (is_commands ? docs::command_page() : variable_page())) continue;
        fmt::print(stderr, "{} is not what the tables say; run vigil_cvar_docs{} > {}\n", path,
                   is_commands ? " --commands" : "", path);
        status = 1;
    }
    return status;
}
