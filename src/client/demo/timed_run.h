// SPDX-License-Identifier: GPL-2.0-or-later
// What is measured while a camera route is flown or a demo is played frame by frame, once or
// several times: seconds, GPU times and counts of every frame, pictures of some, and the report at
// the end (Quake's line, a table of passes, JSON). It decides nothing about what is rendered.
#pragma once

#include "client/measure/count_statistics.h"
#include "client/measure/pass_statistics.h"
#include "client/play/session.h"
#include "common/progress.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace vigil::client {

/// What is run and what shall come of it.
struct RunPlan {
    std::string kind = "route"; ///< or "demo", for the report
    std::string name;           ///< of the route or demo, for the report
    double fps = 20.0;          ///< frames per second of the level's time
    /// Pictures PREFIX_000.png, PREFIX_001.png, ...; empty: none. NAME.exr: linear radiance as
    /// NAME_000.exr, ...
    std::string prefix;
    int every = 1;      ///< one picture for so many frames
    std::string json;   ///< name of the report below outdir; empty: none
    glm::ivec2 size{0}; ///< of the picture, for the report
};

class TimedRun {
public:
    /// `frames` of all repetitions, for the progress.
    TimedRun(RunPlan plan, int frames) : plan_(std::move(plan)), expected_(frames) {}

    const RunPlan& plan() const { return plan_; }
    /// Frames of the present repetition; 0 between two.
    int frame_count() const { return static_cast<int>(frames_.size() - begin_); }
    int repetitions() const { return static_cast<int>(finished_.size()); }

    /// Begins a repetition: frames before it do not count.
    void begin(Session& session);
    /// Takes the times and the picture of the frame that was rendered last. `seconds` is the time
    /// that rendering it took. Throws Error when the picture cannot be written.
    void end_frame(Session& session, double seconds);
    /// Collects GPU times of frames that are finished; with `wait`, of all.
    void take_gpu_times(Session& session, bool wait);
    /// Ends the repetition. Waits for the GPU; that time counts.
    void end(Session& session);
    /// Drops the repetition under way: report() tells of those before it.
    void drop();

    /// Logs Quake's line and the table of the repetition that ended last.
    void log_repetition() const;
    /// Logs the same for all of them together where there are several, and the names of pictures;
    /// writes the JSON report if one is wanted. Throws Error when it cannot be written.
    void report(Session& session, const CvarRegistry& variables) const;

    /// Throws Error now where a picture or the report could not be written at the end.
    void check_outputs() const;

private:
    void tell_progress();

    struct FrameRecord {
        double seconds = 0.0; // of the main loop
        uint64_t number = 0;  // as the renderer counts
        std::vector<refresh::PassTime> passes;
    };
    struct Repetition {
        size_t frames = 0;
        double seconds = 0.0;
    };

    std::filesystem::path picture_path(int number) const;
    Repetition together() const;
    std::string json_text(const Session& session, const std::string& device,
                          const CvarRegistry& variables) const;

    RunPlan plan_;
    int expected_ = 0;
    int pictures_ = 0;
    double seconds_ = 0.0; // of the present repetition
    size_t begin_ = 0;     // its first frame
    std::vector<FrameRecord> frames_;
    std::vector<Repetition> finished_;
    std::vector<PassSum> sums_;
    PassStatistics repetition_statistics_;
    struct Totals {
        PassStatistics passes;
        CountStatistics counts{0};
    };
    Totals totals_;          // with the present repetition
    Totals finished_totals_; // without
    std::unique_ptr<Progress> progress_;
};

} // namespace vigil::client
