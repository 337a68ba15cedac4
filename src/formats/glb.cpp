// SPDX-License-Identifier: GPL-2.0-or-later
// Binary glTF 2.0, sections 3.6 (buffers, accessors) and 4.4 (the GLB container) of the
// specification; see glb.h.
#include "formats/glb.h"

#include "formats/byte_reader.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace vigil {

using nlohmann::json;

namespace {

constexpr uint32_t glb_magic = 0x46546c67;  // "glTF"
constexpr uint32_t chunk_json = 0x4e4f534a; // "JSON"
constexpr uint32_t chunk_bin = 0x004e4942;  // "BIN\0"
constexpr double max_number = 1e9;
/// Parsed JSON takes up to some fifty times its text in memory.
constexpr size_t max_json_bytes = size_t{32} << 20;
/// Each level takes memory and time of its own; glTF needs about ten.
constexpr int max_json_depth = 64;

enum ComponentType : uint64_t {
    type_i8 = 5120,
    type_u8 = 5121,
    type_i16 = 5122,
    type_u16 = 5123,
    type_u32 = 5125,
    type_f32 = 5126,
};

/// Bytes per component, 0: not a component type.
size_t component_size(uint64_t type) {
    switch (type) {
    case type_i8:
    case type_u8:
        return 1;
    case type_i16:
    case type_u16:
        return 2;
    case type_u32:
    case type_f32:
        return 4;
    default:
        return 0;
    }
}

template <typename T> T load(const uint8_t* at) {
    T value;
    std::memcpy(&value, at, sizeof(T));
    return value;
}

/// One component as a float; `normalized` maps integers to 0..1 or -1..1.
float load_float(const uint8_t* at, uint64_t type, bool normalized) {
    const auto scaled = [&](float value, float largest) {
        return normalized ? std::max(value / largest, -1.0f) : value;
    };
    switch (type) {
    case type_i8:
        return scaled(load<int8_t>(at), 127.0f);
    case type_u8:
        return scaled(load<uint8_t>(at), 255.0f);
    case type_i16:
        return scaled(load<int16_t>(at), 32767.0f);
    case type_u16:
        return scaled(load<uint16_t>(at), 65535.0f);
    case type_u32:
        return scaled(static_cast<float>(load<uint32_t>(at)), 4294967296.0f);
    default:
        return load<float>(at);
    }
}

const json& empty_object() {
    static const json empty = json::object();
    return empty;
}

const json& empty_array() {
    static const json empty = json::array();
    return empty;
}

/// How deep arrays and objects of a JSON text are nested. (The library could ask us at each of
/// them, but takes time then that grows with the square of an array's length.)
int depth_of(std::span<const uint8_t> text) {
    int depth = 0, deepest = 0;
    bool quoted = false;
    for (size_t i = 0; i < text.size(); ++i) {
        if (quoted) {
            if (text[i] == '\\') ++i;
            if (text[i] == '"') quoted = false;
            continue;
        }
        if (text[i] == '"') quoted = true;
        if (text[i] == '[' || text[i] == '{') deepest = std::max(deepest, ++depth);
        if (text[i] == ']' || text[i] == '}') --depth;
    }
    return deepest;
}

} // namespace

Glb::Glb(std::string_view name, std::span<const uint8_t> bytes) : name_(name) {
    const std::string what = fmt::format("{}: glTF header", name);
    ByteReader header(what, bytes);
    if (header.u32() != glb_magic) bad("not a binary glTF file (no glTF signature)");
    if (const uint32_t version = header.u32(); version != 2)
        bad("glTF version {}, only version 2 is read", version);
    const uint32_t length = header.u32();
    if (length < header.position() || length > bytes.size())
        bad("the header says {} bytes, the file has {}", length, bytes.size());

    const std::string chunk = fmt::format("{}: glTF chunk", name);
    ByteReader reader(chunk, bytes.first(length).subspan(header.position()));
    std::span<const uint8_t> text;
    while (reader.remaining() > 0) {
        const uint32_t size = reader.u32(), type = reader.u32();
        const auto content = reader.take(size);
        if (type == chunk_json && text.empty()) text = content;
        if (type == chunk_bin && binary_.empty()) binary_ = content;
    }
    if (text.size() > max_json_bytes)
        bad("a JSON chunk of {} bytes is too long (limit {})", text.size(), max_json_bytes);
    if (depth_of(text) > max_json_depth)
        bad("its JSON is nested more than {} deep", max_json_depth);
    root_ = json::parse(text.begin(), text.end(), nullptr, false);
    if (!root_.is_object()) bad("the JSON chunk is missing or not valid JSON");
}

const json& Glb::child(const json& from, const char* key) const {
    const auto it = from.find(key);
    return it != from.end() && it->is_object() ? *it : empty_object();
}

const json& Glb::array(const json& from, const char* key) const {
    const auto it = from.find(key);
    return it != from.end() && it->is_array() ? *it : empty_array();
}

size_t Glb::count(const char* kind) const {
    return array(root_, kind).size();
}

const json& Glb::object(const char* kind, uint64_t index) const {
    const json& list = array(root_, kind);
    if (index >= list.size()) bad("{}: entry {} of {} is used", kind, index, list.size());
    if (!list[index].is_object()) bad("{}: entry {} is no object", kind, index);
    return list[index];
}

uint64_t Glb::get_index(const json& from, const char* key, uint64_t fallback) const {
    const auto it = from.find(key);
    if (it == from.end()) return fallback;
    if (!it->is_number_unsigned()) bad("\"{}\" is not a whole number of 0 or more", key);
    return it->get<uint64_t>();
}

uint64_t Glb::require_index(const json& from, const char* key) const {
    if (!from.contains(key)) bad("\"{}\" is missing", key);
    return get_index(from, key, 0);
}

float Glb::get_float(const json& from, const char* key, float fallback) const {
    const auto it = from.find(key);
    if (it == from.end()) return fallback;
    if (!it->is_number() || !(std::abs(it->get<double>()) <= max_number))
        bad("\"{}\" is not a usable number", key);
    return it->get<float>();
}

bool Glb::get_floats(const json& from, const char* key, std::span<float> numbers) const {
    const auto it = from.find(key);
    if (it == from.end()) return false;
    if (!it->is_array() || it->size() != numbers.size())
        bad("\"{}\" is not an array of {} numbers", key, numbers.size());
    for (size_t i = 0; i < numbers.size(); ++i) {
        const json& number = (*it)[i];
        if (!number.is_number() || !(std::abs(number.get<double>()) <= max_number))
            bad("\"{}\" holds an unusable number", key);
        numbers[i] = number.get<float>();
    }
    return true;
}

std::string Glb::get_string(const json& from, const char* key) const {
    const auto it = from.find(key);
    return it != from.end() && it->is_string() ? it->get<std::string>() : std::string();
}

bool Glb::get_bool(const json& from, const char* key) const {
    const auto it = from.find(key);
    return it != from.end() && it->is_boolean() && it->get<bool>();
}

Glb::Elements Glb::elements(uint64_t accessor, uint32_t components) const {
    constexpr std::array<const char*, 5> type_names = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
    const json& json_accessor = object("accessors", accessor);
    if (get_string(json_accessor, "type") != type_names.at(components))
        bad("accessor {} is not of type {}", accessor, type_names.at(components));
    if (json_accessor.contains("sparse")) bad("accessor {} is sparse, which is not read", accessor);
    Elements result;
    result.component_type = require_index(json_accessor, "componentType");
    result.normalized = get_bool(json_accessor, "normalized");
    const size_t size = component_size(result.component_type) * components;
    if (size == 0) bad("accessor {}: component type {}", accessor, result.component_type);

    const json& view = object("bufferViews", require_index(json_accessor, "bufferView"));
    if (require_index(view, "buffer") != 0 || object("buffers", 0).contains("uri"))
        bad("accessor {} lies outside the binary chunk", accessor);
    const uint64_t view_start = get_index(view, "byteOffset", 0);
    const uint64_t view_size = require_index(view, "byteLength");
    if (view_start > binary_.size() || view_size > binary_.size() - view_start)
        bad("accessor {}: its buffer view of {} bytes at {} does not fit into {} bytes", accessor,
            view_size, view_start, binary_.size());

    const uint64_t start = get_index(json_accessor, "byteOffset", 0);
    const uint64_t count = require_index(json_accessor, "count");
    const uint64_t stride = get_index(view, "byteStride", size);
    if (count == 0) bad("accessor {} is empty", accessor);
    if (stride < size || stride > 252)
        bad("accessor {}: stride {} for elements of {} bytes", accessor, stride, size);
    // Dividing instead of multiplying: count comes from the file and may be anything.
    if (start > view_size || size > view_size - start ||
        count - 1 > (view_size - start - size) / stride)
        bad("accessor {}: {} elements at byte {} do not fit into {} bytes", accessor, count, start,
            view_size);
    result.count = count;
    result.stride = stride;
    result.bytes = binary_.subspan(view_start + start, (count - 1) * stride + size);
    return result;
}

std::vector<glm::vec4> Glb::read_vectors(uint64_t accessor, uint32_t components) const {
    const Elements source = elements(accessor, components);
    const size_t size = component_size(source.component_type);
    std::vector<glm::vec4> vectors(source.count, glm::vec4(0.0f));
    for (size_t i = 0; i < source.count; ++i)
        for (uint32_t c = 0; c < components; ++c) {
            const uint8_t* at = source.bytes.data() + i * source.stride + c * size;
            const float value = load_float(at, source.component_type, source.normalized);
            if (!(std::abs(value) <= max_number))
                bad("accessor {}: element {} is {}", accessor, i, value);
            vectors[i][c] = value;
        }
    return vectors;
}

std::vector<uint32_t> Glb::read_indices(uint64_t accessor) const {
    const Elements source = elements(accessor, 1);
    std::vector<uint32_t> indices(source.count);
    for (size_t i = 0; i < source.count; ++i) {
        const uint8_t* at = source.bytes.data() + i * source.stride;
        switch (source.component_type) {
        case type_u8:
            indices[i] = *at;
            break;
        case type_u16:
            indices[i] = load<uint16_t>(at);
            break;
        case type_u32:
            indices[i] = load<uint32_t>(at);
            break;
        default:
            bad("accessor {}: indices of component type {}", accessor, source.component_type);
        }
    }
    return indices;
}

} // namespace vigil
