// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/scene/subdivide.h"

namespace vigil::vkpt {

namespace {

template <typename T> T middle(const T& a, const T& b) {
    return 0.5f * (a + b);
}

void subdivide_once(ModelGeometry& geometry) {
    std::vector<BvhInputTriangle> triangles;
    std::vector<shader::Primitive> primitives;
    const auto add = [&](BvhInputTriangle triangle, shader::Primitive primitive) {
        triangles.push_back(triangle);
        primitives.push_back(primitive);
    };
    for (std::size_t i = 0; i < geometry.triangles.size(); ++i) {
        const BvhInputTriangle& t = geometry.triangles[i];
        const shader::Primitive& p = geometry.primitives[i];
        if (p.light != shader::NONE) {
            add(t, p);
            continue;
        }
        const glm::vec3 v01 = middle(t.v0, t.v1), v12 = middle(t.v1, t.v2),
                        v20 = middle(t.v2, t.v0);
        const glm::vec2 uv01 = middle(p.uv0, p.uv1), uv12 = middle(p.uv1, p.uv2),
                        uv20 = middle(p.uv2, p.uv0);
        const auto part = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                              const glm::vec2& uva, const glm::vec2& uvb, const glm::vec2& uvc) {
            BvhInputTriangle triangle = t;
            shader::Primitive primitive = p;
            triangle.v0 = a, triangle.v1 = b, triangle.v2 = c;
            primitive.uv0 = uva, primitive.uv1 = uvb, primitive.uv2 = uvc;
            add(triangle, primitive);
        };
        part(t.v0, v01, v20, p.uv0, uv01, uv20);
        part(v01, t.v1, v12, uv01, p.uv1, uv12);
        part(v20, v12, t.v2, uv20, uv12, p.uv2);
        part(v01, v12, v20, uv01, uv12, uv20);
    }
    geometry.triangles = std::move(triangles);
    geometry.primitives = std::move(primitives);
}

} // namespace

void subdivide(ModelGeometry& geometry, int times) {
    for (int i = 0; i < times; ++i)
        subdivide_once(geometry);
}

} // namespace vigil::vkpt
