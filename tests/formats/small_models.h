// SPDX-License-Identifier: GPL-2.0-or-later
// A small MD2 model and a builder for .glb files, for the model tests and the damage test.
#pragma once

#include "byte_writer.h"
#include "formats/sp2.h"

#include <string>
#include <string_view>

namespace vigil {

/// Two frames, four vertices, five texture coordinates, two triangles that share the edge 0-2 but
/// use different texture coordinates at vertex 0. In frame "stand" the square lies in z = 1, x and
/// y in 0..10, clockwise seen from above (so its front is up).
Bytes small_md2();

/// Byte offsets inside small_md2().
inline constexpr size_t md2_triangles_at = 68 + 64 + 5 * 4;
inline constexpr size_t md2_frames_at = md2_triangles_at + 2 * 12;

/// A sprite of these frames.
Bytes write_sp2(std::span<const Sp2Frame> frames);
/// Two frames, of 32 x 24 and of 8 x 8 units.
Bytes small_sp2();

/// A .glb from its JSON text and its binary chunk.
Bytes write_glb(std::string json, const Bytes& binary);

/// One triangle (0,0,0) (1,0,0) (0,1,0) with normals +z, texture coordinates and 16-bit indices,
/// placed by `node` (JSON members of the node, e.g. "\"translation\":[1,2,3],").
Bytes triangle_glb(std::string_view node = "", std::string_view material = "{}");

} // namespace vigil
