// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/plan_csv.h"

#include <fmt/format.h>

#include <cmath>

namespace vigil::bench {

using nlohmann::ordered_json;

namespace {

std::string field(std::string text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos; at += 2)
        text.insert(at, 1, '"');
    return '"' + text + '"';
}

/// A member that is a number; empty where it is none.
std::string number(const ordered_json& object, const char* name) {
    const auto value = object.find(name);
    const bool exists =
        value != object.end() && value->is_number() && std::isfinite(value->get<double>());
    return exists ? fmt::format("{:.6g}", value->get<double>()) : "";
}

std::string interval(const ordered_json& value) {
    return number(value, "value") + ',' + number(value, "low") + ',' + number(value, "high");
}

} // namespace

std::string plan_csv(const ordered_json& report) {
    std::string text =
        "part,level,width,height,triangles,lights,row,measure,frame,value,low,high\n";
    for (const ordered_json& part : report["parts"]) {
        const std::string head = fmt::format(
            "{},{},{},{},{},{}", field(part["part"]), field(part["level"]), number(part, "width"),
            number(part, "height"), number(part, "triangles"), number(part, "lights"));
        for (const ordered_json& row : part["rows"]) {
            const std::string start = head + ',' + field(row["label"]) + ',';
            const auto add = [&](const std::string& measure, const std::string& frame,
                                 const std::string& values) {
                text += fmt::format("{}{},{},{}\n", start, measure, frame, values);
            };
            for (const auto& [key, member] : row.items()) {
                // A row that has frames itself is a curve of MSE.
                const bool is_curve = key == "frames";
                const std::string name = is_curve ? "mse" : key;
                const ordered_json measure = is_curve ? ordered_json{{key, member}} : member;
                if (!measure.is_object()) continue;
                if (measure.contains("value")) add(name, "", interval(measure));
                // Ratios to the baseline, and others of their kind.
                for (const auto& [inner, value] : measure.items())
                    if (value.is_object() && value.contains("value"))
                        add(name + '.' + inner, "", interval(value));
                if (!measure.contains("frames")) continue;
                int frame = 0;
                for (const ordered_json& value : measure["frames"]) {
                    const std::string number_text = std::to_string(++frame);
                    if (value.is_object()) {
                        add(name, number_text, interval(value));
                        add(name + ".median", number_text, interval(value["median"]));
                    } else {
                        add(name, number_text, fmt::format("{:.6g},,", value.get<double>()));
                    }
                }
            }
        }
    }
    return text;
}

} // namespace vigil::bench
