// SPDX-License-Identifier: GPL-2.0-or-later
// The variable registry: text to value and back, ranges, change counters. The table itself is
// shaders/shared/settings_table.h.
#include "console/cvar.h"

#include "common/ascii_case.h"
#include "common/error.h"
#include "common/log.h"
#include "common/printable.h"
#include "console/preset.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>

namespace vigil {

namespace {

constexpr bool defaults_are_valid() {
#define VIGIL_STRING(...)
#define VIGIL_NUMBER(name, life, affects, value, low, high, help)                                  \
    if (!(low <= value && value <= high)) return false;
#define VIGIL_CHOICE(name, life, affects, value, choices, help)                                    \
    if (choice_index(choices, value) < 0) return false;
    VIGIL_PROGRAM_TABLE(VIGIL_STRING, VIGIL_NUMBER, VIGIL_NUMBER, VIGIL_CHOICE)
    VIGIL_RENDERER_TABLE(VIGIL_STRING, VIGIL_NUMBER, VIGIL_NUMBER, VIGIL_CHOICE, VIGIL_NUMBER,
                         VIGIL_NUMBER, VIGIL_CHOICE)
#undef VIGIL_STRING
#undef VIGIL_NUMBER
#undef VIGIL_CHOICE
    return true;
}
static_assert(defaults_are_valid(), "a default in the table is out of its range or choices");

constexpr std::size_t gpu_row_count() {
    std::size_t count = 0;
    for (const CvarInfo& info : cvar_infos)
        count += info.gpu ? 1 : 0;
    return count;
}
static_assert(sizeof(GpuSettings) == 4 * gpu_row_count(),
              "GpuSettings must have the scalar layout");

std::string_view trim(std::string_view text) {
    const char* space = " \t\r\n";
    const auto first = text.find_first_not_of(space);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(space) - first + 1);
}

double parse_number(const CvarInfo& info, std::string_view text) {
    std::string_view digits = trim(text);
    if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);

    double number = 0;
    const char* end = digits.data() + digits.size();
    const auto [stop, fault] = std::from_chars(digits.data(), end, number);
    if (fault == std::errc::result_out_of_range && stop == end)
        fail("{}: \"{}\" is beyond what a number can hold", info.name, text);
    if (fault != std::errc() || stop != end || std::isnan(number))
        fail("{}: \"{}\" is not a number ({})", info.name, text, cvar_range_text(info));
    return number;
}

double clamp_number(const CvarInfo& info, double number) {
    const double clamped = std::clamp(number, info.minimum, info.maximum);
    if (clamped != number)
        log_warning("{}: {:.9g} is out of range, set to {:.9g} ({})", info.name, number, clamped,
                    cvar_range_text(info));
    return clamped;
}

std::string check_string(const CvarInfo& info, std::string_view text) {
    if (std::ranges::any_of(text, [](char c) { return is_control(c) || c == '"'; }))
        fail("{}: the text holds a double quote or a control character", info.name);
    if (text.size() > cvar_max_bytes)
        fail("{}: the text has {} bytes (limit {})", info.name, text.size(), cvar_max_bytes);
    return std::string(text);
}

int parse_choice(const CvarInfo& info, std::string_view text) {
    const std::string name = ascii_lower(trim(text));
    if (const int index = choice_index(info.choices, name); index >= 0) return index;

    int index = -1;
    const char* end = name.data() + name.size();
    const auto [stop, fault] = std::from_chars(name.data(), end, index);
    if (fault != std::errc() || stop != end || index < 0 || index > info.maximum)
        fail("{}: \"{}\" is none of {}", info.name, text, cvar_range_text(info));
    return index;
}

using Value = std::variant<std::string, int, float>;

/// What a person's text means; throws Error as CvarRegistry::set().
Value parse_value(const CvarInfo& info, std::string_view text) {
    switch (info.type) {
    case CvarType::String:
        return check_string(info, text);
    case CvarType::Choice:
        return parse_choice(info, text);
    case CvarType::Real:
        return static_cast<float>(clamp_number(info, parse_number(info, text)));
    case CvarType::Integer:
        break;
    }
    const double number = clamp_number(info, parse_number(info, text));
    if (number != std::floor(number))
        fail("{}: \"{}\" is not a whole number ({})", info.name, text, cvar_range_text(info));
    return static_cast<int>(number);
}

/// Of pt_preset, which follows other rows.
const CvarInfo& preset_info() {
    static const CvarInfo& info = *find_cvar("pt_preset");
    return info;
}
std::size_t preset_row() {
    return static_cast<std::size_t>(&preset_info() - cvar_infos);
}

} // namespace

CvarRegistry& cvars() {
    static CvarRegistry registry;
    return registry;
}

std::string cvar_text(const CvarInfo& info, const CvarValues& values) {
    if (info.type == CvarType::Choice)
        return std::string(
            choice_name(info.choices, values.*std::get<int CvarValues::*>(info.member)));
    return std::visit([&](auto member) { return fmt::format("{}", values.*member); }, info.member);
}

std::string cvar_default_text(const CvarInfo& info) {
    return cvar_text(info, CvarValues());
}

std::string cvar_range_text(const CvarInfo& info) {
    switch (info.type) {
    case CvarType::String:
        return "text";
    case CvarType::Integer:
        return fmt::format("whole number, {:.0f} to {:.0f}", info.minimum, info.maximum);
    case CvarType::Real:
        return fmt::format("number, {:g} to {:g}", info.minimum, info.maximum);
    case CvarType::Choice:
        break;
    }
    return std::string(info.choices);
}

std::string describe_cvar(const CvarInfo& info, const CvarValues& values) {
    return fmt::format("{} \"{}\" (default \"{}\"; {}): {}", info.name, cvar_text(info, values),
                       cvar_default_text(info), cvar_range_text(info), info.help);
}

std::vector<std::string> choice_names(const CvarInfo& info) {
    std::vector<std::string> names;
    if (info.type == CvarType::Choice)
        for (int i = 0; i < choice_count(info.choices); ++i)
            names.emplace_back(choice_name(info.choices, i));
    return names;
}

std::vector<const CvarInfo*> list_cvars(std::string_view prefix) {
    std::vector<const CvarInfo*> rows;
    for (const CvarInfo& info : cvar_infos)
        if (starts_nocase(info.name, prefix)) rows.push_back(&info);
    std::sort(rows.begin(), rows.end(),
              [](const CvarInfo* a, const CvarInfo* b) { return a->name < b->name; });
    return rows;
}

CvarRegistry::CvarRegistry() {
    for (const CvarInfo& info : cvar_infos)
        states_.push_back({0, cvar_default_text(info)});
}

std::size_t CvarRegistry::row_of(std::string_view name) {
    const CvarInfo* info = find_cvar(name);
    if (!info) fail("{}: unknown variable", name);
    return static_cast<std::size_t>(info - cvar_infos);
}

std::size_t CvarRegistry::row_of(const Member& member) {
    const auto* info = std::find_if(std::begin(cvar_infos), std::end(cvar_infos),
                                    [&](const CvarInfo& row) { return row.member == member; });
    return static_cast<std::size_t>(info - cvar_infos);
}

void CvarRegistry::set_for_this_run(std::string_view name, std::string_view text) {
    const std::size_t row = row_of(name);
    Value value = parse_value(cvar_infos[row], text);
    if (row == preset_row())
        assign_preset(std::get<int>(value));
    else
        assign(row, std::move(value));
}

void CvarRegistry::set(std::string_view name, std::string_view text) {
    set_for_this_run(name, text);
    keep(row_of(name));
}

/// The configuration file keeps the present value; for pt_preset, those that it stands for.
void CvarRegistry::keep(std::size_t row) {
    states_[row].archived = cvar_text(cvar_infos[row], values_);
    if (row != preset_row()) return;
    if (const Preset* preset = find_preset(states_[row].archived))
        for (const PresetSetting& setting : preset->settings)
            keep(row_of(setting.variable));
}

/// False where it has this value already.
bool CvarRegistry::store(std::size_t row, Value value) {
    return std::visit(
        [&](auto member) {
            auto& target = values_.*member;
            auto& source = std::get<std::remove_reference_t<decltype(target)>>(value);
            if (target == source) return false;
            target = std::move(source);
            ++states_[row].changes;
            ++changes_;
            return true;
        },
        cvar_infos[row].member);
}

void CvarRegistry::assign(std::size_t row, Value value) {
    if (store(row, std::move(value)) && is_preset_setting(cvar_infos[row].name))
        store(preset_row(), choice_index(preset_info().choices, preset_name_of(values_)));
}

void CvarRegistry::assign_preset(int choice) {
    const Preset* preset = find_preset(choice_name(preset_info().choices, choice));
    if (preset == nullptr) return; // custom
    for (const PresetSetting& setting : preset->settings) {
        const std::size_t row = row_of(setting.variable);
        store(row, parse_value(cvar_infos[row], setting.value));
    }
    store(preset_row(), choice);
}

void CvarRegistry::reset(std::string_view name) {
    set(name, cvar_default_text(cvar_infos[row_of(name)]));
}

std::string CvarRegistry::get_text(std::string_view name) const {
    return cvar_text(cvar_infos[row_of(name)], values_);
}

std::uint64_t CvarRegistry::changes(std::string_view name) const {
    return states_[row_of(name)].changes;
}

std::string CvarRegistry::archive_text() const {
    // The preset of what is kept: the present one may be for this run only.
    const auto kept_of = [this](std::string_view name) { return states_[row_of(name)].archived; };
    const Preset* preset = preset_with(kept_of);
    std::string text;
    for (const CvarInfo* info : list_cvars()) {
        if (info->life != CvarLife::Archived) continue;
        std::string value = kept_of(info->name);
        if (info == &preset_info())
            value = preset != nullptr ? preset->name : custom_preset;
        else if (preset != nullptr && is_preset_setting(info->name))
            continue;
        if (value != cvar_default_text(*info))
            text += fmt::format("set {} \"{}\"\n", info->name, value);
    }
    return text;
}

} // namespace vigil
