// SPDX-License-Identifier: GPL-2.0-or-later
// What a demo's effects leave behind for a while: lights that fade, beams, particles. All of it is
// a function of the demo's time, so that it looks the same at every frame rate and each time.
#pragma once

#include "client/play/effect_lights.h"
#include "client/play/played_scene.h"

#include <deque>
#include <random>

namespace vigil::client {

class DemoEffects {
public:
    /// More particles than the game has at once are not kept: the oldest go first.
    static constexpr size_t most_particles = 4096;

    /// An announced effect begins at this time, in seconds.
    void add(const dm2::TempEntity& effect, double time_s);
    /// A weapon fires: at the place and with the angles of who holds it.
    void add(const dm2::MuzzleFlash& flash, const glm::vec3& origin, const glm::vec3& angles,
             double time_s);
    /// What flew from one place to another since the last step leaves a trail there.
    void add_trail(uint32_t effects, const glm::vec3& from, const glm::vec3& to, double time_s);

    /// Adds what there is at a time; what ended before is forgotten.
    void show(double time_s, PlayedScene& scene);

private:
    struct Light {
        uint32_t id;
        glm::vec3 origin;
        EffectLight light;
        double begin_s, end_s;
        bool fades;
    };
    struct Beam {
        refresh::Beam beam;
        double end_s;
    };
    struct Particle {
        glm::vec3 origin, velocity, color;
        double begin_s, end_s;
    };

    float random(); // in [-1, 1)
    glm::vec3 random_direction();
    void add_particles(int count, const glm::vec3& place, const glm::vec3& color, float speed,
                       double time_s);
    void add_line(const glm::vec3& from, const glm::vec3& to, float spacing, const glm::vec3& color,
                  double seconds, double time_s);
    void add_beam(const glm::vec3& from, const glm::vec3& to, float radius, const glm::vec3& color,
                  double seconds, double time_s);

    std::minstd_rand random_{1};
    uint32_t next_id_ = uint32_t{1} << 20; // beyond those of entities
    std::deque<Light> lights_;
    std::deque<Beam> beams_;
    std::deque<Particle> particles_;
};

} // namespace vigil::client
