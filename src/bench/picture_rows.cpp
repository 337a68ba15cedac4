// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/picture_rows.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace vigil::bench {

using nlohmann::ordered_json;

PictureRows::PictureRows(std::span<const QualityRow> rows, std::string baseline)
    : baseline_(std::move(baseline)) {
    for (const QualityRow& row : rows)
        rows_.push_back({row, {}, {}});
}

void PictureRows::add(std::size_t row, const std::string& name, double value) {
    Row& to = rows_[row];
    const auto [values, is_new] = to.values.try_emplace(name);
    if (is_new) to.names.push_back(name);
    values->second.resize(views_);
    values->second.back().push_back(value);
}

Comparison PictureRows::ratio(const Row& row, const std::string& name) const {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const auto baseline = std::ranges::find(
        rows_, baseline_, [](const Row& other) -> const std::string& { return other.row.label; });
    if (baseline == rows_.end() || !baseline->values.contains(name))
        return {{unknown, unknown, unknown}, unknown};
    return typical_ratio(row.values.at(name), baseline->values.at(name));
}

ordered_json PictureRows::json() const {
    ordered_json rows = ordered_json::array();
    for (const Row& row : rows_) {
        ordered_json& json = rows.emplace_back(to_json(row.row));
        for (const std::string& name : row.names) {
            json[name] = to_json(row.values.at(name));
            json[name]["ratio"] = to_json(ratio(row, name));
        }
    }
    return rows;
}

std::string PictureRows::text(std::span<const PictureColumn> columns) const {
    std::string text = fmt::format("  {:<16}", "row");
    for (const PictureColumn& column : columns) {
        text += fmt::format("{:>14}", column.heading);
        if (column.has_ratio) text += fmt::format("{:>10}", "/ " + baseline_);
    }
    text += '\n';
    for (const Row& row : rows_) {
        text += fmt::format("  {:<16}", row.row.label);
        for (const PictureColumn& column : columns) {
            const bool has = row.values.contains(column.name);
            text += fmt::format("{:>14}",
                                has ? number_text(median_of(row.values.at(column.name))) : "");
            if (column.has_ratio)
                text += fmt::format("{:>10}",
                                    has ? number_text(ratio(row, column.name).ratio.value) : "");
        }
        text += '\n';
    }
    return text;
}

ordered_json to_json(std::span<const PictureColumn> columns) {
    ordered_json json = ordered_json::array();
    for (const PictureColumn& column : columns)
        json.push_back(
            {{"name", column.name}, {"heading", column.heading}, {"has_ratio", column.has_ratio}});
    return json;
}

Reference picture_reference(const QualityOptions& options, QualityRenderer& renderer,
                            const Pose& pose, Progress& progress) {
    Reference reference(std::size_t{3} * options.size.x * options.size.y);
    const int batches = std::max(2, options.reference_paths / reference_batch_paths);
    renderer.complete(
        reference, pose,
        {options.reference, options.warmup, options.fresh, {}, batches, [&](int done) {
             progress.note(fmt::format("reference, {} paths of {}", done * reference_batch_paths,
                                       batches * reference_batch_paths));
         }});
    return reference;
}

ordered_json view_json(const std::string& name, const Pose& pose, const Reference& reference) {
    return {{"name", name},
            {"origin", {pose.origin.x, pose.origin.y, pose.origin.z}},
            {"angles", {pose.angles.x, pose.angles.y, pose.angles.z}},
            {"time_s", pose.time_s},
            {"reference",
             {{"paths", reference.batches() * reference_batch_paths},
              {"mean", reference.picture_mean()},
              {"variance", reference.mean_variance()},
              {"relative_variance", relative_variance(reference)}}}};
}

std::vector<float> picture_of(const Reference& reference) {
    std::vector<float> picture;
    for (std::size_t i = 0; i < reference.values(); ++i)
        picture.push_back(static_cast<float>(reference.mean(i)));
    return picture;
}

} // namespace vigil::bench
