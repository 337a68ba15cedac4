// SPDX-License-Identifier: GPL-2.0-or-later
// Light that changes while the camera stands still, there and back again, and how many frames it
// takes until nine tenths of that are shown.
#include "bench/change_response.h"
#include "bench/picture_rows.h"
#include "bench/scene_changes.h"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace vigil::bench {

using nlohmann::ordered_json;

namespace {

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
    const ChangingScene scene = changing_scenes(options, renderer).front();
    const bool flashes = options.changing == Changing::Strobe;
    const int state_frames = flashes ? 8 : 16, cycles = flashes ? 2 : 1;
    const Reference before = reference_with(options, renderer, scene.pose, scene.before, progress);
    const Reference after = reference_with(options, renderer, scene.pose, scene.after, progress);
    PictureRows rows(options.rows, options.baseline);
    rows.begin_view();
    std::vector<ordered_json> curves(options.rows.size(), ordered_json::array()); // [row][seed]
    take_turns(options, progress, "seed", [&](std::size_t row, int seed) {
        Curve brighter(state_frames), darker(state_frames);
        renderer.change(scene.before);
        renderer.begin_run(options.rows[row], seed);
        renderer.stand_still(scene.pose, settle_frames);
        for (int cycle = 0; cycle < cycles; ++cycle)
            for (const bool back : {false, true}) {
                renderer.change(back ? scene.before : scene.after);
                for (int frame = 0; frame < state_frames; ++frame) {
                    const ChangeShown shown =
                        change_shown(renderer.show(scene.pose), back ? after : before,
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
        {"views", {view_json("before", scene.pose, before), view_json("after", scene.pose, after)}},
        {"frames_after_change", state_frames},
        {"shown_share", shown_share},
        {"columns", to_json(change_columns)},
        {"nonfinite", renderer.nonfinite_count()},
        {"rows", rows.json()}};
    for (std::size_t row = 0; row < curves.size(); ++row)
        report["rows"][row]["curves"] = std::move(curves[row]);
    std::string text = fmt::format(
        "\n{}: {}; frames until {:.0f}% of it is shown ({} at most; one more: later), "
        "and the share that is after 1 and 4\n{}",
        level, scene.what, 100.0 * shown_share, state_frames, rows.text(change_columns));
    return {std::move(report), std::move(text)};
}

} // namespace vigil::bench
