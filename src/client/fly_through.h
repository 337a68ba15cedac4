// SPDX-License-Identifier: GPL-2.0-or-later
// One flight of the camera along a route: every frame of the route is rendered, none is skipped,
// and the end reports frame rate and GPU times (Quake's timedemo, with a camera instead of a demo).
#pragma once

#include "client/count_statistics.h"
#include "client/pass_statistics.h"
#include "client/route.h"
#include "client/session.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vigil::client {

struct FlightPlan {
    std::string name;   ///< of the route, for the report
    double fps = 20.0;  ///< frames per second of route time
    std::string prefix; ///< pictures PREFIX_000.png, PREFIX_001.png, ...; empty: none
    int every = 1;      ///< one picture for so many frames
    std::string json;   ///< name of the report below outdir; empty: none
    glm::ivec2 size{0}; ///< of the picture, for the report
};

class FlyThrough {
public:
    FlyThrough(Route route, FlightPlan plan);

    bool finished() const { return frame_ == frame_count_; }

    /// Puts the camera at this frame's view and lets one frame of route time pass.
    void begin_frame(Session& session);
    /// Takes this frame's times and picture. `seconds` is the time that rendering it took. Throws
    /// Error when the picture cannot be written.
    void end_frame(Session& session, double seconds);

    /// Quake's line and the table of passes; writes the JSON report if one is wanted. Throws Error
    /// when it cannot be written. Waits for the GPU; that time counts.
    void report(Session& session, const CvarRegistry& variables);

private:
    struct FrameRecord {
        double seconds = 0.0; // of the main loop
        uint64_t number = 0;  // as the renderer counts
        std::vector<refresh::PassTime> passes;
    };

    void take_gpu_times(Session& session, bool wait);
    std::filesystem::path picture_path(int number) const;
    std::string json_text(const Session& session, const std::string& device,
                          const CvarRegistry& variables) const;

    Route route_;
    FlightPlan plan_;
    int frame_ = 0;
    int frame_count_ = 0;
    int pictures_ = 0;
    double seconds_ = 0.0;
    std::vector<FrameRecord> frames_;
    PassStatistics statistics_;
    CountStatistics counts_{0};
};

} // namespace vigil::client
