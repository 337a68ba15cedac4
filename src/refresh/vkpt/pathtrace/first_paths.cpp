// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/pathtrace/first_paths.h"

#include "formats/bsp_query.h"
#include "shared/random.h"
#include "shared/sampling.h"

#include <algorithm>
#include <cmath>

namespace vigil::vkpt {

namespace {

constexpr float ray_length = 65536.0f;
/// Map units that a path goes on from above a surface.
constexpr float off_surface = 0.25f;

bool is_sky(const Bsp& bsp, const BspLeaf& leaf) {
    const auto sky = [&](const BspBrushSide& side) {
        return side.texinfo >= 0 &&
               (bsp.texinfos[static_cast<size_t>(side.texinfo)].flags & SURF_SKY) != 0;
    };
    for (uint32_t i = 0; i < leaf.leaf_brush_count; ++i) {
        const BspBrush& brush = bsp.brushes[bsp.leaf_brushes[leaf.first_leaf_brush + i]];
        const auto sides = std::span(bsp.brush_sides).subspan(brush.first_side, brush.side_count);
        if (std::ranges::any_of(sides, sky)) return true;
    }
    return false;
}

} // namespace

std::vector<glm::vec3> first_paths(const Bsp& bsp, const FrameDescription& camera, uint32_t count,
                                   int bounces) {
    std::vector<glm::vec3> places;
    for (uint32_t path = 0; path < count; ++path) {
        // Points of the R2 sequence in the picture.
        const glm::vec2 at = {shader::unit_float((path + 1) * shader::R2_STEPS.x),
                              shader::unit_float((path + 1) * shader::R2_STEPS.y)};
        glm::vec3 from = camera.camera_origin;
        glm::vec3 direction =
            glm::normalize(camera.camera_forward + (2.0f * at.x - 1.0f) * camera.camera_right +
                           (1.0f - 2.0f * at.y) * camera.camera_up);
        shader::Random random = shader::random_begin(glm::uvec2(path, 0), 0, 0);
        for (int bounce = 0; bounce <= bounces; ++bounce) {
            const std::optional<LineHit> hit = first_hit(bsp, from, from + ray_length * direction);
            if (!hit || is_sky(bsp, bsp.leafs[hit->leaf])) break;
            const float length = glm::length(hit->normal);
            if (!(length > 0.0f) || !std::isfinite(glm::dot(hit->point, hit->point))) break;
            places.push_back(hit->point);
            const glm::vec3 normal = hit->normal / length;
            from = hit->point + off_surface * normal;
            direction =
                shader::to_world(shader::make_basis(normal),
                                 shader::sample_cosine_hemisphere(shader::random_next2(random)));
        }
    }
    return places;
}

} // namespace vigil::vkpt
