// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/quality_options.h"

#include "bench/option_values.h"
#include "bench/quality_estimate.h"
#include "common/error.h"
#include "console/cvar.h"
#include "shared/techniques.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace vigil::bench {

namespace {

constexpr std::string_view usage =
    "--level NAME, --basedir FOLDER, --shared, --views N, --seeds S, --first-seed N, --warmup W, "
    "--frames N, --size WxH, --technique NAME, --variant LABEL:NAME=VALUE,..., --set NAME VALUE, "
    "--baseline LABEL, --reference ROW, --reference-paths N, --fresh, --floor, --quick, --part "
    "NAME, --keep, --json FILE, --trade FILE, --pictures FOLDER";

/// Where rays alone find the light (a sun behind a gap), nothing else converges in time.
const std::string default_reference = "vlc+cdq";

/// Fills what the command line left open.
void complete(QualityOptions& options, std::vector<QualityRow> techniques,
              const std::vector<QualityRow>& variants) {
    if (options.basedirs.empty()) options.basedirs = default_basedirs();
    if (!techniques.empty()) options.rows = std::move(techniques);
    options.rows.insert(options.rows.end(), variants.begin(), variants.end());
    for (auto row = options.rows.begin(); row != options.rows.end(); ++row)
        if (std::any_of(options.rows.begin(), row,
                        [&](const QualityRow& other) { return other.label == row->label; }))
            fail("two rows are called {}", row->label);
    const auto has_row = [&](std::string_view label) {
        return std::ranges::any_of(options.rows,
                                   [&](const QualityRow& row) { return row.label == label; });
    };
    if (options.baseline.empty())
        options.baseline = has_row("sll") ? "sll" : options.rows.front().label;
    if (!has_row(options.baseline)) fail("--baseline {}: no such row", options.baseline);
    // A row by its label, else a technique.
    const std::string reference =
        options.reference.label.empty() ? default_reference : options.reference.label;
    const auto row = std::ranges::find(options.rows, reference, &QualityRow::label);
    options.reference = row != options.rows.end() ? *row : technique_row(reference);
}

} // namespace

QualityRow parse_variant(std::string_view text) {
    const std::size_t colon = text.find(':');
    if (colon == 0 || colon == std::string_view::npos)
        fail("--variant {}: expected LABEL:NAME=VALUE,NAME=VALUE", text);
    QualityRow row{std::string(text.substr(0, colon)), {}};
    text.remove_prefix(colon + 1);
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(','));
        text.remove_prefix(std::min(text.size(), word.size() + 1));
        const std::size_t equals = word.find('=');
        if (equals == 0 || equals == std::string_view::npos)
            fail("--variant {}: {} is not NAME=VALUE", row.label, word);
        const std::string_view name = word.substr(0, equals);
        if (!find_cvar(name)) fail("--variant {}: no variable is called {}", row.label, name);
        row.settings.push_back({std::string(name), std::string(word.substr(equals + 1))});
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

bool is_guided(const QualityRow& row) {
    return std::ranges::any_of(row.settings, [](const Setting& setting) {
        return setting.name == "pt_guide" && setting.value != "brdf";
    });
}

std::vector<QualityRow> technique_rows() {
    std::vector<QualityRow> rows;
    for (const TechniqueInfo& info : technique_infos)
        if (info.name != "brute") rows.push_back(technique_row(info.name));
    return rows;
}

QualityOptions parse_quality_options(std::span<const std::string> arguments,
                                     const QualityDefaults& defaults) {
    const bool quick = std::ranges::find(arguments, "--quick") != arguments.end();
    QualityOptions options = quick ? defaults.quick : defaults.options;
    std::vector<QualityRow> techniques, variants;
    std::vector<std::string> levels; // named ones replace the default
    OptionWords words(arguments);
    const auto value = [&]() -> const std::string& { return words.value(); };
    const auto count = [&](std::string_view option, int& number, int low, int high) {
        number = parse_count(option, value(), low, high);
    };
    const OptionWords::Actions actions = {
        {"--quick", [] {}}, // above, before all others
        {"--level", [&] { levels.push_back(value()); }},
        {"--basedir", [&] { options.basedirs.emplace_back(value()); }},
        {"--shared",
         [&] {
             levels.insert(levels.end(), {"dm3", "e1m1", "e3m4", "e3m6", "end", "start"});
         }},
        {"--views", [&] { count("--views", options.views, 1, 1000); }},
        {"--seeds", [&] { count("--seeds", options.seeds, 1, 1000); }},
        {"--first-seed", [&] { count("--first-seed", options.first_seed, 0, 1000000); }},
        {"--warmup", [&] { count("--warmup", options.warmup, 0, 900); }},
        {"--frames", [&] { count("--frames", options.frames, 1, 900); }},
        {"--size", [&] { options.size = parse_size("--size", value()); }},
        {"--technique", [&] { techniques.push_back(technique_row(value())); }},
        {"--variant", [&] { variants.push_back(parse_variant(value())); }},
        {"--set",
         [&] {
             const std::string name = value();
             options.settings.push_back(parse_setting("--set", name, value()));
         }},
        {"--baseline", [&] { options.baseline = value(); }},
        {"--reference", [&] { options.reference.label = value(); }},
        {"--reference-paths",
         [&] { count("--reference-paths", options.reference_paths, 2, 100000000); }},
        {"--fresh", [&] { options.fresh = true; }},
        {"--floor", [&] { options.floor = true; }},
        {"--part", [&] { options.parts.push_back(value()); }},
        {"--keep", [&] { options.keep = true; }},
        {"--json", [&] { options.json = value(); }},
        {"--trade",
         [&] {
             if (options.trade.empty()) fail("--trade belongs to confirm");
             options.trade = value();
         }},
        {"--pictures", [&] { options.pictures = value(); }},
    };
    words.run(actions, usage);
    if (options.measured != Measured::Errors && (options.floor || !options.pictures.empty()))
        fail("--floor and --pictures belong to single frames");
    if (options.measured == Measured::Curve && options.frames <= settled_tail)
        fail("--frames {}: a curve needs more than {}", options.frames, settled_tail);
    // Light that no technique samples is not for the floor to explain.
    if (options.floor)
        options.settings.insert(
            options.settings.begin(),
            {{"pt_bounces", "0"}, {"pt_sky_scale", "0"}, {"pt_sun_scale", "0"}});
    if (!levels.empty()) options.levels = std::move(levels);
    complete(options, std::move(techniques), variants);
    return options;
}

} // namespace vigil::bench
