// SPDX-License-Identifier: GPL-2.0-or-later
// materials.json through nlohmann-json; see material_table.h.
#include "formats/material_table.h"

#include "common/ascii_case.h"
#include "common/error.h"
#include "common/printable.h"

#include <nlohmann/json.hpp>

namespace vigil {

namespace {

using nlohmann::json;

constexpr float brightest_value = 10000.0f;

/// A number in [low, high]; `fallback` where the member is missing.
float number(std::string_view entry, const json& object, const char* key, float fallback, float low,
             float high) {
    const auto it = object.find(key);
    if (it == object.end()) return fallback;
    // Rounded before it is compared: as a double, 0.1 is less than the float of that name. No range
    // here reaches below 0.
    constexpr double finite = 1e6;
    const double value = it->is_number() ? it->get<double>() : -1.0;
    const float rounded = value >= 0.0 && value <= finite ? static_cast<float>(value) : -1.0f;
    if (!(rounded >= low && rounded <= high))
        fail("{}: {} is not a number from {} to {}", entry, key, low, high);
    return rounded;
}

} // namespace

MaterialTable parse_material_table(std::string_view name, std::string_view text) {
    const json root = json::parse(text, nullptr, false);
    if (!root.is_object()) fail("{}: is not a JSON object", name);
    MaterialTable table;
    for (const auto& [texture, source] : root.items()) {
        const std::string entry = fmt::format("{}: {}", name, printable(texture, 80));
        if (!source.is_object()) fail("{}: is no object", entry);
        Gloss gloss;
        gloss.roughness = number(entry, source, "roughness", gloss.roughness, 0.1f, 1.0f);
        gloss.specular = number(entry, source, "specular", gloss.specular, 0.0f, 1.0f);
        if (source.contains("light"))
            gloss.light = number(entry, source, "light", 0.0f, 0.0f, brightest_value);
        if (gloss.specular > 0.0f || gloss.light) table[ascii_lower(texture)] = gloss;
    }
    return table;
}

} // namespace vigil
