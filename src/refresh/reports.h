// SPDX-License-Identifier: GPL-2.0-or-later
// What a renderer tells of itself, as numbers: how it traces a level, and what its guiding knows
// where the crosshair looks. Whoever shows them makes the text (ours:
// client/measure/report_text.h).
#pragma once

#include "shared/techniques.h"

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace vigil::refresh {

struct SceneReport {
    /// A part of the path tracer that runs only where the scene has `what` it is for.
    struct Feature {
        std::string name;
        bool on = false;
        std::string what;
        std::optional<uint64_t> count{}; ///< of `what`, where it is counted
    };

    std::string level;
    std::vector<Feature> features;
    uint64_t triangles = 0, materials = 0, textures = 0, instances = 0;
    uint64_t lights = 0, static_lights = 0; ///< emissive triangles; those of the static world
    std::vector<std::string> missing_textures;
    uint64_t bytes = 0;           ///< on the device
    uint64_t ray_query_bytes = 0; ///< of these; 0 without acceleration structures
    uint64_t filter_bytes = 0;    ///< besides these, of the filter; 0 while it is off
    bool ray_query = false;       ///< rays are traced by the device's ray queries
};

/// A leaf of the octree, in the frame that was rendered last.
struct OctreeLeaf {
    static constexpr uint32_t none = ~0u;

    uint32_t leaf = 0;          ///< its number
    std::vector<uint32_t> path; ///< child numbers from the root down; as many as the leaf is deep
    glm::vec3 corner{0.0f};     ///< lowest corner of its cube, map units
    float size = 0.0f;          ///< edge of its cube, map units
    uint32_t samples = 0;       ///< surface samples
    uint32_t room = 0;          ///< light samples that fit
    uint32_t rays = 0;          ///< of all leaves of its node: those that brought light
    uint32_t ray_room = 0;      ///< ray samples of these leaves that fit
    float explore_share = 0.0f; ///< of light samples that its finds ask to search lists; 0 .. 0.9
    uint32_t source = none;     ///< leaf of the tree before, from which its cache came
    std::array<uint32_t, 6> neighbours{}; ///< beyond -x +x -y +y -z +z; none outside the root

    /// Samples that the leaf had no room for.
    uint32_t dropped() const { return samples > room ? samples - room : 0; }
};

/// A light of a cache.
struct CachedLight {
    enum class Owner { World, Entity, DynamicLight, Gone };
    uint32_t id = 0;
    float power = 0.0f; ///< pi times area times luminance
    Owner owner = Owner::World;
    uint32_t number = 0; ///< of the entity or dynamic light
};

/// A quadtree of directions.
struct QuadtreeReport {
    /// A leaf's square on the octahedral map.
    struct Cell {
        glm::vec3 direction{0.0f}; ///< of its centre, unit
        uint32_t depth = 0;
        float density = 0.0f; ///< of draws there, per steradian
    };
    uint32_t bits = 0;
    uint32_t deepest = 0;
    std::vector<Cell> cells;    ///< one per leaf; the densest first
    float below_horizon = 0.0f; ///< share of draws that a surface loses below its horizon
    float share = 0.0f;         ///< of rays that it draws
};

/// Guiding in the last frame. While pt_compare splits the picture: of the side that the crosshair
/// looked at.
struct GuidingReport {
    struct Amount {
        std::string name;
        uint64_t amount = 0;
    };
    /// Of what a buffer holds.
    struct Room {
        std::string name;
        uint64_t need = 0;  ///< in the last frame
        uint64_t worst = 0; ///< the most since the buffer was made
        uint64_t room = 0;  ///< how many fit
    };

    Technique technique = Technique::sll; ///< that the frame used
    bool on = false;                      ///< the octree was kept; else the rest is empty
    bool quadtrees = false;               ///< and quadtrees of directions guided rays
    uint32_t leaves = 0, depth = 0;       ///< of the octree
    uint32_t caches = 0;                  ///< leaves with lights
    bool teaches = true;                  ///< the frame stored samples; else there are none
    std::vector<Amount> memory;           ///< bytes on the device, by what they hold
    uint64_t bytes = 0;                   ///< all of them
    std::vector<Room> rooms;

    /// The surface under the crosshair; empty where light can fall on nothing (sky, or the inside
    /// of a wall). The rest is about it.
    std::optional<glm::vec3> position;
    OctreeLeaf leaf;    ///< that its samples go to
    OctreeLeaf earlier; ///< where it was a frame ago: its cache and quadtree are of that leaf
    std::vector<std::vector<CachedLight>> buckets; ///< of the cache; the strongest lights first
    QuadtreeReport quadtree;                       ///< empty without quadtrees
};

} // namespace vigil::refresh
