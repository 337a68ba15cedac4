// SPDX-License-Identifier: GPL-2.0-or-later
#include "yamagi/variables.h"

#include "common/error.h"
#include "common/log.h"
#include "console/preset.h"

#include <algorithm>

namespace vigil::yamagi {

namespace {

/// What pt_preset was when it was last seen: a variable of the engine.
constexpr const char* kept_preset = "vigil_preset_kept";
constexpr const char* default_preset = "balanced";

/// Those of the program are not here: the engine has a window, folders and demos of its own.
bool is_offered(const CvarInfo& info) {
    for (const std::string_view prefix : {"pt_", "flt_", "tm_", "vk_"})
        if (info.name.starts_with(prefix)) return true;
    return info.name == "vid_scale" || info.name == "vid_fps_target";
}

} // namespace

Variables::Variables(const Engine& engine) : engine_(engine) {
    for (const CvarInfo& info : cvar_infos) {
        if (!is_offered(info)) continue;
        Row row{&info, nullptr, cvar_default_text(info), std::string(info.name)};
        const int flags = info.life == CvarLife::Archived ? variable_archived : 0;
        row.variable = engine.functions().variable(row.name.c_str(), row.text.c_str(), flags);
        if (row.variable != nullptr) rows_.push_back(std::move(row));
    }
    begin_with_preset();
    update();
}

/// The engine keeps pt_preset and each of its settings, and sets them before this module is there:
/// in which order nobody can tell. The preset that was kept tells which of them a person has set
/// since, who then means those.
void Variables::begin_with_preset() {
    const std::string kept = engine_.text(kept_preset, default_preset, variable_archived);
    const auto preset = std::ranges::find(rows_, std::string_view("pt_preset"), &Row::name);
    if (preset == rows_.end()) return;
    const bool is_named = find_preset(kept) != nullptr;
    if (is_named) registry_.set("pt_preset", kept);
    // Settings of one's own are of no more use where a preset is asked for.
    const bool is_asked_for = find_preset(text_of(*preset)) != nullptr;
    for (Row& row : rows_)
        row.text = !is_named && is_asked_for && is_preset_setting(row.name)
                       ? text_of(row)
                       : registry_.get_text(row.name);
}

std::string Variables::text_of(const Row& row) {
    return row.variable->text != nullptr ? row.variable->text : "";
}

void Variables::take(Row& row) {
    const std::string text = text_of(row);
    if (row.text == text) return;
    try {
        registry_.set(row.name, text);
    } catch (const Error& error) {
        log_warning("{}", error.what());
    }
    row.text = registry_.get_text(row.name);
    if (row.text != text) engine_.set(row.name.c_str(), row.text);
}

void Variables::update() {
    for (Row& row : rows_)
        take(row);
    show_changes();
}

/// A preset sets other variables, and each of those may end a preset.
void Variables::show_changes() {
    if (shown_changes_ == registry_.changes()) return;
    shown_changes_ = registry_.changes();
    for (Row& row : rows_) {
        std::string text = registry_.get_text(row.name);
        if (text == row.text && text == text_of(row)) continue;
        row.text = std::move(text);
        engine_.set(row.name.c_str(), row.text);
    }
    engine_.set(kept_preset, registry_.get_text("pt_preset"));
}

} // namespace vigil::yamagi
