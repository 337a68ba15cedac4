// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/scene/scene.h"

#include "common/error.h"
#include "common/file_system.h"
#include "common/log.h"
#include "level/level.h"
#include "refresh/vkpt/scene/particle_geometry.h"
#include "refresh/vkpt/scene/subdivide.h"
#include "refresh/vkpt/scene/transform.h"
#include "refresh/vkpt/scene/world_geometry.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <utility>

namespace vigil::vkpt {

namespace {

constexpr uint64_t entity_key_base = uint64_t{1} << 32;
constexpr uint64_t dynamic_light_key_base = uint64_t{2} << 32;
constexpr uint64_t beam_key_base = uint64_t{3} << 32;
constexpr uint64_t spot_key_base = uint64_t{5} << 32;
constexpr uint64_t particles_key = uint64_t{4} << 32;
constexpr size_t least_particles = 256;
// How far a shell stands off its model, as in Quake II, in map units.
constexpr float shell_swell = 4.0f, front_shell_swell = 0.5f;

bool is_liquid(const shader::Material& material) {
    return (material.flags & (shader::MATERIAL_WARP | shader::MATERIAL_FLOWING)) != 0;
}

bool is_animated(const shader::Material& material) {
    return material.frame_count > 1;
}

} // namespace

Scene::Scene(const gpu::Device& device, const FileSystem& files, std::shared_ptr<const Level> level,
             const refresh::Settings& settings)
    : device_(device), files_(files), level_(std::move(level)),
      textures_(std::make_unique<TextureSet>(files)),
      materials_(std::make_unique<MaterialSet>(files, *textures_)) {
    environment_on_ = settings.pt_env_nee != 0;
    most_sky_lights_ = static_cast<uint32_t>(settings.pt_sky_lights);
    ModelGeometry world = brush_model_geometry(*level_, 0, *materials_);
    subdivide(world, settings.pt_subdivide);
    read_sky();
    place_model("*0", std::move(world), Deforms::No);
    restart_lights();
    cluster_buffer_ =
        gpu::make_buffer(device_, gpu::bytes_of(vkpt::cluster_tree(level_->bsp)), "cluster tree");
    update_features(false);
}

std::span<const LightSource> Scene::lights_of(const Placed& placed) const {
    return std::span(placed.lights).first(environment_on_ ? placed.lights.size() : placed.lamps);
}

size_t Scene::place_model(std::string name, ModelGeometry geometry, Deforms deforms) {
    Placed placed;
    placed.name = std::move(name);
    placed.first_triangle = static_cast<uint32_t>(triangles_.size());
    placed.triangle_count = static_cast<uint32_t>(geometry.triangles.size());
    placed.first_node_word = static_cast<uint32_t>(nodes_.size());
    triangles_.resize(triangles_.size() + geometry.triangles.size());
    primitives_.resize(triangles_.size());
    if (device_.features().ray_query) corners_.resize(3 * triangles_.size());
    placed.deforms = deforms == Deforms::Yes;
    write_model(placed, geometry);
    // A deforming model gets room for the largest hierarchy that a pose can need.
    if (placed.deforms)
        nodes_.resize(placed.first_node_word + max_bvh_words(placed.triangle_count));
    placed.node_words = static_cast<uint32_t>(nodes_.size()) - placed.first_node_word;
    placed.lights = std::move(geometry.lights);
    placed.lamps = placed.lights.size();
    cut_windows(placed);
    placed_.push_back(std::move(placed));
    static_dirty_ = true;
    return placed_.size() - 1;
}

void Scene::write_model(Placed& placed, const ModelGeometry& geometry) {
    const Bvh bvh = build_bvh(geometry.triangles);
    placed.bounds = bvh.bounds;
    ++placed.revision;
    if (placed.node_words == 0) {
        placed.root = append_bvh(bvh, placed.first_triangle, nodes_);
    } else {
        const std::vector<glm::uvec4> nodes =
            rebase_bvh(bvh, placed.first_triangle, placed.first_node_word / shader::BVH_NODE_WORDS);
        std::copy(nodes.begin(), nodes.end(), nodes_.begin() + placed.first_node_word);
    }
    for (size_t slot = 0; slot < bvh.order.size(); ++slot) {
        const BvhInputTriangle& source = geometry.triangles[bvh.order[slot]];
        shader::BvhTriangle& triangle = triangles_[placed.first_triangle + slot];
        triangle.v0 = source.v0;
        triangle.flags = source.coverage & shader::TRIANGLE_COVERAGE_MASK;
        triangle.e1 = source.v1 - source.v0;
        triangle.e2 = source.v2 - source.v0;
        primitives_[placed.first_triangle + slot] = geometry.primitives[bvh.order[slot]];
        if (!corners_.empty()) {
            glm::vec3* corners = &corners_[3 * (placed.first_triangle + slot)];
            corners[0] = source.v0;
            corners[1] = source.v1;
            corners[2] = source.v2;
        }
    }
}

refresh::ModelHandle Scene::register_model(std::string_view name) {
    if (const auto known = model_names_.find(name); known != model_names_.end())
        return known->second;
    Model model;
    model.name = name;
    if (name.starts_with('*')) {
        uint32_t index = 0;
        const auto parsed = std::from_chars(name.data() + 1, name.data() + name.size(), index);
        if (parsed.ec != std::errc() || parsed.ptr != name.data() + name.size() || index == 0 ||
            index >= level_->bsp.models.size())
            fail("{}: the level has brush models *1 to *{}", name, level_->bsp.models.size() - 1);
        model.frames.push_back(place_model(
            model.name, brush_model_geometry(*level_, index, *materials_), Deforms::No));
    } else if (name.ends_with(".md2")) {
        model.md2 = std::make_shared<Md2>(parse_md2(name, files_.read(name)));
        for (const std::string& skin : model.md2->skins)
            model.skin_materials.push_back(materials_->picture_material(skin));
        if (model.skin_materials.empty())
            model.skin_materials.push_back(materials_->picture_material(model.name + " skin"));
    } else if (name.ends_with(".glb")) {
        model.frames.push_back(
            place_model(model.name, mesh_geometry(parse_glb(name, files_.read(name)), *materials_),
                        Deforms::No));
    } else if (name.ends_with(".sp2")) {
        model.sprite = true;
        for (const Sp2Frame& frame : parse_sp2(name, files_.read(name)))
            model.frames.push_back(place_model(
                model.name, sprite_geometry(frame, materials_->cutout_material(frame.picture)),
                Deforms::No));
    } else {
        fail("{}: models are *N, .md2, .sp2 or .glb", name);
    }
    models_.push_back(std::move(model));
    const auto handle = static_cast<refresh::ModelHandle>(models_.size() - 1);
    model_names_.emplace(std::string(name), handle);
    static_dirty_ = true;
    return handle;
}

refresh::SkinHandle Scene::register_skin(std::string_view name) {
    const std::string path(name);
    if (textures_->picture(path).file.empty()) fail("{}: not a picture that can be read", name);
    const uint32_t material = materials_->picture_material(path);
    const auto known = std::find(skins_.begin(), skins_.end(), material);
    if (known != skins_.end()) return static_cast<refresh::SkinHandle>(known - skins_.begin());
    static_dirty_ = true;
    skins_.push_back(material);
    return static_cast<refresh::SkinHandle>(skins_.size() - 1);
}

size_t Scene::pose_of(const refresh::Entity& entity) {
    const Model& model = models_[static_cast<size_t>(entity.model)];
    Md2Pose shown{entity.frame, entity.old_frame, entity.backlerp, 0.0f, 0};
    if (entity.shell != glm::vec3(0.0f)) {
        shown.material = materials_->particle_material(entity.shell);
        shown.swell =
            (entity.flags & refresh::entity_in_front) != 0 ? front_shell_swell : shell_swell;
    } else if (entity.custom_skin >= 0 && static_cast<size_t>(entity.custom_skin) < skins_.size()) {
        shown.material = skins_[static_cast<size_t>(entity.custom_skin)];
    } else {
        const int last = static_cast<int>(model.skin_materials.size()) - 1;
        shown.material =
            model.skin_materials[static_cast<size_t>(std::clamp(entity.skin, 0, last))];
    }
    const std::pair key(entity.model, entity.number);
    auto known = poses_.find(key);
    if (known == poses_.end()) {
        // Take over an unused slot of the same model, else make one.
        const auto unused = std::find_if(poses_.begin(), poses_.end(), [&](const auto& row) {
            return !row.second.used && row.first.first == entity.model;
        });
        Pose pose;
        if (unused != poses_.end()) {
            pose = unused->second;
            poses_.erase(unused);
        } else {
            pose.shown = shown;
            pose.placed = place_model(model.name, md2_geometry(*model.md2, shown), Deforms::Yes);
        }
        known = poses_.emplace(key, pose).first;
    }
    Pose& pose = known->second;
    pose.used = true;
    if (pose.shown != shown) {
        pose.shown = shown;
        write_model(placed_[pose.placed], md2_geometry(*model.md2, shown));
        changed_.push_back(pose.placed);
    }
    return pose.placed;
}

void Scene::add_instance(const Placed& placed, size_t placed_index, const glm::mat4x3& transform,
                         uint32_t first_light, uint64_t key, uint32_t entity,
                         const InstanceLook& look) {
    shader::Instance instance{};
    instance.world_from_object = transform;
    instance.object_from_world = inverse_transform(transform);
    const auto before = previous_transforms_.find(key);
    instance.previous_world_from_object =
        before != previous_transforms_.end() ? before->second : transform;
    instance.bvh_root = placed.root;
    instance.first_light = first_light;
    instance.flags = look.flags;
    instance.entity = entity;
    instance.glow = look.glow;
    transforms_[key] = transform;
    const auto index = static_cast<uint32_t>(instances_.size());
    if (index > 0)
        top_instances_.push_back(
            {placed.bounds, transform, instance.object_from_world, placed.root, index, look.flags});
    instances_.push_back(instance);
    instance_placed_.push_back(placed_index);
}

void Scene::add_model(size_t placed_index, const glm::mat4x3& transform, const glm::vec3& tint,
                      uint64_t key, uint32_t entity, const InstanceLook& look) {
    const Placed& placed = placed_[placed_index];
    // Light that its rays do not find is none.
    const float share = (look.flags & shader::INSTANCE_LIT) != 0
                            ? static_cast<float>(shader::bvh_opacity(look.flags)) / 255.0f
                            : 0.0f;
    if (const auto first_light = lights_.place(key, lights_of(placed), transform, share * tint))
        add_instance(placed, placed_index, transform, *first_light, key, entity, look);
    else if (!std::exchange(reported_no_room_, true))
        log_warning("{}: its entities have more than {} lights. The rest is not shown.",
                    level_->bsp.name, max_moving_lights);
}

void Scene::add_entity(const refresh::Entity& entity, const refresh::View& view) {
    if (entity.model < 0 || entity.model >= static_cast<int>(models_.size())) return;
    const Model& model = models_[static_cast<size_t>(entity.model)];
    const bool for_camera_alone = model.sprite || (model.md2 && entity.shell != glm::vec3(0.0f));
    InstanceLook look;
    look.flags = coverage_of(entity.alpha) << shader::INSTANCE_OPACITY_SHIFT;
    if (look.flags == 0) return;
    if ((entity.flags & refresh::entity_hidden_from_camera) == 0)
        look.flags |= (entity.flags & refresh::entity_in_front) != 0 ? shader::INSTANCE_FRONT
                                                                     : shader::INSTANCE_SEEN;
    if ((entity.flags & refresh::entity_hidden_from_light) == 0 && !for_camera_alone)
        look.flags |= shader::INSTANCE_LIT;
    if (model.sprite) look.flags |= shader::INSTANCE_CUTOUT;
    look.glow = glm::max(entity.glow, 0.0f);
    const size_t placed =
        model.md2 ? pose_of(entity) : model.frames[wrap_frame(entity.frame, model.frames.size())];
    const auto number = static_cast<uint32_t>(entity.number);
    const glm::mat4x3 transform =
        rigid_transform(entity.origin, model.sprite ? view.angles : entity.angles);
    add_model(placed, scaled_across_view(transform, view.origin, view.angles, entity.view_scale),
              glm::vec3(1.0f), entity_key_base + number, number, look);
}

void Scene::add_particles(const refresh::Frame& frame) {
    if (frame.particles.empty()) return;
    // One model for all of them, whose size doubles as needed: the hierarchy of a model that
    // deforms has a fixed place.
    if (particle_capacity_ < frame.particles.size()) {
        particle_capacity_ = std::bit_ceil(std::max(frame.particles.size(), least_particles));
        particle_model_ = place_model(
            "particles", particle_geometry(frame, particle_capacity_, *materials_), Deforms::Yes);
    } else if (particle_eye_ != frame.view.origin ||
               !std::ranges::equal(frame.particles, shown_particles_)) {
        const size_t materials = materials_->materials().size();
        write_model(placed_[*particle_model_],
                    particle_geometry(frame, particle_capacity_, *materials_));
        changed_.push_back(*particle_model_);
        static_dirty_ |= materials_->materials().size() != materials; // a new colour
    }
    shown_particles_.assign(frame.particles.begin(), frame.particles.end());
    particle_eye_ = frame.view.origin; // which they face
    add_instance(placed_[*particle_model_], *particle_model_, glm::mat4x3(1.0f), 0, particles_key,
                 0);
}

bool Scene::prepare(const refresh::Frame& frame) {
    // Place all models of this frame.
    instances_.clear();
    instance_placed_.clear();
    top_instances_.clear();
    previous_transforms_.swap(transforms_);
    transforms_.clear();
    // What is shown again keeps its pose, however early a new entity is in the list.
    for (auto& [key, pose] : poses_)
        pose.used = false;
    for (const refresh::Entity& entity : frame.entities)
        if (const auto known = poses_.find({entity.model, entity.number}); known != poses_.end())
            known->second.used = true;
    lights_.begin_frame(frame.light_styles, frame.settings.pt_emissive_scale,
                        environment(frame.settings));
    const glm::mat4x3 identity(1.0f);
    add_instance(placed_[0], 0, identity, 0, 0, 0);
    const size_t materials = materials_->materials().size();
    for (const refresh::Entity& entity : frame.entities)
        add_entity(entity, frame.view);
    static_dirty_ |= materials_->materials().size() != materials; // a new colour of a shell
    add_particles(frame);
    if ((!frame.dynamic_lights.empty() || !frame.beams.empty()) && !dynamic_light_model_)
        dynamic_light_model_ = place_model(
            "dynamic light", dynamic_light_geometry(materials_->lamp_material()), Deforms::No);
    for (const refresh::DynamicLight& light : frame.dynamic_lights) {
        if (!(light.radius > 0.0f)) continue;
        InstanceLook look;
        if (!light.visible) look.flags &= ~shader::INSTANCE_SEEN;
        add_model(*dynamic_light_model_, scale_transform(light.origin, light.radius),
                  light.radiance, dynamic_light_key_base + light.id, light.id, look);
    }
    for (const refresh::Beam& beam : frame.beams) {
        if (!is_visible(beam)) continue;
        add_model(*dynamic_light_model_, spindle_transform(beam.from, beam.to, beam.radius),
                  beam.radiance, beam_key_base + beam.id, beam.id);
    }
    if (!frame.spots.empty() && !spot_model_)
        spot_model_ = place_model(
            "spot", spot_geometry(materials_->lamp_material(), materials_->black_material()),
            Deforms::No);
    for (const refresh::Spot& spot : frame.spots) {
        if (!(spot.radius > 0.0f)) continue;
        const glm::mat3 turned = spot.radius * rotation_from_angles(spot.angles);
        const glm::mat4x3 transform(turned[0], turned[1], turned[2], spot.origin);
        add_model(*spot_model_, transform, spot.radiance, spot_key_base + spot.id, spot.id);
    }
    lights_.end_frame();
    if (top_instances_ != built_top_instances_ || top_nodes_.empty()) {
        top_nodes_ = build_top_level(top_instances_);
        built_top_instances_ = top_instances_;
        top_changed_ = true;
    }
    update_features(instances_.size() > 1);

    // Note whether the picture can differ from the last frame's.
    const auto bytes = gpu::bytes_of(instances_);
    const bool moved =
        !std::equal(bytes.begin(), bytes.end(), instance_bytes_.begin(), instance_bytes_.end());
    if (moved || static_dirty_ || !changed_.empty() || lights_.revision() != seen_light_revision_)
        ++revision_;
    if (moved) instance_bytes_.assign(bytes.begin(), bytes.end());
    instances_changed_ |= moved;
    seen_light_revision_ = lights_.revision();

    // Make room.
    bool renewed = static_dirty_ && upload_static();
    const auto make_room = [&](gpu::Buffer& buffer, uint64_t size, const char* name,
                               bool& changed) {
        if (!gpu::grow(device_, buffer, size, name)) return;
        renewed = changed = true;
    };
    make_room(instances_buffer_, bytes.size(), "instances", instances_changed_);
    make_room(top_buffer_, gpu::bytes_of(top_nodes_).size(), "top-level nodes", top_changed_);
    if (gpu::grow(device_, lights_buffer_, lights_.lights().size_bytes(), "lights")) {
        renewed = true;
        uploaded_light_revision_ = 0;
    }
    return renewed;
}

bool Scene::upload_static() {
    device_.wait_idle();
    const auto replace = [this](gpu::Buffer& buffer, const auto& values, const char* name) {
        buffer = gpu::make_buffer(device_, gpu::bytes_of(values), name);
    };
    replace(nodes_buffer_, nodes_, "bottom-level nodes");
    replace(triangles_buffer_, triangles_, "triangles");
    replace(primitives_buffer_, primitives_, "primitives");
    replace(materials_buffer_, materials_->materials(), "materials");
    const uint32_t most = device_.properties().limits.maxTexelBufferElements;
    if (const size_t cut = textures_->fit(most); cut > 0)
        log_warning("{} pictures are shown in less detail: this device reads at most {} texels",
                    cut, most);
    replace(textures_buffer_, textures_->headers(), "texture headers");
    replace(texels_buffer_, textures_->texels(), "texels");
    static_dirty_ = false;
    changed_.clear();
    return true;
}

void Scene::upload(gpu::FrameCommands& commands) {
    for (const size_t index : changed_) {
        const Placed& placed = placed_[index];
        const auto nodes = std::span(nodes_).subspan(placed.first_node_word, placed.node_words);
        commands.upload(nodes_buffer_, placed.first_node_word * sizeof(glm::uvec4),
                        std::as_bytes(nodes));
        commands.upload(
            triangles_buffer_, placed.first_triangle * sizeof(shader::BvhTriangle),
            std::as_bytes(
                std::span(triangles_).subspan(placed.first_triangle, placed.triangle_count)));
        commands.upload(
            primitives_buffer_, placed.first_triangle * sizeof(shader::Primitive),
            std::as_bytes(
                std::span(primitives_).subspan(placed.first_triangle, placed.triangle_count)));
    }
    changed_.clear();
    if (std::exchange(instances_changed_, false))
        commands.upload(instances_buffer_, 0, gpu::bytes_of(instances_));
    if (std::exchange(top_changed_, false))
        commands.upload(top_buffer_, 0, gpu::bytes_of(top_nodes_));
    if (uploaded_light_revision_ != lights_.revision()) {
        commands.upload(lights_buffer_, 0, std::as_bytes(lights_.lights()));
        uploaded_light_revision_ = lights_.revision();
    }
    if (ray_query_) ray_query_->record(commands);
}

SceneFeatures Scene::features_of_surfaces() const {
    SceneFeatures features;
    for (const shader::Material& material : materials_->materials()) {
        features.sky |= (material.flags & shader::MATERIAL_SKY) != 0;
        features.gloss |= (material.flags & shader::MATERIAL_GLOSSY) != 0;
    }
    features.translucent =
        std::any_of(triangles_.begin(), triangles_.end(), [](const shader::BvhTriangle& t) {
            return (t.flags & shader::TRIANGLE_COVERAGE_MASK) != 255;
        });
    return features;
}

void Scene::update_features(bool any_instances) {
    if (static_dirty_ || !changed_.empty()) surface_features_ = features_of_surfaces();
    SceneFeatures features = surface_features_;
    for (const shader::Instance& instance : instances_) {
        features.effects |=
            instance.flags != shader::INSTANCE_PLAIN || instance.glow != glm::vec3(0.0f);
        features.translucent |= shader::bvh_opacity(instance.flags) != 255;
    }
    features.lights = !lights_.lights().empty();
    features.environment = features.sky && environment_on_;
    features.instances = any_instances;
    features_ = features;
}

bool Scene::textures_move() const {
    return std::ranges::any_of(materials_->materials(), [](const shader::Material& material) {
        return is_animated(material) || is_liquid(material);
    });
}

SceneFeatures Scene::compiled_features(const refresh::Settings& settings) const {
    SceneFeatures features = features_;
    for (const SceneFeatureRow& row : scene_feature_rows)
        features.*row.member |= forces_feature(settings.pt_features, row.member);
    features.environment &= environment_on_;
    return features;
}

Scene::TriangleRange Scene::instance_triangles(size_t instance) const {
    const Placed& placed = placed_[instance_placed_[instance]];
    return {placed.first_triangle, placed.triangle_count};
}

refresh::SceneReport Scene::report() const {
    const std::vector<shader::Material>& materials = materials_->materials();
    const auto flagged = [&](uint32_t flags) -> uint64_t {
        return std::ranges::count_if(
            materials, [&](const shader::Material& m) { return (m.flags & flags) != 0; });
    };
    const uint64_t translucent =
        std::ranges::count_if(triangles_, [](const shader::BvhTriangle& t) {
            return (t.flags & shader::TRIANGLE_COVERAGE_MASK) != 255;
        });
    const uint64_t liquids = std::ranges::count_if(materials, is_liquid);
    const uint64_t animated = std::ranges::count_if(materials, is_animated);
    refresh::SceneReport report;
    report.level = level_->name;
    report.triangles = triangles_.size();
    report.materials = materials.size();
    report.textures = textures_->headers().size();
    report.instances = instances_.size();
    report.lights = lights_.lights().size();
    report.static_lights = lights_.static_count();
    report.features = {
        {"lights", features_.lights, "emissive triangles", report.lights},
        {"sky", features_.sky,
         !features_.sky ? "no sky faces"
                        : fmt::format("faces show sky \"{}\"{}", sky_.name,
                                      sky_.texture ? "" : " (no pictures: an even colour)")},
        {"sun", has_sun(),
         has_sun() ? "worldspawn has _sun_light" : "no _sun_light, or no sky faces"},
        {"sky as light", features_.environment,
         features_.sky ? "windows to the sky, and the sun" : "no sky faces",
         features_.environment
             ? static_cast<uint64_t>(std::ranges::count_if(
                   lights_.lights(), [](const shader::Light& l) { return l.flags != 0; }))
             : 0},
        {"translucency", features_.translucent, "triangles", translucent},
        {"gloss", features_.gloss, "materials", flagged(shader::MATERIAL_GLOSSY)},
        {"liquids", liquids > 0, "warping or flowing materials", liquids},
        {"animation", animated > 0, "animated materials", animated},
        {"instances", features_.instances, "besides the static world",
         instances_.empty() ? 0 : instances_.size() - 1},
        {"effects", features_.effects,
         "entities that fade, glow, are sprites or hidden from some rays"}};
    report.missing_textures = textures_->missing();
    report.ray_query_bytes = ray_query_ ? ray_query_->bytes() : 0;
    report.bytes = report.ray_query_bytes;
    for (const gpu::Buffer* buffer :
         {&nodes_buffer_, &triangles_buffer_, &primitives_buffer_, &top_buffer_, &instances_buffer_,
          &materials_buffer_, &textures_buffer_, &texels_buffer_, &lights_buffer_,
          &cluster_buffer_})
        report.bytes += buffer->bytes();
    return report;
}

} // namespace vigil::vkpt
