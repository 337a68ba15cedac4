// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/measure.h"

namespace vigil::bench {

using nlohmann::ordered_json;

ordered_json to_json(const Interval& interval) {
    return {{"value", interval.value}, {"low", interval.low}, {"high", interval.high}};
}

ordered_json to_json(const Comparison& comparison) {
    ordered_json json = to_json(comparison.ratio);
    json["p"] = comparison.p;
    return json;
}

ordered_json to_json(const Strata& values) {
    return {{"value", mean_over_views(values)},
            {"median", to_json(typical_run(values))},
            {"by_view_and_seed", values}};
}

ordered_json to_json(const QualityRow& row) {
    return {{"label", row.label}, {"variables", variables_json(row.settings)}};
}

ordered_json variables_json(std::span<const Setting> settings) {
    ordered_json variables = ordered_json::object();
    for (const Setting& setting : settings)
        variables[setting.name] = setting.value;
    return variables;
}

} // namespace vigil::bench
