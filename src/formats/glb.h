// SPDX-License-Identifier: GPL-2.0-or-later
// The container and accessor layer of binary glTF 2.0: chunks, JSON fields and typed arrays, all
// range-checked. Own code over nlohmann-json because tinygltf (2.7) leaves accessor, buffer view
// and index ranges to its caller, which is the part that hostile files attack. Not for use outside
// src/formats (see mesh.h).
#pragma once

#include "common/error.h"

#include <glm/vec4.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vigil {

class Glb {
public:
    /// Splits the file and parses its JSON. Throws Error. `bytes` must outlive the object.
    Glb(std::string_view name, std::span<const uint8_t> bytes);

    const nlohmann::json& root() const { return root_; }

    /// root[kind][index]; `kind` is "nodes", "accessors", ... Throws where it is missing.
    const nlohmann::json& object(const char* kind, uint64_t index) const;
    size_t count(const char* kind) const;

    /// Member access on any JSON object; a missing member gives `fallback`, one of the wrong type
    /// or range throws.
    uint64_t get_index(const nlohmann::json& from, const char* key, uint64_t fallback) const;
    uint64_t require_index(const nlohmann::json& from, const char* key) const;
    /// Finite and at most 1e9 in magnitude.
    float get_float(const nlohmann::json& from, const char* key, float fallback) const;
    /// `numbers` holds the fallback; false (and untouched) where the member is missing.
    bool get_floats(const nlohmann::json& from, const char* key, std::span<float> numbers) const;
    std::string get_string(const nlohmann::json& from, const char* key) const;
    bool get_bool(const nlohmann::json& from, const char* key) const;
    /// The member if it is an object, else an empty object.
    const nlohmann::json& child(const nlohmann::json& from, const char* key) const;
    /// The member if it is an array, else an empty array.
    const nlohmann::json& array(const nlohmann::json& from, const char* key) const;

    /// Reads an accessor with `components` numbers per element (unused ones stay 0). Integers are
    /// converted as KHR_mesh_quantization says (divided by their largest value when "normalized").
    std::vector<glm::vec4> read_vectors(uint64_t accessor, uint32_t components) const;
    /// Reads an accessor of unsigned integers.
    std::vector<uint32_t> read_indices(uint64_t accessor) const;

    template <typename... Args>
    [[noreturn]] void bad(fmt::format_string<Args...> text, Args&&... args) const {
        fail("{}: {}", name_, fmt::format(text, std::forward<Args>(args)...));
    }

private:
    struct Elements {
        std::span<const uint8_t> bytes; ///< from the first element to the last one's end
        size_t count = 0, stride = 0;
        uint64_t component_type = 0;
        bool normalized = false;
    };
    Elements elements(uint64_t accessor, uint32_t components) const;

    std::string name_;
    nlohmann::json root_;
    std::span<const uint8_t> binary_;
};

} // namespace vigil
