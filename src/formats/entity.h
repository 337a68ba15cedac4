// SPDX-License-Identifier: GPL-2.0-or-later
// The entity text of a level: blocks { "key" "value" ... } as Quake wrote them. Entities hold plain
// strings; the getters convert on demand and never fail. It knows no entity classes.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vigil {

/// Key/value pairs in file order, each key once (a later duplicate replaces the earlier value).
/// Keys compare without regard to ASCII case, as in Quake.
struct Entity {
    std::vector<std::pair<std::string, std::string>> pairs;

    /// The value, or nullptr.
    const std::string* find(std::string_view key) const;
    bool has(std::string_view key) const { return find(key) != nullptr; }
    void set(std::string_view key, std::string_view value);

    /// Each getter returns `fallback` where the key is missing, and where its value does not start
    /// with the wanted number(s) or is not finite. Text after the numbers is ignored.
    std::string get_string(std::string_view key, std::string_view fallback = "") const;
    float get_float(std::string_view key, float fallback = 0.0f) const;
    int get_int(std::string_view key, int fallback = 0) const;
    std::optional<glm::vec2> get_vec2(std::string_view key) const;
    glm::vec3 get_vec3(std::string_view key, glm::vec3 fallback = glm::vec3(0.0f)) const;
    /// The key "angles" (pitch, yaw, roll), or "angle" as a yaw.
    glm::vec3 get_angles() const;
    /// The same of a model or a view: an `angle` of -1 looks up, -2 down, as in Quake.
    glm::vec3 get_model_angles() const;

    std::string classname() const { return get_string("classname"); }
};

/// Parses entity text up to its end or its first NUL. As in Quake: a quote always ends a string (a
/// backslash does not protect it, "c:\dir\" is valid), \n inside a value becomes a line feed, //
/// starts a comment outside quotes, and tokens may stand without quotes.
/// `name` appears in messages. Throws Error with the line number on unterminated strings and
/// blocks, missing values and text outside blocks.
std::vector<Entity> parse_entities(std::string_view name, std::string_view text);

} // namespace vigil
