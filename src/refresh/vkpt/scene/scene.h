// SPDX-License-Identifier: GPL-2.0-or-later
// The scene on the GPU: models (triangles, hierarchies, primitives), materials, textures, and per
// frame instances, top level and lights. Owns the buffers of set 0 that describe it, and knows
// which features the level uses.
#pragma once

#include "refresh/refresh.h"
#include "refresh/vkpt/gpu/commands.h"
#include "refresh/vkpt/scene/acceleration_structure.h"
#include "refresh/vkpt/scene/light_set.h"
#include "refresh/vkpt/scene/material_set.h"
#include "refresh/vkpt/scene/mesh_geometry.h"
#include "refresh/vkpt/scene/sky_description.h"
#include "refresh/vkpt/scene/top_level.h"

#include "shared/features.h"

#include <map>
#include <memory>
#include <optional>
#include <string>

namespace vigil::vkpt {

/// Whether a beam has any extent.
inline bool is_visible(const refresh::Beam& beam) {
    return beam.radius > 0.0f && beam.from != beam.to;
}

/// What an instance has besides its place.
struct InstanceLook {
    uint32_t flags = shader::INSTANCE_PLAIN;
    glm::vec3 glow{0.0f};
};

class Scene {
public:
    Scene(const gpu::Device& device, const FileSystem& files, std::shared_ptr<const Level> level,
          const refresh::Settings& settings);

    refresh::ModelHandle register_model(std::string_view name);
    refresh::SkinHandle register_skin(std::string_view name);
    void set_sky(std::string_view name, float degrees_per_second, const glm::vec3& axis);

    /// Follows pt_env_nee and pt_sky_lights. True if lights have other ids than before: whoever
    /// knows some must forget them.
    bool follow_environment(const refresh::Settings& settings);
    /// Brings the scene to this frame on the host: instances, lights, poses. Returns true if a
    /// buffer was made anew, so that descriptors must be written again; the GPU must be idle then,
    /// which this function sees to.
    bool prepare(const refresh::Frame& frame);
    /// After prepare: makes what ray queries need, or brings it to this frame (`on`), or drops it.
    /// Returns true if acceleration_structure() is another one than before; the GPU is idle then.
    /// Throws Error if the device has no room for it.
    bool prepare_ray_query(bool on);
    /// Records the copies of what changed; after prepare and prepare_ray_query.
    void upload(gpu::FrameCommands& commands);

    const Level& level() const { return *level_; }
    const SceneFeatures& features() const { return features_; }
    /// Those that shaders are compiled for: the scene's own, and what pt_features adds. Sky and sun
    /// are lights only where pt_env_nee makes them so.
    SceneFeatures compiled_features(const refresh::Settings& settings) const;
    const SkyDescription& sky() const { return sky_; }
    /// Whether sky faces show a sun.
    bool has_sun() const { return features_.sky && sky_.sun_irradiance != glm::vec3(0.0f); }
    /// Whether time alone changes what surfaces look like.
    bool textures_move() const;
    const LightSet& lights() const { return lights_; }
    /// Of the static world's triangles.
    const Bounds& world_bounds() const { return placed_.front().bounds; }
    /// Grows whenever anything that a picture shows differs from the frame before.
    uint64_t revision() const { return revision_; }
    refresh::SceneReport report() const;

    const gpu::Buffer& nodes() const { return nodes_buffer_; }
    const gpu::Buffer& triangles() const { return triangles_buffer_; }
    const gpu::Buffer& primitives() const { return primitives_buffer_; }
    const gpu::Buffer& top_nodes() const { return top_buffer_; }
    const gpu::Buffer& instances() const { return instances_buffer_; }
    const gpu::Buffer& materials() const { return materials_buffer_; }
    const gpu::Buffer& textures() const { return textures_buffer_; }
    const gpu::Buffer& texels() const { return texels_buffer_; }
    const gpu::Buffer& light_buffer() const { return lights_buffer_; }
    const gpu::Buffer& cluster_tree() const { return cluster_buffer_; }
    /// The top level for ray queries; null while they are off.
    VkAccelerationStructureKHR acceleration_structure() const {
        return ray_query_ ? ray_query_->top() : VK_NULL_HANDLE;
    }

    // What exporting needs (scene_export.h): everything in its host form.
    const std::vector<shader::BvhTriangle>& host_triangles() const { return triangles_; }
    const std::vector<shader::Primitive>& host_primitives() const { return primitives_; }
    const std::vector<shader::Instance>& host_instances() const { return instances_; }
    const MaterialSet& host_materials() const { return *materials_; }
    const TextureSet& host_textures() const { return *textures_; }
    /// Range of triangles of the model an instance shows.
    struct TriangleRange {
        uint32_t first;
        uint32_t count;
    };
    TriangleRange instance_triangles(size_t instance) const;

private:
    /// A model, or a pose of an animated one, in the shared geometry buffers.
    struct Placed {
        std::string name;
        uint32_t root = 0;
        uint32_t first_triangle = 0;
        uint32_t triangle_count = 0;
        uint32_t first_node_word = 0;
        uint32_t node_words = 0; // reserved
        uint64_t revision = 0;   // of the geometry, from 1
        bool deforms = false;    // a pose
        Bounds bounds;
        std::vector<LightSource> lights; // lamps, then windows to the sky
        size_t lamps = 0;
    };
    struct Model {
        std::string name;
        std::vector<size_t> frames; // rigid models: one; sprites: their quads
        bool sprite = false;
        std::shared_ptr<const Md2> md2; // animated ones
        std::vector<uint32_t> skin_materials;
    };
    struct Pose {
        size_t placed = 0;
        Md2Pose shown;
        bool used = false;
    };

    void read_sky();
    void find_sky_pictures();
    void measure_sky();
    /// Makes windows of the sky faces that a model has.
    void cut_windows(Placed& placed);
    /// The model's lights, without those that pt_env_nee leaves out.
    std::span<const LightSource> lights_of(const Placed& placed) const;
    void restart_lights();
    /// What sky and sun are as lights in this frame.
    Environment environment(const refresh::Settings& settings) const;
    enum class Deforms { No, Yes };
    size_t place_model(std::string name, ModelGeometry geometry, Deforms deforms);
    void write_model(Placed& placed, const ModelGeometry& geometry);
    size_t pose_of(const refresh::Entity& entity);
    void add_entity(const refresh::Entity& entity, const refresh::View& view);
    void add_particles(const refresh::Frame& frame);
    /// Adds an instance with its lights, unless there is no room for these.
    void add_model(size_t placed_index, const glm::mat4x3& transform, const glm::vec3& tint,
                   uint64_t key, uint32_t entity, const InstanceLook& look = {});
    void add_instance(const Placed& placed, size_t placed_index, const glm::mat4x3& transform,
                      uint32_t first_light, uint64_t key, uint32_t entity,
                      const InstanceLook& look = {});
    void update_features(bool any_instances);
    /// What materials and triangles have of features.
    SceneFeatures features_of_surfaces() const;
    bool upload_static();

    const gpu::Device& device_;
    const FileSystem& files_;
    std::shared_ptr<const Level> level_;
    std::unique_ptr<TextureSet> textures_;
    std::unique_ptr<MaterialSet> materials_;
    SkyDescription sky_;
    SkyBrightness sky_brightness_;
    uint64_t sky_revision_ = 0;
    bool environment_on_ = false; // pt_env_nee
    uint32_t most_sky_lights_ = 0;
    float sun_area_ = 0.0f; // of the world's sky faces, across the sun's rays
    SceneFeatures features_;

    // Geometry of all models, as the GPU has it.
    std::vector<glm::uvec4> nodes_;
    std::vector<shader::BvhTriangle> triangles_;
    std::vector<shader::Primitive> primitives_;
    std::vector<glm::vec3> corners_; // of the triangles, exact; only where rays can be queried
    std::vector<Placed> placed_;
    std::vector<Model> models_;
    std::map<std::string, refresh::ModelHandle, std::less<>> model_names_;
    std::vector<uint32_t> skins_;                                // materials
    std::map<std::pair<refresh::ModelHandle, int>, Pose> poses_; // by model and entity number
    std::vector<size_t> changed_; // placed models whose geometry was written since the last upload
    std::optional<size_t> dynamic_light_model_;
    std::optional<size_t> spot_model_;
    std::optional<size_t> particle_model_;
    size_t particle_capacity_ = 0;
    bool static_dirty_ = true;

    // This frame.
    std::vector<shader::Instance> instances_;
    std::vector<size_t> instance_placed_;
    std::vector<TopLevelInstance> top_instances_, built_top_instances_; // those of top_nodes_
    std::vector<shader::TopNode> top_nodes_;
    std::map<uint64_t, glm::mat4x3> previous_transforms_;
    std::map<uint64_t, glm::mat4x3> transforms_;
    LightSet lights_;
    uint64_t uploaded_light_revision_ = 0;
    uint64_t seen_light_revision_ = 0;
    bool reported_no_room_ = false; // that there was no room for some
    uint64_t revision_ = 1;
    std::vector<std::byte> instance_bytes_; // of the frame before, to see changes
    // What the buffers do not have yet.
    bool instances_changed_ = true, top_changed_ = true;
    SceneFeatures surface_features_; // of materials and triangles as they are
    std::vector<refresh::Particle> shown_particles_;
    glm::vec3 particle_eye_{0.0f};

    gpu::Buffer nodes_buffer_, triangles_buffer_, primitives_buffer_, top_buffer_,
        instances_buffer_, materials_buffer_, textures_buffer_, texels_buffer_, lights_buffer_,
        cluster_buffer_;
    std::optional<AccelerationStructures> ray_query_; // while rays are traced by queries
};

} // namespace vigil::vkpt
