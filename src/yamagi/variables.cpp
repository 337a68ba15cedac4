// SPDX-License-Identifier: GPL-2.0-or-later
#include "yamagi/variables.h"

#include "common/error.h"
#include "common/log.h"

#include <array>

namespace vigil::yamagi {

namespace {

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
        if (row.variable == nullptr) continue;
        take(row);
        rows_.push_back(std::move(row));
    }
}

void Variables::take(Row& row) {
    const char* const text = row.variable->text != nullptr ? row.variable->text : "";
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
}

void Variables::set(std::string_view name, std::string_view text) {
    registry_.set(name, text);
    for (Row& row : rows_) {
        if (row.name != name) continue;
        row.text = registry_.get_text(name);
        engine_.set(row.name.c_str(), row.text);
    }
}

} // namespace vigil::yamagi
