// SPDX-License-Identifier: GPL-2.0-or-later
// What the renderer tells: its pictures, the scene, the memory of its guiding, and the octree's
// leaf under the crosshair with the lights of its cache and its quadtree.
#include "common/error.h"
#include "refresh/vkpt/guiding/cdq_report.h"
#include "refresh/vkpt/guiding/guiding_counts.h"
#include "refresh/vkpt/guiding/leaf_report.h"
#include "refresh/vkpt/light/light_power.h"
#include "refresh/vkpt/renderer.h"

#include "shared/direction_map.h"

#include <algorithm>
#include <cstring>

namespace vigil::vkpt {

namespace {

using refresh::CachedLight;

/// Whether a light of this instance, which is not the world, has this id.
bool has_light(const Scene& scene, size_t instance, uint32_t id) {
    const uint32_t first = scene.host_instances()[instance].first_light;
    if (id < first) return false;
    const Scene::TriangleRange range = scene.instance_triangles(instance);
    return std::ranges::any_of(
        std::span(scene.host_primitives()).subspan(range.first, range.count),
        [&](const shader::Primitive& primitive) { return primitive.light == id - first; });
}

/// The last `dynamic_lights` instances are dynamic lights.
CachedLight cached_light(const Scene& scene, uint32_t id, size_t dynamic_lights) {
    const std::span<const shader::Light> lights = scene.lights().lights();
    CachedLight light{id};
    if (id < lights.size()) light.power = shader::PI * light_power(lights[id]);
    if (id < scene.lights().static_count()) return light;
    const std::vector<shader::Instance>& instances = scene.host_instances();
    light.owner = CachedLight::Owner::Gone;
    for (size_t i = 1; i < instances.size(); ++i) {
        if (!has_light(scene, i, id)) continue;
        const bool dynamic = i + dynamic_lights >= instances.size();
        light.owner = dynamic ? CachedLight::Owner::DynamicLight : CachedLight::Owner::Entity;
        light.number = instances[i].entity;
    }
    return light;
}

/// Where a point of an instance was in the frame before.
glm::vec3 position_before(const shader::Instance& instance, glm::vec3 position) {
    const glm::vec3 local = instance.object_from_world * glm::vec4(position, 1.0f);
    return instance.previous_world_from_object * glm::vec4(local, 1.0f);
}

} // namespace

std::optional<shader::PrimaryHit> VkptRenderer::hit_under_crosshair() const {
    device_.wait_idle();
    const glm::uvec2 size = buffers_.size(), pixel = shader::crosshair_pixel(size);
    const shader::PrimaryHit hit = gpu::download_now_as<shader::PrimaryHit>(
        device_, buffers_.primary_hits(), uint64_t{pixel.y} * size.x + pixel.x, 1)[0];
    if (hit.primitive == shader::NONE) return std::nullopt;
    return hit;
}

refresh::SceneReport VkptRenderer::report_scene(const refresh::Settings& settings) const {
    if (!scene_) fail("no level is loaded");
    refresh::SceneReport report = scene_->report();
    if (const LightTechnique* technique = left_.technique())
        report.features.push_back(
            {"light caches", technique->uses_guiding(), technique->guiding_reason()});
    report.ray_query = use_ray_query(settings);
    report.filter_bytes = filter_.bytes();
    return report;
}

refresh::GuidingReport VkptRenderer::report_guiding() const {
    if (!scene_) fail("no level is loaded");
    const Side& side = shown_side();
    refresh::GuidingReport report;
    report.technique = side.id();
    report.on = shown_.guided;
    if (!report.on) return report;
    report.quadtrees = shown_.guide.guide == Guide::cdq;
    report.leaves = octree_leaf_count(guiding_work_.nodes);
    report.depth = guiding_work_.depth;
    report.caches = guiding_work_.cached_leaves;

    const Guiding& guiding = side.guiding();
    const Guiding::Tree& tree = guiding.tree();
    report.bytes = guiding.memory_bytes();
    // There are two trees, the one before and the one of the frame.
    report.memory = {{"octree nodes, twice", 2 * tree.nodes.bytes()},
                     {"octree cells, twice", 2 * tree.cells.bytes()},
                     {"octree leaves, twice", 2 * tree.leaves.bytes()},
                     {"light samples", guiding.samples().bytes()},
                     {"light caches, twice", 2 * tree.caches.bytes()}};
    if (guiding.guided()) report.memory.push_back({"ray samples", guiding.rays().bytes()});
    uint64_t rest = report.bytes;
    for (const auto& part : report.memory)
        rest -= part.amount;
    report.memory.push_back({"plan and lists", rest});
    const Guiding::Needs needs = Guiding::needs_of(guiding_work_), &worst = guiding.worst();
    const shader::GuidingHeader& header = guiding.header();
    report.teaches = header.stores != 0;
    report.rooms = {{"inner nodes", needs.nodes, worst.nodes, header.node_capacity},
                    {"light samples", needs.samples, worst.samples, header.sample_capacity}};
    if (guiding.guided())
        report.rooms.push_back({"ray samples", needs.rays, worst.rays, header.ray_capacity});
    report.rooms.push_back(
        {"words of caches", needs.cache_words, worst.cache_words, header.vlc_capacity});

    const std::optional<shader::PrimaryHit> hit = hit_under_crosshair();
    if (!hit) return report;
    report.position = hit->position;
    const TreeCopy copy(device_, guiding);
    report.leaf = copy.leaf_at(hit->position, shown_.bucket_size);
    // What moves uses the cache and the quadtree of where it was.
    const shader::Instance& instance = scene_->host_instances()[hit->instance];
    const LeafReport earlier =
        copy.leaf_at(hit->instance == 0 ? hit->position : position_before(instance, hit->position),
                     shown_.bucket_size);
    report.earlier = earlier;
    if (report.quadtrees) {
        report.quadtree = report_cdq(earlier.guide, shown_.guide.size, hit->normal);
        report.quadtree.share = shader::share_of(earlier.guide_share, 1.0f - settings_.pt_cdq_brdf);
    }
    for (const std::vector<uint32_t>& ids : earlier.buckets) {
        std::vector<CachedLight>& bucket = report.buckets.emplace_back();
        for (const uint32_t id : ids)
            bucket.push_back(cached_light(*scene_, id, shown_.dynamic_lights));
        std::ranges::stable_sort(bucket, std::greater{}, &CachedLight::power);
    }
    return report;
}

refresh::Picture VkptRenderer::read_picture(bool with_overlay) {
    if (frame_number_ == 0) fail("no frame has been rendered");
    device_.wait_idle();
    refresh::Picture picture;
    picture.width = static_cast<int>(picture_.width());
    picture.height = static_cast<int>(picture_.height());
    const uint64_t bytes = uint64_t{4} * picture_.width() * picture_.height();
    std::vector<std::byte> pixels;
    if (with_overlay || !scene_) {
        const gpu::Buffer staging(device_, bytes, gpu::MemoryUse::Readback, "picture readback");
        gpu::run_now(device_, [&](VkCommandBuffer commands) {
            VkBufferImageCopy region{};
            region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
            region.imageExtent = {picture_.width(), picture_.height(), 1};
            vkCmdCopyImageToBuffer(commands, picture_.handle(),
                                   VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, staging.handle(), 1,
                                   &region);
        });
        pixels.assign(staging.mapped(), staging.mapped() + bytes);
    } else {
        pixels = gpu::download_now(device_, buffers_.display(), 0, bytes);
    }
    picture.rgba.resize(bytes);
    std::memcpy(picture.rgba.data(), pixels.data(), bytes);
    return picture;
}

refresh::RadiancePicture VkptRenderer::read_radiance() {
    if (frame_number_ == 0 || !scene_) fail("no frame of a level has been rendered");
    device_.wait_idle();
    refresh::RadiancePicture picture;
    picture.width = static_cast<int>(buffers_.size().x);
    picture.height = static_cast<int>(buffers_.size().y);
    picture.frames = static_cast<int>(accumulated_);
    picture.rgb = gpu::download_now_as<float>(device_, buffers_.mean_radiance(), 0,
                                              uint64_t{3} * buffers_.size().x * buffers_.size().y);
    return picture;
}

} // namespace vigil::vkpt
