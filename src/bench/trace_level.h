// SPDX-License-Identifier: GPL-2.0-or-later
// A level as one list of triangles, and the rays a path tracer would shoot in it: primary rays of a
// few cameras, shadow rays to points on surfaces, one diffuse bounce. Not the renderer's scene: no
// materials, no moving parts, so that other ray tracers get exactly the same input.
#pragma once

#include "refresh/vkpt/scene/bvh_builder.h"
#include "shared/bvh.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace vigil::bench {

struct TraceLevel {
    std::string name;
    std::vector<BvhInputTriangle> triangles;
};

/// Static world of maps/NAME.bsp below basedir/baseq2, with the meshes (.glb) that its misc_model
/// entities place. Throws Error.
TraceLevel load_trace_level(const std::filesystem::path& basedir, const std::string& name);

/// `count` triangles of 40 units at random places in a cube of 1000.
TraceLevel random_trace_level(std::size_t count);

enum class RayKind { Primary, Shadow, Bounce };
inline constexpr const char* ray_kind_names[] = {"primary", "shadow", "bounce"};

struct RaySet {
    RayKind kind;
    std::vector<shader::Ray>
        rays; // in the order the renderer's work groups have: tiles of 8 x 8 pixels
};

/// The three sets of four cameras with size x size pixels each (`size` a multiple of 8). The same
/// level and size give the same rays everywhere.
std::vector<RaySet> make_rays(const TraceLevel& level, std::uint32_t size);

} // namespace vigil::bench
