// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/trace_level.h"

#include "bench/host_tracer.h"
#include "common/error.h"
#include "common/file_system.h"
#include "formats/bsp.h"
#include "formats/bsp_query.h"
#include "formats/mesh.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace vigil::bench {

namespace {

class Random {
public:
    float next() { return static_cast<float>(engine_() >> 8) * 0x1p-24f; }
    std::size_t below(std::size_t count) { return engine_() % count; }
    glm::vec3 direction() {
        const float z = 2.0f * next() - 1.0f;
        const float phi = 6.2831853f * next();
        const float r = std::sqrt(std::max(0.0f, 1.0f - z * z));
        return {r * std::cos(phi), r * std::sin(phi), z};
    }
    glm::vec3 in_cube() {
        const float x = next() - 0.5f;
        const float y = next() - 0.5f;
        return {x, y, next() - 0.5f};
    }

private:
    std::mt19937 engine_{7};
};

void add_polygon(const std::vector<glm::vec3>& corners, std::vector<BvhInputTriangle>& triangles) {
    for (std::size_t i = 2; i < corners.size(); ++i)
        triangles.push_back({corners[0], corners[i - 1], corners[i], 255});
}

void add_mesh(const Mesh& mesh, const Entity& entity, std::vector<BvhInputTriangle>& triangles) {
    const float yaw = glm::radians(entity.get_float("angle"));
    const glm::vec3 x(std::cos(yaw), std::sin(yaw), 0.0f);
    const glm::vec3 y(-std::sin(yaw), std::cos(yaw), 0.0f);
    const auto place = [&](const glm::vec3& p) {
        return entity.get_vec3("origin") + p.x * x + p.y * y + glm::vec3(0.0f, 0.0f, p.z);
    };
    for (const MeshPrimitive& part : mesh.primitives) {
        for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3) {
            triangles.push_back({place(part.positions[part.indices[i]]),
                                 place(part.positions[part.indices[i + 1]]),
                                 place(part.positions[part.indices[i + 2]]), 255});
        }
    }
}

glm::vec3 normal_of(const BvhInputTriangle& triangle) {
    return glm::cross(triangle.v1 - triangle.v0, triangle.v2 - triangle.v0);
}

struct Camera {
    glm::vec3 origin;
    glm::vec3 forward;
};

/// Random places from which surfaces are seen all around, none very near and none from behind,
/// looking towards the longest way. The demands are lowered until four are found.
std::vector<Camera> find_cameras(const TraceLevel& level, const HostTracer& tracer,
                                 Random& random) {
    constexpr int probes = 48;
    std::vector<Camera> cameras;
    const Bounds& bounds = tracer.bvh().bounds;
    for (int attempt = 0; cameras.size() < 4; ++attempt) {
        const float ease = 1.0f / (1.0f + static_cast<float>(attempt / 4000));
        const glm::vec3 origin = bounds.center() + bounds.extent() * random.in_cube();
        Camera camera{origin, glm::vec3(1.0f, 0.0f, 0.0f)};
        float longest = 0.0f;
        int wrong = 0; // escapes, near surfaces and back sides
        for (int i = 0; i < probes; ++i) {
            const glm::vec3 direction = random.direction();
            const shader::Hit hit = tracer.closest({origin, 0.0f, direction, 1e30f});
            if (hit.primitive == shader::NONE || hit.t < 16.0f * ease ||
                glm::dot(normal_of(level.triangles[hit.primitive]), direction) > 0.0f) {
                wrong += 1;
            } else if (hit.t > longest && std::abs(direction.z) < 0.3f) {
                longest = hit.t;
                camera.forward = direction;
            }
        }
        const float allowed = 0.1f + static_cast<float>(attempt) / 20000.0f;
        if (static_cast<float>(wrong) > allowed * probes || longest < 200.0f * ease) continue;
        cameras.push_back(camera);
    }
    return cameras;
}

/// One primary ray per pixel, 90 degrees wide, tile by tile.
void add_primary_rays(const Camera& camera, std::uint32_t size, Random& random,
                      std::vector<shader::Ray>& rays) {
    const glm::vec3 right = glm::normalize(glm::cross(camera.forward, glm::vec3(0, 0, 1)));
    const glm::vec3 up = glm::cross(right, camera.forward);
    const auto scale = 2.0f / static_cast<float>(size);
    const std::uint32_t tiles = size / 8;
    for (std::uint32_t i = 0; i < size * size; ++i) {
        const std::uint32_t tile = i / 64;
        const float x = static_cast<float>(tile % tiles * 8 + i % 8) + random.next();
        const float y = static_cast<float>(tile / tiles * 8 + i % 64 / 8) + random.next();
        const glm::vec3 direction =
            glm::normalize(camera.forward + (x * scale - 1.0f) * right - (y * scale - 1.0f) * up);
        rays.push_back({camera.origin, 0.0f, direction, 1e30f});
    }
}

} // namespace

TraceLevel load_trace_level(const std::filesystem::path& basedir, const std::string& name) {
    FileSystem files;
    files.mount_game(basedir, "baseq2");
    const std::string path = "maps/" + name + ".bsp";
    const Bsp bsp = parse_bsp(path, files.read(path));
    TraceLevel level;
    level.name = name;
    const BspModel& world = bsp.models[0];
    for (std::uint32_t f = world.first_face; f < world.first_face + world.face_count; ++f) {
        const std::uint32_t flags = bsp.texinfos[bsp.faces[f].texinfo].flags;
        if ((flags & (SURF_NODRAW | SURF_HINT | SURF_SKIP)) == 0)
            add_polygon(face_polygon(bsp, bsp.faces[f]), level.triangles);
    }
    for (const Entity& entity : bsp.entities) {
        const std::string model = entity.get_string("model");
        if (entity.classname() == "misc_model" && model.ends_with(".glb"))
            add_mesh(parse_glb(model, files.read(model)), entity, level.triangles);
    }
    if (level.triangles.empty()) fail("{}: no triangles to trace", path);
    return level;
}

TraceLevel random_trace_level(std::size_t count) {
    TraceLevel level;
    level.name = "random";
    Random random;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 center = 1000.0f * random.in_cube();
        const glm::vec3 v0 = center + 40.0f * random.in_cube();
        const glm::vec3 v1 = center + 40.0f * random.in_cube();
        level.triangles.push_back({v0, v1, center + 40.0f * random.in_cube(), 255});
    }
    return level;
}

std::vector<RaySet> make_rays(const TraceLevel& level, std::uint32_t size) {
    const HostTracer tracer(level.triangles);
    Random random;
    std::vector<RaySet> sets = {
        {RayKind::Primary, {}}, {RayKind::Shadow, {}}, {RayKind::Bounce, {}}};
    for (const Camera& camera : find_cameras(level, tracer, random)) {
        std::vector<shader::Ray> primary;
        add_primary_rays(camera, size, random, primary);
        // Surfaces seen: where the next rays start, and, some of them, what shadow rays aim at.
        struct Seen {
            glm::vec3 position;
            glm::vec3 normal;
        };
        std::vector<Seen> seen;
        for (const shader::Ray& ray : primary) {
            const shader::Hit hit = tracer.closest(ray);
            if (hit.primitive == shader::NONE) continue;
            glm::vec3 normal = glm::normalize(normal_of(level.triangles[hit.primitive]));
            if (!(glm::length(normal) > 0.5f)) continue; // a triangle without area
            if (glm::dot(normal, ray.direction) > 0.0f) normal = -normal;
            seen.push_back({ray.origin + hit.t * ray.direction + 0.05f * normal, normal});
        }
        std::vector<glm::vec3> lights;
        for (int i = 0; i < 16 && !seen.empty(); ++i)
            lights.push_back(seen[random.below(seen.size())].position);
        for (const Seen& point : seen) {
            const glm::vec3 light = lights[random.below(lights.size())] + 8.0f * random.in_cube();
            sets[1].rays.push_back({point.position, 0.0f, light - point.position, 0.999f});
            glm::vec3 direction = point.normal + random.direction(); // cosine-distributed
            if (glm::length(direction) < 1e-3f) direction = point.normal;
            sets[2].rays.push_back({point.position, 0.0f, glm::normalize(direction), 1e30f});
        }
        sets[0].rays.insert(sets[0].rays.end(), primary.begin(), primary.end());
    }
    return sets;
}

} // namespace vigil::bench
