// SPDX-License-Identifier: GPL-2.0-or-later
// One model as triangles: the static world, a brush model, a mesh, or a pose of an MD2. Pure data
// between the loaders and the scene; object space, original triangle order.
#pragma once

#include "refresh/vkpt/scene/bvh_builder.h"
#include "shared/scene_types.h"

#include <cmath>
#include <vector>

namespace vigil::vkpt {

/// Opacity 0..1 as coverage 0..255; what lies outside, or is no number, is brought inside.
inline uint32_t coverage_of(float alpha) {
    return alpha > 0.0f ? static_cast<uint32_t>(std::lround(255.0f * glm::min(alpha, 1.0f))) : 0;
}

/// An emissive triangle of a model, in object space.
struct LightSource {
    glm::vec3 v0{0.0f}, v1{0.0f}, v2{0.0f};
    glm::vec3 radiance{0.0f}; // at light style value 1 and pt_emissive_scale 1
    float coverage = 1.0f;    // below 1 for translucent lamps, and where a window is not all sky
    int style = 0;            // light style that dims it
    uint32_t flags = 0;       // shader::LIGHT_*
};

struct ModelGeometry {
    std::vector<BvhInputTriangle> triangles;
    std::vector<shader::Primitive> primitives; // one per triangle; light indexes `lights`
    std::vector<LightSource> lights;

    /// Adds a triangle that does not shine, in no cluster, without texture coordinates; what is
    /// returned can be filled in until the next one is added.
    shader::Primitive& add(const BvhInputTriangle& triangle, uint32_t material) {
        triangles.push_back(triangle);
        shader::Primitive& primitive = primitives.emplace_back();
        primitive.material = material;
        primitive.light = primitive.cluster = shader::NONE;
        return primitive;
    }
    /// Makes the triangle that was added last a light.
    void shine(const glm::vec3& radiance, int style = 0) {
        const BvhInputTriangle& t = triangles.back();
        primitives.back().light = static_cast<uint32_t>(lights.size());
        lights.push_back(
            {t.v0, t.v1, t.v2, radiance, static_cast<float>(t.coverage) / 255.0f, style, 0});
    }
};

} // namespace vigil::vkpt
