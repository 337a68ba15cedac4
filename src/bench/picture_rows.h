// SPDX-License-Identifier: GPL-2.0-or-later
// What the parts of `picture` share: numbers of every run by row and name, their report, and the
// reference of a pose.
#pragma once

#include "bench/measure.h"
#include "bench/reference.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace vigil::bench {

/// Frames that stand still before what counts, so that filters have settled.
inline constexpr int settle_frames = 32;

/// A column of a table: a number, its heading, and whether its ratio to the baseline stands beside
/// it.
struct PictureColumn {
    const char* name;
    const char* heading;
    bool has_ratio = false;
};

class PictureRows {
public:
    PictureRows(std::span<const QualityRow> rows, std::string baseline);

    /// Numbers that follow are of another view.
    void begin_view() { ++views_; }
    /// A number of one run.
    void add(std::size_t row, const std::string& name, double value);

    /// A member per row: what it is, and of each number all that is known, with the ratio to the
    /// baseline's run of the same view and seed.
    nlohmann::ordered_json json() const;
    /// Typical runs.
    std::string text(std::span<const PictureColumn> columns) const;

private:
    struct Row {
        QualityRow row;
        std::vector<std::string> names; // in the order in which they came
        std::map<std::string, Strata> values;
    };
    Comparison ratio(const Row& row, const std::string& name) const;

    std::vector<Row> rows_;
    std::string baseline_;
    std::size_t views_ = 0;
};

/// The columns, for tools that make tables of reports.
nlohmann::ordered_json to_json(std::span<const PictureColumn> columns);

/// A reference of as many paths as the options say, of the scene as it is; from the cache, where it
/// goes.
Reference picture_reference(const QualityOptions& options, QualityRenderer& renderer,
                            const Pose& pose, Progress& progress);

/// What reports say of a place and its reference.
nlohmann::ordered_json view_json(const std::string& name, const Pose& pose,
                                 const Reference& reference);

/// Means of all values.
std::vector<float> picture_of(const Reference& reference);

} // namespace vigil::bench
