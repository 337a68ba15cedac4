// SPDX-License-Identifier: GPL-2.0-or-later
// What an experiment about quality is asked to do, as data: levels, rows (a technique with
// variables), and how often and how long to measure. Parsed from the command line; docs/quality.md
// lists it.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vigil::bench {

/// A console variable and its value as text.
struct Setting {
    std::string name;
    std::string value;
};

/// One row of the tables: what it is called, and the variables that make it what it is.
struct QualityRow {
    std::string label;
    std::vector<Setting> settings;
};

/// What is measured of every row.
enum class Measured {
    Errors, // of single frames after a warm-up, and times
    Curve,  // errors frame by frame from an empty cache, standing still
    Times   // of every frame of the warm-up, by pass; no references
};

struct QualityOptions {
    Measured measured = Measured::Errors;
    std::vector<std::string> levels;
    std::vector<std::filesystem::path> basedirs; // the first that has the level is taken
    std::vector<Setting> settings;               // for all rows and references
    std::vector<QualityRow> rows;
    std::string baseline;       // label of the row that others are compared with
    QualityRow reference;       // renders references
    int views = 4;              // places per level
    int seeds = 8;              // repeats
    int first_seed = 1;         // pt_seed of the first
    bool floor = false;         // direct light alone, and the best that a choice of lights can do
    int warmup = 16;            // frames before the measured ones
    int frames = 1;             // measured in each run, or of the curve
    glm::ivec2 size{320, 180};  // pixels
    int reference_paths = 1024; // most paths per pixel of a reference
    double reference_share = 0.02;  // of the smallest MSE: variance that a reference may have
    bool fresh = false;             // references are made anew
    bool keep = false;              // a finished report of the same measurement is left as it is
    std::vector<std::string> parts; // only those parts whose names begin so; empty: all
    std::string json;               // empty: NAME.json below outdir
    std::string trade;              // of `confirm`: the report whose values are measured again
    std::string pictures;           // folder for pictures of references and runs; empty: none
};

/// What an experiment does when nothing else is said.
struct QualityDefaults {
    QualityOptions options;
    QualityOptions quick; // with --quick
};

/// Parses the words after an experiment's name. `rows` of the defaults are those when no technique
/// is named. Throws Error that lists the options when one is unknown, and when a value is no
/// number, out of range, or names no technique.
QualityOptions parse_quality_options(std::span<const std::string> arguments,
                                     const QualityDefaults& defaults);

/// "LABEL:NAME=VALUE,NAME=VALUE". Throws Error when it is not of this form or no variable is called
/// NAME.
QualityRow parse_variant(std::string_view text);

/// The row of a technique with rays drawn by the BRDF; "NAME+cdq" is the same with guided rays.
/// Throws Error when there is no such technique.
QualityRow technique_row(std::string_view name);

/// Whether a row draws rays from quadtrees.
bool is_guided(const QualityRow& row);

/// One row per technique, in the order of shaders/shared/techniques.h, without `brute`.
std::vector<QualityRow> technique_rows();

} // namespace vigil::bench
