// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/light/list_sight.h"

#include "formats/bsp_query.h"
#include "shared/brdf.h"
#include "shared/random.h"
#include "shared/sampling.h"
#include "shared/triangle_light.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <vector>

namespace vigil {

namespace {

constexpr uint32_t place_count = 4096;
/// Lights that a place looks at.
constexpr size_t most_lights = 64;
/// Map units that the ends of a line of sight lie off their surfaces.
constexpr float off_surface = 1.0f;

struct Triangle {
    glm::vec3 v0, e1, e2, normal;
    double area_before; // of all triangles before this one
};

/// The triangles of the static world's faces that are drawn; `area` becomes that of all.
std::vector<Triangle> world_triangles(const Bsp& bsp, double& area) {
    std::vector<Triangle> triangles;
    area = 0.0;
    const BspModel& world = bsp.models.front();
    for (uint32_t f = world.first_face; f < world.first_face + world.face_count; ++f) {
        const BspFace& face = bsp.faces[f];
        if ((bsp.texinfos[face.texinfo].flags & (SURF_SKY | SURF_NODRAW)) != 0) continue;
        const std::vector<glm::vec3> corners = face_polygon(bsp, face);
        const glm::vec3 normal = face_normal(bsp, face);
        for (size_t i = 2; i < corners.size(); ++i) {
            const glm::vec3 e1 = corners[i - 1] - corners[0], e2 = corners[i] - corners[0];
            const double size = 0.5 * static_cast<double>(glm::length(glm::cross(e1, e2)));
            if (!(size > 0.0)) continue;
            triangles.push_back({corners[0], e1, e2, normal, area});
            area += size;
        }
    }
    return triangles;
}

/// The `number`-th point of the R2 sequence in the unit square.
glm::vec2 spread(uint32_t number) {
    return {shader::unit_float(number * shader::R2_STEPS.x),
            shader::unit_float(number * shader::R2_STEPS.y)};
}

} // namespace

double part_in_sight(const Bsp& bsp, const LightLists& lists,
                     std::span<const shader::Light> lights) {
    double area = 0.0;
    const std::vector<Triangle> triangles = world_triangles(bsp, area);
    double lit = 0.0, seen = 0.0;
    uint32_t number = 0; // of the points drawn so far
    for (uint32_t i = 0; i < place_count && !triangles.empty(); ++i) {
        const double at = area * (i + 0.5) / place_count;
        const Triangle& triangle =
            *std::prev(std::ranges::upper_bound(triangles, at, {}, &Triangle::area_before));
        const glm::vec2 weights = shader::sample_triangle(spread(++number));
        const glm::vec3 place = triangle.v0 + weights.x * triangle.e1 + weights.y * triangle.e2 +
                                off_surface * triangle.normal;
        const int32_t cluster = cluster_at(bsp, place);
        if (cluster < 0) continue;
        double all = 0.0, in_sight = 0.0;
        const std::span<const uint32_t> list = lists.list(static_cast<size_t>(cluster));
        const size_t asked = std::min(list.size(), most_lights);
        for (size_t k = 0; k < asked; ++k) {
            size_t place_in_list = k;
            if (asked < list.size()) // one in each of so many parts
                place_in_list = static_cast<size_t>(
                    (static_cast<double>(k) + static_cast<double>(spread(++number).x)) *
                    static_cast<double>(list.size()) / static_cast<double>(asked));
            const shader::Light& light = lights[list[place_in_list]];
            const shader::LightSample sample = shader::sample_light(light, place, spread(++number));
            const double cosine = std::max(glm::dot(triangle.normal, sample.direction), 0.0f);
            const double value = static_cast<double>(shader::luminance(light.radiance)) *
                                 static_cast<double>(sample.geometry) * cosine;
            if (!(value > 0.0)) continue;
            all += value;
            if (is_clear_line(bsp, place, sample.point + off_surface * shader::light_normal(light)))
                in_sight += value;
        }
        if (!(in_sight > 0.0)) continue;
        lit += 1.0;
        seen += in_sight / all;
    }
    return lit > 0.0 ? seen / lit : 1.0;
}

} // namespace vigil
