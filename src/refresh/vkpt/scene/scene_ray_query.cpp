// SPDX-License-Identifier: GPL-2.0-or-later
// The scene's side of ray queries: tells acceleration_structure.h what its models are. Nothing here
// runs, or takes memory on the device, while rays go through our BVH in compute.
#include "refresh/vkpt/scene/scene.h"

namespace vigil::vkpt {

bool Scene::prepare_ray_query(bool on) {
    if (!on) {
        if (ray_query_) device_.wait_idle();
        ray_query_.reset();
        return false;
    }
    if (!ray_query_) ray_query_.emplace(device_);
    std::vector<QueryModel> models;
    models.reserve(placed_.size());
    for (const Placed& placed : placed_) {
        models.push_back(
            {std::span(corners_).subspan(3 * size_t{placed.first_triangle},
                                         3 * size_t{placed.triangle_count}),
             std::span(triangles_).subspan(placed.first_triangle, placed.triangle_count),
             placed.first_triangle, placed.revision, placed.deforms});
    }
    return ray_query_->prepare(models, instance_placed_, instances_);
}

} // namespace vigil::vkpt
