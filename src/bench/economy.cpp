// SPDX-License-Identifier: GPL-2.0-or-later
// What `economy` measures of a level: the times of `timing` for every set of features that shaders
// are compiled for, and beside them memory, uploads and the shaders themselves. A feature that the
// level has is no row of its own: its shaders are those of `auto`.
#include "bench/measure.h"
#include "bench/shader_size.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vigil::bench {

using nlohmann::ordered_json;

namespace {

/// Frames that stand still: of the last one, everything from the flight before has settled.
constexpr int still_frames = 4;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

double sum(const gpu::ByteCounts& counts) {
    return std::accumulate(counts.begin(), counts.end(), 0.0, [](double all, const auto& row) {
        return all + static_cast<double>(row.second);
    });
}

ordered_json bytes_json(const gpu::ByteCounts& counts) {
    ordered_json json = {{"value", sum(counts)}, {"by", ordered_json::object()}};
    for (const auto& [name, bytes] : counts)
        json["by"][name] = bytes;
    return json;
}

/// Names of the features that shaders are compiled for.
ordered_json names_json(const vkpt::SceneFeatures& features) {
    ordered_json names = ordered_json::array();
    for (const vkpt::SceneFeatureRow& row : vkpt::scene_feature_rows)
        if (features.*row.member) names.push_back(row.name);
    return names;
}

/// What one pass's shader is for a row.
struct ShaderCost {
    double spirv_bytes = 0.0, code_bytes = 0.0, compile_s = 0.0;
};

/// Of every pass whose shader depends on features; `passes` has their names.
ordered_json shaders_json(const Preparation& made, const std::set<std::string>& passes) {
    ShaderCost all;
    ordered_json rows = ordered_json::array();
    for (const gpu::CompiledPipeline& pipeline : made.pipelines) {
        if (!passes.contains(pipeline.source.name)) continue;
        const ShaderCost cost{static_cast<double>(pipeline.source.spirv.size_bytes()),
                              specialized_bytes(pipeline.source).value_or(nothing),
                              pipeline.seconds};
        all.spirv_bytes += cost.spirv_bytes;
        all.code_bytes += cost.code_bytes;
        all.compile_s += cost.compile_s;
        rows.push_back({{"name", pipeline.source.name},
                        {"spirv_bytes", cost.spirv_bytes},
                        {"code_bytes", cost.code_bytes},
                        {"compile_s", cost.compile_s}});
    }
    return {{"spirv_bytes", {{"value", all.spirv_bytes}}},
            {"code_bytes", {{"value", all.code_bytes}}},
            {"compile_s", {{"value", all.compile_s}}},
            {"shaders", std::move(rows)}};
}

} // namespace

PartReport measure_economy(const QualityOptions& options, QualityRenderer& renderer,
                           const std::string& level, Progress& progress) {
    // A row that is compiled for what an earlier one is compiled for is that row.
    const std::vector<Preparation>& made = renderer.preparations();
    QualityOptions different = options;
    different.rows.clear();
    std::vector<std::size_t> rows; // of options.rows
    std::vector<std::string> same;
    for (std::size_t row = 0; row < made.size(); ++row) {
        const bool known = std::ranges::any_of(
            rows, [&](std::size_t other) { return made[other].features == made[row].features; });
        if (known)
            same.push_back(options.rows[row].label);
        else
            rows.push_back(row);
        if (!known) different.rows.push_back(options.rows[row]);
    }
    progress.skip(options.seeds * static_cast<int>(same.size()));
    // Of the first row, shaders without features are among those that were made.
    std::set<std::string> passes;
    for (const std::size_t row : rows)
        if (row != rows.front() || rows.size() == 1)
            for (const gpu::CompiledPipeline& pipeline : made[row].pipelines)
                passes.insert(pipeline.source.name);

    PartReport report = measure_times(different, renderer, level, progress);
    report.text += fmt::format("\n  {:<14}{:>12}{:>12}{:>12}{:>16}{:>16}\n", "row", "compile s",
                               "code KiB", "memory MiB", "upload, moving", "upload, still");
    for (std::size_t i = 0; i < rows.size(); ++i) {
        ordered_json& json = report.json["rows"][i];
        const Preparation& preparation = made[rows[i]];
        json["features"] = names_json(preparation.features);
        json.update(shaders_json(preparation, passes));
        const StillCost still = renderer.stand(renderer.places().front(), different.rows[i],
                                               options.first_seed, still_frames);
        json["memory_bytes"] = bytes_json(still.memory);
        json["still_upload_bytes"] = bytes_json(still.uploads);
        report.text += fmt::format(
            "  {:<14}{:>12.2f}{:>12.1f}{:>12.1f}{:>16.0f}{:>16.0f}\n", different.rows[i].label,
            json["compile_s"]["value"].get<double>(),
            json["code_bytes"]["value"].get<double>() / 1024.0, sum(still.memory) / 1048576.0,
            json["upload_bytes"]["value"].get<double>(), sum(still.uploads));
    }
    if (!rows.empty()) report.json["features"] = names_json(made[rows.front()].features);
    report.json["same_as_auto"] = same;
    return report;
}

} // namespace vigil::bench
