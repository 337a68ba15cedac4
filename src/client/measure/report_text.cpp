// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/measure/report_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

namespace vigil::client {

namespace {

using refresh::GuidingReport;
using refresh::OctreeLeaf;

/// A table that nobody reads to the end is cut.
constexpr size_t most_buckets_listed = 8, most_lights_listed = 10, most_cells_listed = 8;

double mebibytes(uint64_t bytes) {
    return static_cast<double>(bytes) / 1048576.0;
}

std::string count_text(size_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// The line of each of the first `most` rows, and how many `others` there are.
template <typename Row, typename Line>
std::string table(const std::vector<Row>& rows, size_t most, std::string_view indent,
                  std::string_view others, const Line& line) {
    std::string text;
    for (size_t i = 0; i < std::min(rows.size(), most); ++i)
        text += fmt::format("\n{}{}", indent, line(rows[i], i));
    if (rows.size() > most)
        text += fmt::format("\n{}and {} {}", indent, rows.size() - most, others);
    return text;
}

std::string off_text(const GuidingReport& guiding) {
    return fmt::format("Guiding was off in the last frame: pt_nee {} needs none. `scene` says why.",
                       technique_infos[static_cast<size_t>(guiding.technique)].name);
}

constexpr const char* nothing_there =
    "There is no surface under the crosshair: sky, or the inside of a wall.";

std::string leaf_text(const OctreeLeaf& leaf) {
    const auto name = [](uint32_t number) {
        return number == OctreeLeaf::none ? std::string("-") : std::to_string(number);
    };
    const auto& beyond = leaf.neighbours;
    return fmt::format("leaf {}: path {}, depth {}\n"
                       "  cube            {:.1f} {:.1f} {:.1f} and on, {:.1f} map units wide\n"
                       "  samples         {} in this frame, room for {}, {} dropped\n"
                       "  source          leaf {} of the frame before\n"
                       "  neighbours      -x {}  +x {}  -y {}  +y {}  -z {}  +z {}\n",
                       leaf.leaf, fmt::join(leaf.path, "."), leaf.path.size(), leaf.corner.x,
                       leaf.corner.y, leaf.corner.z, leaf.size, leaf.samples, leaf.room,
                       leaf.dropped(), name(leaf.source), name(beyond[0]), name(beyond[1]),
                       name(beyond[2]), name(beyond[3]), name(beyond[4]), name(beyond[5]));
}

std::string place_text(const GuidingReport& guiding) {
    const glm::vec3 position = *guiding.position;
    return fmt::format("under the crosshair: {:.1f} {:.1f} {:.1f}\n{}", position.x, position.y,
                       position.z,
                       guiding.teaches ? "" : "this frame stored no samples or rays\n") +
           leaf_text(guiding.leaf);
}

std::string light_text(const refresh::CachedLight& light) {
    using Owner = refresh::CachedLight::Owner;
    static constexpr std::array<std::string_view, 4> owners = {
        "static world", "entity", "dynamic light", "of nothing that is there now"};
    std::string text = fmt::format("light {:<6} power {:<10.4g} {}", light.id, light.power,
                                   owners[static_cast<size_t>(light.owner)]);
    if (light.owner == Owner::Entity || light.owner == Owner::DynamicLight)
        text += fmt::format(" {}", light.number);
    return text;
}

} // namespace

std::string scene_text(const refresh::SceneReport& scene, const GuidingReport& guiding,
                       const refresh::Health& health, const refresh::Settings& settings) {
    std::string text = fmt::format(
        "{}: {} triangles, {} materials, {} textures, {} lights ({} of the static world), {} "
        "instances",
        scene.level, scene.triangles, scene.materials, scene.textures, scene.lights,
        scene.static_lights, scene.instances);
    for (const refresh::SceneReport::Feature& feature : scene.features)
        text += fmt::format("\n  {:<16}{:<5}{}{}", feature.name, feature.on ? "on" : "off",
                            feature.count ? fmt::format("{} ", *feature.count) : "", feature.what);
    text += fmt::format("\n  scene memory    {:.1f} MiB", mebibytes(scene.bytes));
    if (scene.ray_query_bytes > 0)
        text += fmt::format(", {:.1f} MiB of it for ray queries", mebibytes(scene.ray_query_bytes));
    if (scene.filter_bytes > 0)
        text += fmt::format("\n  filter memory   {:.1f} MiB", mebibytes(scene.filter_bytes));
    if (!scene.missing_textures.empty())
        text += fmt::format("\n  {} missing textures: {}", scene.missing_textures.size(),
                            fmt::join(scene.missing_textures, " "));
    const TechniqueInfo& technique = technique_infos[static_cast<size_t>(settings.pt_nee)];
    text += fmt::format("\n  ray tracing     {}\n  light sampling  {}: {}",
                        scene.ray_query ? "VK_KHR_ray_query" : "our BVH in compute", technique.name,
                        technique.help);
    if (settings.pt_compare != 0)
        text += fmt::format("\n  compared with   {}",
                            choice_name(compare_choices, settings.pt_compare));
    text += "\n  guiding         off";
    if (guiding.on)
        text.replace(text.size() - 3, 3,
                     fmt::format("octree of {} leaves, depth {}, {} caches, {:.1f} MiB",
                                 guiding.leaves, guiding.depth, guiding.caches,
                                 mebibytes(guiding.bytes)));
    if (health.nonfinite > 0)
        text +=
            fmt::format("\n  {} radiance values were not finite. pt_view nonfinite shows where.",
                        health.nonfinite);
    return text;
}

std::string guiding_text(const GuidingReport& guiding) {
    if (!guiding.on) return off_text(guiding);
    std::string text = "guiding memory, bytes";
    const auto row = [&](std::string_view name, uint64_t bytes) {
        text += fmt::format("\n  {:<22} {:>12}  {:8.2f} MiB", name, bytes, mebibytes(bytes));
    };
    for (const GuidingReport::Amount& part : guiding.memory)
        row(part.name, part.amount);
    row("all", guiding.bytes);
    text +=
        fmt::format("\n  {:<22} {:>12}  {:>12}  {:>12}", "", "in use", "at most yet", "room for");
    for (const GuidingReport::Room& room : guiding.rooms)
        text += fmt::format("\n  {:<22} {:>12}  {:>12}  {:>12}", room.name, room.need, room.worst,
                            room.room);
    return text;
}

std::string light_cache_text(const GuidingReport& guiding) {
    if (!guiding.on) return off_text(guiding);
    if (!guiding.position) return nothing_there;
    std::string text = place_text(guiding);
    if (guiding.earlier.leaf != guiding.leaf.leaf)
        text +=
            "its light cache is that of where it was a frame ago:\n" + leaf_text(guiding.earlier);
    size_t count = 0;
    for (const auto& bucket : guiding.buckets)
        count += bucket.size();
    text += fmt::format("  cache           {} in {}\n"
                        "  {:.0f}% of samples gain from a search for other lights",
                        count_text(count, "light"), count_text(guiding.buckets.size(), "bucket"),
                        100.0f * guiding.earlier.explore_share);
    return text + table(guiding.buckets, most_buckets_listed, "  ", "more buckets",
                        [](const auto& bucket, size_t number) {
                            return fmt::format(
                                "bucket {}: {}{}", number, count_text(bucket.size(), "light"),
                                table(bucket, most_lights_listed, "    ", "weaker ones",
                                      [](const auto& light, size_t) { return light_text(light); }));
                        });
}

std::string quadtree_text(const GuidingReport& guiding) {
    if (!guiding.quadtrees)
        return "No quadtrees guided rays in the last frame. pt_guide cdq makes them.";
    if (!guiding.position) return nothing_there;
    std::string text =
        place_text(guiding) +
        fmt::format("  rays            {} of its node's in this frame, room for {}\n",
                    guiding.leaf.rays, guiding.leaf.ray_room);
    if (guiding.earlier.leaf != guiding.leaf.leaf)
        text += fmt::format("its quadtree is that of leaf {}, where it was a frame ago:\n",
                            guiding.earlier.leaf);
    const refresh::QuadtreeReport& tree = guiding.quadtree;
    text += fmt::format("  guided rays     {:.0f} % of all from here\n"
                        "  quadtree        {} bits, {} leaves, the smallest at level {}\n"
                        "  density         {:.3g} to {:.3g} per steradian\n"
                        "  below horizon   {:.1f} % of its draws\n"
                        "  its densest leaves (yaw from +x, pitch down positive, degrees):",
                        100.0f * tree.share, tree.bits, tree.cells.size(), tree.deepest,
                        tree.cells.back().density, tree.cells.front().density,
                        100.0f * tree.below_horizon);
    return text + table(tree.cells, most_cells_listed, "    ", "less dense ones",
                        [](const auto& cell, size_t) {
                            const glm::vec3& d = cell.direction;
                            return fmt::format("yaw {:7.1f}  pitch {:6.1f}  level {:2}  {:.3g} per "
                                               "steradian",
                                               glm::degrees(std::atan2(d.y, d.x)),
                                               glm::degrees(-std::atan2(d.z, std::hypot(d.x, d.y))),
                                               cell.depth, cell.density);
                        });
}

} // namespace vigil::client
