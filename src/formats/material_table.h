// SPDX-License-Identifier: GPL-2.0-or-later
// materials.json: how glossy the surfaces of a texture are, and how much they shine, by the
// texture's name. It opens no file and knows no texture; the renderer looks names up.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace vigil {

struct Gloss {
    float roughness = 1.0f; ///< 0.1..1
    float specular = 0.0f;  ///< reflectance at normal incidence, 0..1; 0: diffuse
    /// VALUE of faces with this texture, in place of what the level says, 0..10,000; 0: they do not
    /// shine. Without it the level's own counts.
    std::optional<float> light;
};

/// By the texture's name below textures/, in lower case and without an extension.
using MaterialTable = std::map<std::string, Gloss, std::less<>>;

/// Parses {"NAME": {"roughness": R, "specular": S, "light": L}, ...}; a missing number keeps its
/// default, and other members are ignored. `name` appears in messages. Throws Error where the text
/// is not JSON or an entry is no object or holds a number out of range.
MaterialTable parse_material_table(std::string_view name, std::string_view text);

} // namespace vigil
