// SPDX-License-Identifier: GPL-2.0-or-later
// The camera moves somewhere else and is at the place from one frame to the next: how much worse
// the first frames there are.
#include "bench/display.h"
#include "bench/flip.h"
#include "bench/picture_rows.h"

#include <iterator>
#include <utility>

namespace vigil::bench {

using nlohmann::ordered_json;

namespace {

constexpr int cut_frames = 8;

constexpr PictureColumn cut_columns[] = {{"mse_1", "MSE, frame 1", true},
                                         {"mse_2", "frame 2", true},
                                         {"mse_4", "frame 4", true},
                                         {"mse_8", "frame 8", true},
                                         {"flip_1", "FLIP, fr. 1", true}};

/// Of a view: the frames that lead to the next one, or, where there is one view, to the same place
/// looking back.
std::vector<Pose> frames_elsewhere(const std::vector<Place>& places, std::size_t view) {
    std::vector<Pose> frames = places[(view + 1) % places.size()].frames;
    if (places.size() == 1)
        for (Pose& pose : frames)
            pose.angles.y += 180.0f;
    return frames;
}

} // namespace

PartReport measure_cut(const QualityOptions& options, QualityRenderer& renderer,
                       const std::string& level, Progress& progress) {
    PictureRows rows(options.rows, options.baseline);
    ordered_json views = ordered_json::array();
    for (std::size_t view = 0; view < renderer.places().size(); ++view) {
        rows.begin_view();
        const Place& place = renderer.places()[view];
        const Pose& pose = place.measured();
        const std::vector<Pose> elsewhere = frames_elsewhere(renderer.places(), view);
        const Reference reference = picture_reference(options, renderer, pose, progress);
        const std::vector<float> expected = picture_of(reference);
        const double exposure = exposure_of(expected, options.size);
        take_turns(options, progress, fmt::format("view {}, seed", place.name),
                   [&](std::size_t row, int seed) {
                       renderer.begin_run(options.rows[row], seed);
                       for (const Pose& before : elsewhere)
                           renderer.show(before);
                       for (int frame = 1; frame <= cut_frames; ++frame) {
                           const std::vector<float> picture = renderer.show(pose);
                           rows.add(row, fmt::format("mse_{}", frame),
                                    picture_error(picture, reference).mse);
                           if (frame == 1)
                               rows.add(row, "flip_1",
                                        mean_flip(displayed(expected, exposure),
                                                  displayed(picture, exposure), options.size));
                       }
                   });
        views.push_back(view_json(place.name, pose, reference));
    }
    ordered_json report = {{"views", std::move(views)},
                           {"columns", to_json(cut_columns)},
                           {"nonfinite", renderer.nonfinite_count()},
                           {"rows", rows.json()}};
    std::string text = fmt::format("\n{}: after a cut\n{}", level, rows.text(cut_columns));
    return {std::move(report), std::move(text)};
}

} // namespace vigil::bench
