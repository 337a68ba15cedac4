// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/scene_changes.h"

#include "common/error.h"

#include <glm/glm.hpp>

#include <utility>

namespace vigil::bench {

namespace {

constexpr float lamp_radius = 4.0f;
constexpr float lamp_flux = 3000.0f; // radiance times radius^2: a bright effect of the game
constexpr float dimmed = 0.25f;

/// A lamp that the camera sees none of jumps from the left of the picture to its right, as far from
/// the camera as half the way to what is there.
ChangingScene lamp_scene(QualityRenderer& renderer, const Place& place, glm::ivec2 size) {
    ChangingScene scene{"a lamp jumps", place.name, place.measured(), {}, {}};
    renderer.show(scene.pose);
    const std::vector<shader::PrimaryHit> hits = renderer.surfaces();
    const shader::FrameParams camera = renderer.camera(scene.pose);
    const auto lamp_at = [&](int column) {
        const shader::PrimaryHit& hit =
            hits[static_cast<std::size_t>(size.y / 2) * size.x + column];
        // The sky is far away.
        const glm::vec3 end = hit.primitive == shader::NONE
                                  ? scene.pose.origin + 256.0f * camera.camera_forward
                                  : hit.position;
        return refresh::DynamicLight{1, glm::mix(scene.pose.origin, end, 0.5f), lamp_radius,
                                     glm::vec3(lamp_flux / (lamp_radius * lamp_radius)), false};
    };
    scene.before.lamp = lamp_at(size.x / 5);
    scene.after.lamp = lamp_at(size.x - 1 - size.x / 5);
    return scene;
}

/// Views of a door from both of its sides.
std::vector<Pose> door_views(const QualityRenderer& renderer, const Door& door) {
    const glm::vec3 middle = 0.5f * (door.low + door.high), extent = door.high - door.low;
    const int axis = extent.x < extent.y ? 0 : 1; // across it
    std::vector<Pose> views;
    for (const float side : {-1.0f, 1.0f})
        for (const float distance : {96.0f, 160.0f, 256.0f}) {
            Pose pose{middle, {0.0f, 0.0f, 0.0f}, 0.0};
            pose.origin[axis] += side * (0.5f * extent[axis] + distance);
            pose.angles.y = (axis == 0 ? 0.0f : 90.0f) + (side > 0.0f ? 180.0f : 0.0f);
            if (renderer.is_open(pose.origin)) views.push_back(pose);
        }
    return views;
}

/// The door, and the view of it, that hides the most.
ChangingScene door_scene(QualityRenderer& renderer) {
    std::size_t most = 0;
    ChangingScene scene{"a door opens and shuts", "door", {}, {}, {}};
    for (const Door& door : renderer.doors())
        for (const Pose& pose : door_views(renderer, door)) {
            renderer.change({});
            renderer.show(pose);
            const std::vector<shader::PrimaryHit> shut = renderer.surfaces();
            SceneChange gone;
            gone.hidden = door.number;
            renderer.change(gone);
            renderer.show(pose);
            const std::vector<shader::PrimaryHit> open = renderer.surfaces();
            std::size_t differ = 0;
            for (std::size_t i = 0; i < shut.size(); ++i)
                differ += glm::distance(shut[i].position, open[i].position) > 1.0f;
            if (differ <= most) continue;
            most = differ;
            scene.pose = pose;
            scene.after = gone;
        }
    if (most == 0) fail("no door is seen");
    return scene;
}

} // namespace

std::vector<ChangingScene> changing_scenes(const QualityOptions& options,
                                           QualityRenderer& renderer) {
    renderer.begin_run(options.rows.front(), 0);
    if (options.changing == Changing::Door) return {door_scene(renderer)};
    std::vector<ChangingScene> scenes;
    for (const Place& place : renderer.places()) {
        if (options.changing == Changing::Lamp) {
            scenes.push_back(lamp_scene(renderer, place, options.size));
            continue;
        }
        ChangingScene scene{"all lamps flash", place.name, place.measured(), {}, {}};
        scene.after.brightness = dimmed;
        scenes.push_back(std::move(scene));
    }
    return scenes;
}

} // namespace vigil::bench
