// SPDX-License-Identifier: GPL-2.0-or-later
// Console variables: typed values generated from shaders/shared/cvar_table.h, and the registry that
// sets them by name, keeps them in range and counts changes. It does not read or write files; the
// console commands around it are in builtin_commands.h. Used by the main thread only.
#pragma once

#include "shared/cvar_table.h"

#include <cstdint>
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

/// Number of choices in "a|b|c".
constexpr int choice_count(std::string_view choices) {
    int count = 1;
    for (char c : choices)
        count += c == '|' ? 1 : 0;
    return count;
}

/// Index of `name` in "a|b|c", or -1.
constexpr int choice_index(std::string_view choices, std::string_view name) {
    for (int index = 0;; ++index) {
        const auto bar = choices.find('|');
        if (choices.substr(0, bar) == name) return index;
        if (bar == std::string_view::npos) return -1;
        choices.remove_prefix(bar + 1);
    }
}

/// Name number `index` of "a|b|c"; index must be in range.
constexpr std::string_view choice_name(std::string_view choices, int index) {
    for (; index > 0; --index)
        choices.remove_prefix(choices.find('|') + 1);
    return choices.substr(0, choices.find('|'));
}

/// The value of every variable, as typed members: values.pt_spp, values.basedir. A choice is the
/// index of its name; compare it with cvar_choice().
struct CvarValues {
#define VIGIL_STRING(name, life, value, help) std::string name = value;
#define VIGIL_INTEGER(name, life, value, low, high, help) int name = value;
#define VIGIL_REAL(name, life, value, low, high, help) float name = static_cast<float>(value);
#define VIGIL_CHOICE(name, life, value, choices, help) int name = choice_index(choices, value);
    VIGIL_CVAR_TABLE(VIGIL_STRING, VIGIL_INTEGER, VIGIL_REAL, VIGIL_CHOICE, VIGIL_INTEGER,
                     VIGIL_REAL, VIGIL_CHOICE)
#undef VIGIL_STRING
#undef VIGIL_INTEGER
#undef VIGIL_REAL
#undef VIGIL_CHOICE
};

/// Longest text of a String variable. Scripts repeat variables in one another; this bounds it.
inline constexpr std::size_t cvar_max_bytes = 4096;

/// One row of the table.
struct CvarInfo {
    std::string_view name;
    CvarType type;
    CvarLife life;
    bool guarded;             ///< scripts from game archives cannot set it
    bool gpu;                 ///< a field of GpuCvars
    double minimum, maximum;  ///< Integer and Real: inclusive range
    std::string_view choices; ///< Choice: names with bars between them
    std::string_view help;
    std::variant<std::string CvarValues::*, int CvarValues::*, float CvarValues::*> member;
};

// clang-format off
inline constexpr CvarInfo cvar_infos[] = {
#define VIGIL_STRING(name, life, value, help) \
    {#name, CvarType::String, cvar_life::life.lasts, cvar_life::life.guarded, false, 0, 0, "", help, \
     &CvarValues::name},
#define VIGIL_NUMBER_ROW(name, type, life, gpu, low, high, help) \
    {#name, CvarType::type, cvar_life::life.lasts, cvar_life::life.guarded, gpu, low, high, "", help, \
     &CvarValues::name},
#define VIGIL_CHOICE_ROW(name, life, gpu, choices, help) \
    {#name, CvarType::Choice, cvar_life::life.lasts, cvar_life::life.guarded, gpu, 0, \
     choice_count(choices) - 1.0, choices, help, &CvarValues::name},
#define VIGIL_INTEGER(name, life, value, low, high, help) \
    VIGIL_NUMBER_ROW(name, Integer, life, false, low, high, help)
#define VIGIL_REAL(name, life, value, low, high, help) \
    VIGIL_NUMBER_ROW(name, Real, life, false, low, high, help)
#define VIGIL_CHOICE(name, life, value, choices, help) \
    VIGIL_CHOICE_ROW(name, life, false, choices, help)
#define VIGIL_GPU_INTEGER(name, life, value, low, high, help) \
    VIGIL_NUMBER_ROW(name, Integer, life, true, low, high, help)
#define VIGIL_GPU_REAL(name, life, value, low, high, help) \
    VIGIL_NUMBER_ROW(name, Real, life, true, low, high, help)
#define VIGIL_GPU_CHOICE(name, life, value, choices, help) \
    VIGIL_CHOICE_ROW(name, life, true, choices, help)
    VIGIL_CVAR_TABLE(VIGIL_STRING, VIGIL_INTEGER, VIGIL_REAL, VIGIL_CHOICE, VIGIL_GPU_INTEGER,
                     VIGIL_GPU_REAL, VIGIL_GPU_CHOICE)
#undef VIGIL_STRING
#undef VIGIL_NUMBER_ROW
#undef VIGIL_CHOICE_ROW
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
#define VIGIL_STRING(name, life, value, help)
#define VIGIL_NUMBER(name, life, value, low, high, help)
#define VIGIL_CHOICE(name, life, value, choices, help)                                             \
    if (variable == #name) index = choice_index(choices, choice);
    VIGIL_CVAR_TABLE(VIGIL_STRING, VIGIL_NUMBER, VIGIL_NUMBER, VIGIL_CHOICE, VIGIL_NUMBER,
                     VIGIL_NUMBER, VIGIL_CHOICE)
#undef VIGIL_STRING
#undef VIGIL_NUMBER
#undef VIGIL_CHOICE
    if (index < 0) throw "no such variable or choice";
    return index;
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
    void set(std::string_view name, std::string_view text);

    /// As set(), but what the configuration file keeps stays as it was: for the command line.
    void set_for_this_run(std::string_view name, std::string_view text);

    /// Sets a variable that is known when compiling: set(&CvarValues::pt_spp, 4). Same checks as
    /// above.
    template <typename T> void set(T CvarValues::*member, const std::type_identity_t<T>& value) {
        set_member(member, value);
    }

    /// Back to the default. Throws Error when the name is unknown.
    void reset(std::string_view name);

    /// The value as text that set() accepts; a choice by name. Throws Error when the name is
    /// unknown.
    std::string get_text(std::string_view name) const;

    /// Number of times that the value of this variable, or of any, became another one.
    std::uint64_t changes(std::string_view name) const;
    template <typename T> std::uint64_t changes(T CvarValues::*member) const {
        return states_[row_of(member)].changes;
    }
    std::uint64_t changes() const { return changes_; }

    /// The fields that shaders read.
    GpuCvars gpu_values() const;

    /// Lines `set NAME "VALUE"` for the archived variables that differ from their default.
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
    void set_member(const Member& member, Value value);
    void assign(std::size_t row, Value value);

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
