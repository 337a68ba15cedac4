// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/demo/effects.h"

#include "client/play/camera.h"
#include "formats/dm2_protocol.h"

#include <algorithm>

namespace vigil::client {

namespace {

constexpr float particle_gravity = -40.0f; // map units per second squared, as in the game
constexpr float particle_size = 1.0f;
constexpr float longest_step = 512.0f; // of a trail; farther is a jump
constexpr float most_per_line = 400.0f;

struct Trail {
    uint32_t effects;
    uint8_t color; // of the palette
    float spacing; // map units
    double seconds;
};

constexpr Trail trails[] = {
    {dm2::EF_ROCKET, 0xe0, 8.0f, 0.6},
    {dm2::EF_BLASTER, 0xe0, 5.0f, 0.3},
    {dm2::EF_GIB, 0xe8, 10.0f, 0.7},
    {dm2::EF_GRENADE, 4, 10.0f, 0.7},
    {dm2::EF_GREENGIB, 0xdf, 10.0f, 0.7},
    {dm2::EF_FLAG1, 0xf2, 5.0f, 0.8},
    {dm2::EF_FLAG2, 0xf3, 5.0f, 0.8},
    {dm2::EF_IONRIPPER, 0xe4, 5.0f, 0.5},
    {dm2::EF_BLUEHYPERBLASTER, 0xb0, 5.0f, 0.3},
};

} // namespace

float DemoEffects::random() {
    const auto range = static_cast<float>(std::minstd_rand::max() - std::minstd_rand::min());
    return 2.0f * static_cast<float>(random_() - std::minstd_rand::min()) / range - 1.0f;
}

glm::vec3 DemoEffects::random_direction() {
    for (;;) {
        const float x = random(), y = random(), z = random();
        const glm::vec3 direction(x, y, z);
        const float length = glm::length(direction);
        if (length > 0.1f && length <= 1.0f) return direction / length;
    }
}

void DemoEffects::add_particles(int count, const glm::vec3& place, const glm::vec3& color,
                                float speed, double time_s) {
    for (int i = 0; i < count; ++i) {
        const glm::vec3 direction = random_direction();
        const float share = 0.5f + 0.5f * random();
        particles_.push_back({place + 4.0f * direction, speed * share * direction, color, time_s,
                              time_s + 0.5 + 0.3 * static_cast<double>(share)});
    }
    while (particles_.size() > most_particles)
        particles_.pop_front();
}

void DemoEffects::add_line(const glm::vec3& from, const glm::vec3& to, float spacing,
                           const glm::vec3& color, double seconds, double time_s) {
    const float length = glm::distance(from, to);
    if (length == 0.0f) return;
    const int count = static_cast<int>(std::min(length / spacing, most_per_line)) + 1;
    for (int i = 0; i < count; ++i) {
        const float part = (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
        const glm::vec3 place = glm::mix(from, to, part) + random_direction();
        const glm::vec3 drift = 5.0f * random_direction();
        particles_.push_back({place, drift - glm::vec3(0.0f, 0.0f, 0.5f * particle_gravity), color,
                              time_s,
                              time_s + seconds * (0.75 + 0.25 * static_cast<double>(random()))});
    }
    while (particles_.size() > most_particles)
        particles_.pop_front();
}

void DemoEffects::add_beam(const glm::vec3& from, const glm::vec3& to, float radius,
                           const glm::vec3& color, double seconds, double time_s) {
    beams_.push_back(
        {{next_id_++, from, to, radius, refresh::particle_radiance * color}, time_s + seconds});
}

void DemoEffects::add(const dm2::TempEntity& effect, double time_s) {
    switch (effect.type) {
    case dm2::TE_RAILTRAIL:
    case dm2::TE_RAILTRAIL2:
        add_line(effect.place, effect.end, 4.0f, palette_color(0x74), 1.0, time_s);
        break;
    case dm2::TE_BUBBLETRAIL:
    case dm2::TE_BUBBLETRAIL2:
        add_line(effect.place, effect.end, 32.0f, palette_color(4), 1.0, time_s);
        break;
    case dm2::TE_DEBUGTRAIL:
        add_line(effect.place, effect.end, 8.0f, palette_color(0x74), 2.0, time_s);
        break;
    case dm2::TE_FORCEWALL:
        add_line(effect.place, effect.end, 4.0f, palette_color(effect.color), 3.0, time_s);
        break;
    case dm2::TE_BFG_LASER:
        add_beam(effect.place, effect.end, 2.0f, laser_color(0xd0d1d2d3), 0.1, time_s);
        break;
    case dm2::TE_LIGHTNING:
        add_beam(effect.place, effect.end, 1.0f, {0.6f, 0.7f, 1.0f}, 0.2, time_s);
        break;
    case dm2::TE_HEATBEAM:
    case dm2::TE_MONSTER_HEATBEAM:
        add_beam(effect.place, effect.end, 1.0f, palette_color(0xe0), 0.2, time_s);
        break;
    default:
        break;
    }
    const Burst burst = burst_of(effect);
    if (burst.light.radius > 0.0f)
        lights_.push_back({next_id_++, effect.place, burst.light, time_s,
                           time_s + static_cast<double>(burst.seconds), true});
    add_particles(burst.particles, effect.place, burst.particle_color, burst.particle_speed,
                  time_s);
}

void DemoEffects::add(const dm2::MuzzleFlash& flash, const glm::vec3& origin,
                      const glm::vec3& angles, double time_s) {
    const Flash result = muzzle_flash(flash);
    if (result.light.radius <= 0.0f) return;
    const ViewAxes axes = view_axes(angles);
    // As the game: before and beside whoever fires. A monster's muzzles are known to its game only.
    const glm::vec3 place = origin + 18.0f * axes.forward + 16.0f * axes.right;
    lights_.push_back({next_id_++, place, result.light, time_s,
                       time_s + static_cast<double>(result.seconds), false});
}

void DemoEffects::add_trail(uint32_t effects, const glm::vec3& from, const glm::vec3& to,
                            double time_s) {
    if (glm::distance(from, to) > longest_step) return;
    for (const Trail& trail : trails) {
        if ((effects & trail.effects) == 0) continue;
        add_line(from, to, trail.spacing, palette_color(trail.color), trail.seconds, time_s);
        return;
    }
}

void DemoEffects::show(double time_s, PlayedScene& scene) {
    // What lasts a tenth of a second is still there at the end of the frame that announced it,
    // which is all that a timedemo shows.
    const auto ended = [time_s](const auto& effect) { return effect.end_s < time_s - 1e-6; };
    std::erase_if(lights_, ended);
    std::erase_if(beams_, ended);
    std::erase_if(particles_, ended);
    for (const Light& effect : lights_) {
        EffectLight light = effect.light;
        if (effect.fades)
            light.radius *= static_cast<float>(
                std::max(0.0, (effect.end_s - time_s) / (effect.end_s - effect.begin_s)));
        if (light.radius >= 1.0f)
            scene.dynamic_lights.push_back(dynamic_light(effect.id, effect.origin, light));
    }
    for (const Beam& effect : beams_)
        scene.beams.push_back(effect.beam);
    for (const Particle& particle : particles_) {
        const auto age = static_cast<float>(time_s - particle.begin_s);
        const auto left = static_cast<float>(
            std::max(0.0, (particle.end_s - time_s) / (particle.end_s - particle.begin_s)));
        const glm::vec3 fall(0.0f, 0.0f, 0.5f * particle_gravity * age * age);
        scene.particles.push_back({particle.origin + age * particle.velocity + fall,
                                   particle_size * (0.3f + 0.7f * left), particle.color});
    }
}

} // namespace vigil::client
