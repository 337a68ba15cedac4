// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/light/cluster_lists.h"

#include "common/log.h"
#include "formats/bsp.h"
#include "refresh/vkpt/scene/light_set.h"

#include <algorithm>
#include <utility>

namespace vigil::vkpt {

namespace {

LightTriangle triangle_of(const shader::Light& light, uint32_t id) {
    return {light.v0, light.v0 + light.e1, light.v0 + light.e2, id};
}

std::vector<LightTriangle> moving_triangles(const LightSet& lights) {
    std::vector<LightTriangle> triangles;
    for (uint32_t id = lights.static_count(); id < lights.lights().size(); ++id) {
        const shader::Light& light = lights.lights()[id];
        if (light.radiance != glm::vec3(0.0f)) triangles.push_back(triangle_of(light, id));
    }
    return triangles;
}

/// A static light that is dark now may be switched on later: it is listed all the same. The sun
/// shines in where a window to the sky faces it.
std::vector<LightTriangle> static_triangles(const LightSet& lights) {
    std::vector<LightTriangle> triangles;
    const uint32_t sun = lights.sun();
    for (uint32_t id = 0; id < lights.static_count(); ++id) {
        const shader::Light& light = lights.lights()[id];
        if (id == sun) continue;
        triangles.push_back(triangle_of(light, id));
        if (lights.sun_enters(light)) triangles.push_back(triangle_of(light, sun));
    }
    // Windows that move may let it in anywhere: a triangle in no cluster, below all of them and
    // facing up, is in every list.
    if (sun != shader::NONE && lights.has_moving_sky()) {
        constexpr float far = 1e6f;
        triangles.push_back({{-far, -far, -far}, {far, -far, -far}, {0.0f, far, -far}, sun});
    }
    return triangles;
}

/// What fits into the device's buffers, which grow by half.
LightListLimits limits_of(const gpu::Device& device) {
    LightListLimits limits;
    const uint64_t buffer_ids = device.features().max_storage_buffer_bytes / sizeof(uint32_t);
    limits.ids = std::min(limits.ids, buffer_ids - buffer_ids / 3);
    return limits;
}

} // namespace

ClusterLists::ClusterLists(const TechniqueContext& context)
    : lister_(context.lister), limits_(limits_of(context.device)) {}

LightLists ClusterLists::build(std::span<const LightTriangle> lights, const char* which,
                               bool& warned) const {
    LightListLimits limits = limits_;
    if (warned) limits.steps = 0; // refused once, and not tried again in every frame
    LightLists lists = lister_.build(lights, limits);
    if (!lists.refused.empty() && !std::exchange(warned, true))
        log_warning(
            "{}: light lists of {} {} lights in {} clusters {}; all clusters share the list "
            "of all lights, and the picture is noisier",
            lister_.bsp().name, lights.size(), which, lister_.cluster_count(), lists.refused);
    return lists;
}

ClusterLists::Changes ClusterLists::prepare(const LightSet& lights) {
    Changes changes;
    if (sun_revision_ != lights.sun_revision()) {
        sun_revision_ = lights.sun_revision();
        still_ = build(static_triangles(lights), "static", still_warned_);
        changes.still = true;
    }
    if (revision_ != lights.moving_revision()) {
        revision_ = lights.moving_revision();
        const std::vector<LightTriangle> triangles = moving_triangles(lights);
        moving_count_ = triangles.size();
        moving_ = build(triangles, "moving", moving_warned_);
        changes.moving = true;
    }
    return changes;
}

} // namespace vigil::vkpt
