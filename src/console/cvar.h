// SPDX-License-Identifier: GPL-2.0-or-later
// Console variables: typed values generated from shaders/shared/settings_table.h, and the registry
// that sets them by name, keeps them in range and counts changes. It does not read or write files;
// the console commands around it are in builtin_commands.h. Used by the main thread only.
#pragma once

#include "refresh/settings.h"

#include <cstdint>
#include <fmt/format.h>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace vigil {

enum class CvarType { String, Integer, Real, Choice };

/// How long a value lasts; see the table.
enum class CvarLife { Archived, Session, Start };

/// The column "life" of the table: how long a value lasts, and whether the variable is guarded.
namespace cvar_life {
struct Column {
    CvarLife lasts;
    bool guarded;
};
inline constexpr Column Archived{CvarLife::Archived, false};
inline constexpr Column Session{CvarLife::Session, false};
inline constexpr Column GuardedArchived{CvarLife::Archived, true};
inline constexpr Column GuardedSession{CvarLife::Session, true};
inline constexpr Column Start{CvarLife::Start, true};
} // namespace cvar_life

/// The value of every variable, as typed members: values.pt_spp, values.basedir. A choice is the
/// index of its name; compare it with cvar_choice().
struct CvarValues : refresh::Settings {
    VIGIL_PROGRAM_TABLE(VIGIL_STRING_MEMBER, VIGIL_INTEGER_MEMBER, VIGIL_REAL_MEMBER,
                        VIGIL_CHOICE_MEMBER)
};

/// Longest text of a String variable. Scripts repeat variables in one another; this bounds it.
inline constexpr std::size_t cvar_max_bytes = 4096;

/// One row of the table.
struct CvarInfo {
    std::string_view name;
    CvarType type;
    CvarLife life;
    bool guarded; ///< scripts from game archives cannot set it
    Affects affects;
    bool gpu;                 ///< a field of GpuSettings
    double minimum, maximum;  ///< Integer and Real: inclusive range
    std::string_view choices; ///< Choice: names with bars between them
    std::string_view help;
    std::variant<std::string CvarValues::*, int CvarValues::*, float CvarValues::*> member;
};

// clang-format off
inline constexpr CvarInfo cvar_infos[] = {
#define VIGIL_ROW(name, type, life, affects, gpu, low, high, choices, help) \
    {#name, CvarType::type, cvar_life::life.lasts, cvar_life::life.guarded, Affects::affects, gpu, \
     low, high, choices, help, &CvarValues::name},
#define VIGIL_STRING(name, life, affects, value, help) \
    VIGIL_ROW(name, String, life, affects, false, 0, 0, "", help)
#define VIGIL_INTEGER(name, life, affects, value, low, high, help) \
    VIGIL_ROW(name, Integer, life, affects, false, low, high, "", help)
#define VIGIL_REAL(name, life, affects, value, low, high, help) \
    VIGIL_ROW(name, Real, life, affects, false, low, high, "", help)
#define VIGIL_CHOICE(name, life, affects, value, choices, help) \
    VIGIL_ROW(name, Choice, life, affects, false, 0, choice_count(choices) - 1.0, choices, help)
#define VIGIL_GPU_INTEGER(name, life, affects, value, low, high, help) \
    VIGIL_ROW(name, Integer, life, affects, true, low, high, "", help)
#define VIGIL_GPU_REAL(name, life, affects, value, low, high, help) \
    VIGIL_ROW(name, Real, life, affects, true, low, high, "", help)
#define VIGIL_GPU_CHOICE(name, life, affects, value, choices, help) \
    VIGIL_ROW(name, Choice, life, affects, true, 0, choice_count(choices) - 1.0, choices, help)
    VIGIL_PROGRAM_TABLE(VIGIL_STRING, VIGIL_INTEGER, VIGIL_REAL, VIGIL_CHOICE)
    VIGIL_RENDERER_TABLE(VIGIL_STRING, VIGIL_INTEGER, VIGIL_REAL, VIGIL_CHOICE, VIGIL_GPU_INTEGER,
                         VIGIL_GPU_REAL, VIGIL_GPU_CHOICE)
#undef VIGIL_ROW
#undef VIGIL_STRING
#undef VIGIL_INTEGER
#undef VIGIL_REAL
#undef VIGIL_CHOICE
#undef VIGIL_GPU_INTEGER
#undef VIGIL_GPU_REAL
#undef VIGIL_GPU_CHOICE
};
// clang-format on

/// The row of `name`, or null.
constexpr const CvarInfo* find_cvar(std::string_view name) {
    for (const CvarInfo& info : cvar_infos)
        if (info.name == name) return &info;
    return nullptr;
}

/// The value of a named choice, checked when compiling:
/// `if (cvars()->vid_driver == cvar_choice("vid_driver", "headless"))`.
consteval int cvar_choice(std::string_view variable, std::string_view choice) {
    // From the table itself, not from cvar_infos: with -fsanitize=undefined GCC 12 does not take
    // the addresses of its elements for constants.
    int index = -1;
#define VIGIL_SKIP(...)
#define VIGIL_CHOICE(name, life, affects, value, choices, help)                                    \
    if (variable == #name) index = choice_index(choices, choice);
    VIGIL_PROGRAM_TABLE(VIGIL_SKIP, VIGIL_SKIP, VIGIL_SKIP, VIGIL_CHOICE)
#undef VIGIL_SKIP
#undef VIGIL_CHOICE
    return index < 0 ? setting_choice(variable, choice) : index;
}

/// Holds the values. There is one for the program, cvars(); tests make their own.
class CvarRegistry {
public:
    CvarRegistry();

    const CvarValues& values() const { return values_; }
    const CvarValues* operator->() const { return &values_; }

    /// Sets a variable from text. A choice is given by name (in any case) or index. A number
    /// outside the range is clamped and a warning logged. Throws Error when the name is unknown,
    /// when the text is not a number or a choice (NaN is not a number), or when a string holds
    /// control characters or double quotes, which a configuration file could not hold, or more than
    /// cvar_max_bytes.
    ///
    /// pt_preset always says which preset (console/preset.h) the settings are: setting it sets them
    /// all, and setting one of them may make it `custom`. `custom` itself changes nothing.
    void set(std::string_view name, std::string_view text);

    /// As set(), but what the configuration file keeps stays as it was: for the command line.
    void set_for_this_run(std::string_view name, std::string_view text);

    /// Sets a variable that is known when compiling: set(&CvarValues::pt_spp, 4). Same checks as
    /// above.
    template <typename T, typename Part>
    void set(T Part::*member, const std::type_identity_t<T>& value) {
        set(cvar_infos[row_of(member)].name, fmt::format("{}", value));
    }

    /// Back to the default. Throws Error when the name is unknown.
    void reset(std::string_view name);

    /// The value as text that set() accepts; a choice by name. Throws Error when the name is
    /// unknown.
    std::string get_text(std::string_view name) const;

    /// Number of times that the value of this variable, or of any, became another one.
    std::uint64_t changes(std::string_view name) const;
    template <typename T, typename Part> std::uint64_t changes(T Part::*member) const {
        return states_[row_of(member)].changes;
    }
    std::uint64_t changes() const { return changes_; }

    /// Lines `set NAME "VALUE"` for the archived variables that differ from their default. Where
    /// pt_preset's settings are those of a preset, its name stands for them.
    std::string archive_text() const;

private:
    using Value = std::variant<std::string, int, float>;
    using Member = decltype(CvarInfo::member);

    struct State {
        std::uint64_t changes = 0;
        std::string archived; ///< what the configuration file keeps, as text
    };

    static std::size_t row_of(const Member& member);
    static std::size_t row_of(std::string_view name);
    bool store(std::size_t row, Value value);
    void assign(std::size_t row, Value value);
    void assign_preset(int choice);
    void keep(std::size_t row);

    CvarValues values_;
    std::vector<State> states_;
    std::uint64_t changes_ = 0;
};

/// The program's variables.
CvarRegistry& cvars();

/// Rows whose name begins with `prefix` (in any case), sorted by name.
std::vector<const CvarInfo*> list_cvars(std::string_view prefix = {});

/// A row's value or default as text.
std::string cvar_text(const CvarInfo& info, const CvarValues& values);
std::string cvar_default_text(const CvarInfo& info);

/// One line about a variable: value, default, range and help.
std::string describe_cvar(const CvarInfo& info, const CvarValues& values);

/// The names of a Choice, in order; none for other types.
std::vector<std::string> choice_names(const CvarInfo& info);

/// What a person may type: "0 to 1", "sll|uniform|power", "text".
std::string cvar_range_text(const CvarInfo& info);

} // namespace vigil
