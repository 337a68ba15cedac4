// SPDX-License-Identifier: GPL-2.0-or-later
// What a benchmark is asked to do, as data: levels, rows (a technique with variables), and how
// often and how long to measure. Parsed from the command line by CLI11, whose --help lists all;
// docs/research/quality.md explains them.
#pragma once

#include <filesystem>
#include <functional>
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
    Curve,  // errors frame by frame from an empty cache, or after a change, standing still
    Times,  // of every frame of the warm-up, by pass; no references
    Turn,   // errors frame by frame after a lamp has turned
    Route,  // of `picture`: errors and FLIP of frames while the camera moves, and times
    Still,  // flicker and detail of a view that stands still, flicker of one that moves
    Change, // how fast light that comes or goes is shown
    Cut,    // errors after the camera was elsewhere
    Economy // Times, and memory, uploads and shaders by what these are compiled for
};

/// What changes in a scene.
enum class Changing {
    Nothing,
    Lamp,  // one that moves at once, or is switched on
    Door,  // one that is gone at once
    Strobe // all lights, to a quarter
};
/// What options and parts call it.
std::string_view changing_name(Changing changing);

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
    Changing changing = Changing::Nothing; // of Measured::Change, and of Curve after the warm-up
    // Of `ring`: frames before the lamp turns, its turns in degrees, and sizes of quadtrees.
    int settle = 0;
    std::vector<int> turns, bits;
};

/// What an experiment does when nothing else is said.
struct QualityDefaults {
    QualityOptions options;
    QualityOptions quick; // with --quick
    /// Rows of a technique that is asked for; empty: the technique itself.
    std::function<std::vector<QualityRow>(std::string_view technique)> rows_of = {};
};

/// Parses the words after an experiment's name; which options there are depends on what is
/// measured. Named levels, techniques, turns and sizes replace those of the defaults. Throws Error
/// when an option is unknown or a value is no number, out of range, or names nothing. Prints the
/// options and exits with --help.
QualityOptions parse_quality_options(std::span<const std::string> arguments,
                                     const QualityDefaults& defaults);

/// Of `trace`.
struct TraceOptions {
    bool quick = false;  // fewer rays
    bool texels = false; // nodes as texels, not as a storage buffer
    std::string json;    // empty: none
    std::vector<std::filesystem::path> basedirs;
    std::vector<std::string> levels = {"warehouse", "gallery", "yard", "room", "e3m6", "random"};
};
TraceOptions parse_trace_options(std::span<const std::string> arguments);

/// Of a benchmark without any.
void parse_no_options(std::span<const std::string> arguments);

/// The first of the folders that has maps/LEVEL.bsp; empty where none has.
std::filesystem::path folder_with(std::span<const std::filesystem::path> basedirs,
                                  const std::string& level);

/// "LABEL:NAME=VALUE,NAME=VALUE". Throws Error when it is not of this form or no variable is called
/// NAME.
QualityRow parse_variant(std::string_view text);

/// The row of a technique with rays drawn by the BRDF; "NAME+cdq" is the same with guided rays.
/// Throws Error when there is no such technique.
QualityRow technique_row(std::string_view name);

/// Those of several names.
std::vector<QualityRow> technique_rows(std::initializer_list<std::string_view> names);

/// One row per technique, in the order of shaders/shared/techniques.h, without `brute`.
std::vector<QualityRow> technique_rows();

/// The row `preset NAME`, with the variables of pt_preset NAME. Throws Error when there is no such
/// preset.
QualityRow preset_row(std::string_view name);

/// The raw picture, with its light averaged over time, filtered, and filtered with what SVGF
/// (Schied et al. 2017) has in place of our variables, all with rays of a technique. Labels name
/// the technique unless it is vlc+cdq.
std::vector<QualityRow> picture_rows(std::string_view technique);

/// One row per size of quadtree, bits, and one with rays drawn by the BRDF alone, the last.
std::vector<QualityRow> ring_rows(std::span<const int> bits);

/// Whether a row draws rays from quadtrees.
bool is_guided(const QualityRow& row);

} // namespace vigil::bench
