// SPDX-License-Identifier: GPL-2.0-or-later
// Questions about one face or one point of a checked level: polygon, plane, texture coordinates,
// leaf, animation. It does no collision and no visibility (level/, game/).
#pragma once

#include "formats/bsp.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace vigil {

/// Corners of a face in map units, counter-clockwise seen from the side it faces (its normal by the
/// right-hand rule is face_normal). For brush models: relative to the model's entity origin.
std::vector<glm::vec3> face_polygon(const Bsp& bsp, const BspFace& face);

/// The unit normal on the visible side of the face.
glm::vec3 face_normal(const Bsp& bsp, const BspFace& face);

/// Texture coordinates in texels (s right, t down); divide by the texture's size for 0..1.
glm::vec2 texel_coordinates(const BspTexInfo& info, const glm::vec3& point);

/// Index of the leaf that contains a point, in the tree that starts at `headnode` (by default the
/// world's). Points on a plane belong to its front.
uint32_t leaf_at(const Bsp& bsp, const glm::vec3& point);
uint32_t leaf_at(const Bsp& bsp, const glm::vec3& point, int32_t headnode);

/// Cluster of the world's leaf at a point, -1 in solid space and outside.
int32_t cluster_at(const Bsp& bsp, const glm::vec3& point);

/// Where a line comes to something solid.
struct LineHit {
    glm::vec3 point;
    glm::vec3 normal;  // against the line, not of unit length; 0 where the line begins within
    uint32_t leaf = 0; // that is solid
};

/// Where the line from one point to another first meets something solid of the world's tree. Brush
/// models are not in it.
std::optional<LineHit> first_hit(const Bsp& bsp, const glm::vec3& from, const glm::vec3& to);

/// Whether there is no such hit.
bool is_clear_line(const Bsp& bsp, const glm::vec3& from, const glm::vec3& to);

/// Texinfos of the animation that starts at `texinfo`: itself first, then along `next` until the
/// chain ends or closes (parse_bsp refuses longer ones than bsp_max_animation). A length of 1 means
/// no animation. Quake II shows two frames per second.
std::vector<uint32_t> animation_chain(const Bsp& bsp, uint32_t texinfo);

} // namespace vigil
