// SPDX-License-Identifier: GPL-2.0-or-later
// Where what a pixel shows was a frame ago: camera and models have moved since. Meshes whose poses change count as rigid.
#ifndef VIGIL_FILTER_MOTION_GLSL
#define VIGIL_FILTER_MOTION_GLSL

#include "filter/filter.glsl"
#include "scene/scene.glsl"

/// From the camera of the frame before to where a point of an instance was then.
vec3 offset_before(vec3 position, uint instance) { return previous_position(position, instance) - frame.last_camera_origin; }

vec3 normal_before(vec3 normal, uint instance) {
    if (instance == 0u) return normal;
    const Instance moved = load_instance(instance);
    return normalize(mat3(moved.previous_world_from_object) * (mat3(moved.object_from_world) * normal));
}

/// What a pixel shows in this frame, in the picture of the frame before (project_last); sky is infinitely far away.
bool place_before(ivec2 pixel, out vec2 place) {
    const PrimaryHit hit = load_primary_hit(pixel_index(pixel));
    if (hit.primitive == NONE) return project_last(camera_ray(vec2(pixel) + turn.pixel_point), place);
    return project_last(offset_before(hit.position, hit.instance), place);
}

#endif
