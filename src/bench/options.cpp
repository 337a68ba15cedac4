// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/options.h"

#include "bench/quality_estimate.h"
#include "common/error.h"
#include "console/cvar.h"
#include "console/preset.h"
#include "shared/techniques.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

namespace vigil::bench {

namespace {

/// Where rays alone find light (pt_env_nee 0, and a sun behind a gap), nothing else converges in
/// time.
const std::string default_reference = "vlc+cdq";

/// CLI11 with what all benchmarks have in common.
class Parser : public CLI::App {
public:
    Parser() {
        // What is said twice: the last one counts.
        option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    }

    void add_count(const std::string& name, int& value, int low, int high,
                   const std::string& help) {
        add_option(name, value, help)->check(CLI::Range(low, high))->capture_default_str();
    }

    void add_basedirs(std::vector<std::filesystem::path>& folders) {
        folders = {".", VIGIL_SOURCE_DIR};
        if (const char* shared = std::getenv("VIGIL_SHARED"))
            folders.push_back(std::filesystem::path(shared) / "levels");
        add_option("--basedir", folders, "where levels are looked for, in this order");
    }

    void read(std::span<const std::string> words) {
        try {
            parse(std::vector<std::string>(words.rbegin(), words.rend())); // as CLI11 wants them
        } catch (const CLI::CallForHelp&) {
            fmt::print("{}", help());
            std::exit(0);
        } catch (const CLI::ParseError& error) {
            fail("{} (--help lists the options)", error.what());
        }
    }
};

bool has_row(const QualityOptions& options, std::string_view label) {
    return std::ranges::find(options.rows, label, &QualityRow::label) != options.rows.end();
}

/// Fills what the command line left open.
void complete(QualityOptions& options) {
    for (auto row = options.rows.begin(); row != options.rows.end(); ++row)
        if (std::find_if(options.rows.begin(), row,
                         [&](const QualityRow& other) { return other.label == row->label; }) != row)
            fail("two rows are called {}", row->label);
    if (options.baseline.empty())
        options.baseline = has_row(options, "sll") ? "sll" : options.rows.front().label;
    if (!has_row(options, options.baseline)) fail("--baseline {}: no such row", options.baseline);
    // A row by its label, else a technique.
    const std::string reference =
        options.reference.label.empty() ? default_reference : options.reference.label;
    const auto row = std::ranges::find(options.rows, reference, &QualityRow::label);
    options.reference = row != options.rows.end() ? *row : technique_row(reference);
}

/// A variable that exists.
Setting setting_of(std::string_view option, std::string_view name, std::string_view value) {
    if (!find_cvar(name)) fail("{}: no variable is called {}", option, name);
    return {std::string(name), std::string(value)};
}

} // namespace

QualityRow parse_variant(std::string_view text) {
    const std::size_t colon = text.find(':');
    if (colon == 0 || colon == std::string_view::npos)
        fail("--variant {}: expected LABEL:NAME=VALUE,NAME=VALUE", text);
    QualityRow row{std::string(text.substr(0, colon)), {}};
    std::istringstream words{std::string(text.substr(colon + 1))};
    for (std::string word; std::getline(words, word, ',');) {
        const std::size_t equals = word.find('=');
        if (equals == 0 || equals == std::string::npos)
            fail("--variant {}: {} is not NAME=VALUE", row.label, word);
        row.settings.push_back(
            setting_of("--variant " + row.label, word.substr(0, equals), word.substr(equals + 1)));
    }
    if (row.settings.empty()) fail("--variant {}: no variables", row.label);
    return row;
}

QualityRow technique_row(std::string_view name) {
    const std::optional<TechniqueRow> row = find_technique_row(name);
    if (!row)
        fail("{}: no such technique; known are {}, each also with + and one of {}", name,
             technique_choices, guider_choices);
    const std::string_view technique = technique_infos[static_cast<size_t>(row->technique)].name;
    return {std::string(name),
            {{"pt_nee", std::string(technique)},
             {"pt_guide", std::string(guider_infos[static_cast<size_t>(row->guide)].name)}}};
}

std::vector<QualityRow> technique_rows(std::initializer_list<std::string_view> names) {
    std::vector<QualityRow> rows;
    std::ranges::transform(names, std::back_inserter(rows), technique_row);
    return rows;
}

std::vector<QualityRow> technique_rows() {
    std::vector<QualityRow> rows;
    for (const TechniqueInfo& info : technique_infos)
        if (info.name != "brute") rows.push_back(technique_row(info.name));
    return rows;
}

QualityRow preset_row(std::string_view name) {
    const Preset* preset = find_preset(name);
    if (preset == nullptr) fail("{}: no such preset; pt_preset at the console lists them", name);
    QualityRow row{fmt::format("preset {}", name), {}};
    for (const PresetSetting& setting : preset->settings)
        row.settings.push_back({std::string(setting.variable), setting.value});
    return row;
}

std::vector<QualityRow> picture_rows(std::string_view technique) {
    const QualityRow base = technique_row(technique);
    // Camera rays go through the middles of pixels in references, so they do here.
    const QualityRow filters[] = {
        {"raw", {{"flt_enable", "0"}}},
        {"temporal", {{"flt_enable", "1"}, {"flt_taa", "0"}, {"flt_atrous", "0"}}},
        {"full", {{"flt_enable", "1"}, {"flt_taa", "0"}}},
        {"svgf-like",
         {{"flt_enable", "1"},
          {"flt_taa", "0"},
          {"flt_history", "5"}, // a new frame counts for a fifth
          {"flt_atrous", "5"},
          {"flt_noise", "0"},
          {"flt_sigma", "4"},
          {"flt_firefly", "0"},
          {"flt_antilag", "0"}}}};
    std::vector<QualityRow> rows;
    for (const QualityRow& filter : filters) {
        QualityRow& row = rows.emplace_back(filter);
        if (technique != default_reference) row.label += fmt::format(" {}", technique);
        row.settings.insert(row.settings.begin(), base.settings.begin(), base.settings.end());
    }
    return rows;
}

std::vector<QualityRow> ring_rows(std::span<const int> bits) {
    std::vector<QualityRow> rows;
    for (const int size : bits)
        rows.push_back(
            {fmt::format("cdq{}", size),
             {{"pt_nee", "vlc"}, {"pt_guide", "cdq"}, {"pt_cdq_bits", std::to_string(size)}}});
    rows.push_back({"brdf", {{"pt_nee", "vlc"}, {"pt_guide", "brdf"}}});
    return rows;
}

bool is_guided(const QualityRow& row) {
    return std::ranges::any_of(row.settings, [](const Setting& setting) {
        return setting.name == "pt_guide" && setting.value != "brdf";
    });
}

std::filesystem::path folder_with(std::span<const std::filesystem::path> basedirs,
                                  const std::string& level) {
    for (const std::filesystem::path& basedir : basedirs)
        if (std::filesystem::exists(basedir / "baseq2/maps" / (level + ".bsp"))) return basedir;
    return {};
}

std::string_view changing_name(Changing changing) {
    switch (changing) {
    case Changing::Lamp:
        return "lamp";
    case Changing::Door:
        return "door";
    case Changing::Strobe:
        return "strobe";
    case Changing::Nothing:
        break;
    }
    return "";
}

QualityOptions parse_quality_options(std::span<const std::string> arguments,
                                     const QualityDefaults& defaults) {
    bool quick = std::ranges::find(arguments, "--quick") != arguments.end();
    QualityOptions options = quick ? defaults.quick : defaults.options;
    const bool turns = options.measured == Measured::Turn;
    Parser parser;
    parser.add_flag("--quick", quick, "little of everything"); // known before all others
    const auto read_size = [&size = options.size](const std::string& text) {
        char rest = 0;
        const auto fits = [](int pixels) { return pixels >= 16 && pixels <= 16384; };
        if (std::sscanf(text.c_str(), "%dx%d%c", &size.x, &size.y, &rest) != 2 || !fits(size.x) ||
            !fits(size.y))
            fail("--size {}: expected WIDTHxHEIGHT, each from 16 to 16384", text);
    };
    parser.add_option_function<std::string>("--size", read_size, "pixels")
        ->type_name("WxH")
        ->default_str(fmt::format("{}x{}", options.size.x, options.size.y));
    parser.add_count("--seeds", options.seeds, 1, 1000, "repeats");
    if (options.measured != Measured::Route)
        parser.add_count("--frames", options.frames, turns ? 2 * ring_tail : 1, turns ? 10000 : 900,
                         "frames measured in each run");
    parser.add_count("--reference-paths", options.reference_paths, turns ? 48 : 2, 100000000,
                     "most paths per pixel of a reference");
    parser.add_flag("--fresh", options.fresh, "make references anew");
    parser.add_flag("--keep", options.keep, "leave a finished report of the same measurement");
    std::vector<std::pair<std::string, std::string>> settings;
    parser.add_option("--set", settings, "a variable for all rows and references")
        ->type_name("NAME VALUE");
    parser.add_option("--part", options.parts, "only parts whose names begin so");
    parser.add_option("--json", options.json, "the report; without it NAME.json below outdir");
    parser.add_basedirs(options.basedirs);
    std::vector<std::string> techniques, variants, presets;
    bool shared = false;
    if (turns) {
        parser.add_count("--settle", options.settle, 1, 10000, "frames before the turn");
        parser.add_option("--turn", options.turns, "of the lamp, degrees")
            ->check(CLI::Range(1, 359));
        parser.add_option("--bits", options.bits, "size of a quadtree")
            ->check(CLI::IsMember({32, 64, 96, 128}));
    } else {
        parser.add_option("--level", options.levels, "a level");
        parser.add_flag("--shared", shared, "dm3, e1m1, e3m4, e3m6, end and start");
        parser.add_count("--views", options.views, 1, 1000, "places per level");
        parser.add_count("--first-seed", options.first_seed, 0, 1000000,
                         "seed of the first repeat");
        parser.add_count("--warmup", options.warmup, 0, 900, "frames before the measured ones");
        parser.add_option("--technique", techniques, "a row: NAME, or NAME+cdq with guided rays");
        parser.add_option("--preset", presets, "one more row: what pt_preset NAME sets");
        parser.add_option("--variant", variants, "one more row: LABEL:NAME=VALUE,...");
        parser.add_option("--baseline", options.baseline, "the row that ratios are relative to");
        parser.add_option("--reference", options.reference.label,
                          "row or technique that renders references");
    }
    if (options.measured == Measured::Curve) {
        std::map<std::string, Changing> changes;
        for (const Changing change : {Changing::Lamp, Changing::Door, Changing::Strobe})
            changes.emplace(changing_name(change), change);
        parser
            .add_option("--change", options.changing,
                        "frames count from when a lamp goes on, a door opens, or all lights dim")
            ->transform(CLI::Transformer(changes));
    }
    if (options.measured == Measured::Errors) {
        parser.add_flag("--floor", options.floor, "the least error that a choice of lights leaves");
        parser.add_option("--pictures", options.pictures, "folder for references and runs");
    }
    if (options.measured == Measured::Route) {
        parser.add_option("--pictures", options.pictures,
                          "folder for references, runs, albedo and normals");
    }
    if (!options.trade.empty())
        parser.add_option("--trade", options.trade, "the report whose values are measured again");
    parser.read(arguments);

    if (options.measured == Measured::Curve && options.frames <= settled_tail)
        fail("--frames {}: a curve needs more than {}", options.frames, settled_tail);
    for (const auto& [name, value] : settings)
        options.settings.push_back(setting_of("--set", name, value));
    // The light of the first hit alone, all of it by lights: the floor is that of choosing them.
    if (options.floor)
        options.settings.insert(options.settings.begin(),
                                {{"pt_bounces", "0"}, {"pt_env_nee", "1"}});
    if (shared) {
        if (parser.count("--level") == 0) options.levels.clear();
        options.levels.insert(options.levels.end(),
                              {"dm3", "e1m1", "e3m4", "e3m6", "end", "start"});
    }
    if (turns) options.rows = ring_rows(options.bits);
    if (!techniques.empty()) options.rows.clear();
    for (const std::string& name : techniques) {
        if (defaults.rows_of)
            std::ranges::move(defaults.rows_of(name), std::back_inserter(options.rows));
        else
            options.rows.push_back(technique_row(name));
    }
    for (const std::string& name : presets) {
        const QualityRow row = preset_row(name);
        if (!has_row(options, row.label)) options.rows.push_back(row);
    }
    std::ranges::transform(variants, std::back_inserter(options.rows), parse_variant);
    complete(options);
    return options;
}

TraceOptions parse_trace_options(std::span<const std::string> arguments) {
    TraceOptions options;
    Parser parser;
    parser.add_flag("--quick", options.quick, "fewer rays");
    parser.add_flag("--texels", options.texels, "nodes as texels");
    parser.add_option("--json", options.json, "the report as a file");
    parser.add_basedirs(options.basedirs);
    parser.add_option("--level", options.levels, "a level, or `random` triangles");
    parser.read(arguments);
    return options;
}

void parse_no_options(std::span<const std::string> arguments) {
    Parser().read(arguments);
}

} // namespace vigil::bench
