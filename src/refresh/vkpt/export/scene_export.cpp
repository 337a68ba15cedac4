// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/export/scene_export.h"

#include "common/error.h"
#include "common/output.h"
#include "refresh/vkpt/export/export_files.h"
#include "refresh/vkpt/export/export_pictures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <span>

namespace vigil::vkpt {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// Numbers of the glTF 2.0 specification.
constexpr int gl_float = 5126, gl_unsigned_int = 5125;
constexpr int gl_array_buffer = 34962, gl_element_array_buffer = 34963;
constexpr int gl_linear = 9729, gl_linear_mipmap_linear = 9987, gl_repeat = 10497;

// glTF cameras need a near plane; Vigil's rays start at the eye.
constexpr float near_plane = 0.1f;
// A reflectance of 1 would be an infinite refractive index.
constexpr float max_reflectance = 0.98f;

Json array_of(glm::vec3 v) {
    return {v.x, v.y, v.z};
}

bool is_finite(glm::vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Column-major 4 x 4, as glTF has it.
Json matrix_json(const glm::mat4x3& m) {
    Json values = Json::array();
    for (glm::length_t column = 0; column < 4; ++column) {
        for (glm::length_t row = 0; row < 3; ++row)
            values.push_back(m[column][row]);
        values.push_back(column == 3 ? 1.0f : 0.0f);
    }
    return values;
}

/// Puts `value` at the end of the array `key` and returns its index.
size_t append(Json& root, const char* key, Json value) {
    Json& list = root[key];
    list.push_back(std::move(value));
    return list.size() - 1;
}

/// Everything that goes into NAME.bin, in three runs: one bufferView each.
struct Geometry {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec2> uvs;
    std::vector<uint32_t> indices;
};

// Texture coordinates come last: they are the run that may be empty, and then has no view.
enum BufferView { positions_view, indices_view, uvs_view };

Json accessor(BufferView view, size_t offset, int component, size_t count, const char* type) {
    return {{"bufferView", view},
            {"byteOffset", offset},
            {"componentType", component},
            {"count", count},
            {"type", type}};
}

/// Puts a primitive's vertices into `geometry` and returns its glTF description.
Json add_primitive(const ExportPrimitive& source, const std::string& mesh, Geometry& geometry,
                   Json& root) {
    const size_t vertices = source.positions.size();
    std::vector<uint32_t> indices = source.indices;
    if (indices.empty()) {
        indices.resize(vertices);
        std::iota(indices.begin(), indices.end(), 0u);
    }
    if (indices.size() % 3 != 0)
        fail("mesh {}: {} corners are not triangles", mesh, indices.size());
    if (!source.uvs.empty() && source.uvs.size() != vertices)
        fail("mesh {}: {} texture coordinates for {} vertices", mesh, source.uvs.size(), vertices);

    Json primitive;
    glm::vec3 lower = source.positions.front(), upper = lower;
    for (const glm::vec3& position : source.positions) {
        if (!is_finite(position)) fail("mesh {}: a position is not finite", mesh);
        lower = glm::min(lower, position);
        upper = glm::max(upper, position);
    }
    Json positions = accessor(positions_view, geometry.positions.size() * sizeof(glm::vec3),
                              gl_float, vertices, "VEC3");
    positions["min"] = array_of(lower);
    positions["max"] = array_of(upper);
    primitive["attributes"]["POSITION"] = append(root, "accessors", std::move(positions));
    geometry.positions.insert(geometry.positions.end(), source.positions.begin(),
                              source.positions.end());
    if (!source.uvs.empty()) {
        for (const glm::vec2& uv : source.uvs) {
            if (!std::isfinite(uv.x) || !std::isfinite(uv.y))
                fail("mesh {}: a texture coordinate is not finite", mesh);
        }
        primitive["attributes"]["TEXCOORD_0"] =
            append(root, "accessors",
                   accessor(uvs_view, geometry.uvs.size() * sizeof(glm::vec2), gl_float, vertices,
                            "VEC2"));
        geometry.uvs.insert(geometry.uvs.end(), source.uvs.begin(), source.uvs.end());
    }
    for (const uint32_t index : indices)
        if (index >= vertices) fail("mesh {}: index {} of {} vertices", mesh, index, vertices);
    primitive["indices"] = append(root, "accessors",
                                  accessor(indices_view, geometry.indices.size() * sizeof(uint32_t),
                                           gl_unsigned_int, indices.size(), "SCALAR"));
    geometry.indices.insert(geometry.indices.end(), indices.begin(), indices.end());
    primitive["material"] = source.material;
    return primitive;
}

/// A material. Lambertian surfaces are said by switching the specular layer off
/// (KHR_materials_specular), glossy ones by the refractive index of their reflectance.
Json material_json(const ExportMaterial& source, std::optional<size_t> texture,
                   std::set<std::string>& extensions) {
    if (!is_finite(source.color) || !is_finite(source.radiance) ||
        !(source.coverage >= 0.0f && source.coverage <= 1.0f) ||
        !(source.roughness >= 0.0f && source.roughness <= 1.0f) ||
        !(source.specular >= 0.0f && source.specular <= 1.0f) ||
        glm::any(glm::lessThan(source.radiance, glm::vec3(0.0f))))
        fail("material {}: a value is out of range", source.name);
    Json material = {{"name", source.name}};
    const glm::vec3 color = glm::clamp(source.color, 0.0f, 1.0f);
    Json look;
    look["baseColorFactor"] = {color.x, color.y, color.z, source.coverage};
    if (texture) look["baseColorTexture"] = {{"index", *texture}};
    look["metallicFactor"] = 0;
    look["roughnessFactor"] = source.specular > 0.0f ? source.roughness : 1.0f;
    material["pbrMetallicRoughness"] = std::move(look);
    Json extra;
    if (source.specular > 0.0f) {
        // f0 = ((ior - 1) / (ior + 1))^2
        const float root = std::sqrt(std::min(source.specular, max_reflectance));
        extra["KHR_materials_ior"] = {{"ior", (1.0f + root) / (1.0f - root)}};
    } else {
        extra["KHR_materials_specular"] = {{"specularFactor", 0}};
    }
    if (source.coverage < 1.0f) material["alphaMode"] = "BLEND";
    const float strength =
        std::max({source.radiance.x, source.radiance.y, source.radiance.z, 1.0f});
    if (source.radiance != glm::vec3(0.0f)) {
        material["emissiveFactor"] = array_of(source.radiance / strength);
        if (strength > 1.0f)
            extra["KHR_materials_emissive_strength"] = {{"emissiveStrength", strength}};
    }
    for (const auto& [name, value] : extra.items())
        extensions.insert(name);
    material["extensions"] = std::move(extra);
    return material;
}

void check_texture(const ExportTexture& texture) {
    if (texture.width == 0 || texture.height == 0 || texture.width > 32768 ||
        texture.height > 32768 || texture.texels.size() != size_t{texture.width} * texture.height)
        fail("texture {}: {} texels for {} x {}", texture.name, texture.texels.size(),
             texture.width, texture.height);
}

template <typename T> void write_run(std::vector<std::byte>& bytes, const std::vector<T>& run) {
    const std::span<const std::byte> raw = std::as_bytes(std::span(run));
    bytes.insert(bytes.end(), raw.begin(), raw.end());
}

/// One export: builds the document and its files step by step.
class Exporter {
public:
    Exporter(const ExportScene& scene, const fs::path& path)
        : scene_(scene), stem_(path.stem().string()), files_(path) {}

    ExportSummary run() {
        root_["asset"] = {{"version", "2.0"}, {"generator", "Vigil"}};
        write_materials();
        write_meshes();
        write_nodes();
        write_geometry();
        for (const std::string& name : extensions_)
            root_["extensionsUsed"].push_back(name);
        // The document goes last: who sees it sees all that it names.
        write_file(files_.add(stem_ + ".gltf"),
                   root_.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
        const StagedFiles::Written written = files_.commit();
        return {triangles_, written.files, written.bytes};
    }

private:
    std::string textures_folder() const { return stem_ + "_textures/"; }

    /// The glTF texture of scene texture `index`; its file is written when first asked for.
    size_t texture(uint32_t index, const std::string& material) {
        if (index >= scene_.textures.size())
            fail("material {}: there is no texture {}", material, index);
        if (const auto known = textures_.find(index); known != textures_.end())
            return known->second;
        const ExportTexture& source = scene_.textures[index];
        check_texture(source);
        const std::string file = textures_folder() + plain_file_name(source.name, taken_) + ".png";
        write_file(files_.add(file), encode_png(source));
        if (!root_.contains("samplers")) {
            append(root_, "samplers",
                   {{"magFilter", gl_linear},
                    {"minFilter", gl_linear_mipmap_linear},
                    {"wrapS", gl_repeat},
                    {"wrapT", gl_repeat}});
        }
        const size_t image =
            append(root_, "images", {{"name", source.name}, {"uri", uri_of(file)}});
        return textures_[index] = append(root_, "textures", {{"sampler", 0}, {"source", image}});
    }

    void write_materials() {
        for (const ExportMaterial& material : scene_.materials) {
            std::optional<size_t> picture;
            if (material.texture) picture = texture(*material.texture, material.name);
            append(root_, "materials", material_json(material, picture, extensions_));
        }
    }

    void write_meshes() {
        for (const ExportMesh& mesh : scene_.meshes) {
            Json primitives = Json::array();
            uint64_t triangles = 0;
            for (const ExportPrimitive& primitive : mesh.primitives) {
                if (primitive.positions.empty()) continue; // glTF knows no empty ones
                if (primitive.material >= scene_.materials.size())
                    fail("mesh {}: there is no material {}", mesh.name, primitive.material);
                primitives.push_back(add_primitive(primitive, mesh.name, geometry_, root_));
                triangles += (primitive.indices.empty() ? primitive.positions.size()
                                                        : primitive.indices.size()) /
                             3;
            }
            mesh_triangles_.push_back(triangles);
            meshes_.emplace_back();
            if (!primitives.empty())
                meshes_.back() = append(
                    root_, "meshes", {{"name", mesh.name}, {"primitives", std::move(primitives)}});
        }
    }

    void write_nodes() {
        Json children = Json::array();
        for (const ExportInstance& instance : scene_.instances) {
            if (instance.mesh >= meshes_.size())
                fail("instance {}: there is no mesh {}", instance.name, instance.mesh);
            for (glm::length_t column = 0; column < 4; ++column)
                if (!is_finite(instance.world_from_object[column]))
                    fail("instance {}: its place is not finite", instance.name);
            if (!meshes_[instance.mesh]) continue;
            triangles_ += mesh_triangles_[instance.mesh];
            Json node = {{"name", instance.name}, {"mesh", *meshes_[instance.mesh]}};
            if (instance.world_from_object != glm::mat4x3(1.0f))
                node["matrix"] = matrix_json(instance.world_from_object);
            children.push_back(append(root_, "nodes", std::move(node)));
        }
        children.push_back(append(root_, "nodes", camera_node()));
        if (scene_.sun) children.push_back(append(root_, "nodes", sun_node(*scene_.sun)));
        // z up to y up: (x, y, z) becomes (x, z, -y), a quarter turn about x.
        const double half = std::sqrt(0.5);
        const size_t top = append(root_, "nodes",
                                  {{"name", "z up to y up"},
                                   {"rotation", {-half, 0.0, 0.0, half}},
                                   {"children", std::move(children)}});
        Json scene = {{"name", scene_.name}, {"nodes", Json::array({top})}};
        if (scene_.sky) scene["extras"]["vigil_sky"] = sky_json(*scene_.sky);
        root_["scene"] = append(root_, "scenes", std::move(scene));
    }

    Json camera_node() {
        const ExportCamera& camera = scene_.camera;
        if (!is_finite(camera.origin) || !is_finite(camera.forward) || !is_finite(camera.right) ||
            !is_finite(camera.up) ||
            !(camera.vertical_fov > 0.0f && camera.vertical_fov < 3.1416f && camera.aspect > 0.0f))
            fail("the camera cannot be exported: a value is out of range");
        const size_t index = append(root_, "cameras",
                                    {{"name", "view"},
                                     {"type", "perspective"},
                                     {"perspective",
                                      {{"aspectRatio", camera.aspect},
                                       {"yfov", camera.vertical_fov},
                                       {"znear", near_plane}}}});
        // glTF cameras look along their -z with +y up.
        const glm::mat4x3 place(camera.right, camera.up, -camera.forward, camera.origin);
        return {{"name", "view"}, {"camera", index}, {"matrix", matrix_json(place)}};
    }

    Json sun_node(const ExportSun& sun) {
        if (!is_finite(sun.direction) || !is_finite(sun.irradiance) ||
            glm::length(sun.direction) < 0.5f)
            fail("the sun cannot be exported: a value is out of range");
        const float intensity =
            std::max({sun.irradiance.x, sun.irradiance.y, sun.irradiance.z, 1e-20f});
        const Json light = {{"name", "sun"},
                            {"type", "directional"},
                            {"color", array_of(sun.irradiance / intensity)},
                            {"intensity", intensity},
                            {"extras", {{"angular_diameter_degrees", sun.angular_diameter}}}};
        root_["extensions"]["KHR_lights_punctual"]["lights"] = Json::array({light});
        extensions_.insert("KHR_lights_punctual");
        // The light shines along the node's -z, so its +z points to the sun.
        const glm::vec3 z = glm::normalize(sun.direction);
        const glm::vec3 aside =
            std::abs(z.z) < 0.9f ? glm::vec3(0.0f, 0.0f, 1.0f) : glm::vec3(1.0f, 0.0f, 0.0f);
        const glm::vec3 x = glm::normalize(glm::cross(aside, z));
        Json node = {{"name", "sun"},
                     {"matrix", matrix_json({x, glm::cross(z, x), z, glm::vec3(0.0f)})}};
        node["extensions"]["KHR_lights_punctual"]["light"] = 0;
        return node;
    }

    Json sky_json(const ExportSky& sky) {
        if (!is_finite(sky.radiance)) fail("the sky cannot be exported: a value is not finite");
        Json json;
        if (sky.sides) {
            for (const ExportTexture& side : *sky.sides)
                check_texture(side);
            const std::string file = textures_folder() + "sky.exr";
            write_sky_panorama(sky, files_.add(file));
            json["panorama"] = uri_of(file);
        } else {
            json["radiance"] = array_of(sky.radiance);
        }
        if (!sky.faces.empty()) {
            // No node places this mesh: to readers that do not ask for it there is nothing.
            Json primitive = add_primitive({0, sky.faces, {}, {}}, "sky faces", geometry_, root_);
            primitive.erase("material");
            json["faces"] = append(
                root_, "meshes",
                {{"name", "sky faces"}, {"primitives", Json::array({std::move(primitive)})}});
        }
        return json;
    }

    void write_geometry() {
        if (geometry_.positions.empty()) return;
        std::vector<std::byte> bytes;
        const auto view = [&](const auto& run, size_t stride, int target) {
            const size_t offset = bytes.size();
            write_run(bytes, run);
            Json json = {
                {"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes.size() - offset}};
            if (stride) json["byteStride"] = stride;
            json["target"] = target;
            if (bytes.size() > offset) append(root_, "bufferViews", std::move(json));
        };
        view(geometry_.positions, sizeof(glm::vec3), gl_array_buffer);
        view(geometry_.indices, 0, gl_element_array_buffer);
        view(geometry_.uvs, sizeof(glm::vec2), gl_array_buffer);
        const std::string file = stem_ + ".bin";
        append(root_, "buffers", {{"uri", uri_of(file)}, {"byteLength", bytes.size()}});
        write_file(files_.add(file), bytes);
    }

    const ExportScene& scene_;
    std::string stem_;
    StagedFiles files_;
    Json root_;
    Geometry geometry_;
    std::set<std::string> extensions_;
    std::set<std::string> taken_{"sky"};
    std::map<uint32_t, size_t> textures_;       // scene texture to glTF texture
    std::vector<std::optional<size_t>> meshes_; // scene mesh to glTF mesh; none if empty
    std::vector<uint64_t> mesh_triangles_;
    uint64_t triangles_ = 0;
};

} // namespace

ExportSummary write_gltf(const ExportScene& scene, const fs::path& path) {
    if (path.extension() != ".gltf" || path.stem().empty())
        fail("{}: exported scenes are named NAME.gltf", path.string());
    try {
        return Exporter(scene, path).run();
    } catch (const std::runtime_error& error) { // Error, or std::filesystem's
        fail("{}: not exported: {}", path.string(), error.what());
    }
}

} // namespace vigil::vkpt
