// SPDX-License-Identifier: GPL-2.0-or-later
// Static triangle meshes out of a .glb: walks the node tree, applies transforms and turns glTF's
// axes into Vigil's. The byte level is in glb.h.
#include "formats/mesh.h"

#include "common/printable.h"
#include "formats/glb.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace vigil {

using nlohmann::json;

namespace {

constexpr uint64_t none = ~uint64_t{0};
constexpr uint64_t mode_triangles = 4;
constexpr float max_coordinate = 1048576.0f; ///< map units
/// What an instanced primitive counts for besides its vertices, as it takes memory even when tiny.
constexpr size_t primitive_cost = 32;
/// What may stand in "extensionsRequired": the rest would change geometry in ways not read here.
constexpr std::array<std::string_view, 4> known_extensions = {
    "KHR_mesh_quantization", "KHR_materials_emissive_strength", "KHR_texture_transform",
    "KHR_materials_unlit"};

/// glTF's y-up to z-up: (x, y, z) -> (x, -z, y). A rotation, so windings and normals stay right.
glm::vec3 to_z_up(const glm::vec3& v) {
    return {v.x, -v.z, v.y};
}

class MeshReader {
public:
    MeshReader(std::string_view name, std::span<const uint8_t> bytes) : glb_(name, bytes) {}

    Mesh read() {
        check_extensions();
        for (size_t i = 0; i < glb_.count("materials"); ++i)
            mesh_.materials.push_back(read_material(glb_.object("materials", i)));
        visited_.assign(glb_.count("nodes"), false);
        for (const uint64_t root : root_nodes())
            collect_tree(root);
        for (const Instance& instance : instances_)
            read_primitive(*instance.primitive, instance.to_world);
        if (mesh_.primitives.empty()) glb_.bad("the scene holds no triangles");
        if (mesh_.materials.empty()) mesh_.materials.emplace_back();
        return std::move(mesh_);
    }

private:
    /// A primitive where a node places it.
    struct Instance {
        const json* primitive;
        glm::mat4 to_world;
    };
    struct PendingNode {
        uint64_t index;
        glm::mat4 parent_to_world;
    };

    void check_extensions() const {
        for (const json& extension : glb_.array(glb_.root(), "extensionsRequired")) {
            const std::string text = extension.is_string() ? extension.get<std::string>() : "?";
            if (std::find(known_extensions.begin(), known_extensions.end(), text) ==
                known_extensions.end())
                glb_.bad("needs the glTF extension {}, which is not supported",
                         printable(text, 80));
        }
    }

    MeshMaterial read_material(const json& source) const {
        MeshMaterial material;
        material.name = glb_.get_string(source, "name");
        material.double_sided = glb_.get_bool(source, "doubleSided");
        const json& pbr = glb_.child(source, "pbrMetallicRoughness");
        std::array<float, 4> color = {1, 1, 1, 1};
        glb_.get_floats(pbr, "baseColorFactor", color);
        material.base_color = glm::clamp(glm::make_vec4(color.data()), 0.0f, 1.0f);
        material.roughness = glm::clamp(glb_.get_float(pbr, "roughnessFactor", 1.0f), 0.0f, 1.0f);
        material.metallic = glm::clamp(glb_.get_float(pbr, "metallicFactor", 1.0f), 0.0f, 1.0f);
        std::array<float, 3> emissive = {0, 0, 0};
        glb_.get_floats(source, "emissiveFactor", emissive);
        const json& strength =
            glb_.child(glb_.child(source, "extensions"), "KHR_materials_emissive_strength");
        material.emissive = glm::max(glm::make_vec3(emissive.data()), 0.0f) *
                            std::max(glb_.get_float(strength, "emissiveStrength", 1.0f), 0.0f);
        return material;
    }

    /// The default scene's nodes; without scenes, every node that is nobody's child.
    std::vector<uint64_t> root_nodes() const {
        if (glb_.count("scenes") > 0)
            return node_list(glb_.object("scenes", glb_.get_index(glb_.root(), "scene", 0)),
                             "nodes");
        std::vector<bool> is_child(glb_.count("nodes"), false);
        for (size_t i = 0; i < is_child.size(); ++i)
            for (const uint64_t child : node_list(glb_.object("nodes", i), "children"))
                is_child[child] = true;
        std::vector<uint64_t> roots;
        for (size_t i = 0; i < is_child.size(); ++i)
            if (!is_child[i]) roots.push_back(i);
        return roots;
    }

    std::vector<uint64_t> node_list(const json& from, const char* key) const {
        std::vector<uint64_t> nodes;
        for (const json& node : glb_.array(from, key)) {
            if (!node.is_number_unsigned() || node.get<uint64_t>() >= glb_.count("nodes"))
                glb_.bad("\"{}\" names a node that does not exist", key);
            nodes.push_back(node.get<uint64_t>());
        }
        return nodes;
    }

    /// Depth-first without recursion; a node met twice is a loop or has two parents.
    void collect_tree(uint64_t root) {
        std::vector<PendingNode> stack{{root, glm::mat4(1.0f)}};
        while (!stack.empty()) {
            const PendingNode pending = stack.back();
            stack.pop_back();
            if (visited_[pending.index]) glb_.bad("node {} is reached twice", pending.index);
            visited_[pending.index] = true;
            const json& node = glb_.object("nodes", pending.index);
            const glm::mat4 to_world = pending.parent_to_world * local_transform(node);
            if (const uint64_t mesh = glb_.get_index(node, "mesh", none); mesh != none)
                for (const json& primitive : glb_.array(glb_.object("meshes", mesh), "primitives"))
                    collect(primitive, to_world);
            for (const uint64_t child : node_list(node, "children"))
                stack.push_back({child, to_world});
        }
    }

    glm::mat4 local_transform(const json& node) const {
        std::array<float, 16> matrix{};
        if (glb_.get_floats(node, "matrix", matrix)) return glm::make_mat4(matrix.data());
        std::array<float, 3> move = {0, 0, 0}, scale = {1, 1, 1};
        std::array<float, 4> turn = {0, 0, 0, 1}; // x, y, z, w
        glb_.get_floats(node, "translation", move);
        glb_.get_floats(node, "rotation", turn);
        glb_.get_floats(node, "scale", scale);
        glm::mat4 transform = glm::mat4_cast(glm::quat(turn[3], turn[0], turn[1], turn[2]));
        for (size_t axis = 0; axis < 3; ++axis)
            transform[axis] *= scale[axis];
        transform[3] = glm::vec4(glm::make_vec3(move.data()), 1.0f);
        return transform;
    }

    /// Counts an instance against the limit, before anything of it is read.
    void collect(const json& primitive, const glm::mat4& to_world) {
        if (!primitive.is_object()) glb_.bad("a mesh primitive is no object");
        const json& attributes = glb_.child(primitive, "attributes");
        const uint64_t positions = glb_.require_index(attributes, "POSITION");
        claim(primitive_cost);
        claim_accessor(positions);
        claim_accessor(glb_.get_index(attributes, "NORMAL", none));
        claim_accessor(glb_.get_index(attributes, "TEXCOORD_0", none));
        claim_accessor(glb_.get_index(primitive, "indices", positions));
        instances_.push_back({&primitive, to_world});
    }

    void claim(uint64_t count) {
        if (count > mesh_max_elements - elements_)
            glb_.bad("more than {} vertices and indices", mesh_max_elements);
        elements_ += count;
    }

    void claim_accessor(uint64_t accessor) {
        if (accessor != none)
            claim(glb_.require_index(glb_.object("accessors", accessor), "count"));
    }

    void read_primitive(const json& source, const glm::mat4& to_world) {
        if (const uint64_t mode = glb_.get_index(source, "mode", mode_triangles);
            mode != mode_triangles)
            glb_.bad("primitive mode {}, only triangles (4) are read", mode);
        if (glb_.child(source, "extensions").contains("KHR_draco_mesh_compression"))
            glb_.bad("Draco-compressed meshes are not read");
        MeshPrimitive primitive;
        const json& attributes = glb_.child(source, "attributes");
        read_positions(primitive, glb_.require_index(attributes, "POSITION"), to_world);
        if (const uint64_t index = glb_.get_index(attributes, "NORMAL", none); index != none)
            read_normals(primitive, index, to_world);
        if (const uint64_t index = glb_.get_index(attributes, "TEXCOORD_0", none); index != none)
            read_uvs(primitive, index);
        read_indices(primitive, glb_.get_index(source, "indices", none), to_world);
        primitive.material = read_material_index(glb_.get_index(source, "material", none));
        mesh_.primitives.push_back(std::move(primitive));
    }

    void read_positions(MeshPrimitive& primitive, uint64_t accessor, const glm::mat4& to_world) {
        for (const glm::vec4& position : glb_.read_vectors(accessor, 3)) {
            const glm::vec3 point(to_world * glm::vec4(glm::vec3(position), 1.0f));
            for (size_t axis = 0; axis < 3; ++axis)
                if (!(std::abs(point[axis]) <= max_coordinate))
                    glb_.bad("a vertex lies at {}, beyond {} units", point[axis], max_coordinate);
            primitive.positions.push_back(to_z_up(point));
        }
    }

    void read_normals(MeshPrimitive& primitive, uint64_t accessor, const glm::mat4& to_world) {
        // Cofactors: the inverse transpose up to a positive factor, defined for singular matrices.
        const glm::mat3 linear(to_world);
        const float sign = glm::determinant(linear) < 0.0f ? -1.0f : 1.0f;
        const glm::mat3 cofactors(glm::cross(linear[1], linear[2]),
                                  glm::cross(linear[2], linear[0]),
                                  glm::cross(linear[0], linear[1]));
        for (const glm::vec4& stored : glb_.read_vectors(accessor, 3)) {
            const glm::vec3 normal = sign * (cofactors * glm::vec3(stored));
            const float length = glm::length(normal);
            const bool usable = length > 0.0f && std::isfinite(length);
            primitive.normals.push_back(usable ? to_z_up(normal / length) : glm::vec3(0, 0, 1));
        }
        if (primitive.normals.size() != primitive.positions.size())
            glb_.bad("{} normals for {} vertices", primitive.normals.size(),
                     primitive.positions.size());
    }

    void read_uvs(MeshPrimitive& primitive, uint64_t accessor) {
        for (const glm::vec4& uv : glb_.read_vectors(accessor, 2))
            primitive.uvs.emplace_back(uv.x, uv.y);
        if (primitive.uvs.size() != primitive.positions.size())
            glb_.bad("{} texture coordinates for {} vertices", primitive.uvs.size(),
                     primitive.positions.size());
    }

    void read_indices(MeshPrimitive& primitive, uint64_t accessor, const glm::mat4& to_world) {
        const size_t vertices = primitive.positions.size();
        if (accessor != none) {
            primitive.indices = glb_.read_indices(accessor);
        } else {
            for (size_t i = 0; i < vertices; ++i)
                primitive.indices.push_back(static_cast<uint32_t>(i));
        }
        if (primitive.indices.size() % 3 != 0)
            glb_.bad("{} indices are no whole triangles", primitive.indices.size());
        for (const uint32_t index : primitive.indices)
            if (index >= vertices) glb_.bad("index {} of {} vertices", index, vertices);
        // A mirroring transform turns triangles inside out.
        if (glm::determinant(glm::mat3(to_world)) < 0.0f)
            for (size_t i = 0; i < primitive.indices.size(); i += 3)
                std::swap(primitive.indices[i + 1], primitive.indices[i + 2]);
    }

    /// Primitives without a material share one with glTF's defaults, added behind the file's own.
    uint32_t read_material_index(uint64_t index) {
        if (index == none) {
            index = glb_.count("materials");
            if (mesh_.materials.size() == index) mesh_.materials.emplace_back();
        }
        if (index >= mesh_.materials.size())
            glb_.bad("material {} of {} is used", index, glb_.count("materials"));
        return static_cast<uint32_t>(index);
    }

    Glb glb_;
    Mesh mesh_;
    std::vector<Instance> instances_;
    std::vector<bool> visited_;
    uint64_t elements_ = 0;
};

} // namespace

Mesh parse_glb(std::string_view name, std::span<const uint8_t> bytes) {
    return MeshReader(name, bytes).read();
}

} // namespace vigil
