// SPDX-License-Identifier: GPL-2.0-or-later
// Text files: scripts, camera routes, materials, light styles, and the names that files hold.
#include "client/demo/route.h"
#include "client/play/light_styles.h"
#include "client/play/walk.h"
#include "common/error.h"
#include "common/game_path.h"
#include "common/printable.h"
#include "console/builtin_commands.h"
#include "console/command.h"
#include "formats/material_table.h"
#include "formats/sky.h"
#include "formats/texture_name.h"
#include "target.h"

#include <algorithm>
#include <cmath>

namespace vigil::fuzz {

namespace {

bool finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// What FileSystem::read_text refuses never reaches a parser of text.
bool is_text(Input bytes) {
    return std::find(bytes.begin(), bytes.end(), 0) == bytes.end();
}

void run_script(CommandRegistry& commands, std::string_view text, Trust trust) {
    // The script may call itself.
    add_builtin_commands(commands, [&](std::string_view name) -> ScriptText {
        if (name != "self.cfg") fail("{}: no such file", printable(name));
        return {std::string(text), trust};
    });
    commands.execute_text(text, "self.cfg", trust);
    for (int frame = 0; frame < 3; ++frame)
        commands.run_frame();
}

} // namespace

void fuzz_cfg(Input bytes) {
    if (!is_text(bytes)) return;
    const std::string_view text = text_of(bytes);
    CvarRegistry variables;
    CommandRegistry commands(variables);
    run_script(commands, text, Trust::Person);
    commands.complete(text.substr(0, text.find('\n')));

    // What is kept must come back the same.
    const std::string kept = variables.archive_text();
    if (kept.empty()) return;
    CvarRegistry restored;
    CommandRegistry next_time(restored);
    add_builtin_commands(next_time, [](std::string_view) { return ScriptText(); });
    next_time.execute_text(kept);
    require(restored.archive_text() == kept, "the configuration does not come back the same");
}

void fuzz_packed_cfg(Input bytes) {
    if (!is_text(bytes)) return;
    CvarRegistry variables;
    CommandRegistry commands(variables);
    run_script(commands, text_of(bytes), Trust::Archive);
    require(variables.archive_text().empty(), "an archive's script changed what is kept");
    for (const CvarInfo& info : cvar_infos)
        if (info.guarded)
            require(variables.changes(info.name) == 0,
                    "an archive's script set a guarded variable");
}

void fuzz_walk(Input bytes) {
    if (!is_text(bytes)) return;
    parse_or_refuse("x.walk", [&] {
        const client::Walk walk = client::Walk::parse("x.walk", text_of(bytes));
        const client::Walk again = client::Walk::parse("x.walk", walk.text());
        require(again.ticks() == walk.ticks() && walk.ticks() >= 1, "a walk changes as text");
        for (const int64_t tick : {int64_t{0}, walk.ticks() / 2, walk.ticks() - 1})
            require(again.command_at(tick) == walk.command_at(tick), "a command changes as text");
    });
}

void fuzz_route(Input bytes) {
    if (!is_text(bytes)) return;
    parse_or_refuse("x.route", [&] {
        const client::Route route = client::Route::parse("x.route", text_of(bytes));
        require(route.frame_count(1e4) >= 1, "a route without frames");
        for (int i = -1; i < 40; ++i) {
            const auto view = route.at(route.duration_s() * i / 32.0);
            require(finite(view.origin) && finite(view.angles), "a view is not finite");
        }
        for (const client::Route::Key& key : route.keys()) {
            const auto view = route.at(key.time_s - route.begin_s());
            require(finite(view.origin) && finite(view.angles), "a view is not finite");
        }
    });
}

void fuzz_materials(Input bytes) {
    if (!is_text(bytes)) return;
    parse_or_refuse("materials.json", [&] {
        for (const auto& [name, gloss] : parse_material_table("materials.json", text_of(bytes)))
            require(gloss.roughness >= 0.1f && gloss.roughness <= 1.0f && gloss.specular >= 0.0f &&
                        gloss.specular <= 1.0f,
                    "a number is out of range");
    });
}

void fuzz_style(Input bytes) {
    parse_or_refuse("light style", [&] {
        client::LightStyles styles;
        styles.set_pattern(bytes.empty() ? 0 : bytes.front(), text_of(bytes));
        for (const double time : {0.0, 0.05, 1.0, 1e9})
            for (const float value : styles.values_at(time))
                require(value >= 0.0f && std::isfinite(value), "a brightness is no number");
    });
}

void fuzz_names(Input bytes) {
    const std::string_view name = text_of(bytes);
    if (game_path_fault(name).empty())
        require(("/" + std::string(name) + "/").find("/../") == std::string::npos,
                "a path that goes up was accepted");
    require(printable(name).find('\n') == std::string::npos, "a line feed is no text");
    texture_candidates(name);
    require(!animation_names(name, [&](const std::string& frame) { return frame != name; }).empty(),
            "an animation without frames");
    for (std::size_t side = 0; side < sky_sides.size(); ++side)
        sky_candidates(name, side);
}

} // namespace vigil::fuzz
