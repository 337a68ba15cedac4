// SPDX-License-Identifier: GPL-2.0-or-later
// Light that changes while the camera stands still, there and back again, and how many frames it
// takes until nine tenths of that are shown.
#include "bench/change_response.h"
#include "bench/picture_rows.h"
#include "common/error.h"
#include "refresh/vkpt/scene/transform.h"

#include <glm/glm.hpp>

#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace vigil::bench {

using nlohmann::ordered_json;

namespace {

constexpr float lamp_radius = 4.0f;
constexpr float lamp_flux = 3000.0f; // radiance times radius^2: a bright effect of the game
constexpr float dimmed = 0.25f;

/// A scene, what becomes of it, and where that is seen.
struct Scenes {
    const char* what; // changes
    Pose pose;
    SceneChange before, after;
    int frames = 16; // that each of them lasts
    int cycles = 1;
};

/// A lamp that the camera sees none of jumps from the left of the picture to its right, as far from
/// the camera as half the way to what is there.
Scenes lamp_scenes(QualityRenderer& renderer, glm::ivec2 size) {
    Scenes scenes{"a lamp jumps", renderer.places().front().measured(), {}, {}};
    renderer.show(scenes.pose);
    const std::vector<shader::PrimaryHit> hits = renderer.surfaces();
    const shader::FrameParams camera = renderer.camera(scenes.pose);
    const auto lamp_at = [&](int column) {
        const shader::PrimaryHit& hit =
            hits[static_cast<std::size_t>(size.y / 2) * size.x + column];
        // The sky is far away.
        const glm::vec3 end = hit.primitive == shader::NONE
                                  ? scenes.pose.origin + 256.0f * camera.camera_forward
                                  : hit.position;
        return refresh::DynamicLight{1, glm::mix(scenes.pose.origin, end, 0.5f), lamp_radius,
                                     glm::vec3(lamp_flux / (lamp_radius * lamp_radius)), false};
    };
    scenes.before.lamp = lamp_at(size.x / 5);
    scenes.after.lamp = lamp_at(size.x - 1 - size.x / 5);
    return scenes;
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
Scenes door_scenes(QualityRenderer& renderer) {
    std::size_t most = 0;
    Scenes scenes{"a door opens and shuts", {}, {}, {}};
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
            scenes.pose = pose;
            scenes.after = gone;
        }
    if (most == 0) fail("no door is seen");
    return scenes;
}

Scenes scenes_of(const QualityOptions& options, QualityRenderer& renderer) {
    renderer.begin_run(options.rows.front(), 0);
    switch (options.changing) {
    case Changing::Lamp:
        return lamp_scenes(renderer, options.size);
    case Changing::Door:
        return door_scenes(renderer);
    case Changing::Strobe:
        break;
    }
    Scenes scenes{"all lamps flash", renderer.places().front().measured(), {}, {}, 8, 2};
    scenes.after.brightness = dimmed;
    return scenes;
}

Reference reference_with(const QualityOptions& options, QualityRenderer& renderer, const Pose& pose,
                         const SceneChange& change, Progress& progress) {
    renderer.change(change);
    return picture_reference(options, renderer, pose, progress);
}

/// Mean share by frame after a change, of the changes that have one.
class Curve {
public:
    explicit Curve(int frames) : sums_(frames), counts_(frames) {}

    void add(std::size_t frame, double share) {
        if (std::isnan(share)) return;
        sums_[frame] += share;
        ++counts_[frame];
    }
    std::vector<double> means() const {
        std::vector<double> means;
        for (std::size_t i = 0; i < sums_.size(); ++i)
            means.push_back(counts_[i] > 0 ? sums_[i] / counts_[i]
                                           : std::numeric_limits<double>::quiet_NaN());
        return means;
    }

private:
    std::vector<double> sums_;
    std::vector<int> counts_;
};

constexpr PictureColumn change_columns[] = {
    {"lag_brighter", "lag, brighter"}, {"brighter_1", "frame 1"}, {"brighter_4", "frame 4"},
    {"lag_darker", "lag, darker"},     {"darker_1", "frame 1"},   {"darker_4", "frame 4"}};

} // namespace

PartReport measure_change(const QualityOptions& options, QualityRenderer& renderer,
                          const std::string& level, Progress& progress) {
    const Scenes scenes = scenes_of(options, renderer);
    const Reference before =
        reference_with(options, renderer, scenes.pose, scenes.before, progress);
    const Reference after = reference_with(options, renderer, scenes.pose, scenes.after, progress);
    PictureRows rows(options.rows, options.baseline);
    rows.begin_view();
    std::vector<ordered_json> curves(options.rows.size(), ordered_json::array()); // [row][seed]
    take_turns(options, progress, "seed", [&](std::size_t row, int seed) {
        Curve brighter(scenes.frames), darker(scenes.frames);
        renderer.change(scenes.before);
        renderer.begin_run(options.rows[row], seed);
        renderer.stand_still(scenes.pose, settle_frames);
        for (int cycle = 0; cycle < scenes.cycles; ++cycle)
            for (const bool back : {false, true}) {
                renderer.change(back ? scenes.before : scenes.after);
                for (int frame = 0; frame < scenes.frames; ++frame) {
                    const ChangeShown shown =
                        change_shown(renderer.show(scenes.pose), back ? after : before,
                                     back ? before : after, options.size);
                    brighter.add(frame, shown.brighter);
                    darker.add(frame, shown.darker);
                }
            }
        const std::vector<double> come = brighter.means(), gone = darker.means();
        rows.add(row, "lag_brighter", lag_of(come));
        rows.add(row, "lag_darker", lag_of(gone));
        for (const int frame : {1, 4}) {
            rows.add(row, fmt::format("brighter_{}", frame), come[frame - 1]);
            rows.add(row, fmt::format("darker_{}", frame), gone[frame - 1]);
        }
        curves[row].push_back({{"brighter", come}, {"darker", gone}});
    });
    renderer.change({});
    ordered_json report = {
        {"views",
         {view_json("before", scenes.pose, before), view_json("after", scenes.pose, after)}},
        {"frames_after_change", scenes.frames},
        {"shown_share", shown_share},
        {"columns", to_json(change_columns)},
        {"nonfinite", renderer.nonfinite_count()},
        {"rows", rows.json()}};
    for (std::size_t row = 0; row < curves.size(); ++row)
        report["rows"][row]["curves"] = std::move(curves[row]);
    std::string text = fmt::format(
        "\n{}: {}; frames until {:.0f}% of it is shown ({} at most; one more: later), "
        "and the share that is after 1 and 4\n{}",
        level, scenes.what, 100.0 * shown_share, scenes.frames, rows.text(change_columns));
    return {std::move(report), std::move(text)};
}

} // namespace vigil::bench
