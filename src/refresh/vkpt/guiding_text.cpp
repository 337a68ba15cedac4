// SPDX-License-Identifier: GPL-2.0-or-later
// What the renderer says about its guiding: the memory it takes (`guiding`, `scene`), and the leaf
// under the crosshair with the lights of its cache (`vlcinfo`) or with its quadtree (`cdqinfo`).
#include "refresh/vkpt/guiding/cdq_report.h"
#include "refresh/vkpt/guiding/guiding_counts.h"
#include "refresh/vkpt/guiding/leaf_report.h"
#include "refresh/vkpt/light/light_power.h"
#include "refresh/vkpt/renderer.h"

#include "shared/direction_map.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <span>

namespace vigil::vkpt {

namespace {

/// A table that nobody reads to the end is cut.
constexpr size_t most_buckets_listed = 8, most_lights_listed = 10, most_cells_listed = 8;

double mebibytes(uint64_t bytes) {
    return static_cast<double>(bytes) / 1048576.0;
}

std::string count_text(size_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// Ids of the lights of an instance that is not the world: `count` from `first`.
struct LightRange {
    uint32_t first = 0, count = 0;
};

LightRange lights_of_instance(const Scene& scene, size_t index) {
    const Scene::TriangleRange range = scene.instance_triangles(index);
    LightRange lights{scene.host_instances()[index].first_light, 0};
    for (uint32_t i = range.first; i < range.first + range.count; ++i) {
        const uint32_t light = scene.host_primitives()[i].light;
        if (light != shader::NONE) lights.count = std::max(lights.count, light + 1);
    }
    return lights;
}

/// What the light of this id belongs to. The last `dynamic_lights` instances are dynamic lights.
std::string owner_text(const Scene& scene, uint32_t id, size_t dynamic_lights) {
    if (id < scene.lights().static_count()) return "static world";
    const std::vector<shader::Instance>& instances = scene.host_instances();
    for (size_t i = 1; i < instances.size(); ++i) {
        const LightRange range = lights_of_instance(scene, i);
        if (id < range.first || id >= range.first + range.count) continue;
        const bool dynamic = i + dynamic_lights >= instances.size();
        return fmt::format("{} {}", dynamic ? "dynamic light" : "entity", instances[i].entity);
    }
    return "of nothing that is there now";
}

/// One line per light, the strongest first.
std::string lights_text(const Scene& scene, std::vector<uint32_t> ids, size_t dynamic_lights) {
    const std::span<const shader::Light> lights = scene.lights().lights();
    const auto power = [&](uint32_t id) {
        return id < lights.size() ? shader::PI * light_power(lights[id]) : 0.0f;
    };
    std::ranges::stable_sort(ids, std::greater{}, power);
    std::string text;
    for (size_t i = 0; i < std::min(ids.size(), most_lights_listed); ++i)
        text += fmt::format("\n    light {:<6} power {:<10.4g} {}", ids[i], power(ids[i]),
                            owner_text(scene, ids[i], dynamic_lights));
    if (ids.size() > most_lights_listed)
        text += fmt::format("\n    and {} weaker ones", ids.size() - most_lights_listed);
    return text;
}

std::string cache_text(const Scene& scene, const LeafReport& report, size_t dynamic_lights) {
    size_t count = 0;
    for (const std::vector<uint32_t>& bucket : report.buckets)
        count += bucket.size();
    std::string text = fmt::format("  cache           {} in {}", count_text(count, "light"),
                                   count_text(report.buckets.size(), "bucket"));
    text += fmt::format("\n  {:.0f}% of samples would pay off looking for other lights",
                        100.0f * report.explore_share);
    for (size_t i = 0; i < std::min(report.buckets.size(), most_buckets_listed); ++i) {
        const std::vector<uint32_t>& bucket = report.buckets[i];
        text += fmt::format("\n  bucket {}: {}", i, count_text(bucket.size(), "light"));
        text += lights_text(scene, bucket, dynamic_lights);
    }
    if (report.buckets.size() > most_buckets_listed)
        text += fmt::format("\n  and {} more buckets", report.buckets.size() - most_buckets_listed);
    return text;
}

/// Where a point of an instance was in the frame before.
glm::vec3 position_before(const shader::Instance& instance, glm::vec3 position) {
    const glm::vec3 local = instance.object_from_world * glm::vec4(position, 1.0f);
    return instance.previous_world_from_object * glm::vec4(local, 1.0f);
}

/// The leaf that a surface's samples go to, and the one it learns from: where it was a frame ago.
struct SurfaceReports {
    LeafReport now, before;
};

SurfaceReports leaves_of(const shader::PrimaryHit& hit, const Scene& scene, const TreeCopy& tree,
                         uint32_t bucket_size) {
    const glm::vec3 earlier = position_before(scene.host_instances()[hit.instance], hit.position);
    return {tree.leaf_at(hit.position, bucket_size),
            tree.leaf_at(hit.instance == 0 ? hit.position : earlier, bucket_size)};
}

std::string place_text(const shader::PrimaryHit& hit) {
    return fmt::format("under the crosshair: {:.1f} {:.1f} {:.1f}\n", hit.position.x,
                       hit.position.y, hit.position.z);
}

constexpr const char* nothing_there =
    "nothing under the crosshair that light could fall on (sky, or the inside of a wall)";

} // namespace

std::optional<shader::PrimaryHit> VkptRenderer::hit_under_crosshair() const {
    device_.wait_idle();
    const glm::uvec2 size = buffers_.size(), pixel = shader::crosshair_pixel(size);
    const shader::PrimaryHit hit = gpu::download_now_as<shader::PrimaryHit>(
        device_, buffers_.primary_hits(), uint64_t{pixel.y} * size.x + pixel.x, 1)[0];
    if (hit.primitive == shader::NONE) return std::nullopt;
    return hit;
}

std::string VkptRenderer::guiding_off_text() const {
    if (!scene_) return "no level is loaded";
    if (shown_.guided) return {};
    return fmt::format("guiding was off in the last frame: pt_nee {} learns nothing",
                       technique_infos[static_cast<size_t>(shown_side().id())].name);
}

std::string VkptRenderer::describe_guiding() const {
    if (std::string off = guiding_off_text(); !off.empty()) return off;
    const Guiding::Tree& tree = shown_side().guiding().tree();
    // There are two trees, the one before and the one of the frame.
    const uint64_t trees = 2 * (tree.nodes.bytes() + tree.cells.bytes() + tree.leaves.bytes());
    const uint64_t samples = shown_side().guiding().samples().bytes(),
                   caches = 2 * tree.caches.bytes();
    const uint64_t total = shown_side().guiding().memory_bytes();
    std::string text = "guiding memory, bytes";
    const auto row = [&](std::string_view name, uint64_t bytes) {
        text += fmt::format("\n  {:<22} {:>12}  {:8.2f} MiB", name, bytes, mebibytes(bytes));
    };
    row("octree nodes, twice", 2 * tree.nodes.bytes());
    row("octree cells, twice", 2 * tree.cells.bytes());
    row("octree leaves, twice", 2 * tree.leaves.bytes());
    row("light samples", samples);
    row("light caches, twice", caches);
    row("rays, plan and lists", total - trees - samples - caches);
    row("all", total);
    const shader::GuidingHeader& header = shown_side().guiding().header();
    text += fmt::format("\n  room for {} inner nodes, {} light samples, {} light ids in caches",
                        header.node_capacity, header.sample_capacity, header.vlc_capacity);
    return text;
}

std::string VkptRenderer::guiding_line() const {
    if (!shown_.guided) return "off";
    return fmt::format("octree of {} leaves, depth {}; {} caches; {:.1f} MiB",
                       octree_leaf_count(guiding_work_.nodes), guiding_work_.depth,
                       guiding_work_.cached_leaves,
                       mebibytes(shown_side().guiding().memory_bytes()));
}

std::string VkptRenderer::describe_leaf() const {
    if (std::string off = guiding_off_text(); !off.empty()) return off;
    const std::optional<shader::PrimaryHit> hit = hit_under_crosshair();
    if (!hit) return nothing_there;
    const auto [now, before] =
        leaves_of(*hit, *scene_, TreeCopy(device_, shown_side().guiding()), shown_.bucket_size);
    std::string text = place_text(*hit) + leaf_text(now) + "\n";
    // What moves uses the cache of where it was.
    if (before.leaf != now.leaf)
        text += "its light cache is that of where it was a frame ago:\n" + leaf_text(before) + "\n";
    return text + cache_text(*scene_, before, shown_.dynamic_lights);
}

std::string VkptRenderer::describe_directions() const {
    if (!scene_) return "no level is loaded";
    if (shown_.guide.guide != Guide::cdq)
        return "no quadtrees of directions guided rays in the last frame: pt_guide cdq makes them";
    const std::optional<shader::PrimaryHit> hit = hit_under_crosshair();
    if (!hit) return nothing_there;
    const auto [now, before] =
        leaves_of(*hit, *scene_, TreeCopy(device_, shown_side().guiding()), shown_.bucket_size);
    std::string text = place_text(*hit) + leaf_text(now) + "\n";
    text += fmt::format("  rays            {} brought light in this frame, room for {}\n", now.rays,
                        now.room);
    // What moves uses the quadtree of where it was.
    if (before.leaf != now.leaf)
        text += fmt::format("its quadtree is that of leaf {}, where it was a frame ago:\n",
                            before.leaf);
    return text +
           cdq_text(report_cdq(before.guide, shown_.guide.size, hit->normal), most_cells_listed);
}

} // namespace vigil::vkpt
