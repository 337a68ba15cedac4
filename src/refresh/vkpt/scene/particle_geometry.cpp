// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/scene/particle_geometry.h"

namespace vigil::vkpt {

static_assert(refresh::particle_radiance == shader::SHINE_RADIANCE);

namespace {

/// Two directions across the view of a particle: with the third, towards the eye, right-handed.
struct Facing {
    glm::vec3 right, up;
};

Facing facing(const glm::vec3& particle, const glm::vec3& eye) {
    const glm::vec3 away = eye - particle;
    const float distance = glm::length(away);
    const glm::vec3 towards = distance > 1e-3f ? away / distance : glm::vec3(1, 0, 0);
    const glm::vec3 other = std::abs(towards.z) < 0.99f ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
    const glm::vec3 right = glm::normalize(glm::cross(other, towards));
    return {right, glm::cross(towards, right)};
}

} // namespace

ModelGeometry particle_geometry(const refresh::Frame& frame, size_t capacity,
                                MaterialSet& materials) {
    ModelGeometry geometry;
    geometry.triangles.reserve(capacity);
    geometry.primitives.reserve(capacity);
    uint32_t material = 0;
    for (const refresh::Particle& particle : frame.particles) {
        const Facing axes = facing(particle.origin, frame.view.origin);
        const glm::vec3 top = particle.origin + particle.size * axes.up;
        const glm::vec3 foot = particle.origin - 0.5f * particle.size * axes.up;
        const glm::vec3 side = 0.866f * particle.size * axes.right;
        material = materials.particle_material(particle.color);
        geometry.add({top, foot - side, foot + side, coverage_of(particle.alpha)}, material);
    }
    const glm::vec3 nowhere =
        frame.particles.empty() ? glm::vec3(0.0f) : frame.particles.front().origin;
    while (geometry.triangles.size() < capacity)
        geometry.add({nowhere, nowhere, nowhere, 255}, material);
    return geometry;
}

} // namespace vigil::vkpt
