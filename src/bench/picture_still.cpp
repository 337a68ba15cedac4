// SPDX-License-Identifier: GPL-2.0-or-later
// A camera that moves, then stands still: flicker of both, and what detail is left in the mean of
// the frames that stand still.
#include "bench/detail.h"
#include "bench/display.h"
#include "bench/flicker.h"
#include "bench/flip.h"
#include "bench/picture_rows.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace vigil::bench {

using nlohmann::ordered_json;

namespace {

constexpr int flicker_frames = 16;

constexpr PictureColumn still_columns[] = {{"flicker", "flicker", true},
                                           {"flicker_shown", "as shown", true},
                                           {"moving_flicker", "moving", true},
                                           {"flip", "FLIP", true},
                                           {"mse", "MSE", true},
                                           {"texture", "texture"},
                                           {"shadow", "shadows"}};

} // namespace

PartReport measure_still(const QualityOptions& options, QualityRenderer& renderer,
                         const std::string& level, Progress& progress) {
    PictureRows rows(options.rows, options.baseline);
    ordered_json views = ordered_json::array();
    for (const Place& place : renderer.places()) {
        rows.begin_view();
        const Pose& pose = place.measured();
        const Reference reference = picture_reference(options, renderer, pose, progress);
        const std::vector<float> expected = picture_of(reference);
        const double exposure = exposure_of(expected, options.size);
        std::size_t texture_pairs = 0, shadow_pairs = 0;
        take_turns(options, progress, fmt::format("view {}, seed", place.name),
                   [&](std::size_t row, int seed) {
                       renderer.begin_run(options.rows[row], seed);
                       // The second half of the way, when the history is there.
                       double moving = 0.0;
                       int pairs = 0;
                       std::optional<SeenFrame> before;
                       for (std::size_t frame = 0; frame < place.frames.size(); ++frame) {
                           const std::vector<float> picture = renderer.show(place.frames[frame]);
                           if (frame + 1 < place.frames.size() / 2) continue;
                           SeenFrame now = seen_frame(picture, renderer.surfaces(),
                                                      renderer.camera(place.frames[frame]));
                           if (before) {
                               moving += moving_flicker(*before, now);
                               ++pairs;
                           }
                           before = std::move(now);
                       }
                       rows.add(row, "moving_flicker", moving / pairs);

                       renderer.stand_still(pose, settle_frames);
                       Flicker flicker, shown;
                       std::vector<float> mean(expected.size());
                       std::vector<float> last;
                       for (int frame = 0; frame < flicker_frames; ++frame) {
                           last = renderer.show(pose);
                           flicker.add(last);
                           shown.add(displayed(last, exposure));
                           for (std::size_t i = 0; i < mean.size(); ++i)
                               mean[i] += last[i] / static_cast<float>(flicker_frames);
                       }
                       rows.add(row, "flicker", flicker.variance());
                       rows.add(row, "flicker_shown", shown.variance());
                       rows.add(row, "mse", picture_error(last, reference).mse);
                       rows.add(row, "flip",
                                mean_flip(displayed(expected, exposure), displayed(last, exposure),
                                          options.size));
                       const Detail detail =
                           detail_kept(mean, reference, renderer.surfaces(), options.size);
                       texture_pairs = detail.texture_pairs;
                       shadow_pairs = detail.shadow_pairs;
                       rows.add(row, "texture", detail.texture);
                       rows.add(row, "shadow", detail.shadow);
                   });
        ordered_json& view = views.emplace_back(view_json(place.name, pose, reference));
        view["texture_pairs"] = texture_pairs;
        view["shadow_pairs"] = shadow_pairs;
    }
    ordered_json report = {{"views", std::move(views)},
                           {"settle_frames", settle_frames},
                           {"flicker_frames", flicker_frames},
                           {"columns", to_json(still_columns)},
                           {"nonfinite", renderer.nonfinite_count()},
                           {"rows", rows.json()}};
    std::string text = fmt::format(
        "\n{}: a view that stands still, {} frames after {}; moving: on the way there\n{}", level,
        flicker_frames, settle_frames, rows.text(still_columns));
    return {std::move(report), std::move(text)};
}

} // namespace vigil::bench
