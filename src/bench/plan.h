// SPDX-License-Identifier: GPL-2.0-or-later
// An experiment as a list of parts, each a level and how it is measured: what `quality`, `adapt`,
// `ring`, `timing`, `scale`, `trade`, `confirm`, `picture` and `economy` are. All share options,
// progress, references, and the report that is continued after an interruption.
#pragma once

#include "bench/options.h"

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vigil::bench {

/// A shipped level that experiments measure.
struct MeasuredLevel {
    std::string_view name;
    /// Frames that quadtrees need there, where that is more than the light cache does; else 0.
    int quadtree_frames = 0;
};
inline constexpr MeasuredLevel measured_levels[] = {
    {"warehouse"},
    // Few rays meet their sun, where they have to (pt_env_nee 0).
    {"mine", 64},
    {"gallery"},
    {"yard", 64},
    {"room", 64},
    {"quay"},
};
/// Their names.
std::vector<std::string> measured_level_names();

struct Part {
    std::string name; // unique in its plan
    std::string level;
    QualityOptions options; // with the settings of this part; `levels` is of no importance
    std::string axis;       // what grows from part to part; empty: nothing does
    double value = 0.0;     // of what grows
};

struct Plan {
    std::string name;       // of the report
    QualityOptions options; // of the command line
    std::vector<Part> parts;
    nlohmann::ordered_json about = nlohmann::ordered_json::object(); // more for the report's head
};

/// One part per level. Errors of single frames: techniques with and without guided rays.
Plan quality_plan(std::span<const std::string> arguments);
/// Errors by frame from an empty cache, as the paper's figure 9.
Plan adapt_plan(std::span<const std::string> arguments);
/// How fast quadtrees follow a light that turns, a part per turn, as the paper's figure 10.
Plan ring_plan(std::span<const std::string> arguments);
/// Times of every frame of a camera route by pass, as the paper's figures 11 and 12.
Plan timing_plan(std::span<const std::string> arguments);
/// Cost and error against the number of lights, of pixels and of triangles.
Plan scale_plan(std::span<const std::string> arguments);
/// What every variable buys and costs: rows are values of one variable, parts are levels and
/// variables. The table is in trade_plan.cpp.
Plan trade_plan(std::span<const std::string> arguments);

/// How calm pictures are, and what that costs: parts are levels and situations (a moving camera, a
/// still one, changes of light, cuts), rows are filters.
Plan picture_plan(std::span<const std::string> arguments);

/// What each feature that a level lacks costs where shaders are compiled for it all the same
/// (pt_features): time, memory, uploads, and the shaders themselves. Parts are levels, rows
/// features.
Plan economy_plan(std::span<const std::string> arguments);

/// The values that the report of `trade` (--trade FILE) takes for better than the default, once
/// more: with fresh seeds, against the default alone. No parts where there is no such value. Throws
/// Error when that report is not finished or has some of these seeds.
Plan confirm_plan(std::span<const std::string> arguments);

/// Parts with guided rays, of levels in which quadtrees learn late (a table in plan.cpp), get the
/// warm-up that they need there, unless `arguments` hold --warmup or --quick.
void warm_up_quadtrees(Plan& plan, std::span<const std::string> arguments);

/// Whether the words have an option.
bool is_named(std::span<const std::string> arguments, std::string_view option);

/// What `trade` and `confirm` do with --quick: one small picture of everything.
QualityOptions least(QualityOptions options);

/// Drops the parts that --part leaves out. Throws Error, which names all, when none is left.
void select_parts(Plan& plan);

/// Measures what the report does not have yet; prints tables to stdout, progress to stderr; writes
/// NAME.json and NAME.csv. Returns the program's exit status: 1 when a part failed.
int run_plan(const Plan& plan);

} // namespace vigil::bench
